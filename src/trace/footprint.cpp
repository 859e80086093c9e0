#include "trace/footprint.h"

#include <algorithm>

namespace rt {
namespace {

/// Near enough for the curvature where the camera's ray is, far enough from rounding, in samples.
constexpr double step = 0.25;

bool has_lobe(const ActiveLayer& layer) {
    const SurfaceModel& model = layer.finish->model;
    return model.s != 0.0 && model.specular == SurfaceModel::Specular::microfacet;
}

/// Of the half vector over the surface: h / (n.h) - n.
Vec3 slope(const Vec3& n, const Vec3& v, const Vec3& l) {
    const Vec3 s = v + l;
    return s / dot(n, s) - n;
}

}  // namespace

Footprints::Footprints(const World& world, const DistanceRules& rules, const SampleGrid& grid)
    : world_(world),
      rules_(rules),
      right_(world.camera.right / static_cast<double>(grid.columns)),
      up_(world.camera.up / static_cast<double>(grid.rows)),
      across_(cross(world.camera.right, world.camera.up)) {}

const Footprint* Footprints::around(const Ray& ray, const Hit& hit, const SurfacePoint& at, std::span<const ActiveLayer> layers) {
    if (world_.camera.projection > Projection::orthographic) return nullptr;  // no formula says where its next sample is seen
    if (!std::any_of(layers.begin(), layers.end(), has_lobe)) return nullptr;
    last_ = {beside(ray, right_, hit, at), beside(ray, up_, hit, at)};
    return &last_;
}

Footprint::Beside Footprints::beside(const Ray& ray, const Vec3& to_next, const Hit& hit, const SurfacePoint& at) const {
    const CameraBasis& camera = world_.camera;
    const bool interpolated = std::fabs(dot(at.side, at.normal)) < 1.0 - 1e-12;
    for (const double samples : {step, -step}) {
        Ray other = ray;
        if (camera.projection == Projection::orthographic) {
            other.origin += samples * to_next;
        } else {
            const double scale = dot(camera.direction, across_) / dot(ray.direction, across_);
            other.direction = unit(scale * ray.direction + samples * to_next);
        }
        Hit met;
        if (!world_.nearest(other, rules_.traced(), RayKind::image, met) || met.object != hit.object) continue;
        // Between flat faces the normal jumps: there is an edge, and no curvature.
        if (!interpolated && (met.primitive != hit.primitive || met.shape.part != hit.shape.part)) continue;
        const Vec3 point = other.at(met.shape.t);
        const Vec3 normal = world_.normal(met, point);
        return {point, dot(normal, at.normal) < 0.0 ? -normal : normal, -other.direction, samples};
    }
    return {};
}

double widened_alpha(double alpha, const SurfacePoint& at, const LightSource& source, const LightRay& ray) {
    const Vec3 m = slope(at.normal, -at.direction, ray.direction);
    double change2 = 0.0;
    for (const Footprint::Beside* beside : {&at.footprint->across, &at.footprint->upwards}) {
        if (beside->samples == 0.0) continue;
        const Vec3 l = source.direction_beside(beside->point, at.point, ray);
        const Vec3 change = (slope(beside->normal, beside->to_viewer, l) - m) / beside->samples;
        change2 += dot(change, change);
    }
    if (!std::isfinite(change2)) return alpha;
    const double m2 = dot(m, m), alpha2 = alpha * alpha;
    const double weight = m2 > alpha2 + change2 ? (alpha2 + change2) / m2 : 1.0;
    return std::sqrt(alpha2 + std::min(weight * change2 / 12.0, 0.18));
}

}  // namespace rt
