#include "commands/causes/wrong_answer.h"

#include <fmt/format.h>

#include "commands/causes/wrong_picture.h"
#include "commands/causes/wrong_pixel.h"
#include "commands/pixel/divergence_text.h"
#include "commands/pixel/told_pixel_file.h"
#include "film/image_file.h"
#include "grading/text_causes.h"

namespace rt {

namespace {

std::string pixel_text(const StoredImage& image, int x, int y) {
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    const std::size_t first =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * channels;
    const auto value = [&](std::size_t c) { return image.values[first + (channels < 3 ? 0 : c)]; };
    return fmt::format("({:g}, {:g}, {:g})", value(0), value(1), value(2));
}

void add_pixel(const Suite& suite, const TestCase& test, const std::string& printed, Result& result, std::vector<std::string>& lines) {
    const DifferingRegion& region = *result.region;
    const PixelVerdict pixel = explain_pixel(test.arguments, suite.inputs, region.x, region.y, printed);
    lines.insert(lines.end(), pixel.lines.begin(), pixel.lines.end());
    if (!pixel.cause || *pixel.cause == Cause::other) return;
    if (result.cause.empty()) {
        result.cause = name_of(*pixel.cause);
        lines.push_back("the cause is named by these rays; the picture alone does not say it");
    } else if (agree(result.cause, *pixel.cause)) {
        lines.push_back("the rays say the same as the picture");
    }
}

/// The record in a text, if it is one.
std::optional<ToldPixel> told(const std::string& text) {
    Sources sources;
    sources.add({"text", text});
    try {
        ToldPixel pixel = told_pixel_of_text(sources);
        if (!pixel.samples.empty()) return pixel;
    } catch (const SceneError&) {  // another kind of text
    }
    return std::nullopt;
}

}  // namespace

std::string rays_told(const TestCase& test, const Result& result, const RunAgain& run_again) {
    if (!result.region) return {};
    const std::vector<std::string> words = printrays_arguments(test.arguments, result.region->x, result.region->y);
    return words.empty() ? std::string() : run_again(words);
}

void explain_picture(const Suite& suite, const TestCase& test, const StoredImage& expected, const StoredImage& actual,
                     const std::string& printed, Result& result) {
    Verdicts verdicts = cause_of(suite, test, expected, actual);
    result.cause = std::move(verdicts.cause);
    std::vector<std::string> lines = std::move(verdicts.lines);
    if (result.region) {
        const int x = result.region->x, y = result.region->y;
        lines.push_back(fmt::format("pixel ({}, {}) from the top left, in the largest region that differs: {}, {} expected", x, y,
                                    pixel_text(actual, x, y), pixel_text(expected, x, y)));
        add_pixel(suite, test, printed, result, lines);
    }
    result.explanation = fmt::format("{}", fmt::join(lines, "\n"));
}

void explain_text(const std::string& expected, const std::string& actual, Result& result) {
    const TextCause plain = text_cause(expected, actual);
    result.cause = plain.cause;
    result.explanation = plain.evidence;
    const std::optional<ToldPixel> a = told(expected), b = told(actual);
    if (!a || !b) return;
    constexpr double tolerance = 2e-4;  // texts have four decimals
    const std::optional<Divergence> found = first_divergence(*a, *b, tolerance);
    if (!found) return;
    if (found->cause != Cause::other) result.cause = name_of(found->cause);
    result.explanation +=
        fmt::format("\nthe rays of both texts, the expected one's (A) beside the program's (B):\n{}", divergence_text(*found, *a));
    if (result.explanation.ends_with('\n')) result.explanation.pop_back();
}

}  // namespace rt
