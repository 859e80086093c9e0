#include "trace/enlarged.h"

#include <algorithm>

#include "film/enlarge.h"

namespace rt {

namespace {

/// How the pixels of a region are made from those that are traced.
struct Enlargement {
    Enlargement(const RenderOptions& options, const Region& region)
        : across(scaled_down(options.width, options.scale), options.width, region.x0, region.x1),
          down(scaled_down(options.height, options.scale), options.height, region.y0, region.y1) {}
    Region traced() const { return {across.first(), down.first(), across.last(), down.last()}; }
    Stretch across, down;
};

RenderOptions traced_options(const RenderOptions& options, const Region& traced) {
    RenderOptions small = options;
    small.scale = 1;
    small.width = scaled_down(options.width, options.scale), small.height = scaled_down(options.height, options.scale);
    small.region = traced;
    if (const int n = samples_a_side(options.sampling); options.trace.specular_aa)
        small.trace.specular_aa = SampleGrid{small.width * n, small.height * n};
    small.only_region = true;
    // Not so narrow that they fall between what is traced.
    small.edges.width = std::max(options.edges.width / options.scale, std::min(options.edges.width, 1.0));
    return small;
}

/// Colours under their transmittance are sums of light, as the picture is when it is laid over another; a legacy scene's, and those of a
/// working space that is no linear light, are filtered as they are, too.
Filtered filtered_in(const RenderOptions& options) {
    const bool light = !options.display.raw && !options.working_srgb && options.working_gamma == 1.0;
    return light && !options.alpha ? Filtered::square_roots : Filtered::values;
}

}  // namespace

RenderResult render_enlarged(const World& world, const RenderOptions& options) {
    check_picture_memory(options.width, options.height, available_memory(), picture_memory(options.width, options.height));
    const Region region = rendered_region(options);
    const Enlargement enlargement(options, region);
    RenderResult result = render(world, traced_options(options, enlargement.traced()));
    Film part = enlarge(std::move(result.film), enlargement.across, enlargement.down, filtered_in(options));
    if (options.only_region || (part.width == options.width && part.height == options.height)) {
        result.film = std::move(part);
        return result;
    }
    result.film = Film(options.width, options.height);
    for (int y = 0; y < part.height; ++y) std::copy_n(&part.at(0, y), part.width, &result.film.at(region.x0, region.y0 + y));
    return result;
}

}  // namespace rt
