// `key=value` choices from the shading catalogue, wherever they are stated, turned into the model of a finish.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands/job/model_keys.h"
#include "scene/scene.h"
#include "world/model_choice.h"

namespace rt {

/// A choice from the command line.
struct ModelOption {
    std::string key, value;
    bool implied = false;  ///< by a quality: weaker than whatever is stated, in the scene as well
};

/// Throws OptionError for choices of the command line that contradict each other: f0 with eta or k, coefficients of a law that is not
/// the polynomial.
void check_together(std::span<const ModelOption> command_line);

/// The choice for a finish. Three levels: what the file states, then what the finish states, then the command line; a later level wins over
/// an earlier one, and all of them over what a quality implies. Inside a level presets come first, then materials, then models (shading),
/// then single terms, whatever their order in the text; of several statements of a key the last counts. A preset and a material start anew
/// what others of their kind set. The microfacet model keeps the terms chosen for it, but not those of a model that brought its own. f0 and
/// the indices eta and k replace each other. Throws SceneError, with the place, for a scene's value that does not exist or contradicts
/// another one of its level, and OptionError for such options.
ModelChoice choice_for(const Scene& scene, const std::vector<SceneOption>& finish, const std::vector<ModelOption>& command_line);

/// Every name of the catalogue with the text it comes from, for help.
std::string catalogue_text();

}  // namespace rt
