// What --stats prints.
#pragma once

#include <string>

#include "commands/job/render_job.h"
#include "scene/scene.h"

namespace rt {

/// Wall-clock seconds of each phase.
struct Phases {
    double parse = 0.0;
    double build = 0.0;
    double trace = 0.0;
    double write = 0.0;
};

/// Microfacet lobes that are narrower than what a sample spans of half vectors: their highlights may fall between the samples.
struct NarrowLobes {
    std::size_t materials = 0;  ///< that have such a lobe
    double least_alpha = 0.0;   ///< of them
    double spanned = 0.0;       ///< radians between the half vectors of neighbouring samples of a flat surface
};

struct Stats {
    Phases phases;
    NarrowLobes narrow;
    RayCounts rays;
    std::optional<Convergence> convergence;
    int threads = 0;
    std::uint64_t non_finite = 0;
    std::size_t peak_bytes = 0;
};

/// Triangles of the scene, those of its meshes included.
std::size_t count_triangles(const Scene& scene);
/// "1", "2.2", "srgb" or "none (values are written as they are)".
std::string gamma_text(const Gamma& gamma);
/// Largest resident size of this process so far, in bytes.
std::size_t peak_memory();

/// From one sample to the next the ray turns by the angle between them and, on a flat surface under a distant light, the half vector by
/// half of that; curved surfaces turn it by more. Lobes of alpha below that are counted; those of alpha 0 have no highlight to lose.
NarrowLobes narrow_lobes(const World& world, int width, int height, const Sampling& sampling);

/// Several lines, each ended by a newline.
std::string stats_text(const RenderJob& job, const Scene& scene, const Stats& stats);

}  // namespace rt
