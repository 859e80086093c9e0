// raytrace explain A B: where two records of one pixel part, and what that usually means.
#include <fmt/format.h>

#include "commands/base/command_line.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/base/verdict.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/pixel/divergence_text.h"
#include "commands/pixel/told_pixel_file.h"
#include "core/source.h"
#include "grading/explain.h"

namespace rt {

int run_explain(const Words& words) {
    double tolerance = 1e-4;
    bool quiet = false;
    CommandLine line(explain_usage, explain_footer);
    line.value("--tolerance", "X", "numbers are the same within X, relative over 1 (1e-4)",
               [&](const std::string& v) { tolerance = real_number("tolerance", v, 0.0, 1.0); });
    line.flag("-q,--quiet", "no text; the exit status says it", [&] { quiet = true; });
    try {
        const Words files = line.parse(with_two_dashes(words, line));
        if (line.help_asked()) {
            write_stdout(line.help());
            return 0;
        }
        if (files.size() != 2) throw OptionError("explain: expected two records of a pixel; see raytrace explain --help");
        const ToldPixel a = read_told_pixel(files[0]), b = read_told_pixel(files[1]);
        const std::optional<Divergence> found = first_divergence(a, b, tolerance);
        if (!quiet) write_stdout(found ? divergence_text(*found, a) : "the same\n");
        return found ? 1 : 0;
    } catch (const SceneError& error) {  // its own line, which editors parse
        write_stderr(fmt::format("{}\n", error.what()));
    } catch (const std::runtime_error& error) {  // statuses 1 and 3 have meanings of their own here
        write_stderr(fmt::format("raytrace: {}\n", error.what()));
    }
    return static_cast<int>(Verdict::unreadable);
}

}  // namespace rt
