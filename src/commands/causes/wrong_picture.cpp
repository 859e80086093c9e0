#include "commands/causes/wrong_picture.h"

#include <fmt/format.h>

#include <iterator>

#include "commands/causes/scene_causes.h"
#include "grading/picture_causes.h"

namespace rt {

namespace {

/// The picture of another test, given for this one.
std::optional<Finding> of_another_test(const Suite& suite, const TestCase& test, const ColorPicture& expected, const ColorPicture& actual) {
    constexpr std::size_t most_tests = 64;
    const Misfit whole = misfit(expected, actual);
    std::optional<Finding> best;
    std::size_t looked_at = 0;
    for (const TestCase& other : suite.tests) {
        if (other.kind != TestCase::Kind::picture || other.expected == test.expected || ++looked_at > most_tests) continue;
        ColorPicture picture;
        try {
            picture = color_picture(read_image(other.expected));
        } catch (const std::runtime_error&) {  // it is that test's problem
            continue;
        }
        if (picture.width != actual.width || picture.height != actual.height) continue;
        const Misfit left = misfit(picture, actual);
        Finding found{"picture of another test", fmt::format("the picture is that of {}: {}", other.name, pixels_left(left, whole, actual)),
                      share_left(left, whole)};
        if (!best || found.left < best->left) best = std::move(found);
    }
    return best;
}

void add(std::vector<Finding>& findings, std::vector<Finding> more) {
    findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Verdicts cause_of(const Suite& suite, const TestCase& test, const StoredImage& expected_image, const StoredImage& actual_image) {
    const ColorPicture expected = color_picture(expected_image), actual = color_picture(actual_image);
    std::vector<Finding> findings = picture_findings(expected, actual);
    if (std::optional<Finding> other = of_another_test(suite, test, expected, actual); other && other->left <= 0.9)
        findings.push_back(std::move(*other));
    // What treats all pixels alike so well has nothing to do with the scene.
    constexpr double clear = 0.02;
    const bool known = std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.left + f.freedom <= clear; });
    if (!known)
        if (const std::optional<SceneSamples> samples = SceneSamples::read(test.arguments, suite.inputs, expected, actual))
            add(findings, scene_findings(*samples, roughness_of(expected, actual)));
    return choose(std::move(findings));
}

}  // namespace rt
