#include "commands/job/requirements_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands/base/json_text.h"
#include "commands/job/missing_counts.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

std::string counts_text(const std::map<std::string, std::size_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    return text.empty() ? "none" : text;
}

std::string list_text(const std::vector<std::string>& list) { return list.empty() ? "none" : fmt::format("{}", fmt::join(list, ", ")); }

std::string text_of(const std::string& scene, const Requirements& needs) {
    std::string text = fmt::format("{}\n", scene);
    text += fmt::format("  objects:   {} ({})\n", needs.objects, counts_text(needs.shapes));
    text += fmt::format("  triangles: {}\n", needs.triangles);
    text += fmt::format("  lights:    {}\n", counts_text(needs.lights));
    text += fmt::format("  camera:    {}\n", needs.camera);
    text += fmt::format("  gamma:     {}\n", needs.gamma);
    text += fmt::format("  language:  {}\n", needs.language_version > 0.0 ? fmt::format("{}", needs.language_version) : "not stated");
    text += fmt::format("  features:  {}\n", list_text(needs.features));
    text += fmt::format("  includes:  {}\n", list_text(needs.includes));
    if (needs.missing.empty()) return text + "  not modelled: nothing\n";
    text += "  not modelled:\n";
    for (const MissingFeature& missing : needs.missing)
        text += fmt::format("    {}:{}:{}: {}\n", missing.file, missing.line, missing.column, missing.name);
    return text;
}

Json json_of(const std::string& scene, const Requirements& needs) {
    Json missing = Json::array();
    for (const MissingFeature& m : needs.missing)
        missing.push_back({{"name", m.name}, {"file", m.file}, {"line", m.line}, {"column", m.column}});
    return {{"scene", scene},
            {"objects", needs.objects},
            {"shapes", needs.shapes},
            {"triangles", needs.triangles},
            {"lights", needs.lights},
            {"camera", needs.camera},
            {"gamma", needs.gamma},
            {"language_version", needs.language_version},
            {"features", needs.features},
            {"includes", needs.includes},
            {"not_modelled", missing}};
}

struct Summary {
    std::size_t complete = 0, incomplete = 0, unread = 0;
};

Summary summary_of(const std::vector<SceneReading>& readings) {
    Summary summary;
    for (const SceneReading& reading : readings)
        ++(reading.status != 0 ? summary.unread : reading.missing.empty() ? summary.complete : summary.incomplete);
    return summary;
}

MissingOfScenes missing_of(const std::vector<SceneReading>& readings) {
    MissingOfScenes missing;
    for (const SceneReading& reading : readings) missing.push_back(reading.missing);
    return missing;
}

}  // namespace

SceneReading reading_of(const std::string& scene, const Requirements& needs) {
    return {scene, text_of(scene, needs), json_of(scene, needs), needs.missing, 0};
}

SceneReading failed_reading(const std::string& scene, const std::string& error, int status) {
    return {scene,
            fmt::format("{}\n  error: {}\n", scene, error.substr(0, error.find('\n'))),
            {{"scene", scene}, {"error", error}, {"status", status}},
            {},
            status};
}

std::string packed(const SceneReading& reading) {
    return json_line({{"json", reading.json}, {"status", reading.status}}) + "\n" + reading.text;  // which need not be UTF-8
}

SceneReading unpacked(const std::string& bytes) {
    const std::size_t end = bytes.find('\n');
    const Json head = Json::parse(bytes.substr(0, end));
    SceneReading reading{head["json"]["scene"], bytes.substr(end + 1), head["json"], {}, head["status"]};
    if (reading.status == 0)
        for (const Json& m : reading.json["not_modelled"]) reading.missing.push_back({m["name"], m["file"], m["line"], m["column"]});
    return reading;
}

std::string missing_text(const std::vector<SceneReading>& readings) {
    const Summary summary = summary_of(readings);
    std::string text;
    if (summary.incomplete > 0) {
        text += "what is not modelled, by gain         scenes that ask for it    for nothing else\n";
        for (const MissingCount& count : missing_counts(missing_of(readings)))
            text += fmt::format("  {:<38} {:>20} {:>19}\n", count.name, count.scenes, count.only_this);
        text += "one after the other                          scenes completed         then complete\n";
        std::size_t complete = summary.complete;
        for (const MissingStep& step : missing_order(missing_of(readings))) {
            complete += step.completes;
            text += fmt::format("  {:<38} {:>20} {:>19}\n", step.name, step.completes, fmt::format("{} of {}", complete, readings.size()));
        }
    }
    return text + fmt::format("{} of {} scenes miss nothing, {} miss something, {} could not be read\n", summary.complete, readings.size(),
                              summary.incomplete, summary.unread);
}

Json readings_json(const std::vector<SceneReading>& readings) {
    const Summary summary = summary_of(readings);
    Json counts = Json::array(), order = Json::array(), scenes = Json::array();
    for (const MissingCount& count : missing_counts(missing_of(readings)))
        counts.push_back({{"name", count.name}, {"scenes", count.scenes}, {"only_this", count.only_this}});
    for (const MissingStep& step : missing_order(missing_of(readings)))
        order.push_back({{"name", step.name}, {"completes", step.completes}});
    for (const SceneReading& reading : readings) scenes.push_back(reading.json);
    return {{"format", "raytrace requires 1"},
            {"summary", {{"complete", summary.complete}, {"incomplete", summary.incomplete}, {"unread", summary.unread}}},
            {"missing", counts},
            {"order", order},
            {"scenes", scenes}};
}

}  // namespace rt
