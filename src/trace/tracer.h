// Whitted recursion: one camera ray to one radiance. Directions point away from the surface except a ray's own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/options.h"
#include "trace/ray_log.h"
#include "world/world.h"

namespace rt {

/// Rays cast, by kind. Plain counters: each worker has its own, summed at the end.
struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0;
    std::uint64_t edge = 0;  ///< around samples, for lines over the picture
    RayCounts& operator+=(const RayCounts& o) {
        camera += o.camera, shadow += o.shadow, reflected += o.reflected, refracted += o.refracted, edge += o.edge;
        return *this;
    }
};

/// Radiance that arrives along a camera ray, and how much of the background it sees.
struct Radiance {
    Rgb rgb{0.0};
    double transmittance = 0.0;
};

/// One worker's tracer: holds scratch memory, so use one per thread. The world and options outlive it.
class Tracer {
public:
    Tracer(const World& world, const TraceOptions& options);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// `ray.direction` is unit. The same ray gives the same bits whatever was traced before. Never NaN; infinite where numbers overflow.
    Radiance camera_ray(const Ray& ray);
    /// The same for each of several rays; the nearer they are to each other, the cheaper.
    void camera_rays(std::span<const Ray> rays, std::span<Radiance> light);
    /// The same, and records what the ray met in `log` (emptied first).
    Radiance camera_ray(const Ray& ray, RayLog& log);
    const RayCounts& counts() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rt
