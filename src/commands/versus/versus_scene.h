// One scene in POV-Ray and twice in this program.
#pragma once

#include <optional>

#include "commands/base/entry_store.h"
#include "commands/versus/versus_scenes.h"
#include "commands/versus/versus_settings.h"

namespace rt {

/// The folder of a scene's pictures.
std::string pictures_of(const VersusSettings& settings, const VersusScene& scene);

/// Renders and judges, in a worker: the result and the pictures (povray, same, general, difference_same, difference_general) are then in
/// pictures_of(). POV-Ray runs if `known` has nothing under the scene's content and settings, and what it does is put there.
void run_scene(const VersusSettings& settings, const VersusScene& scene, const EntryStore& known, int slot);

/// What run_scene() left; empty if it left nothing.
std::optional<VersusResult> result_of_scene(const VersusSettings& settings, const VersusScene& scene);

/// Removes what an earlier comparison left there.
void remove_result_of(const VersusSettings& settings, const VersusScene& scene);

/// A result that says why there is none.
VersusResult result_without_run(const VersusScene& scene, VersusRun::State state, const std::string& message);

}  // namespace rt
