#include "commands/causes/broken_paths.h"

#include "shading/course_terms.h"
#include "shading/optics.h"
#include "trace/course_surface.h"
#include "world/surface_index.h"

namespace rt {

namespace {

/// What a ray met.
struct Met {
    std::uint32_t object = RayNode::none;
    double t = infinity;
    Vec3 point{0.0}, normal{0.0};
};

class Paths {
public:
    Paths(const ShadedScene& shaded, const PathRules& rules) : shaded_(shaded), rules_(rules) {}

    RayLog follow(const Ray& ray) {
        follow(ray, RayNode::none, RayNode::Kind::camera, RayKind::image, 0);
        return std::move(log_);
    }

private:
    double follow(const Ray& ray, std::uint32_t parent, RayNode::Kind kind, RayKind seen, int level) {
        const std::size_t index = log_.nodes.size();
        RayNode& started = log_.nodes.emplace_back();
        started.parent = parent, started.kind = kind, started.ray = ray, started.level = level + 1;
        Met met;
        if (!nearest(ray, {0.0, infinity}, seen, met)) {
            started.end = RayNode::End::background;
            return infinity;
        }
        bool inside = dot(met.normal, ray.direction) > 0.0;
        met.normal = changed_normal(shaded_.scene.objects[met.object], met.normal, inside, rules_.normal);
        inside = !rules_.side_ignored && dot(met.normal, ray.direction) > 0.0;
        const Vec3 side = inside ? -met.normal : met.normal;
        const course::Surface surface = surface_at(met);
        const double F = shaded_.rules.fresnel ? F_schlick(f0_from_ior(surface.ior), std::fabs(dot(met.normal, ray.direction))) : 0.0;
        const Refraction bent = refract(ray.direction, side, inside ? surface.ior : 1.0 / surface.ior);
        const RayNode::Shares shares = course::shares(surface, F, bent.total);
        std::vector<ShadowAnswer> shadows;
        for (std::uint32_t i = 0; i < shaded_.world.lights.size(); ++i)
            shadows.push_back({i, 0, Rgb(lit(met, side, shaded_.world.lights[i]) ? 1.0 : 0.0), {}});
        RayNode& node = log_.nodes[index];
        node.object = met.object, node.t = met.t, node.point = met.point, node.normal = met.normal, node.inside = inside;
        node.layers = {{surface.pigment, surface.filter, 0.0}};
        node.shares = shares, node.shadows = std::move(shadows);
        if (level >= shaded_.rules.further_rays) return met.t;
        const std::uint32_t self = static_cast<std::uint32_t>(index);
        if (shares.reflection > 0.0) {
            const Vec3 mirrored = unit(reflect(ray.direction, side)) * (rules_.mirror_reversed ? -1.0 : 1.0);
            follow(further(met, mirrored), self, RayNode::Kind::reflected, RayKind::reflected, level + 1);
        }
        if (shares.transmission > 0.0) transmit(met, unit(bent.direction), self, seen, level, surface, inside);
        return met.t;
    }

    void transmit(const Met& met, const Vec3& direction, std::uint32_t self, RayKind seen, int level, const course::Surface& surface,
                  bool inside) {
        const std::size_t child = log_.nodes.size();
        const double length = follow(further(met, direction), self, RayNode::Kind::refracted, seen, level + 1);
        Rgb factor(log_.nodes[self].shares->transmission);
        if (!inside && length < infinity)
            factor *= shaded_.rules.beers ? course::beers_law(surface.pigment, length, CourseRules::beer_density) : surface.pigment;
        log_.nodes[child].factor = factor;
    }

    Ray further(const Met& met, const Vec3& direction) const { return {met.point + rules_.offset * direction, direction}; }

    course::Surface surface_at(const Met& met) {
        const CompiledObject& object = shaded_.world.objects[met.object];
        const LayerSample top = top_layer(shaded_.world.materials[object.material].layers, met.point);
        return {.pigment = top.color.rgb,
                .filter = top.color.filter,
                .reflection = top.finish->finish.reflection.max.r,
                .ior = shaded_.world.interiors[object.interior].ior};
    }

    bool lit(const Met& met, const Vec3& side, const Light& light) {
        const Vec3 start = met.point + rules_.offset * side, way = light.location - start;
        const double distance = length(way);
        if (distance == 0.0) return true;
        Met between;
        return !nearest({start, way / distance}, {0.0, rules_.shadows_from_behind ? infinity : distance}, RayKind::shadow, between);
    }

    bool nearest(const Ray& ray, const Interval& range, RayKind seen, Met& met) const {
        if (rules_.distances_in_object_space) return nearest_in_object_space(ray, range, met);
        Hit hit;
        if (!shaded_.world.nearest(ray, range, seen, hit)) return false;
        met = {hit.object, hit.shape.t, ray.at(hit.shape.t), Vec3(0.0)};
        const Object& object = shaded_.scene.objects[hit.object];
        met.normal = outer(object, rules_.raw_normals ? raw_normal(object, hit.shape, met.point) : shaded_.world.normal(hit, met.point));
        return true;
    }

    static Vec3 raw_normal(const Object& object, const ShapeHit& hit, const Vec3& point) {
        const Transform to_world = object.transform.value_or(Transform{});
        return std::visit(
            [&]<typename S>(const S& shape) {
                if constexpr (std::is_same_v<S, Mesh>)  // the course's scenes have none
                    return Vec3(0.0);
                else
                    return to_world.normal(rt::normal(shape, to_world.inverse_point(point), hit));
            },
            object.shape);
    }

    /// Every object by itself.
    bool nearest_in_object_space(const Ray& ray, const Interval& range, Met& met) const {
        for (std::uint32_t i = 0; i < shaded_.scene.objects.size(); ++i) {
            const Object& object = shaded_.scene.objects[i];
            const Transform to_world = object.transform.value_or(Transform{});
            Ray own = to_world.inverse_ray(ray);
            if (object.transform) own.direction = unit(own.direction);
            std::visit(
                [&]<typename S>(const S& shape) {
                    if constexpr (!std::is_same_v<S, Mesh>) {
                        ShapeHit hit;
                        if (!intersect(shape, own, range, hit) || hit.t >= met.t) return;
                        const Vec3 point = ray.at(hit.t);
                        met = {i, hit.t, point, outer(object, unit(raw_normal(object, hit, point)))};
                    }
                },
                object.shape);
        }
        return met.object != RayNode::none;
    }

    /// The course's triangles are counter-clockwise seen from their outer side, POV-Ray's clockwise.
    static Vec3 outer(const Object& object, const Vec3& normal) {
        const bool triangle = std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape) ||
                              std::holds_alternative<Mesh>(object.shape);
        return triangle ? -normal : normal;
    }

    const ShadedScene& shaded_;
    const PathRules& rules_;
    RayLog log_;
};

/// As long as transforms, or a triangle's edges, make it.
Vec3 normal_of_any_length(const Object& object, const Vec3& normal) {
    if (const Triangle* flat = std::get_if<Triangle>(&object.shape)) {
        const Transform to_world = object.transform.value_or(Transform{});
        return length(cross(to_world.direction(flat->b - flat->a), to_world.direction(flat->c - flat->a))) * normal;
    }
    return object.transform ? object.transform->normal(unit(normal * object.transform->linear)) : normal;
}

}  // namespace

Vec3 changed_normal(const Object& object, const Vec3& normal, bool inside, Reshading::Normal how) {
    const bool triangle = std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape) ||
                          std::holds_alternative<Mesh>(object.shape);
    // From the normal in the world back to the object's: normals go with the inverse transpose.
    const auto in_object = [&] { return object.transform ? unit(normal * object.transform->linear) : normal; };
    switch (how) {
        case Reshading::Normal::right:
            return normal;
        case Reshading::Normal::to_viewer:
            return inside ? -normal : normal;
        case Reshading::Normal::triangles_turned:
            return triangle ? -normal : normal;
        case Reshading::Normal::by_matrix:
            return object.transform ? unit(object.transform->direction(in_object())) : normal;
        case Reshading::Normal::in_object_space:
            return in_object();
        case Reshading::Normal::not_unit:
            return normal_of_any_length(object, normal);
    }
    return normal;
}

RayLog follow_broken(const ShadedScene& shaded, const PathRules& rules, const Ray& camera_ray) {
    return Paths(shaded, rules).follow(camera_ray);
}

}  // namespace rt
