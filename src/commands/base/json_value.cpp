#include "commands/base/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "commands/base/json_place.h"
#include "commands/base/values.h"

namespace rt {

namespace {

using nlohmann::json;

/// nlohmann's text begins with its own name and place: "[json.exception.parse_error.101] parse error at line 1, column 2: ".
std::string_view bare(std::string_view message) {
    const std::size_t place = message.find(": ");
    return place == message.npos ? message : message.substr(place + 2);
}

}  // namespace

json parse_json(const Sources& sources) {
    try {
        return json::parse(sources.file(0).text);
    } catch (const json::parse_error& error) {
        const auto at = static_cast<std::uint32_t>(error.byte > 0 ? error.byte - 1 : 0);
        throw SceneError(sources.describe({0, at, at + 1}, "Parse Error", bare(error.what())));
    } catch (const json::out_of_range& error) {  // a number beyond double precision: its digits are told, not their place
        const std::string_view message = error.what();
        const std::size_t begin = message.find('\'') + 1;
        const std::string_view digits = message.substr(begin, message.rfind('\'') - begin);
        const auto at = static_cast<std::uint32_t>(std::min(sources.file(0).text.find(digits), sources.file(0).text.size()));
        throw SceneError(sources.describe({0, at, at + static_cast<std::uint32_t>(digits.size())}, "Parse Error",
                                          fmt::format("Expected a number of double precision, {} found instead.", digits)));
    }
}

JsonValue JsonValue::operator[](const char* name) const {
    if (!content_->is_object()) fail("an object");
    if (!content_->contains(name)) fail(fmt::format("a member \"{}\"", name));
    return below((*content_)[name], name);
}

std::size_t JsonValue::size() const {
    if (!content_->is_array()) fail("a list");
    return content_->size();
}

JsonValue JsonValue::item(std::size_t index) const {
    if (index >= size()) fail(fmt::format("a list of {} or more values", index + 1));
    return below((*content_)[index], std::to_string(index));
}

void JsonValue::expect_only(std::initializer_list<std::string_view> known) const {
    if (!content_->is_object()) fail("an object");
    for (const auto& [name, value] : content_->items()) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        std::vector<std::string> path = path_;
        path.push_back(name);
        refuse(path, fmt::format("Unknown member \"{}\"; known are {}.", printable(name, 40), fmt::join(known, ", ")));
    }
}

double JsonValue::number() const {
    if (content_->is_number()) return content_->get<double>();
    if (*content_ == "Infinity") return std::numeric_limits<double>::infinity();
    if (*content_ == "-Infinity") return -std::numeric_limits<double>::infinity();
    if (*content_ == "NaN") return std::numeric_limits<double>::quiet_NaN();
    fail("a number, \"Infinity\", \"-Infinity\" or \"NaN\"");
}

double JsonValue::number_in(double least, double most) const {
    if (!content_->is_number() || !(content_->get<double>() >= least) || !(content_->get<double>() <= most))
        fail(fmt::format("a number from {} to {}", least, most));
    return content_->get<double>();
}

std::uint32_t JsonValue::count() const {
    if (!content_->is_number_unsigned() || content_->get<std::uint64_t>() > 0x7fffffffu) fail("a whole number");
    return content_->get<std::uint32_t>();
}

bool JsonValue::truth() const {
    if (!content_->is_boolean()) fail("true or false");
    return content_->get<bool>();
}

const std::string& JsonValue::word() const {
    if (!content_->is_string()) fail("a string");
    return content_->get_ref<const std::string&>();
}

Vec3 JsonValue::vector() const {
    if (size() != 3) fail("a list of three numbers");
    return {item(0).number(), item(1).number(), item(2).number()};
}

void JsonValue::fail(std::string_view expected) const {
    const std::string found = content_->dump(-1, ' ', false, json::error_handler_t::replace);
    refuse(path_, fmt::format("Expected {}, {} found instead.", expected, printable(found, 40)));
}

void JsonValue::refuse(const std::vector<std::string>& path, std::string_view text) const {
    const auto at = static_cast<std::uint32_t>(place_in_json(sources_->file(0).text, path));
    throw SceneError(sources_->describe({0, at, at + 1}, "Parse Error", text));
}

JsonValue JsonValue::below(const json& content, std::string key) const {
    JsonValue value(*sources_, content);
    value.path_ = path_;
    value.path_.push_back(std::move(key));
    return value;
}

}  // namespace rt
