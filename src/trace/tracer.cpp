#include "trace/tracer.h"

#include "trace/recursion.h"

namespace rt {

struct Tracer::State {
    Recursion recursion;
    RayCounts counts;
};

Tracer::Tracer(const World& world, const TraceOptions& options) : state_(new State{Recursion(world, options), {}}) {}

Tracer::~Tracer() = default;

Radiance Tracer::camera_ray(const Ray& ray) { return state_->recursion.camera_ray(ray, nullptr); }

void Tracer::camera_rays(std::span<const Ray> rays, std::span<Radiance> light) { state_->recursion.camera_rays(rays, light); }

Radiance Tracer::camera_ray(const Ray& ray, RayLog& log) {
    log.nodes.clear();
    return state_->recursion.camera_ray(ray, &log);
}

const RayCounts& Tracer::counts() const {
    state_->counts = state_->recursion.counts;
    state_->counts.shadow = state_->recursion.shadow_rays();
    return state_->counts;
}

}  // namespace rt
