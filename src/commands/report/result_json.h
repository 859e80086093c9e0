// Results to JSON and back.
#pragma once

#include "commands/base/json_text.h"
#include "commands/base/json_value.h"
#include "grading/result.h"

namespace rt {

/// Everything but the times; the same result gives the same text. Members that have nothing to say are left out.
nlohmann::ordered_json result_json(const Result& result);
/// {alone, wall, cpu, spread: seconds, peak: bytes, busy: threads of a time-out}.
nlohmann::ordered_json times_json(const Result& result);

/// What result_json() wrote. Throws SceneError with the place of what is not as expected.
Result result_of_json(const JsonValue& value);
void read_times(const JsonValue& value, Result& result);

nlohmann::ordered_json figures_json(const PictureFigures& figures);
PictureFigures figures_of(const JsonValue& value);
nlohmann::ordered_json region_json(const DifferingRegion& region);
DifferingRegion region_of(const JsonValue& value);

/// A JSON text: the members of `head`, and a list with one entry a line.
std::string json_listing(const nlohmann::ordered_json& head, const char* list, const std::vector<nlohmann::ordered_json>& entries);

}  // namespace rt
