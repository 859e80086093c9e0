// The keys of the shading catalogue: what each does to a choice, and which surfaces it matters to.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "world/model_choice.h"

namespace rt {

/// Whether `key` chooses from the catalogue; other keys of a scene's comments are settings of the whole picture.
bool is_model_key(std::string_view key);

/// Of those, the ones about all lamps of a picture, which no single finish can choose.
bool is_lamp_key(std::string_view key);

/// The choices about all lamps in the row of that preset, as "key=value key=value"; "" where there is none, or no such preset.
std::string lamp_choices_of_preset(std::string_view name);

/// The keys of the catalogue that are options of the command line as well, with a line of help each.
struct ModelKey {
    std::string_view key, values, help;
};
std::span<const ModelKey> model_keys();

/// Adds one choice. Throws OptionError for a value that does not exist or is out of the model's range.
void choose(ModelChoice& choice, std::string_view key, std::string_view value);

/// A compiled finish under the lamps of its picture.
struct Shading {
    const SurfaceModel& model;
    const LampRules& lamps;
    std::span<const Light> lights;
};

/// Whether the light that comes from a surface of such a finish depends on `key`, whatever its value; false for a key that is not of the
/// catalogue.
bool is_read(std::string_view key, const Shading& shading);

}  // namespace rt
