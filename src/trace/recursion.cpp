#include "trace/recursion.h"

#include <array>

#include "shading/optics.h"
#include "shading/povray_finish.h"
#include "trace/environment.h"

namespace rt {
namespace {

/// Transparent surfaces that one path passes; behind the last one it is dark. Only absurd scenes have more.
constexpr int most_crossings = 10000;

struct Reflectivity {
    Rgb rgb{0.0};
    double weight = 0.0;  ///< what the ray's weight is multiplied by
};

/// By the finish's `reflection`, or by what the catalogue says of the surroundings; `inside` of a transparent body.
Reflectivity reflectivity(const LayerSample& layer, double cos, double fresnel_eta, bool inside) {
    const Reflection& mirror = layer.finish->finish.reflection;
    const Rgb& pigment = layer.color.rgb;
    Reflectivity r;
    if (const SurfaceModel& model = layer.finish->model; model.env != Surroundings::finish) {
        r.rgb = surroundings_weight(model, cos, inside, metallic_f0(pigment, layer.finish->finish.metallic));
        r.weight = max_component(r.rgb);
        return r;
    }
    if (mirror.fresnel) {
        const double F = fresnel_reflectance(fresnel_eta, cos);
        r.rgb = F * mirror.max + (1.0 - F) * mirror.min;
        r.weight = max_component(r.rgb);
    } else {
        r.rgb = angular_reflectivity(mirror.min, mirror.max, mirror.falloff, cos);
        r.weight = std::fmax(max_component(mirror.min), max_component(mirror.max));
    }
    if (mirror.metallic != 0.0) r.rgb *= metallic_tint(pigment, mirror.metallic, cos);
    return r;
}

/// Terms guard themselves against NaN; what is left comes from products of infinities with 0, so it is an overflow.
double overflowed(double x) { return std::isnan(x) ? infinity : x; }

}  // namespace

Recursion::Recursion(const World& world, const TraceOptions& options)
    : world_(world),
      quality_(options.quality),
      rules_(options.distances, world.scene_extent, world.scene_size),
      lighting_(world, options, rules_),
      layers_at_(world, options.quality.quick_colors),
      environment_(options.environment),
      max_level_(std::clamp(options.max_trace_level.value_or(world.max_trace_level), 1, GlobalSettings::highest_trace_level)),
      adc_bailout_(options.adc_bailout.value_or(world.adc_bailout)) {
    if (options.specular_aa && options.shading == ShadingModel::general) footprints_.emplace(world, rules_, *options.specular_aa);
}

Radiance Recursion::camera_ray(const Ray& ray, RayLog* log) {
    log_ = log;
    Radiance result;
    start(ray, nullptr, result);
    if (log_ != nullptr) total(*log_);
    return result;
}

void Recursion::camera_rays(std::span<const Ray> rays, std::span<Radiance> light) {
    log_ = nullptr;
    std::array<Hit, packet_size> hits;
    for (std::size_t first = 0; first < rays.size(); first += packet_size) {
        const std::span<const Ray> packet = rays.subspan(first, std::min(packet_size, rays.size() - first));
        const std::uint32_t found = world_.nearest(packet, rules_.traced(), RayKind::image, hits);
        for (std::size_t i = 0; i < packet.size(); ++i) {
            const FirstHit known{(found >> i & 1u) != 0 ? &hits[i] : nullptr};
            start(packet[i], &known, light[first + i]);
        }
    }
}

void Recursion::start(const Ray& ray, const FirstHit* first, Radiance& result) {
    ++counts.camera;
    const Path path{.ray = ray};
    if (first != nullptr && first->hit == nullptr && path.weight >= adc_bailout_) {
        // Most pixels of many pictures: nothing to prepare, nothing to follow.
        result = {};
        leave_scene(path, result, nullptr);
        return;
    }
    interiors_.assign(world_.camera_interiors.begin(), world_.camera_interiors.end());
    trace(path, 0, start_node(RayNode::none, RayNode::Kind::camera, path, Rgb(1.0), 1.0), first, result);
    result.rgb = {overflowed(result.rgb.r), overflowed(result.rgb.g), overflowed(result.rgb.b)};
}

/// A new record; nothing without a log.
std::uint32_t Recursion::start_node(std::uint32_t parent, RayNode::Kind kind, const Path& path, const Rgb& factor, double exponent) {
    if (log_ == nullptr) return RayNode::none;
    RayNode node;
    node.parent = parent;
    node.kind = kind;
    node.ray = path.ray;
    node.level = path.level + (path.straight ? 0 : 1);
    node.weight = path.weight;
    node.factor = factor;
    node.exponent = exponent;
    log_->nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(log_->nodes.size() - 1);
}

RayNode* Recursion::node(std::uint32_t index) { return log_ == nullptr ? nullptr : &log_->nodes[index]; }

/// Follows the path to its end. Its interiors are those from `first_interior` on.
void Recursion::trace(Path path, std::size_t first_interior, std::uint32_t first_node, const FirstHit* first, Radiance& result) {
    const std::size_t caller = first_interior_;
    first_interior_ = first_interior;
    result = {};
    std::uint32_t at_node = first_node;
    for (int i = 0; i < most_crossings && step(path, result, at_node, i == 0 ? first : nullptr); ++i) {
    }
    first_interior_ = caller;
}

/// Goes to the next surface and adds what is found there; true if the path goes on behind it.
bool Recursion::step(Path& path, Radiance& result, std::uint32_t& at_node, const FirstHit* known) {
    if (path.level >= max_level_ || !(path.weight >= adc_bailout_)) {
        if (RayNode* record = node(at_node)) record->end = path.level >= max_level_ ? RayNode::End::level : RayNode::End::weight;
        return false;
    }
    if (!path.straight) ++path.level;
    Hit searched;
    const Hit* found = known != nullptr ? known->hit : world_.nearest(path.ray, rules_.traced(), path.kind, searched) ? &searched : nullptr;
    if (found == nullptr) {
        leave_scene(path, result, node(at_node));
        return false;
    }
    const CompiledObject& object = world_.objects[found->object];
    const Material& material = world_.materials[object.material];
    Surface surface{.at = surface_point(path.ray, *found),
                    .object = &object,
                    .first_layer = layers_.size(),
                    .first_mirror = mirrors_.size(),
                    .filter = Rgb(1.0),
                    .trans = 1.0,
                    .crossing = {.interior = object.interior},
                    .node = at_node};
    if (material.can_transmit || material.can_reflect) surface.crossing = meet(world_, inside(), object.interior);
    resolve_layers(surface, path.weight);
    if (footprints_ && path.level == 1 && !path.straight)  // the camera's ray itself
        surface.at.footprint = footprints_->around(path.ray, *found, surface.at, std::span(layers_).subspan(surface.first_layer));
    if (RayNode* record = node(at_node)) log_surface(*record, surface, *found);

    result.rgb += path.filter * local_light(surface);
    const bool goes_on = pass(surface, path, result, at_node);
    layers_.resize(surface.first_layer);
    mirrors_.resize(surface.first_mirror);
    return goes_on;
}

void Recursion::leave_scene(const Path& path, Radiance& result, RayNode* record) const {
    const Rgb light = environment_ ? environment_->at(path.ray.direction) : world_.background;
    result.rgb += path.filter * light;
    result.transmittance = environment_ ? 0.0 : path.transmittance * world_.background_transmit;
    if (record != nullptr) record->end = RayNode::End::background, record->background = light;
}

SurfacePoint Recursion::surface_point(const Ray& ray, const Hit& hit) const {
    const Vec3 point = ray.at(hit.shape.t);
    const Vec3 normal = world_.normal(hit, point);
    const bool away = dot(normal, ray.direction) > 0.0;
    const bool two_faced = !world_.materials[world_.objects[hit.object].material].interior_layers.empty();
    return {.point = point,
            .normal = away ? -normal : normal,
            .side = world_.flat_side(hit, normal),
            .direction = ray.direction,
            .t = hit.shape.t,
            .error = rules_.point_error(point, hit.shape.t),
            .object = hit.object,
            .inside = two_faced ? world_.met_from_inside(hit, point, ray.direction) : away};
}

/// From the top layer down while any light comes through: opacities, filters, mirrors.
void Recursion::resolve_layers(Surface& surface, double weight) {
    for (const LayerSample& layer : layers_at_.at(*surface.object, surface.at.inside, surface.at.point)) {
        if (!(surface.trans > adc_bailout_)) break;
        const PigmentColor& c = layer.color;
        layers_.push_back({c, layer.finish, opacity(c.rgb, c.filter, c.transmit, world_.legacy_opacity), surface.filter});
        Rgb lost(0.0);
        if (layer.finish->reflects) {
            const double cos = -dot(surface.at.direction, surface.at.normal);
            const bool inside = surface.crossing.leaves() && world_.materials[surface.object->material].can_transmit;
            const Reflectivity r = reflectivity(layer, cos, surface.crossing.fresnel_eta, inside);
            if (quality_.reflection && r.rgb != Rgb(0.0)) {
                const bool by_finish = layer.finish->model.env == Surroundings::finish;
                const double exponent = by_finish ? layer.finish->finish.reflection.exponent : 1.0;
                mirrors_.push_back({r.rgb, weight * surface.trans * r.weight, exponent});
            }
            if (layer.finish->finish.conserve_energy) lost = r.rgb;
        }
        surface.filter *= c.filter * c.rgb + Rgb(c.transmit);
        if (lost != Rgb(0.0))
            surface.filter *= Rgb(std::fmin(1.0, 1.0 - lost.r), std::fmin(1.0, 1.0 - lost.g), std::fmin(1.0, 1.0 - lost.b));
        surface.trans = std::fmin(1.0, std::fabs(grey(surface.filter)));
    }
}

Rgb Recursion::local_light(const Surface& surface) {
    const std::span<const ActiveLayer> layers = std::span(layers_).subspan(surface.first_layer);
    if (!quality_.lighting) return layers.empty() ? Rgb(0.0) : layers.back().color.rgb;
    LocalLight light;
    for (const ActiveLayer& layer : layers) {
        const Finish& finish = layer.finish->finish;
        const Rgb ambient = lighting_.ambient_per_light(*layer.finish) ? Rgb(0.0) : finish.ambient * world_.ambient_light;
        light.ambient += layer.above * layer.color.rgb * layer.opacity * (ambient + finish.emission);
    }
    RayNode* record = node(surface.node);
    lighting_.direct(surface.at, layers, inside(), light, record);
    if (record != nullptr) record->ambient = light.ambient, record->diffuse = light.diffuse, record->specular = light.specular;
    return light.sum();
}

/// What lies behind the surface and in its mirrors. True if the path goes on: bent, straight, or totally reflected.
bool Recursion::pass(const Surface& surface, Path& path, Radiance& result, std::uint32_t& at_node) {
    const bool through = world_.materials[surface.object->material].can_transmit && quality_.transmission && quality_.lighting &&
                         surface.trans > adc_bailout_;
    Refraction bent;
    if (through) bent = refract(surface.at.direction, surface.at.normal, surface.crossing.ratio);
    if (!(through && bent.total)) reflect_layers(surface, path, result);
    if (!through) return false;

    const CompiledInterior& medium = world_.interiors[surface.crossing.interior];
    Rgb factor(medium.refraction);
    if (surface.crossing.leaves()) factor *= distance_fade(surface.at.t, medium.fade_distance, medium.fade_power, medium.fade_color);
    path.weight *= max_component(surface.filter);
    if (bent.total) {
        ++counts.reflected;
        path.kind = RayKind::reflected;
        path.straight = false;
        path.transmittance = 0.0;
        path.ray.direction = reflect(surface.at.direction, surface.at.normal);
    } else {
        ++counts.refracted;
        cross(interiors_, first_interior_, surface.crossing);
        factor *= surface.filter;
        path.straight = bent.straight;
        path.transmittance *= surface.trans;
        path.ray.direction = bent.direction;
    }
    path.ray.origin = rules_.leave(surface.at, path.ray.direction);
    path.filter *= factor;
    const RayNode::Kind kind = bent.total ? RayNode::Kind::total : bent.straight ? RayNode::Kind::straight : RayNode::Kind::refracted;
    at_node = start_node(at_node, kind, path, factor, 1.0);
    return true;
}

void Recursion::reflect_layers(const Surface& surface, const Path& path, Radiance& result) {
    for (std::size_t i = surface.first_mirror; i < mirrors_.size(); ++i) {
        const Mirror mirror = mirrors_[i];
        ++counts.reflected;
        const Vec3 direction = reflect(surface.at.direction, surface.at.normal);
        const Path mirrored{.ray = {rules_.leave(surface.at, direction), direction},
                            .weight = mirror.weight,
                            .level = path.level,
                            .kind = RayKind::reflected};
        const std::uint32_t child = start_node(surface.node, RayNode::Kind::reflected, mirrored, mirror.reflectivity, mirror.exponent);
        const std::size_t end = interiors_.size();
        for (std::size_t k = first_interior_; k < end; ++k) interiors_.push_back(interiors_[k]);
        Radiance light;
        trace(mirrored, end, child, nullptr, light);
        interiors_.resize(end);
        result.rgb += path.filter * mirror.reflectivity * reflected_light(light.rgb, mirror.exponent);
    }
}

void Recursion::log_surface(RayNode& record, const Surface& surface, const Hit& hit) const {
    record.object = hit.object;
    record.part = hit.shape.part;
    record.t = hit.shape.t;
    record.point = surface.at.point;
    record.normal = surface.at.normal;
    record.inside = surface.at.inside;
    for (const ActiveLayer& layer : std::span(layers_).subspan(surface.first_layer)) record.layers.push_back(layer.color);
}

}  // namespace rt
