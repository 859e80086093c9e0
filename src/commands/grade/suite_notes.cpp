#include "commands/grade/suite_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/base/values.h"
#include "film/image_file.h"
#include "grading/text_difference.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

/// No picture of a thousand pixels, nor a text without words, has a larger file unless it is full of other things.
constexpr std::size_t most_note_bytes = 1u << 16;

bool is_small(const std::string& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    return !error && size <= most_note_bytes;
}

/// Counts are of pixels, all other figures shares of full scale.
bool always_holds(const Threshold& limit, double pixels) {
    const bool is_count = limit.metric == Metric::differing || limit.metric == Metric::differing_1;
    return limit.at_most >= (is_count ? pixels : 1.0);
}

bool any_picture_passes(const TestCase& test) {
    if (!is_small(test.expected)) return false;
    try {
        const StoredImage right = read_image(test.expected);
        const double pixels = static_cast<double>(right.width) * right.height;
        return std::all_of(test.pass.begin(), test.pass.end(), [&](const Threshold& limit) { return always_holds(limit, pixels); });
    } catch (const OptionError&) {
        return false;
    }
}

bool expects_nothing(const TestCase& test) {
    if (!is_small(test.expected)) return false;
    const std::optional<std::string> right = read_file_text(test.expected, most_note_bytes);
    return right && compared_lines(*right).empty();
}

}  // namespace

void note_tests_in_vain(const Suite& suite, const MessageSink& messages) {
    std::vector<std::string> pictures, texts;
    for (const TestCase& test : suite.tests) {
        if (test.kind == TestCase::Kind::picture && any_picture_passes(test)) pictures.push_back(printable(test.name, 200));
        if (test.kind == TestCase::Kind::text && expects_nothing(test)) texts.push_back(printable(test.name, 200));
    }
    if (!pictures.empty())
        messages(fmt::format("raytrace: note: any picture of the right size passes {}: their rules allow for all that can differ",
                             fmt::join(pictures, ", ")));
    if (!texts.empty())
        messages(fmt::format("raytrace: note: a program that prints nothing passes {}: no text is expected", fmt::join(texts, ", ")));
}

}  // namespace rt
