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
    bool too_many = false;          ///< they would tell of more than they may: `rays` is what they may, and the pixels are not all here
    bool stopped = false;           ///< by `options.stop`: the pixels are not all here
};

/// At most `most_rays` of each pixel are told, but at least one of each sample. Nothing more is traced once they are more than
/// `most_in_all`.
PixelTexts pixel_texts(const World& world, const Scene& scene, const RenderOptions& options, std::span<const PixelPlace> places,
                       std::size_t most_rays, std::size_t most_in_all);

}  // namespace rt
