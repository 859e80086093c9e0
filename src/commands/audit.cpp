#include "commands/audit.h"

#include <fmt/format.h>

#include <functional>

#include "commands/result_json.h"
#include "grading/judge.h"
#include "grading/mutations.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

constexpr std::size_t most_bytes = 1u << 28;

struct PictureMistake {
    const char* name;
    /// The wrong picture; empty if it cannot be made for this test.
    std::function<std::optional<StoredImage>(const Suite& suite, const TestCase& test, const StoredImage& right)> make;
};

const std::vector<PictureMistake>& picture_mistakes() {
    static const std::vector<PictureMistake> mistakes{
        {"5 % darker", [](const Suite&, const TestCase&, const StoredImage& right) { return scaled(right, 0.95); }},
        {"mirrored", [](const Suite&, const TestCase&, const StoredImage& right) { return mirrored(right); }},
        {"moved by a pixel", [](const Suite&, const TestCase&, const StoredImage& right) { return shifted(right, 1, 0); }}};
    return mistakes;
}

Ending good_ending(std::string output) {
    Ending ending;
    ending.kind = Ending::Kind::exited, ending.output = std::move(output);
    return ending;
}

void note(AuditLine& line, const TestCase& test, const Result& result, bool same) {
    if (same)
        line.unmoved.push_back(test.name);
    else if (result.outcome == Outcome::passed)
        line.blind.push_back(test.name);
    else
        ++line.noticed;
}

void audit_picture(const Suite& suite, const TestCase& test, std::vector<AuditLine>& lines) {
    const StoredImage right = read_image(test.expected);
    for (std::size_t i = 0; i < picture_mistakes().size(); ++i) {
        const std::optional<StoredImage> wrong = picture_mistakes()[i].make(suite, test, right);
        if (!wrong) continue;
        const Result result = judge_picture(test, good_ending(""), {Written::State::picture, "", *wrong}, right);
        note(lines[i], test, result, wrong->values == right.values);
    }
}

void audit_text(const TestCase& test, AuditLine& line) {
    const std::optional<std::string> right = read_file_text(test.expected, most_bytes);
    if (!right) throw OptionError(fmt::format("cannot read '{}'", test.expected));
    const std::optional<std::string> wrong = one_digit_changed(*right);
    if (wrong) note(line, test, judge_text(test, good_ending(*wrong), *right), false);
}

}  // namespace

std::vector<AuditLine> audit(const Suite& suite) {
    std::vector<AuditLine> lines;
    for (const PictureMistake& mistake : picture_mistakes()) lines.push_back({mistake.name, {}, {}, 0});
    lines.push_back({"one digit changed", {}, {}, 0});
    for (const TestCase& test : suite.tests) {
        if (test.kind == TestCase::Kind::picture) audit_picture(suite, test, lines);
        if (test.kind == TestCase::Kind::text) audit_text(test, lines.back());
    }
    return lines;
}

std::string audit_text(const std::vector<AuditLine>& lines) {
    std::string text;
    for (const AuditLine& line : lines) {
        const std::size_t all = line.noticed + line.blind.size();
        text += fmt::format("{:<24}{:>4} of {:>3} tests notice it", line.mistake, line.noticed, all);
        if (!line.blind.empty()) text += fmt::format("; blind: {}", fmt::join(line.blind, " "));
        if (!line.unmoved.empty()) text += fmt::format("; it changes nothing in: {}", fmt::join(line.unmoved, " "));
        text += "\n";
    }
    return text;
}

std::string audit_json(const Suite& suite, const std::vector<AuditLine>& lines) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const AuditLine& line : lines)
        list.push_back({{"mistake", line.mistake}, {"noticed", line.noticed}, {"blind", line.blind}, {"unmoved", line.unmoved}});
    return json_text({{"format", "raytrace audit 1"}, {"suite", suite.name}, {"mistakes", list}}, 1);
}

}  // namespace rt
