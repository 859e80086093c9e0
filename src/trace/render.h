// World -> Film on all cores: tiles in parallel, the same bytes for any number of threads, any tile order and any split into regions.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "film/encode.h"
#include "film/film.h"
#include "trace/rounding.h"
#include "trace/sampling.h"
#include "trace/tracer.h"

namespace rt {

struct RenderOptions {
    int width = 800;
    int height = 600;
    std::optional<Region> region;  ///< pixels outside stay 0; clipped to the picture
    bool only_region = false;      ///< the film holds the region alone, not the whole picture
    int threads = 0;               ///< 0: all cores
    Sampling sampling;
    int scale = 1;  ///< above 1: that fraction of its width and height is traced and enlarged; by render() alone
    /// The scene's working space, for the comparison of colours in anti-aliasing. A legacy scene has gamma 1.
    double working_gamma = 1.0;
    bool working_srgb = false;  ///< the working space is the sRGB curve; working_gamma says nothing then
    bool alpha = false;         ///< the picture keeps its transmittance; otherwise it is 0 everywhere and anti-aliasing does not compare it
    Encoding display;           ///< how the picture will be shown: errors of adaptive sampling are measured there
    TraceOptions trace;
    EdgeOptions edges;
    Rounding rounding = Rounding::nearest;      ///< of every operation of the workers
    const std::atomic<bool>* stop = nullptr;    ///< set by Ctrl-C: keep the rows that are finished and return
    std::function<void(double done)> progress;  ///< called from one worker at a time, done in 0..1, at most ten times a second
};

/// How far a picture is that gets better step by step. Samples are those of a pixel.
struct Convergence {
    int spacing = 0;              ///< every such column of every such row is traced, 0: not even that; 1: all pixels
    double traced = 0.0;          ///< share of the pixels, 0..1
    std::optional<double> error;  ///< estimated RMSE, see progressive.h; adaptive sampling only, once all pixels are traced
    bool reached = false;         ///< the error that was asked for
    int rounds = 0;               ///< of more samples
    int least = 0, most = 0;      ///< samples
    double mean = 0.0;            ///< samples
};

struct RenderResult {
    Film film;
    RayCounts counts;
    std::uint64_t non_finite = 0;            ///< pixels that came out as NaN or infinity (written as 0)
    bool complete = true;                    ///< false after a stop
    int threads = 0;                         ///< how many worked
    std::optional<Convergence> convergence;  ///< of a progressive render
};

/// Throws LimitError if the picture does not fit in memory, and whatever a worker or `progress` threw.
RenderResult render(const World& world, const RenderOptions& options);

/// The region, inside the picture.
Region rendered_region(const RenderOptions& options);

/// Bytes of a film; throws LimitError when `width` x `height` is not possible at all.
std::uint64_t picture_memory(int width, int height);
/// Throws LimitError when the picture needs more than `available` bytes, with `further` ones for what is known of its pixels.
void check_picture_memory(int width, int height, std::uint64_t available, std::uint64_t further = 0);
/// Physical memory that this process may still use, in bytes.
std::uint64_t available_memory();

/// Calls work(worker, tile) for every tile in [0, count), each on one of `threads` workers (0: all cores), in order of their numbers as far
/// as the workers allow. Every call begins with the processor's default floating-point state (no flush to zero) with this rounding, and a
/// stack that holds the deepest recursion. The first exception ends the work and is thrown here. Returns the number of workers.
int for_each_tile(int threads, std::size_t count, const std::function<void(int worker, std::size_t tile)>& work,
                  Rounding rounding = Rounding::nearest);

/// Workers for so many tiles: never more than tiles, never less than one.
int worker_count(int threads, std::size_t tiles);

}  // namespace rt
