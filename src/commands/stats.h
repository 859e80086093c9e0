// What --stats prints.
#pragma once

#include <string>

#include "commands/render_job.h"
#include "scene/scene.h"

namespace rt {

/// Wall-clock seconds of each phase.
struct Phases {
    double parse = 0.0;
    double build = 0.0;
    double trace = 0.0;
    double write = 0.0;
};

struct Stats {
    Phases phases;
    RayCounts rays;
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

/// Several lines, each ended by a newline.
std::string stats_text(const RenderJob& job, const Scene& scene, const Stats& stats);

}  // namespace rt
