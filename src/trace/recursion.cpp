#include "trace/recursion.h"

#include <array>

#include "shading/optics.h"
#include "shading/povray_finish.h"
#include "trace/camera.h"
#include "trace/environment.h"
#include "trace/grain.h"

namespace rt {
namespace {

/// Transparent surfaces that one path passes; behind the last one it is dark. Only absurd scenes have more.
constexpr int most_crossings = 10000;
/// Mixtures on one way of textures that part, each of which doubles the rays; behind so many their shares count for the weights.
constexpr int free_mixtures = 10;
/// Lesser textures of mixtures inside one another, each with half of the light at most, and the share that no picture shows.
constexpr int most_nested = 64;
constexpr double least_share = 1e-9;

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

/// Mirrored at a bumped normal; where that leads into the surface, at the surface's own, or from it.
Vec3 reflect_bumped(const Vec3& direction, const Vec3& bumped, const Vec3& normal) {
    if (bumped == normal) return reflect(direction, normal);
    Vec3 r = reflect(direction, bumped);
    if (dot(r, normal) < 0.0) r = dot(r, bumped) < 0.0 ? reflect(direction, normal) : r - 2.0 * dot(r, normal) * normal;
    return unit(r);
}

/// The side of a bumped normal that a ray meets.
Vec3 facing(const Vec3& normal, const Vec3& direction) { return dot(normal, direction) > 0.0 ? -normal : normal; }

/// Terms guard themselves against NaN; what is left comes from products of infinities with 0, so it is an overflow.
double overflowed(double x) { return std::isnan(x) ? infinity : x; }

}  // namespace

Recursion::Recursion(const World& world, const TraceOptions& options)
    : world_(world),
      quality_(options.quality),
      rules_(options.distances, world.scene_extent, world.scene_size),
      lighting_(world, options, rules_),
      layers_at_(world, {options.quality.quick_colors, options.quality.normals, options.adc_bailout.value_or(world.adc_bailout)}),
      environment_(options.environment),
      atmosphere_(world),
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
    const bool unhit = first != nullptr && first->hit == nullptr;
    if ((unhit || first == nullptr) && is_no_ray(ray)) {
        result = {Rgb(0.0), 1.0};
        start_node(RayNode::none, RayNode::Kind::camera, path, Rgb(1.0), 1.0);
        return;
    }
    if (unhit && path.weight >= adc_bailout_ && !world_.features.atmosphere) {
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

/// Adds the light of a surface that shows `layers`; true if the path goes on behind it.
bool Recursion::shade(Surface& surface, std::span<const LayerSample> layers, const Hit& hit, Path& path, Radiance& result,
                      std::uint32_t& at_node) {
    resolve_layers(surface, layers, path.weight);
    if (footprints_ && path.level == 1 && !path.straight)  // the camera's ray itself
        surface.at.footprint = footprints_->around(path.ray, hit, surface.at, std::span(layers_).subspan(surface.first_layer));
    if (RayNode* record = node(at_node)) log_surface(*record, surface, hit);

    result.rgb += path.filter * local_light(surface);
    const bool goes_on = pass(surface, path, result, at_node);
    layers_.resize(surface.first_layer);
    mirrors_.resize(surface.first_mirror);
    return goes_on;
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
    if (world_.features.atmosphere) veil(path, found == nullptr ? infinity : found->shape.t, result, node(at_node));
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
    const SeenSurface seen{*found, surface.at.point, surface.at.normal, surface.at.direction};
    const SampledTexture& texture = layers_at_.at(object, surface.at.inside, seen);
    if (texture.is_mixture()) return mix(surface, SampledTexture(texture), *found, path, result, at_node);
    return shade(surface, texture.layers, *found, path, result, at_node);
}

/// Rare, and kept out of the code of all other surfaces, as veil() is.
[[gnu::noinline]] bool Recursion::mix(const Surface& surface, const SampledTexture& texture, const Hit& hit, Path& path, Radiance& result,
                                      std::uint32_t& at_node) {
    const bool together = std::none_of(texture.layers.begin(), texture.layers.end(),
                                       [](const LayerSample& layer) { return layer.bumped || layer.finish->reflects; });
    const auto main = std::ranges::max_element(texture.shares, {}, &TextureShare::weight);
    const std::vector<std::uint32_t> inside(interiors_.begin() + static_cast<std::ptrdiff_t>(first_interior_), interiors_.end());
    std::optional<OneWay> way;
    std::size_t first = 0;
    for (auto share = texture.shares.begin(); share != texture.shares.end(); first = share++->end) {
        Path branch = path;
        branch.filter *= share->weight;
        branch.transmittance *= share->weight;
        if (!together && ++branch.mixtures > free_mixtures) branch.weight *= share->weight;
        const bool lesser = !together && share != main;
        if (lesser && (++branch.nested > most_nested || max_component(glm::abs(branch.filter)) < least_share)) continue;
        Surface one = surface;
        one.share = share->weight;
        std::uint32_t next_node = surface.node;
        bool goes_on = shade(one, std::span(texture.layers).subspan(first, share->end - first), hit, branch, result, next_node);
        if (goes_on && !lesser) join(way, branch, next_node);
        for (int i = 0; i < most_crossings && goes_on && lesser; ++i) goes_on = step(branch, result, next_node, nullptr);
        interiors_.resize(first_interior_);
        interiors_.insert(interiors_.end(), inside.begin(), inside.end());
    }
    if (!way) return false;
    path = way->path;
    at_node = way->node;
    interiors_.resize(first_interior_);
    interiors_.insert(interiors_.end(), way->inside.begin(), way->inside.end());
    return true;
}

/// Adds what one texture lets through to the way of all. The ray is counted once, and told once.
void Recursion::join(std::optional<OneWay>& way, const Path& branch, std::uint32_t branch_node) {
    if (!way) {
        way = {branch, branch_node, {interiors_.begin() + static_cast<std::ptrdiff_t>(first_interior_), interiors_.end()}, counts};
        return;
    }
    way->path.filter += branch.filter;
    way->path.transmittance += branch.transmittance;
    way->path.weight = std::fmax(way->path.weight, branch.weight);
    counts = way->counts;
    if (log_ == nullptr) return;
    log_->nodes[way->node].factor += log_->nodes[branch_node].factor;
    log_->nodes.pop_back();
}

/// What fog and rainbows do on the way to the next surface: on all that is found behind them.
[[gnu::noinline]] void Recursion::veil(Path& path, double length, Radiance& result, RayNode* record) const {
    const Veil veil = atmosphere_.along(path.ray, length, inside());
    result.rgb += path.filter * veil.light;
    path.filter *= veil.left;
    path.transmittance *= veil.transmittance;
    if (record != nullptr) record->veil_light = veil.light, record->veil_left = veil.left;
}

void Recursion::leave_scene(const Path& path, Radiance& result, RayNode* record) const {
    Rgb light = world_.background;
    double seen = environment_ ? 0.0 : world_.background_transmit;
    if (environment_) {
        light = environment_->at(path.ray.direction);
    } else if (!world_.sky.empty()) {
        double through = 1.0;
        light = atmosphere_.sky(path.ray.direction, through);
        seen *= through;
    }
    result.rgb += path.filter * light;
    result.transmittance += path.transmittance * seen;
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
void Recursion::resolve_layers(Surface& surface, std::span<const LayerSample> layers, double weight) {
    surface.top_normal = !layers.empty() && layers.front().bumped ? layers.front().normal : surface.at.normal;
    for (const LayerSample& layer : layers) {
        if (!(surface.trans > adc_bailout_)) break;
        const PigmentColor& c = layer.color;
        layers_.push_back(
            {c, layer.finish, opacity(c.rgb, c.filter, c.transmit, world_.legacy_opacity), surface.filter, layer.bumped, layer.normal});
        Rgb lost(0.0);
        if (layer.finish->reflects) {
            const Vec3& normal = layer.bumped ? layer.normal : surface.at.normal;
            const double cos = -dot(surface.at.direction, normal);
            const bool inside = surface.crossing.leaves() && world_.materials[surface.object->material].can_transmit;
            Reflectivity r = reflectivity(layer, cos, surface.crossing.fresnel_eta, inside);
            if (world_.features.grain && layer.finish->finish.irid)
                r.rgb *= film_factor(*layer.finish->finish.irid, world_, surface.at.point, cos, cos);
            if (quality_.reflection && r.rgb != Rgb(0.0)) {
                const bool by_finish = layer.finish->model.env == Surroundings::finish;
                const double exponent = by_finish ? layer.finish->finish.reflection.exponent : 1.0;
                mirrors_.push_back({r.rgb, weight * surface.trans * r.weight, exponent, normal});
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
    if (record != nullptr) record->add(surface.share, light.ambient, light.diffuse, light.specular);
    return light.sum();
}

/// Factor of the topmost layer's film on light that is totally reflected.
Rgb Recursion::film_on_total(const Surface& surface) const {
    if (layers_.size() == surface.first_layer) return Rgb(1.0);
    const Finish& finish = layers_[surface.first_layer].finish->finish;
    if (!finish.irid) return Rgb(1.0);
    const double cos = dot(surface.at.direction, surface.top_normal);
    return film_factor(*finish.irid, world_, surface.at.point, cos, cos);
}

/// What lies behind the surface and in its mirrors. True if the path goes on: bent, straight, or totally reflected.
bool Recursion::pass(const Surface& surface, Path& path, Radiance& result, std::uint32_t& at_node) {
    const bool through = world_.materials[surface.object->material].can_transmit && quality_.transmission && quality_.lighting &&
                         surface.trans > adc_bailout_;
    Refraction bent;
    if (through) bent = refract(surface.at.direction, facing(surface.top_normal, surface.at.direction), surface.crossing.ratio);
    if (!(through && bent.total)) reflect_layers(surface, path, result);
    if (!through) return false;

    const CompiledInterior& medium = world_.interiors[surface.crossing.interior];
    Rgb factor(medium.refraction);
    if (surface.crossing.leaves()) factor *= distance_fade(surface.at.t, medium.fade_distance, medium.fade_power, medium.fade_color);
    path.weight *= max_component(glm::abs(surface.filter));
    if (bent.total) {
        ++counts.reflected;
        path.kind = RayKind::reflected;
        path.straight = false;
        path.transmittance = 0.0;
        path.ray.direction = reflect_bumped(surface.at.direction, surface.top_normal, surface.at.normal);
        if (world_.features.grain) factor *= film_on_total(surface);
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
    at_node = start_node(at_node, kind, path, surface.share * factor, 1.0);
    return true;
}

void Recursion::reflect_layers(const Surface& surface, const Path& path, Radiance& result) {
    for (std::size_t i = surface.first_mirror; i < mirrors_.size(); ++i) {
        const Mirror mirror = mirrors_[i];
        ++counts.reflected;
        const Vec3 direction = reflect_bumped(surface.at.direction, mirror.normal, surface.at.normal);
        const Path mirrored{.ray = {rules_.leave(surface.at, direction), direction},
                            .weight = mirror.weight,
                            .level = path.level,
                            .mixtures = path.mixtures,
                            .kind = RayKind::reflected};
        const std::uint32_t child =
            start_node(surface.node, RayNode::Kind::reflected, mirrored, surface.share * mirror.reflectivity, mirror.exponent);
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
