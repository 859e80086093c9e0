// A picture that gets better from step to step: first the centres of pixels far apart, of those between them, until there is a sample of
// every pixel, the picture of a plain render; then, round by round, more samples where they lessen the error most.
//
// The error is the root of the mean, over all pixels and channels, of the squared difference from the converged picture of the same model,
// in the encoding that the picture is shown in (0..1, clamped; with alpha, colours as they arrived and alpha as a fourth channel). Only the
// sampling of pixels counts: area lights, depth and so on are those of the model. It is an estimate (error_estimate.h). A region is a
// picture of its own: the error is that of the region.
#pragma once

#include <chrono>
#include <functional>

#include "trace/plane_workers.h"
#include "trace/render.h"

namespace rt {

struct ProgressiveOptions {
    int first_spacing = 1;    ///< of the pixels that are traced first, a power of two; halved until it is 1
    int most_samples = 4096;  ///< of a pixel
    /// Work that is not done by then is left; looked at every few rays, but not before the first step is done. May change between steps.
    const Deadline* deadline = nullptr;
    /// Called after each step, by the caller's thread. The film is whole: what is not traced is made up from what is. False ends the work.
    std::function<bool(const Film& film, const Convergence& reached)> after_step;
};

/// One sample at the centre of every pixel, and if options.sampling says `adaptive`, further ones until the estimated error is at most its
/// max_error, no pixel may have more, or it ends. The same picture for any number of threads, unless a deadline or a stop cuts it; a
/// picture that is cut is whole, too, if its first step was done (convergence->spacing is not 0). Throws as render() does.
RenderResult render_progressive(const World& world, const RenderOptions& options, const ProgressiveOptions& progressive);

}  // namespace rt
