#include "commands/grade/audit.h"

#include <fmt/format.h>

#include <functional>

#include "commands/base/values.h"
#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/job/test_job.h"
#include "commands/report/result_json.h"
#include "grading/judge.h"
#include "grading/mutations.h"
#include "syntax/file_text.h"
#include "trace/render.h"

namespace rt {

namespace {

constexpr std::size_t most_audit_bytes = 1u << 28;

struct WrongPicture {
    StoredImage image;
    bool same;  ///< as the right one: the mistake changes nothing in it
};

struct PictureMistake {
    const char* name;
    /// Empty if it cannot be made for this test.
    std::function<std::optional<WrongPicture>(const Suite& suite, const TestCase& test, const StoredImage& right)> make;
};

PictureMistake by_picture(const char* name, StoredImage (*change)(const StoredImage& right)) {
    return {name, [change](const Suite&, const TestCase&, const StoredImage& right) {
                StoredImage image = change(right);
                const bool same = image.values == right.values;
                return std::optional(WrongPicture{std::move(image), same});
            }};
}

StoredImage rendered(const RenderJob& job, const Scene& scene) {
    const World world = build_world(job, scene, message_sink(true));
    const RenderResult result = render(world, render_options(job, scene));
    Encoding encoding = encoding_of(job, scene.settings.gamma);
    encoding.bits = 8;
    StoredImage image{job.width, job.height, 3, 255, {}};
    for (const Pixel& p : result.film.pixels)
        for (const float channel : {p.r, p.g, p.b}) image.values.push_back(static_cast<float>(quantise(channel, encoding)));
    return image;
}

/// Our own picture of a test with one thing changed. None if the test is no render of ours, or one of random light, which takes long.
PictureMistake by_scene(const char* name, bool (*change)(RenderJob& job, Scene& scene)) {
    return {name, [change](const Suite& suite, const TestCase& test, const StoredImage&) -> std::optional<WrongPicture> {
                try {
                    std::optional<RenderJob> job = job_of_test(test.arguments, suite.inputs);
                    if (!job || !job->course->indirect_samples.empty()) return std::nullopt;
                    job->threads = 0;
                    Scene scene = read_scene(*job, message_sink(true));
                    const StoredImage ours = rendered(*job, scene);
                    if (!change(*job, scene)) return std::nullopt;
                    StoredImage image = rendered(*job, scene);
                    const bool same = image.values == ours.values;
                    return WrongPicture{std::move(image), same};
                } catch (const std::runtime_error&) {  // a scene or an option that is not ours
                    return std::nullopt;
                }
            }};
}

bool drop_shadows(RenderJob& job, Scene& scene) {
    for (Object& object : scene.objects) object.no_shadow = true;
    return job.course->show == CourseShow::shaded;
}

bool drop_antialiasing(RenderJob& job, Scene&) {
    const bool smooth = job.sampling.method == Sampling::Method::grid && job.sampling.depth > 1;
    job.sampling = {};
    return smooth;
}

const std::vector<PictureMistake>& picture_mistakes() {
    static const std::vector<PictureMistake> mistakes{
        by_picture("5 % darker", [](const StoredImage& right) { return scaled(right, 0.95); }),
        by_picture("mirrored", [](const StoredImage& right) { return mirrored(right); }),
        by_picture("moved by a pixel", [](const StoredImage& right) { return shifted(right, 1, 0); }),
        by_scene("without shadows", drop_shadows), by_scene("without anti-aliasing", drop_antialiasing)};
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

std::vector<std::string> some_of(const std::vector<std::string>& names) {
    std::vector<std::string> lines;
    for (const std::string& name : names) lines.push_back(printable(name, 200));
    return lines;
}

StoredImage right_picture(const TestCase& test) {
    try {
        return read_image(test.expected);
    } catch (const OptionError& error) {
        throw OptionError(fmt::format("test '{}': the expected picture: {}", printable(test.name, 200), printable(error.what())));
    }
}

void audit_picture(const Suite& suite, const TestCase& test, std::vector<AuditLine>& lines) {
    const StoredImage right = right_picture(test);
    for (std::size_t i = 0; i < picture_mistakes().size(); ++i) {
        const std::optional<WrongPicture> wrong = picture_mistakes()[i].make(suite, test, right);
        if (!wrong) continue;
        const Result result = judge_picture(test, good_ending(""), {Written::State::picture, "", wrong->image}, right);
        note(lines[i], test, result, wrong->same);
    }
}

void audit_text(const TestCase& test, AuditLine& line) {
    const std::optional<std::string> right = read_file_text(test.expected, most_audit_bytes);
    if (!right)
        throw OptionError(
            fmt::format("test '{}': cannot read the expected text '{}'", printable(test.name, 200), printable(test.expected)));
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
        text += fmt::format("{:<24}", line.mistake);
        text += all ? fmt::format("{:>4} of {:>3} tests notice it", line.noticed, all) : "   no test has it";
        if (!line.blind.empty()) text += fmt::format("; blind: {}", fmt::join(some_of(line.blind), " "));
        if (!line.unmoved.empty()) text += fmt::format("; it changes nothing in: {}", fmt::join(some_of(line.unmoved), " "));
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
