#include "commands/report/result_json.h"

#include <fmt/format.h>

#include <cmath>

#include "grading/result_names.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

Json text_json(const TextDifference& text) {
    Json json = {{"line", text.line},
                 {"field", text.field},
                 {"expected", text.expected},
                 {"actual", text.actual},
                 {"expected_line", text.expected_line},
                 {"actual_line", text.actual_line}};
    if (text.apart && std::isfinite(*text.apart)) json["apart"] = *text.apart;
    return json;
}

TextDifference text_of(const JsonValue& value) {
    TextDifference text{value["line"].count(),
                        value["field"].count(),
                        value["expected_line"].word(),
                        value["actual_line"].word(),
                        value["expected"].word(),
                        value["actual"].word(),
                        std::nullopt};
    if (value.has("apart")) text.apart = value["apart"].number();
    return text;
}

}  // namespace

Json figures_json(const PictureFigures& figures) {
    Json json = {{"pixels", figures.pixels}, {"fuzz", figures.fuzz_percent}};
    for (const auto& [name, metric] : metric_names) json[std::string(name)] = figures[metric];
    return json;
}

PictureFigures figures_of(const JsonValue& value) {
    PictureFigures figures;
    figures.pixels = value["pixels"].count(), figures.fuzz_percent = value["fuzz"].number();
    for (const auto& [name, metric] : metric_names) figures[metric] = value[std::string(name).c_str()].number();
    return figures;
}

Json region_json(const DifferingRegion& r) { return {{"pixels", r.pixels}, {"box", {r.x0, r.y0, r.x1, r.y1}}, {"pixel", {r.x, r.y}}}; }

DifferingRegion region_of(const JsonValue& value) {
    const auto whole = [](const JsonValue& v) { return static_cast<int>(v.count()); };
    const JsonValue box = value["box"], pixel = value["pixel"];
    if (box.size() != 4) box.fail("four numbers");
    if (pixel.size() != 2) pixel.fail("two numbers");
    return {value["pixels"].count(), whole(box.item(0)),   whole(box.item(1)),  whole(box.item(2)),
            whole(box.item(3)),      whole(pixel.item(0)), whole(pixel.item(1))};
}

Json result_json(const Result& result) {
    Json json = {{"submission", result.submission}, {"test", result.test},     {"kind", name_of(kind_names, result.kind)},
                 {"required", result.required},     {"weight", result.weight}, {"outcome", name_of(outcome_names, result.outcome)},
                 {"credit", result.credit},         {"status", result.status}};
    const auto put = [&](const char* name, const std::string& text) {
        if (!text.empty()) json[name] = text;
    };
    put("reason", result.reason);
    if (result.figures) json["figures"] = figures_json(*result.figures);
    if (result.region) json["region"] = region_json(*result.region);
    if (result.text) json["text"] = text_json(*result.text);
    put("cause", result.cause);
    put("explanation", result.explanation);
    put("output", result.output);
    if (result.left_processes) json["left_processes"] = true;
    return json;
}

Json times_json(const Result& result) {
    Json json = {{"alone", result.alone},
                 {"wall", result.wall_seconds},
                 {"cpu", result.cpu_seconds},
                 {"spread", result.spread_seconds},
                 {"peak", result.peak_memory_bytes}};
    if (result.busy_threads > 0) json["busy"] = result.busy_threads;
    return json;
}

Result result_of_json(const JsonValue& value) {
    Result result;
    result.submission = value["submission"].word(), result.test = value["test"].word();
    result.kind = value["kind"].name(kind_names, "kind of test");
    result.required = value["required"].truth(), result.weight = value["weight"].number();
    result.outcome = value["outcome"].name(outcome_names, "outcome");
    result.credit = value["credit"].number(), result.status = static_cast<int>(value["status"].number());
    const auto take = [&](const char* name, std::string& text) {
        if (value.has(name)) text = value[name].word();
    };
    take("reason", result.reason), take("cause", result.cause), take("explanation", result.explanation), take("output", result.output);
    if (value.has("figures")) result.figures = figures_of(value["figures"]);
    if (value.has("region")) result.region = region_of(value["region"]);
    if (value.has("text")) result.text = text_of(value["text"]);
    if (value.has("left_processes")) result.left_processes = value["left_processes"].truth();
    return result;
}

void read_times(const JsonValue& value, Result& result) {
    result.alone = value["alone"].truth();
    result.wall_seconds = value["wall"].number(), result.cpu_seconds = value["cpu"].number();
    result.spread_seconds = value["spread"].number();
    if (value.has("busy")) result.busy_threads = static_cast<int>(value["busy"].number_in(0, 1e6));
    result.peak_memory_bytes = static_cast<std::uint64_t>(value["peak"].number());
}

std::string json_listing(const Json& head, const char* list, const std::vector<Json>& entries) {
    std::string text = "{";
    for (const auto& [name, value] : head.items()) text += fmt::format("\n \"{}\": {},", name, json_line(value));
    text += fmt::format("\n \"{}\": [", list);
    for (std::size_t i = 0; i < entries.size(); ++i) text += fmt::format("{}\n  {}", i ? "," : "", json_line(entries[i]));
    return text + "\n ]\n}\n";
}

}  // namespace rt
