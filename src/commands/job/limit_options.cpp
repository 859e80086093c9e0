#include "commands/job/limit_options.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <vector>

#include "commands/base/suggest.h"
#include "commands/base/values.h"
#include "core/source.h"
#include "syntax/limits.h"

namespace rt {

namespace {

constexpr std::string_view units = "kmg";

std::uint64_t step(const SceneLimit& limit) { return limit.bytes ? 1024 : 1000; }

const SceneLimit& limit_of(std::string_view name) {
    std::vector<std::string> names;
    for (const SceneLimit& limit : scene_limits()) {
        if (limit.name == name) return limit;
        names.emplace_back(limit.name);
    }
    throw OptionError(fmt::format("--limit: there is none of the name '{}'{}; see raytrace help limits", name, did_you_mean(name, names)));
}

/// Nothing for what is no such number or does not fit 64 bits.
std::optional<std::uint64_t> number_of(const SceneLimit& limit, const std::string& text) {
    std::uint64_t value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    if (error != std::errc() || last - end > 1) return std::nullopt;
    if (end == last) return value;
    const std::size_t unit = units.find(*end);
    if (unit == units.npos) return std::nullopt;
    for (std::size_t i = 0; i <= unit; ++i)
        if (__builtin_mul_overflow(value, step(limit), &value)) return std::nullopt;
    return value;
}

/// As it can be written behind the equals sign, to two digits at least.
std::string short_text(const SceneLimit& limit, std::uint64_t value) {
    std::size_t unit = 0;
    for (; unit < units.size() && value >= step(limit) && (value % step(limit) == 0 || value >= 10 * step(limit)); ++unit)
        value /= step(limit);
    return unit == 0 ? fmt::format("{}", value) : fmt::format("{}{}", value, "kMG"[unit - 1]);
}

}  // namespace

void set_limit(ParseOptions& parse, std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos) throw OptionError(fmt::format("--limit: expected NAME=N, not '{}'", printable(text, 100)));
    const SceneLimit& limit = limit_of(text.substr(0, equals));
    const std::string value = lower_case(text.substr(equals + 1));
    const std::optional<std::uint64_t> number = number_of(limit, value);
    if (!number || *number < 1 || *number > limit.highest)
        throw OptionError(fmt::format("--limit {}: '{}' is no whole number from 1 to {}; k, M or G may stand behind it", limit.name,
                                      printable(text.substr(equals + 1), 100), limit.highest));
    set_value(limit, parse, *number);
}

const std::string& limits_topic() {
    static const std::string topic = [] {
        std::string text =
            "raytrace scene.pov --limit macro-depth=50k --limit memory=8G\n\n"
            "What a scene may ask for; more ends the program with status 4.\n\n";
        const ParseOptions defaults;
        for (const SceneLimit& limit : scene_limits()) {
            const std::string words = limit.standard.empty() ? "" : fmt::format(": {}", limit.standard);
            const std::string value = words.empty() ? short_text(limit, value_of(limit, defaults)) : "";
            text += fmt::format("{:<18} {:>5}  {}{}\n", limit.name, value, limit.meaning, words);
        }
        return text +
               "\nFixed: arrays in arrays 100 deep, functions that call each other 100 deep, sets\n"
               "in sets 1000 deep. Deeper nesting may need a larger stack (ulimit -s).\n";
    }();
    return topic;
}

}  // namespace rt
