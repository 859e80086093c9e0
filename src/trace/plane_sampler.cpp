#include "trace/plane_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trace/camera.h"

namespace rt {

namespace {

/// Light that a film cannot hold is as bright as it can hold, not infinite; what was not finite stays so.
float in_film(double light) {
    constexpr double most = std::numeric_limits<float>::max();
    return static_cast<float>(std::isfinite(light) ? std::clamp(light, -most, most) : light);
}

[[gnu::always_inline]] inline Pixel pixel_of(const Rgb& rgb, double transmittance) {
    return {in_film(rgb.r), in_film(rgb.g), in_film(rgb.b), static_cast<float>(transmittance)};
}

}  // namespace

PlaneSampler::PlaneSampler(const World& world, const RenderOptions& options)
    : world_(world), options_(options), tracer_(world, options.trace) {
    if (options.edges.kind != EdgeOptions::Kind::off)
        edges_.emplace(world, options.edges, options.trace.distances, options.width, options.height);
}

void PlaneSampler::operator()(std::span<const Vec2> points, int scale, std::span<Pixel> pixels) {
    rays_.resize(points.size());
    light_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        rays_[i] = camera_ray(world_.camera, points[i].x, points[i].y, options_.width * scale, options_.height * scale);
    tracer_.camera_rays(rays_, light_);
    for (std::size_t i = 0; i < points.size(); ++i) pixels[i] = pixel_of(light_[i].rgb, options_.alpha ? light_[i].transmittance : 0.0);
    if (!edges_) return;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (edges_->covers(points[i], scale)) pixels[i] = pixel_of(options_.edges.color, 0.0);
}

RayCounts PlaneSampler::counts() const {
    RayCounts counts = tracer_.counts();
    if (edges_) counts.edge += edges_->rays;
    return counts;
}

}  // namespace rt
