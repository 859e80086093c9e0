// World -> Film on all cores: tiles in parallel, the same bytes for any number of threads, any tile order and any split into regions.
#pragma once

#include <atomic>
#include <functional>

#include "film/film.h"
#include "trace/tracer.h"

namespace rt {

/// Columns [x0, x1) and rows [y0, y1) of the full picture.
struct Region {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct RenderOptions {
    int width = 800;
    int height = 600;
    std::optional<Region> region;  ///< pixels outside stay 0
    int threads = 0;               ///< 0: all cores
    Sampling sampling;
    /// Exponent of the anti-aliasing comparison for a working gamma g other than 1 is g / Antialias_Gamma.
    double working_gamma = 1.0;
    TraceOptions trace;
    const std::atomic<bool>* stop = nullptr;         ///< set by Ctrl-C: finish the tile in hand and return
    std::function<void(double done)> progress;       ///< called from one worker at a time, done in 0..1
};

struct RenderResult {
    Film film;
    RayCounts counts;
    std::uint64_t non_finite = 0;  ///< pixels that came out as NaN or infinity (written as 0)
    bool complete = true;          ///< false after a stop
};

/// Throws LimitError if the picture does not fit in memory.
RenderResult render(const World& world, const RenderOptions& options);

}  // namespace rt
