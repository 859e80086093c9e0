// What scenes need, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands/job/requirements.h"

namespace rt {

/// What reading one scene came to.
struct SceneReading {
    std::string scene;
    std::string text;                     ///< some ten lines: counts, features, and what is not modelled as file:line:column
    nlohmann::ordered_json json;          ///< {scene, objects, ..., not_modelled: [{name, file, line, column}]}
    std::vector<MissingFeature> missing;  ///< what is not modelled
    int status = 0;                       ///< where the scene could not be read: the exit status of a render of it
};

/// Of a scene that was read.
SceneReading reading_of(const std::string& scene, const Requirements& needs);
/// Of one that was not; its text has the first line of the error, its JSON is {scene, error, status}.
SceneReading failed_reading(const std::string& scene, const std::string& error, int status);

/// Bytes that hold a reading, and back.
std::string packed(const SceneReading& reading);
SceneReading unpacked(const std::string& bytes);

/// Which features are missing, by gain and in the order in which most scenes are complete soonest; behind it a line of counts.
std::string missing_text(const std::vector<SceneReading>& readings);
/// {format, summary, missing: [{name, scenes, only_this}], order: [{name, completes}], scenes: [json of each]}.
nlohmann::ordered_json readings_json(const std::vector<SceneReading>& readings);

}  // namespace rt
