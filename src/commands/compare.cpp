// raytrace compare A B: every figure of difference, a picture of it, and idiff's verdict as the exit status.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/base/command_line.h"
#include "commands/base/difference_file.h"
#include "commands/base/json_text.h"
#include "commands/base/output_name.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/base/verdict.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "core/source.h"
#include "grading/difference.h"

namespace rt {

namespace {

struct CompareJob {
    std::string a, b;
    DifferenceOptions options;
    DifferenceLimits limits;
    std::string picture;
    double scale = 1.0;
    bool json = false;
    bool quiet = false;
};

const char* verdict_name(Verdict v) {
    constexpr const char* names[] = {"same", "warning", "failure", "sizes differ", "unreadable"};
    return names[static_cast<int>(v)];
}

std::string text_of(const CompareJob& job, const Difference& d, const PixelCounts& counts, Verdict v) {
    const double share = d.pixels ? 100.0 / static_cast<double>(d.pixels) : 0.0;
    const auto pixels = [&](const std::string& what, std::uint64_t n) {
        return fmt::format("{:<22}{:>10}  ({:.3f} %)\n", what, n, share * static_cast<double>(n));
    };
    std::string text = fmt::format("{:<22}{:>10}\n", "pixels", d.pixels);
    text += pixels(fmt::format("differ at fuzz {} %", job.options.fuzz_percent), d.differing);
    text += pixels("differ at fuzz 1 %", d.differing_1) + pixels("differ at all", d.differing_0);
    text += pixels(fmt::format("beyond fail {}", job.limits.fail), counts.failing);
    text += pixels(fmt::format("beyond warn {}", job.limits.warn), counts.warning);
    text += fmt::format("{:<22}{:>10.6f}  at ({}, {}) channel {}: {:.6f} and {:.6f}\n", "largest", d.max, d.max_x, d.max_y, d.max_channel,
                        d.max_a, d.max_b);
    text += fmt::format("{:<22}{:>10.6f}\n{:<22}{:>10.6f}\n", "mean absolute", d.mean_absolute, "rmse", d.rmse);
    text += fmt::format("{:<22}{:>10.3f}  dB\n{:<22}{:>10.6f}\n", "psnr", d.psnr, "99th percentile", d.p99);
    text += fmt::format("{:<22}{:>10.6f}\n", "flip mean", d.flip_mean);
    text += fmt::format("{:<22}{:>10.6f}  quartiles {:.6f} {:.6f}, range {:.6f} to {:.6f}\n", "flip median", d.flip_median, d.flip_q1,
                        d.flip_q3, d.flip_min, d.flip_max);
    return text + fmt::format("{:<22}{:>10}\n", "verdict", verdict_name(v));
}

nlohmann::ordered_json json_of(const CompareJob& job, const Difference& d, const PixelCounts& counts, Verdict v) {
    nlohmann::ordered_json psnr = nullptr;  // JSON has no infinity
    if (std::isfinite(d.psnr)) psnr = d.psnr;
    return {{"a", job.a},
            {"b", job.b},
            {"verdict", verdict_name(v)},
            {"pixels", d.pixels},
            {"fuzz_percent", job.options.fuzz_percent},
            {"differing", d.differing},
            {"differing_0", d.differing_0},
            {"differing_1", d.differing_1},
            {"failing", counts.failing},
            {"warning", counts.warning},
            {"max", {{"value", d.max}, {"x", d.max_x}, {"y", d.max_y}, {"channel", d.max_channel}, {"a", d.max_a}, {"b", d.max_b}}},
            {"mean_absolute", d.mean_absolute},
            {"rmse", d.rmse},
            {"psnr", psnr},
            {"p99", d.p99},
            {"flip",
             {{"mean", d.flip_mean},
              {"median", d.flip_median},
              {"q1", d.flip_q1},
              {"q3", d.flip_q3},
              {"min", d.flip_min},
              {"max", d.flip_max}}}};
}

int report_sizes(const CompareJob& job, const StoredImage& a, const StoredImage& b) {
    if (job.json) {
        const nlohmann::ordered_json json = {{"a", job.a},
                                             {"b", job.b},
                                             {"verdict", verdict_name(Verdict::size_differs)},
                                             {"size_a", {a.width, a.height}},
                                             {"size_b", {b.width, b.height}}};
        write_stdout(json_text(json, 2));
    } else if (!job.quiet) {
        write_stdout(fmt::format("sizes differ: {} x {} and {} x {}\n", a.width, a.height, b.width, b.height));
    }
    return static_cast<int>(Verdict::size_differs);
}

void write_difference(const CompareJob& job, const StoredImage& a, const StoredImage& b) {
    const OutputRequest request{job.picture, false, std::nullopt, true};
    const OutputTarget target = output_target(request, job.a);
    const std::string note = note_on_name(request, target);
    if (!note.empty() && !job.quiet) write_stderr(fmt::format("raytrace: note: {}\n", note));
    write_difference_picture({job.a, a}, {job.b, b}, job.scale, target.path, target.format);
}

int run(const CompareJob& job) {
    const StoredImage a = read_image(job.a);
    const StoredImage b = read_image(job.b);
    if (a.width != b.width || a.height != b.height) return report_sizes(job, a, b);
    const Difference difference = compare(a, b, job.options);
    const PixelCounts counts = count_pixels(a, b, job.limits);
    const Verdict result = verdict(counts, difference.pixels, job.limits);
    if (job.json)
        write_stdout(json_text(json_of(job, difference, counts, result), 2));
    else if (!job.quiet)
        write_stdout(text_of(job, difference, counts, result));
    if (!job.picture.empty()) write_difference(job, a, b);
    return static_cast<int>(result);
}

void define(CommandLine& line, CompareJob& job) {
    const auto number = [&line](const char* name, const char* type, const char* help, double& place, double most) {
        line.value(name, type, help, [=, &place](const std::string& v) { place = real_number(name + 2, v, 0.0, most); });
    };
    line.flag("--json", "one JSON object instead of a table", [&] { job.json = true; });
    line.value("-o,--output", "FILE", "write a picture of the absolute differences", [&](const std::string& v) { job.picture = v; });
    number("--scale", "X", "multiply the differences in that picture (1)", job.scale, HUGE_VAL);
    line.value("--fuzz", "N[%]", "count pixels as ImageMagick's -fuzz N% does (5 %)", [&](const std::string& v) {
        job.options.fuzz_percent = real_number("fuzz", v.ends_with('%') ? v.substr(0, v.size() - 1) : v, 0.0, 100.0);
    });
    number("--fail", "X", "a pixel fails beyond X of full scale (1e-6)", job.limits.fail, HUGE_VAL);
    number("--failpercent", "P", "so many percent of pixels may fail (0)", job.limits.fail_percent, 100.0);
    number("--hardfail", "X", "no pixel may differ by more", job.limits.hard_fail, HUGE_VAL);
    number("--warn", "X", "the same for a warning (1e-6)", job.limits.warn, HUGE_VAL);
    number("--warnpercent", "P", "", job.limits.warn_percent, 100.0);
    number("--hardwarn", "X", "", job.limits.hard_warn, HUGE_VAL);
    line.flag("-q,--quiet", "no table; the exit status says it", [&] { job.quiet = true; });
}

}  // namespace

int run_compare(const Words& words) {
    CompareJob job;
    CommandLine line(compare_usage, compare_footer);
    define(line, job);
    try {
        const Words pictures = line.parse(with_two_dashes(words, line));
        if (line.help_asked()) {
            write_stdout(line.help());
            return 0;
        }
        if (pictures.size() != 2) throw OptionError("compare: expected two pictures; see raytrace compare --help");
        job.a = pictures[0];
        job.b = pictures[1];
        return run(job);
    } catch (const std::runtime_error& error) {  // statuses 1 and 3 have meanings of their own here
        write_stderr(fmt::format("raytrace: {}\n", error.what()));
        return static_cast<int>(Verdict::unreadable);
    }
}

}  // namespace rt
