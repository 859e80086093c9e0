#include "commands/causes/wrong_pixel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "commands/base/values.h"
#include "commands/causes/scene_samples.h"
#include "commands/job/job_steps.h"
#include "commands/job/test_job.h"
#include "commands/pixel/course_pixel.h"
#include "commands/pixel/divergence_text.h"
#include "commands/pixel/told_pixel_file.h"

namespace rt {

namespace {

constexpr std::size_t most_ray_lines = 40;  ///< of our own record, where the program has none

void add_text(std::vector<std::string>& lines, const std::string& text) {
    std::vector<std::string> all = split(text, '\n');
    while (!all.empty() && all.back().empty()) all.pop_back();
    for (std::size_t i = 0; i < std::min(all.size(), most_ray_lines); ++i) lines.push_back("  " + all[i]);
    if (all.size() > most_ray_lines) lines.push_back(fmt::format("  ... and {} lines more", all.size() - most_ray_lines));
}

std::optional<ToldPixel> told(const std::string& text, ToldPixel (*read)(const Sources&)) {
    Sources sources;
    sources.add({"printrays", text});
    try {
        ToldPixel pixel = read(sources);
        if (pixel.samples.empty()) return std::nullopt;
        return pixel;
    } catch (const std::runtime_error&) {  // no record of rays
        return std::nullopt;
    }
}

const std::pair<std::string_view, Cause> same_meaning[] = {
    {"mirrored", Cause::mirrored},
    {"upside down", Cause::upside_down},
    {"half-pixel shift", Cause::half_pixel},
    {"missing anti-aliasing", Cause::sampling},
    {"gamma twice", Cause::gamma},
    {"gamma missing", Cause::gamma},
    {"shadow acne", Cause::offset},
    {"shadow acne", Cause::false_shadow},
    {"missing shadows", Cause::missing_shadow},
    {"false shadows", Cause::false_shadow},
    {"false shadows", Cause::offset},
    {"missing lamps", Cause::missing_light},
    {"ambient missing", Cause::missing_ambient},
    {"ambient wrong", Cause::missing_ambient},
    {"diffuse missing", Cause::wrong_diffuse},
    {"diffuse wrong", Cause::wrong_diffuse},
    {"light not normalised", Cause::missing_normalisation},
    {"light not normalised", Cause::wrong_diffuse},
    {"wrong lamp colour", Cause::wrong_diffuse},
    {"specular missing", Cause::missing_highlight},
    {"specular wrong", Cause::wrong_exponent},
    {"specular wrong", Cause::missing_highlight},
    {"specular wrong", Cause::missing_normalisation},
    {"wrong normals", Cause::wrong_normal},
    {"wrong normals", Cause::wrong_normal_side},
    {"wrong pigment", Cause::wrong_pigment},
    {"wrong depth", Cause::depth},
    {"no reflection", Cause::missing_reflection},
    {"reflection wrong", Cause::wrong_mirror_direction},
    {"mirror not tinted", Cause::wrong_pigment},
    {"mirror not tinted", Cause::missing_filter},
    {"no refraction", Cause::missing_filter},
    {"missing filter", Cause::missing_filter},
    {"missing absorption", Cause::missing_filter},
    {"refraction ratio", Cause::wrong_refraction_ratio},
    {"refraction ratio", Cause::total_reflection},
    {"no total reflection", Cause::total_reflection},
    {"missing Fresnel", Cause::missing_fresnel},
    {"wrong share", Cause::wrong_share},
    {"wrong camera", Cause::camera},
    {"missing objects", Cause::missed_object},
    {"wrong transform", Cause::placement},
};

}  // namespace

bool agree(const std::string& picture_cause, Cause cause) {
    for (const auto& [name, same] : same_meaning)
        if (name == picture_cause && same == cause) return true;
    return picture_cause == name_of(cause);
}

std::vector<std::string> printrays_arguments(const std::vector<std::string>& arguments, int x, int y_from_top) {
    const bool by_chance = std::find(arguments.begin(), arguments.end(), "-gi") != arguments.end();
    if (arguments.empty() || arguments[0] != "render" || by_chance) return {};
    std::vector<std::string> words{"printrays"};
    int positions = 0;
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        words.push_back(arguments[i]);
        if (arguments[i].starts_with('-') || ++positions != 3) continue;
        int height = 0;
        const std::string& word = arguments[i];
        if (std::from_chars(word.data(), word.data() + word.size(), height).ec != std::errc()) return {};
        words.push_back(std::to_string(x)), words.push_back(std::to_string(height - 1 - y_from_top));
    }
    if (positions < 3) return {};
    return words;
}

PixelVerdict explain_pixel(const std::vector<std::string>& arguments, const std::string& inputs, int x, int y_from_top,
                           const std::string& printed) {
    PixelVerdict verdict;
    const std::vector<std::string> words = printrays_arguments(arguments, x, y_from_top);
    if (words.empty()) return verdict;
    const CourseUsage usage{.command = "printrays", .size = true, .pixel = true, .tree = true};
    std::optional<TracedPixel> ours;
    try {
        CourseArguments own = parse_course_arguments(usage, {words.begin() + 1, words.end()});
        own.job.scene = scene_path(inputs, own.job.scene);
        own.job.threads = 1;
        ours = trace_course_pixel(own);
    } catch (const std::runtime_error&) {  // a scene or an option that is not ours
        return verdict;
    }
    const std::optional<ToldPixel> a = told(ray_tree_json(*ours), told_pixel_of_json), b = told(printed, told_pixel_of_text);
    if (!a || !b) {
        verdict.lines.push_back("the program prints no rays of it; ours:");
        add_text(verdict.lines, printrays_text(ours->name, ours->scene, ours->rays.samples));
        return verdict;
    }
    constexpr double tolerance = 1e-3;  // texts have four decimals
    const std::optional<Divergence> found = first_divergence(*a, *b, tolerance);
    if (!found) {
        verdict.lines.push_back(
            "the program's own printrays tells the same rays as ours there: the picture is made by other code, or spoilt later");
        return verdict;
    }
    verdict.cause = found->cause;
    verdict.lines.push_back("its rays, ours (A) beside the program's own printrays (B):");
    add_text(verdict.lines, divergence_text(*found, *a));
    return verdict;
}

}  // namespace rt
