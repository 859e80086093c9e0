// Results of comparisons to JSON and back.
#pragma once

#include "commands/base/json_value.h"
#include "commands/versus/versus_result.h"

namespace rt {

/// Everything of a result but its times; the same result gives the same text.
nlohmann::ordered_json versus_json(const VersusResult& result);
/// {scene, povray: {...}, same: {...}, general: {...}}: of each run wall, cpu, parse, build, trace, write: seconds; peak: bytes; threads,
/// alone.
nlohmann::ordered_json versus_times_json(const VersusResult& result);

/// What both wrote. Throws SceneError with the place of what is not as expected.
VersusResult versus_of_json(const JsonValue& result, const JsonValue& times);

/// One run, without and with its times.
nlohmann::ordered_json run_json(const VersusRun& run);
nlohmann::ordered_json run_times_json(const VersusRun& run);
VersusRun run_of_json(const JsonValue& run, const JsonValue& times);

}  // namespace rt
