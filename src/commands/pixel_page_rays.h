// Rays of many pixels for a page: traced on all cores, cut to what a page bears, written as JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "trace/pixel_rays.h"

namespace rt {

/// A pixel's share of a page.
struct PixelText {
    std::string samples;       ///< JSON: a list of rays for each
    std::size_t left_out = 0;  ///< rays that it does not tell of
};

struct PixelTexts {
    std::vector<PixelText> pixels;  ///< of each place, in order
    std::size_t rays = 0;           ///< that they tell of
    bool complete = true;           ///< false after a stop
};

/// At most `most_rays` of each pixel are told. Once a page has more than `most_in_all` they are counted and not written.
PixelTexts pixel_texts(const World& world, const Scene& scene, const RenderOptions& options, std::span<const PixelPlace> places,
                       std::size_t most_rays, std::size_t most_in_all);

}  // namespace rt
