#include "commands/trade/trade_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "commands/base/content_hash.h"
#include "commands/base/json_text.h"
#include "commands/base/json_value.h"
#include "core/source.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* record_name = "record.json";
constexpr const char* film_name = "film";
constexpr std::size_t most_store_bytes = std::size_t{1} << 36;

/// Of times, errors and numbers of samples.
double amount(const JsonValue& value) { return value.number_in(0.0, std::numeric_limits<double>::max()); }

Json seconds_json(const Phases& p) { return {p.build, p.trace, p.write}; }

Phases seconds_of(const JsonValue& value) {
    if (value.size() != 3) value.fail("three numbers");
    return {.parse = 0.0, .build = amount(value.item(0)), .trace = amount(value.item(1)), .write = amount(value.item(2))};
}

Json json_of(const Measured& m) {
    Json runs = Json::array();
    for (const Timing& run : m.runs) runs.push_back({{"wall", seconds_json(run.wall)}, {"cpu", seconds_json(run.cpu)}});
    return {{"runs", runs},
            {"rays", {m.rays.camera, m.rays.shadow, m.rays.reflected, m.rays.refracted, m.rays.edge}},
            {"non_finite", m.non_finite},
            {"error", {m.error.rmse, m.error.p99, m.error.max, m.error.flip}},
            {"picture", m.picture}};
}

Measured measured_of(const JsonValue& value) {
    Measured m;
    for (std::size_t i = 0; i < value["runs"].size(); ++i) {
        const JsonValue run = value["runs"].item(i);
        m.runs.push_back({seconds_of(run["wall"]), seconds_of(run["cpu"])});
    }
    const JsonValue rays = value["rays"], error = value["error"];
    if (rays.size() != 5) rays.fail("five numbers");
    if (error.size() != 4) error.fail("four numbers");
    const auto count = [&](std::size_t i) { return static_cast<std::uint64_t>(amount(rays.item(i))); };
    m.rays = {count(0), count(1), count(2), count(3), count(4)};
    m.non_finite = static_cast<std::uint64_t>(amount(value["non_finite"]));
    m.error = {amount(error.item(0)), amount(error.item(1)), amount(error.item(2)), amount(error.item(3))};
    m.picture = value["picture"].word();
    return m;
}

Json json_of(const ReferenceFacts& facts) {
    return {{"grids", facts.grids}, {"samples", facts.samples}, {"error", facts.error}, {"seconds", facts.seconds}};
}

ReferenceFacts facts_of(const JsonValue& value) {
    ReferenceFacts facts;
    for (std::size_t i = 0; i < value["grids"].size(); ++i) facts.grids.push_back(static_cast<int>(value["grids"].item(i).count()));
    facts.samples = amount(value["samples"]), facts.error = amount(value["error"]), facts.seconds = amount(value["seconds"]);
    return facts;
}

Json json_of(const KnownSetting& known) {
    Json values = Json::array();
    for (const std::size_t value : known.setting.values) values.push_back(value == as_stated ? Json() : Json(value));
    return {{"values", values},
            {"origin", name_of(origin_names, known.origin)},
            {"too_slow", known.too_slow},
            {"expected_seconds", known.expected_seconds}};
}

KnownSetting known_setting_of(const JsonValue& value) {
    KnownSetting known;
    for (std::size_t i = 0; i < value["values"].size(); ++i) {
        const JsonValue place = value["values"].item(i);
        known.setting.values.push_back(place.is_null() ? as_stated : place.count());
    }
    known.origin = value["origin"].name(origin_names, "reason for a setting"), known.too_slow = value["too_slow"].truth();
    known.expected_seconds = amount(value["expected_seconds"]);
    return known;
}

UnstableCount unstable_of(const JsonValue& value) {
    UnstableCount unstable{static_cast<std::uint64_t>(amount(value["pixels"])), {}};
    const JsonValue causes = value["by_cause"];
    if (causes.size() != unstable_causes) causes.fail("a number for each cause");
    for (std::size_t i = 0; i < unstable_causes; ++i) unstable.by_cause[i] = static_cast<std::uint64_t>(amount(causes.item(i)));
    return unstable;
}

/// What `read` makes of a JSON text; nothing if the text is not what we write.
template <typename Read>
auto read_record(const std::string& text, const Read& read) -> std::optional<decltype(read(std::declval<JsonValue>()))> {
    Sources sources;
    sources.add({record_name, text});
    try {
        const nlohmann::json json = parse_json(sources);
        return read(JsonValue(sources, json));
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

}  // namespace

TradeStore::TradeStore(const std::string& folder, std::string content, bool fresh)
    : entries_(folder), content_(std::move(content)), fresh_(fresh) {}

std::string TradeStore::key(const char* kind, const std::string& words) const {
    return hash_of(fmt::format("raytrace trade 2\n{}\n{}\n{}", content_, kind, words));
}

std::optional<std::string> TradeStore::text(const std::string& key, const std::string& name) const {
    if (fresh_ && std::find(put_.begin(), put_.end(), key) == put_.end()) return std::nullopt;
    const std::string path = entries_.path(key, name);
    return path.empty() ? std::nullopt : read_file_text(path, most_store_bytes);
}

std::optional<KnownReference> TradeStore::reference(const std::string& words, int width, int height) const {
    const std::string entry = key("reference", words);
    const std::optional<std::string> record = text(entry, record_name), film = text(entry, film_name);
    KnownReference known{{}, Film(width, height)};
    const std::size_t bytes = known.film.pixels.size() * sizeof(Pixel);
    if (!record || !film || film->size() != bytes) return std::nullopt;
    const std::string hash = hash_of(*film);
    const auto read = [&](const JsonValue& value) {
        if (value["film"].word() != hash) value["film"].fail("the fingerprint of the film");
        return facts_of(value);
    };
    const std::optional<ReferenceFacts> facts = read_record(*record, read);
    if (!facts) return std::nullopt;
    known.facts = *facts;
    std::memcpy(known.film.pixels.data(), film->data(), bytes);
    return known;
}

void TradeStore::put_reference(const std::string& words, const KnownReference& reference) const {
    const std::string entry = key("reference", words);
    const std::string film(reinterpret_cast<const char*>(reference.film.pixels.data()), reference.film.pixels.size() * sizeof(Pixel));
    Json facts = json_of(reference.facts);
    facts["film"] = hash_of(film);
    entries_.put(entry, {{record_name, json_text(facts, 1)}, {film_name, film}});
    put_.push_back(entry);
}

std::optional<Measured> TradeStore::measured(const std::string& words) const {
    const std::optional<std::string> record = text(key("setting", words), record_name);
    return record ? read_record(*record, measured_of) : std::nullopt;
}

void TradeStore::put_measured(const std::string& words, const Measured& measured) const {
    const std::string entry = key("setting", words);
    entries_.put(entry, {{record_name, json_text(json_of(measured), 1)}});
    put_.push_back(entry);
}

std::vector<KnownSetting> TradeStore::settings() const {
    const auto read = [](const JsonValue& value) {
        std::vector<KnownSetting> list;
        for (std::size_t i = 0; i < value.size(); ++i) list.push_back(known_setting_of(value.item(i)));
        return list;
    };
    const std::optional<std::string> record = text(key("settings", ""), record_name);
    return record ? read_record(*record, read).value_or(std::vector<KnownSetting>()) : std::vector<KnownSetting>();
}

void TradeStore::put_settings(const std::vector<KnownSetting>& settings) const {
    const std::string entry = key("settings", "");
    Json list = Json::array();
    for (const KnownSetting& known : settings) list.push_back(json_of(known));
    entries_.put(entry, {{record_name, json_text(list, 1)}});
    put_.push_back(entry);
}

std::optional<UnstableCount> TradeStore::unstable(const std::string& words) const {
    const std::optional<std::string> record = text(key("unstable", words), record_name);
    return record ? read_record(*record, unstable_of) : std::nullopt;
}

void TradeStore::put_unstable(const std::string& words, const UnstableCount& unstable) const {
    const std::string entry = key("unstable", words);
    entries_.put(entry, {{record_name, json_text({{"pixels", unstable.pixels}, {"by_cause", unstable.by_cause}}, 1)}});
    put_.push_back(entry);
}

std::optional<double> TradeStore::size(const std::string& words) const { return number("size", words, "share"); }
void TradeStore::put_size(const std::string& words, double share) const { put_number("size", words, "share", share); }

std::optional<double> TradeStore::alone(const std::string& words) const { return number("alone", words, "rmse"); }
void TradeStore::put_alone(const std::string& words, double rmse) const { put_number("alone", words, "rmse", rmse); }

std::optional<double> TradeStore::number(const char* kind, const std::string& words, const char* name) const {
    const std::optional<std::string> record = text(key(kind, words), record_name);
    return record ? read_record(*record, [&](const JsonValue& value) { return amount(value[name]); }) : std::nullopt;
}

void TradeStore::put_number(const char* kind, const std::string& words, const char* name, double value) const {
    const std::string entry = key(kind, words);
    entries_.put(entry, {{record_name, json_text({{name, value}}, 1)}});
    put_.push_back(entry);
}

}  // namespace rt
