#include "trace/tracer.h"

#include <variant>

#include "trace/course_recursion.h"
#include "trace/recursion.h"

namespace rt {

struct Tracer::State {
    std::variant<Recursion, CourseRecursion> recursion;
    RayCounts counts;

    static State make(const World& world, const TraceOptions& options) {
        if (options.course) return {CourseRecursion(world, *options.course), {}};
        return {Recursion(world, options), {}};
    }
};

Tracer::Tracer(const World& world, const TraceOptions& options) : state_(new State(State::make(world, options))) {}

Tracer::~Tracer() = default;

Radiance Tracer::camera_ray(const Ray& ray) {
    return std::visit([&](auto& recursion) { return recursion.camera_ray(ray, nullptr); }, state_->recursion);
}

void Tracer::camera_rays(std::span<const Ray> rays, std::span<Radiance> light) {
    std::visit([&](auto& recursion) { recursion.camera_rays(rays, light); }, state_->recursion);
}

Radiance Tracer::camera_ray(const Ray& ray, RayLog& log) {
    log.nodes.clear();
    return std::visit([&](auto& recursion) { return recursion.camera_ray(ray, &log); }, state_->recursion);
}

const RayCounts& Tracer::counts() const {
    state_->counts = std::visit([](const auto& recursion) { return recursion.counts; }, state_->recursion);
    if (const auto* povray = std::get_if<Recursion>(&state_->recursion)) state_->counts.shadow = povray->shadow_rays();
    return state_->counts;
}

}  // namespace rt
