#include "trace/pixel_rays.h"

#include <memory>

#include "trace/camera.h"

namespace rt {

namespace {

std::vector<RayLog> samples_of(Tracer& tracer, const World& world, const RenderOptions& options, const PixelPlace& place) {
    const int n = options.sampling.method == Sampling::Method::grid ? options.sampling.depth : 1;
    std::vector<RayLog> samples;
    for (int sub_y = place.y * n; sub_y < (place.y + 1) * n; ++sub_y) {
        for (int sub_x = place.x * n; sub_x < (place.x + 1) * n; ++sub_x) {
            const Ray ray = camera_ray(world.camera, sub_x + 0.5, sub_y + 0.5, options.width * n, options.height * n);
            tracer.camera_ray(ray, samples.emplace_back());
        }
    }
    return samples;
}

}  // namespace

PixelRays trace_pixel(const World& world, RenderOptions options, int x, int y) {
    options.region = Region{x, y, x + 1, y + 1};
    options.threads = 1;
    PixelRays rays;
    rays.pixel = render(world, options).film.at(x, y);
    Tracer tracer(world, options.trace);
    rays.samples = samples_of(tracer, world, options, {x, y});
    return rays;
}

bool trace_pixels(const World& world, const RenderOptions& options, std::span<const PixelPlace> places, const TakeRays& take) {
    std::vector<std::unique_ptr<Tracer>> tracers(static_cast<std::size_t>(worker_count(options.threads, places.size())));
    std::atomic<bool> complete{true};
    for_each_tile(options.threads, places.size(), [&](int worker, std::size_t number) {
        if (options.stop && options.stop->load(std::memory_order_relaxed)) {
            complete = false;
            return;
        }
        std::unique_ptr<Tracer>& tracer = tracers[static_cast<std::size_t>(worker)];
        if (!tracer) tracer = std::make_unique<Tracer>(world, options.trace);
        take(number, samples_of(*tracer, world, options, places[number]));
    });
    return complete;
}

}  // namespace rt
