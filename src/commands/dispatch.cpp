#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "commands/base/program.h"
#include "commands/base/suggest.h"
#include "commands/commands.h"
#include "commands/job/render_arguments.h"
#include "commands/job/session.h"
#include "core/source.h"

namespace rt {

namespace {

constexpr std::array<std::string_view, 19> available_commands{
    "render",  "raycast", "sceneinfo", "pixelray", "firsthit", "pixelcolor", "printrays", "pixeltrace", "printbvh", "requires",
    "compare", "explain", "brdf",      "grade",    "merge",    "versus",     "trade",     "help",       "version"};

/// A first word that is neither an option nor a file, but nearly a command.
void refuse_mistyped_command(const std::string& word) {
    if (word.empty() || word.find_first_of("+-=./") != std::string::npos) return;
    std::error_code ignored;
    for (const std::string& name : {word, word + ".pov"})
        if (std::filesystem::exists(name, ignored)) return;
    const std::string meant = did_you_mean(word, {available_commands.begin(), available_commands.end()});
    if (!meant.empty()) throw OptionError(fmt::format("'{}' is neither a command nor a scene{}", word, meant));
}

}  // namespace

int run_program(const Words& words) {
    const std::string first = words.empty() ? "" : words[0];
    const Words rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    if (is_course_command(first)) return run_course(first, rest);
    if (first == "requires") return run_requires(rest);
    if (first == "compare") return run_compare(rest);
    if (first == "explain") return run_explain(rest);
    if (first == "brdf") return run_brdf(rest);
    if (first == "grade") return run_grade(rest);
    if (first == "merge") return run_merge(rest);
    if (first == "versus") return run_versus(rest);
    if (first == "trade") return run_trade(rest);
    if (first == "help") return run_help(rest);
    if (first == "version" || first == "--version" || first == "-version") return run_version(rest);
    refuse_mistyped_command(first);
    return run_render(words);
}

int run_render(const Words& words) {
    std::string help;
    std::optional<RenderJob> job = parse_render_arguments(words, help);
    if (job) return job->animation ? run_animation(*job) : run_session(std::move(*job));
    write_stdout(help);
    return 0;
}

int run_version(const Words&) {
    write_stdout(fmt::format("raytrace {}\n", program_version()));
    return 0;
}

}  // namespace rt
