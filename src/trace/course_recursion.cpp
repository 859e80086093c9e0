#include "trace/course_recursion.h"

#include <array>
#include <bit>

#include "shading/course_terms.h"
#include "shading/optics.h"
#include "world/surface_index.h"

namespace rt {

namespace {

const Interval ahead{0.0, infinity};

/// A bijection of 64-bit words that changes half of the bits wherever one changes: the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// In [0, 1).
double uniform(std::uint64_t word) { return static_cast<double>(word >> 11) * 0x1p-53; }

/// The random numbers of a camera ray depend on nothing but the ray: not on threads, tiles or what was traced before.
std::uint64_t key_of(const Ray& ray) {
    std::uint64_t key = 0;
    for (const double x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z})
        key = mix(key ^ std::bit_cast<std::uint64_t>(x));
    return key;
}

/// `direction` of the hemisphere over +z, turned with +z onto the unit vector `n` (Duff et al. 2017, "Building an Orthonormal Basis,
/// Revisited").
Vec3 turned_to(const Vec3& n, const Vec3& direction) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z), b = n.x * n.y * a;
    const Vec3 tangent(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), bitangent(b, sign + n.y * n.y * a, -n.y);
    return unit(direction.x * tangent + direction.y * bitangent + direction.z * n);
}

/// What a camera ray brings. Terms guard themselves against NaN; what is left comes from products of infinities with 0: an overflow.
Radiance seen(const Rgb& light) {
    const auto overflowed = [](double x) { return std::isnan(x) ? infinity : x; };
    return {{overflowed(light.r), overflowed(light.g), overflowed(light.b)}, 0.0};
}

}  // namespace

CourseRecursion::CourseRecursion(const World& world, const CourseRules& rules)
    : world_(world), rules_(rules), blockers_(world.lights.size()) {}

Radiance CourseRecursion::camera_ray(const Ray& ray, RayLog* log) {
    log_ = log;
    ++counts.camera;
    Path path{.ray = ray, .key = key_of(ray)};
    record(RayNode::none, RayNode::Kind::camera, path);
    return seen(follow(path).light);
}

void CourseRecursion::camera_rays(std::span<const Ray> rays, std::span<Radiance> light) {
    log_ = nullptr;
    std::array<Hit, packet_size> hits;
    for (std::size_t first = 0; first < rays.size(); first += packet_size) {
        const std::span<const Ray> packet = rays.subspan(first, std::min(packet_size, rays.size() - first));
        const std::uint32_t found = world_.nearest(packet, ahead, RayKind::image, hits);
        for (std::size_t i = 0; i < packet.size(); ++i) {
            ++counts.camera;
            const Path path{.ray = packet[i], .key = key_of(packet[i])};
            light[first + i] = seen(arrive(path, (found >> i & 1u) != 0 ? &hits[i] : nullptr).light);
        }
    }
}

/// Starts the record of a ray; without a log there is none.
void CourseRecursion::record(std::uint32_t parent, RayNode::Kind kind, Path& path) {
    if (log_ == nullptr) return;
    path.node = static_cast<std::uint32_t>(log_->nodes.size());
    RayNode& record = log_->nodes.emplace_back();
    record.parent = parent;
    record.kind = kind;
    record.ray = path.ray;
    record.level = path.level + 1;
}

CourseRecursion::Arrival CourseRecursion::follow(const Path& path) {
    Hit hit;
    return arrive(path, world_.nearest(path.ray, ahead, path.kind, hit) ? &hit : nullptr);
}

/// The light that a ray brings from the surface it meets; nothing from none, whatever the scene's background.
CourseRecursion::Arrival CourseRecursion::arrive(const Path& path, const Hit* hit) {
    if (hit == nullptr) {
        if (RayNode* record = node(path.node)) record->end = RayNode::End::background;
        return {};
    }
    const Point point = point_at(path.ray, *hit);
    if (RayNode* record = node(path.node)) {
        record->object = hit->object;
        record->part = hit->shape.part;
        record->t = hit->shape.t;
        record->point = point.at;
        record->normal = point.normal;
        record->inside = point.inside();
        record->layers = {{point.surface.pigment, point.surface.filter, 0.0}};
    }
    Rgb light;
    switch (rules_.show) {
        case CourseShow::shaded:
            light = shade(path, point);
            break;
        case CourseShow::pigment:
            light = point.surface.pigment;
            break;
        case CourseShow::normals:
            light = 0.5 * (point.normal + Vec3(1.0));
            break;
    }
    if (RayNode* record = node(path.node)) record->radiance = light;
    return {light, hit->shape.t};
}

CourseRecursion::Point CourseRecursion::point_at(const Ray& ray, const Hit& hit) {
    const Vec3 at = ray.at(hit.shape.t);
    Vec3 normal = world_.normal(hit, at);
    // The course's triangles are counter-clockwise seen from their outer side, POV-Ray's clockwise.
    if (world_.surfaces->surfaces().objects[hit.object].is_triangles()) normal = -normal;
    const bool inside = dot(normal, ray.direction) > 0.0;
    return {at, normal, -ray.direction, inside ? -normal : normal, surface_of(hit, at)};
}

course::Surface CourseRecursion::surface_of(const Hit& hit, const Vec3& at) {
    const CompiledObject& object = world_.objects[hit.object];
    const LayerSample top = top_layer(world_.materials[object.material].layers, at);
    const Finish& finish = top.finish->finish;
    return {.pigment = top.color.rgb,
            .filter = top.color.filter,
            .ambient = finish.ambient.r,
            .diffuse = finish.diffuse,
            .specular = finish.specular,
            .roughness = finish.roughness.value_or(1.0),
            .reflection = finish.reflection.max.r,
            .ior = world_.interiors[object.interior].ior};
}

Rgb CourseRecursion::shade(const Path& path, const Point& point) {
    const course::Surface& surface = point.surface;
    const double n_dot_v = std::fabs(dot(point.normal, point.to_viewer));
    const double F = rules_.fresnel ? F_schlick(f0_from_ior(surface.ior), n_dot_v) : 0.0;
    const double ratio = point.inside() ? surface.ior : 1.0 / surface.ior;
    const Refraction bent = refract(path.ray.direction, point.side, ratio);
    const RayNode::Shares shares = course::shares(surface, F, bent.total);

    LocalLight light = local_light(path, point);
    light.ambient *= shares.local, light.diffuse *= shares.local, light.specular *= shares.local;
    Rgb reflection(0.0), refraction(0.0);
    if (path.level < rules_.further_rays) {
        if (shares.reflection > 0.0) reflection = mirrored(path, point, shares.reflection);
        if (shares.transmission > 0.0) refraction = transmitted(path, point, bent.direction, shares.transmission);
    }
    if (RayNode* record = node(path.node)) {
        record->shares = shares;
        record->ambient = light.ambient, record->diffuse = light.diffuse, record->specular = light.specular;
        record->reflection = reflection, record->refraction = refraction;
    }
    return light.ambient + light.diffuse + light.specular + reflection + refraction;
}

CourseRecursion::LocalLight CourseRecursion::local_light(const Path& path, const Point& point) {
    const course::Surface& surface = point.surface;
    LocalLight sum;
    sum.ambient = rules_.indirect_samples.empty() ? surface.ambient * surface.pigment : indirect(path, point);
    for (std::uint32_t i = 0; i < world_.lights.size(); ++i) {
        const Light& light = world_.lights[i];
        const Vec3 way = light.location - point.at;
        const bool arrives = way != Vec3(0.0) && lit(point, light);
        if (RayNode* n = node(path.node)) n->shadows.push_back({i, 0, Rgb(arrives ? 1.0 : 0.0), {}});
        if (!arrives) continue;
        const Vec3 l = unit(way);
        sum.diffuse += surface.diffuse * std::max(0.0, dot(point.normal, l)) * light.color * surface.pigment;
        if (surface.specular == 0.0) continue;
        const double highlight = rules_.cook_torrance
                                     ? course::cook_torrance(point.normal, l, point.to_viewer, surface.roughness, surface.ior)
                                     : course::blinn_phong(dot(point.normal, course::half_vector(l, point.to_viewer)), surface.roughness);
        sum.specular += surface.specular * highlight * light.color * surface.pigment;
    }
    return sum;
}

/// The mean of what arrives from stratified directions, weighted by their cosine through their density: a pair (u, v) of the unit square is
/// a point of the disc, raised to the hemisphere (Malley's method).
Rgb CourseRecursion::indirect(const Path& path, const Point& point) {
    if (path.bounce >= static_cast<int>(rules_.indirect_samples.size())) return Rgb(0.0);
    const int count = rules_.indirect_samples[static_cast<std::size_t>(path.bounce)];
    const int side = static_cast<int>(std::sqrt(count));  // what no square holds goes through the first strata again
    Rgb sum(0.0);
    RayLog* const log = std::exchange(log_, nullptr);  // its rays are too many to be told
    for (int i = 0; i < count; ++i) {
        const std::uint64_t key = mix(path.key + static_cast<std::uint64_t>(i) + 16);
        const double u = (i % side + uniform(mix(key + 1))) / side;
        const double v = (i / side % side + uniform(mix(key + 2))) / side;
        const double radius = std::sqrt(u), angle = 2.0 * pi * v;
        const Vec3 direction = turned_to(point.normal, {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0 - u)});
        const Path next{.ray = {point.at + CourseRules::offset * direction, direction},
                        .kind = RayKind::reflected,
                        .level = path.level + 1,
                        .bounce = path.bounce + 1,
                        .key = key};
        ++counts.reflected;
        sum += follow(next).light;
    }
    log_ = log;
    return sum / static_cast<double>(count);
}

/// Whether nothing, not even a transparent object, is between the point and the light.
bool CourseRecursion::lit(const Point& point, const Light& light) {
    ++counts.shadow;
    const Vec3 start = point.at + CourseRules::offset * point.side;
    const Vec3 way = light.location - start;
    const double distance = length(way);
    if (distance == 0.0) return true;
    const Ray ray{start, way / distance};
    const Interval between{0.0, distance};
    if (world_.occluded(ray, between, blockers_[static_cast<std::size_t>(&light - world_.lights.data())])) return false;
    Hit hit;
    return !world_.features.transmits || !world_.nearest(ray, between, RayKind::shadow, hit);
}

CourseRecursion::Path CourseRecursion::further(const Path& path, const Point& point, const Vec3& direction, RayNode::Kind kind) {
    const bool mirror = kind == RayNode::Kind::reflected;
    Path next{.ray = {point.at + CourseRules::offset * direction, direction},
              .kind = mirror ? RayKind::reflected : path.kind,
              .level = path.level + 1,
              .bounce = path.bounce,
              .key = mix(path.key + static_cast<std::uint64_t>(kind))};
    ++(mirror ? counts.reflected : counts.refracted);
    record(path.node, kind, next);
    return next;
}

Rgb CourseRecursion::mirrored(const Path& path, const Point& point, double share) {
    const Path next = further(path, point, unit(reflect(path.ray.direction, point.side)), RayNode::Kind::reflected);
    const Rgb factor = share * point.surface.pigment;
    if (RayNode* record = node(next.node)) record->factor = factor;
    return factor * follow(next).light;
}

/// Light from behind the surface. The colour of the object is put on once, where the ray enters it.
Rgb CourseRecursion::transmitted(const Path& path, const Point& point, const Vec3& direction, double share) {
    const Path next = further(path, point, unit(direction), RayNode::Kind::refracted);
    const Arrival arrival = follow(next);
    Rgb factor(share);
    if (!point.inside() && arrival.t < infinity)
        factor *= rules_.beers ? course::beers_law(point.surface.pigment, arrival.t, CourseRules::beer_density) : point.surface.pigment;
    if (RayNode* record = node(next.node)) record->factor = factor;
    return factor * arrival.light;
}

}  // namespace rt
