#include "trace/pixel_rays.h"

#include <memory>

#include "trace/camera.h"

namespace rt {

namespace {

bool stopped(const RenderOptions& options) { return options.stop && options.stop->load(std::memory_order_relaxed); }

/// Those traced before a stop.
std::vector<RayLog> samples_of(Tracer& tracer, const World& world, const RenderOptions& options, const PixelPlace& place) {
    const int n = samples_a_side(options.sampling);
    std::vector<RayLog> samples;
    for (int sub_y = place.y * n; sub_y < (place.y + 1) * n; ++sub_y) {
        for (int sub_x = place.x * n; sub_x < (place.x + 1) * n; ++sub_x) {
            if (stopped(options)) return samples;
            const Ray ray = camera_ray(world.camera, sub_x + 0.5, sub_y + 0.5, options.width * n, options.height * n);
            tracer.camera_ray(ray, samples.emplace_back());
        }
    }
    return samples;
}

}  // namespace

std::optional<FewRays> few_rays_of_pixel(const RenderOptions& options, int scene_level) {
    const Sampling& sampling = options.sampling;
    const bool fixed = sampling.method == Sampling::Method::none || sampling.method == Sampling::Method::grid;
    const bool indirect = options.trace.course && !options.trace.course->indirect_samples.empty();
    if (!fixed || indirect || options.edges.kind != EdgeOptions::Kind::off) return std::nullopt;
    const int n = samples_a_side(sampling);
    const int level = options.trace.course ? options.trace.course->further_rays : options.trace.max_trace_level.value_or(scene_level);
    return FewRays{.camera = 2 * n * n, .further = level};  // once for the light in the picture, once for the record
}

PixelRays trace_pixel(const World& world, RenderOptions options, int x, int y) {
    options.region = Region{x, y, x + 1, y + 1};
    options.only_region = true;
    options.threads = 1;
    PixelRays rays;
    rays.pixel = render(world, options).film.at(0, 0);
    const RoundingScope scope(options.rounding);
    Tracer tracer(world, options.trace);
    rays.samples = samples_of(tracer, world, options, {x, y});
    return rays;
}

bool trace_pixels(const World& world, const RenderOptions& options, std::span<const PixelPlace> places, const TakeRays& take) {
    std::vector<std::unique_ptr<Tracer>> tracers(static_cast<std::size_t>(worker_count(options.threads, places.size())));
    std::atomic<bool> complete{true};
    const auto trace_one = [&](int worker, std::size_t number) {
        if (!complete) return;
        std::unique_ptr<Tracer>& tracer = tracers[static_cast<std::size_t>(worker)];
        if (!tracer) tracer = std::make_unique<Tracer>(world, options.trace);
        const std::vector<RayLog> samples = samples_of(*tracer, world, options, places[number]);
        if (stopped(options) || !take(number, samples)) complete = false;
    };
    for_each_tile(options.threads, places.size(), trace_one, options.rounding);
    return complete;
}

}  // namespace rt
