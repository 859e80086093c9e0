#include "commands/versus/versus_json.h"

#include "commands/report/result_json.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

Json likeness_json(const Likeness& like) {
    Json json = {{"agrees", like.agrees}, {"beyond", like.beyond}, {"figures", figures_json(like.figures)}};
    if (like.region) json["region"] = region_json(*like.region), json["povray"] = like.theirs, json["ours"] = like.ours;
    return json;
}

std::array<int, 3> colour_of(const JsonValue& value) {
    std::array<int, 3> colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) colour[i] = static_cast<int>(value.item(i).count());
    return colour;
}

Likeness likeness_of_json(const JsonValue& value) {
    Likeness like;
    like.agrees = value["agrees"].truth(), like.beyond = value["beyond"].count(), like.figures = figures_of(value["figures"]);
    if (value.has("region"))
        like.region = region_of(value["region"]), like.theirs = colour_of(value["povray"]), like.ours = colour_of(value["ours"]);
    return like;
}

Json missing_json(const std::vector<MissingFeature>& missing) {
    Json list = Json::array();
    for (const MissingFeature& m : missing) list.push_back({{"name", m.name}, {"file", m.file}, {"line", m.line}, {"column", m.column}});
    return list;
}

std::uint64_t big_count(const JsonValue& value) { return static_cast<std::uint64_t>(value.number()); }

}  // namespace

Json run_json(const VersusRun& run) {
    Json json = {{"state", name_of(run_state_names, run.state)}, {"command", run.command}};
    if (!run.message.empty()) json["message"] = run.message;
    if (run.state == VersusRun::State::done) json["rays"] = run.rays, json["shadow_tests"] = run.shadow_tests;
    return json;
}

Json run_times_json(const VersusRun& run) {
    return {{"wall", run.wall_seconds},      {"cpu", run.cpu_seconds},    {"parse", run.phases.parse},
            {"build", run.phases.build},     {"trace", run.phases.trace}, {"write", run.phases.write},
            {"peak", run.peak_memory_bytes}, {"threads", run.threads},    {"alone", run.alone}};
}

VersusRun run_of_json(const JsonValue& value, const JsonValue& times) {
    VersusRun run;
    run.state = value["state"].name(run_state_names, "state of a run");
    for (std::size_t i = 0; i < value["command"].size(); ++i) run.command.push_back(value["command"].item(i).word());
    if (value.has("message")) run.message = value["message"].word();
    if (value.has("rays")) run.rays = big_count(value["rays"]), run.shadow_tests = big_count(value["shadow_tests"]);
    run.wall_seconds = times["wall"].number(), run.cpu_seconds = times["cpu"].number();
    run.phases = {times["parse"].number(), times["build"].number(), times["trace"].number(), times["write"].number()};
    run.peak_memory_bytes = big_count(times["peak"]);
    run.threads = static_cast<int>(times["threads"].count()), run.alone = times["alone"].truth();
    return run;
}

Json versus_json(const VersusResult& result) {
    Json json = {{"scene", result.name}, {"path", result.path}, {"cause", name_of(cause_names, result.cause)}};
    if (!result.missing.empty()) json["not_modelled"] = missing_json(result.missing);
    for (const auto& [name, maker] : maker_names) {
        json[std::string(name)] = run_json(result.run(maker));
        if (result.like(maker)) json[std::string(name)]["likeness"] = likeness_json(*result.like(maker));
    }
    return json;
}

Json versus_times_json(const VersusResult& result) {
    Json json = {{"scene", result.name}};
    for (const auto& [name, maker] : maker_names) json[std::string(name)] = run_times_json(result.run(maker));
    return json;
}

VersusResult versus_of_json(const JsonValue& value, const JsonValue& times) {
    VersusResult result;
    result.name = value["scene"].word(), result.path = value["path"].word(), result.cause = value["cause"].name(cause_names, "cause");
    if (value.has("not_modelled")) {
        const JsonValue list = value["not_modelled"];
        for (std::size_t i = 0; i < list.size(); ++i) {
            const JsonValue m = list.item(i);
            result.missing.push_back({m["name"].word(), m["file"].word(), m["line"].count(), m["column"].count()});
        }
    }
    for (const auto& [name, maker] : maker_names) {
        const JsonValue run = value[std::string(name).c_str()];
        result.run(maker) = run_of_json(run, times[std::string(name).c_str()]);
        if (run.has("likeness")) result.like(maker) = likeness_of_json(run["likeness"]);
    }
    return result;
}

}  // namespace rt
