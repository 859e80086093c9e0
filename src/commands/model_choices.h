// `key=value` choices from the shading catalogue, wherever they are stated, turned into the model of a finish.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "world/model_choice.h"

namespace rt {

/// A choice from the command line.
struct ModelOption {
    std::string key, value;
};

/// Whether `key` chooses from the catalogue; other keys of a scene's comments are settings of the whole picture.
bool is_model_key(std::string_view key);

/// Of those, the ones about all lamps of a picture, which no single finish can choose.
bool is_lamp_key(std::string_view key);

/// The keys of the catalogue that are options of the command line as well, with a line of help each.
struct ModelKey {
    std::string_view key, values, help;
};
std::span<const ModelKey> model_keys();

/// Adds one choice. Throws OptionError for a value that does not exist or is out of the model's range.
void choose(ModelChoice& choice, std::string_view key, std::string_view value);

/// The choice for a finish: the file's choices, then the finish's own, then the command line's, presets and models first in each.
/// Throws SceneError, with the place, for a scene's value that does not exist.
ModelChoice choice_for(const Scene& scene, const std::vector<SceneOption>& finish, const std::vector<ModelOption>& command_line);

/// Every name of the catalogue with the text it comes from, for help.
std::string catalogue_text();

}  // namespace rt
