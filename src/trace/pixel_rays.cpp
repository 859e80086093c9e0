#include "trace/pixel_rays.h"

#include "trace/camera.h"

namespace rt {

PixelRays trace_pixel(const World& world, RenderOptions options, int x, int y) {
    options.region = Region{x, y, x + 1, y + 1};
    options.threads = 1;
    PixelRays rays;
    rays.pixel = render(world, options).film.at(x, y);
    const int n = options.sampling.method == Sampling::Method::grid ? options.sampling.depth : 1;
    Tracer tracer(world, options.trace);
    for (int sub_y = y * n; sub_y < (y + 1) * n; ++sub_y) {
        for (int sub_x = x * n; sub_x < (x + 1) * n; ++sub_x) {
            const Ray ray = camera_ray(world.camera, sub_x + 0.5, sub_y + 0.5, options.width * n, options.height * n);
            tracer.camera_ray(ray, rays.samples.emplace_back());
        }
    }
    return rays;
}

}  // namespace rt
