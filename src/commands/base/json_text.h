// JSON as text: names of files and what programs print need not be UTF-8, and what is not is replaced.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rt {

/// One line without its end.
inline std::string json_line(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Lines, indented by `indent` blanks a level.
inline std::string json_text(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rt
