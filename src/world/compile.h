// Scene -> World: the one place where what was written becomes what is shaded.
#pragma once

#include <functional>
#include <optional>

#include "world/model_choice.h"
#include "world/world.h"

namespace rt {

enum class Profile { povray, csc473 };
/// fast: Embree's own triangles, the hit refined in double. exact: double callbacks, bit for bit what brute force finds.
enum class Precision { fast, exact };
enum class IndexKind { automatic, embree, brute_force };

/// All the rays that a world will be asked for, at most: some from the camera, and after each of them chains of mirrored and transmitted
/// ones.
struct FewRays {
    int camera = 1;
    int further = 0;     ///< length of the chains
    bool shaded = true;  ///< else there are neither chains nor shadow rays
};

struct CompileOptions {
    Profile profile = Profile::povray;
    Precision precision = Precision::exact;
    IndexKind index = IndexKind::automatic;
    AlphaMapping alpha = AlphaMapping::roughness2;
    int threads = 0;  ///< for building the index; 0: all cores
    /// Unset: too many to count. The automatic index is none where asking every surface so often is quicker than to build one.
    std::optional<FewRays> few_rays;
    /// What the finish of this place chooses of the catalogue; nothing: the general form with GGX, Smith and Schlick.
    std::function<ModelChoice(const Finish&)> choose;
    /// Lamps along each side of an area light, at most: such a light stands in the world as if the scene stated so few, and with 1 it is
    /// a lamp at its centre. Unset: as many as the scene states.
    std::optional<int> light_samples;
    std::size_t max_nodes = 2'000'000;  ///< pigments beyond the first of each material; more are a LimitError
    bool general_shading = true;        ///< warn of what only the general form's shading cannot take as it is
};

/// Throws SceneError for what a scene can state but no world can hold (look_at = location under the course profile, ...).
/// `warn` receives complete messages (`Sources::describe`).
World compile(const Scene& scene, const CompileOptions& options, const MessageSink& warn);

/// The camera's vectors combined (direction, angle, look_at, transforms) by the profile's rule.
CameraBasis camera_basis(const Camera& camera, Profile profile, const Sources& sources, const MessageSink& warn);

}  // namespace rt
