// A picture that gets better from round to round: first one sample at the centre of every pixel, the picture of a plain render; then, round
// by round, more samples where they lessen the error most.
//
// The error is the root of the mean, over all pixels and channels, of the squared difference from the converged picture of the same model,
// in the encoding that the picture is shown in (0..1, clamped; with alpha, colours as they arrived and alpha as a fourth channel). Only the
// sampling of pixels counts: area lights, depth and so on are those of the model. It is an estimate: samples of the same pixel and of its
// neighbours tell how far their means may be off. A region is a picture of its own: the error is that of the region.
#pragma once

#include <functional>

#include "trace/render.h"

namespace rt {

struct ProgressiveOptions {
    int most_samples = 4096;  ///< of a pixel
    /// Called between rounds, by the caller's thread; the picture is whole then. False ends the work.
    std::function<bool(const Film& film, const Convergence& reached)> after_round;
};

/// Renders until the estimated error is at most options.sampling.max_error (the rest of `sampling` says nothing), no pixel may have more
/// samples, or it is stopped. The same picture for any number of threads. Throws as render() does.
RenderResult render_progressive(const World& world, const RenderOptions& options, const ProgressiveOptions& progressive);

}  // namespace rt
