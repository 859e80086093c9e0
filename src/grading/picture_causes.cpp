#include "grading/picture_causes.h"

#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <optional>

namespace rt {

namespace {

/// The expected picture as it would be if the mistake had been made.
struct Transformation {
    const char* cause;
    const char* words;  ///< behind "the picture is the expected one"
    std::function<Color(const ColorPicture& expected, int x, int y)> color;
};

const Transformation transformations[] = {
    {"mirrored", "mirrored left to right", [](const ColorPicture& e, int x, int y) { return e.at(mirrored_place(e, x, y)); }},
    {"upside down", "with its rows from bottom to top", [](const ColorPicture& e, int x, int y) { return e.at(x, e.height - 1 - y); }},
    {"turned by 180 degrees", "turned by 180 degrees",
     [](const ColorPicture& e, int x, int y) { return e.at(e.width - 1 - x, e.height - 1 - y); }},
    {"channels swapped", "with red and blue swapped",
     [](const ColorPicture& e, int x, int y) {
         return Color{e.at(x, y)[2], e.at(x, y)[1], e.at(x, y)[0]};
     }},
    {"channels swapped", "with red and green swapped",
     [](const ColorPicture& e, int x, int y) {
         return Color{e.at(x, y)[1], e.at(x, y)[0], e.at(x, y)[2]};
     }},
    {"channels swapped", "with green and blue swapped",
     [](const ColorPicture& e, int x, int y) {
         return Color{e.at(x, y)[0], e.at(x, y)[2], e.at(x, y)[1]};
     }},
    {"channels swapped", "with green, blue, red in the place of red, green, blue",
     [](const ColorPicture& e, int x, int y) {
         return Color{e.at(x, y)[1], e.at(x, y)[2], e.at(x, y)[0]};
     }},
    {"channels swapped", "with blue, red, green in the place of red, green, blue",
     [](const ColorPicture& e, int x, int y) {
         return Color{e.at(x, y)[2], e.at(x, y)[0], e.at(x, y)[1]};
     }},
    {"negative", "with each value v as 1 - v",
     [](const ColorPicture& e, int x, int y) {
         return Color{1.0f - e.at(x, y)[0], 1.0f - e.at(x, y)[1], 1.0f - e.at(x, y)[2]};
     }},
};

Finding judged(const Transformation& t, const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    Misfit left;
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) left.add(apart(t.color(expected, x, y), actual.at(x, y)));
    return {t.cause, fmt::format("the picture is the expected one {}: {}", t.words, pixels_left(left, whole, actual)),
            share_left(left, whole)};
}

/// A picture of one colour explains itself, and nothing else does.
std::optional<Finding> single_color(const ColorPicture& actual) {
    const Color first = actual.pixels.front();
    if (std::any_of(actual.pixels.begin(), actual.pixels.end(), [&](const Color& c) { return apart(c, first) > 1.5f / 255.0f; }))
        return std::nullopt;
    if (apart(first, Color{}) <= 1.5f / 255.0f) return Finding{"black", "every pixel is black", 0.0, -0.1};
    return Finding{"one colour",
                   fmt::format("every pixel is ({:.0f}, {:.0f}, {:.0f}): nothing but a background", 255.0f * first[0], 255.0f * first[1],
                               255.0f * first[2]),
                   0.0, -0.1};
}

/// Right down to some row and of one colour below it, or from some row on.
std::optional<Finding> unfinished(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    const auto row_is = [&](int y, const Color& color) {
        for (int x = 0; x < actual.width; ++x)
            if (apart(actual.at(x, y), color) > 1.5f / 255.0f) return false;
        return true;
    };
    int top = 0, bottom = actual.height;
    while (bottom > 0 && row_is(bottom - 1, actual.at(0, actual.height - 1))) --bottom;
    while (top < actual.height && row_is(top, actual.at(0, 0))) ++top;
    const auto outside = [&](int first, int last) {
        Misfit left;
        for (int y = first; y < last; ++y)
            for (int x = 0; x < actual.width; ++x) left.add(apart(expected.at(x, y), actual.at(x, y)));
        return left;
    };
    const bool below = actual.height - bottom >= top;
    const int rows = below ? actual.height - bottom : top;
    // Plain rows that are as expected do not count: most pictures have some.
    const Misfit left = below ? outside(0, bottom) : outside(top, actual.height);
    if (rows == 0 || rows == actual.height) return std::nullopt;
    return Finding{"unfinished",
                   fmt::format("the {} {} of {} rows are of one colour, and in the others {:.0f} of {:.0f} differing pixels lie",
                               below ? "lower" : "upper", rows, actual.height, left.differing, whole.differing),
                   share_left(left, whole), 0.05};
}

}  // namespace

Misfit misfit(const ColorPicture& predicted, const ColorPicture& actual) {
    Misfit sum;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) sum.add(apart(predicted.pixels[i], actual.pixels[i]));
    return sum;
}

std::string pixels_left(const Misfit& left, const Misfit& whole, const ColorPicture& picture) {
    return fmt::format("{:.0f} of {} pixels differ then, {:.0f} as it is", left.differing, picture.pixels.size(), whole.differing);
}

std::vector<Finding> picture_findings(const ColorPicture& expected, const ColorPicture& actual) {
    std::vector<Finding> findings;
    const Misfit whole = misfit(expected, actual);
    if (!(whole.squares > 0.0)) return findings;
    if (std::optional<Finding> plain = single_color(actual)) findings.push_back(std::move(*plain));
    for (const Transformation& t : transformations) findings.push_back(judged(t, expected, actual, whole));
    for (const auto part : {tone_findings, shift_findings, grain_findings}) {
        std::vector<Finding> more = part(expected, actual, whole);
        findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    if (std::optional<Finding> rows = unfinished(expected, actual, whole)) findings.push_back(std::move(*rows));
    std::erase_if(findings, [](const Finding& finding) { return finding.left > 0.9; });
    return findings;
}

}  // namespace rt
