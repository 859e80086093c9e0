#include "trace/shadow.h"

#include <algorithm>

#include "shading/optics.h"
#include "trace/area_average.h"

namespace rt {
namespace {

/// Beyond so many surfaces on the way to a light nothing is left of it.
constexpr int most_shadow_crossings = 10000;
/// Larger area lights ask shared corners again instead of remembering them.
constexpr std::int64_t most_cached_samples = 1 << 20;

/// Only these ask for the normals of layers.
bool has_caustics(const World& world) {
    return std::any_of(world.interiors.begin(), world.interiors.end(),
                       [](const CompiledInterior& medium) { return medium.caustics != 0.0; });
}

}  // namespace

Shadows::Shadows(const World& world, const DistanceRules& rules, const TraceOptions& options)
    : world_(world),
      rules_(rules),
      tinted_(world.features.transmits && options.shadows == ShadowKind::full),
      opaque_first_(options.distances == Distances::scaled),
      layers_(world, {options.quality.quick_colors, has_caustics(world), options.adc_bailout.value_or(world.adc_bailout)}),
      atmosphere_(world),
      blockers_(world.lights.size()) {}

[[gnu::noinline]] bool Shadows::comes_through(std::uint32_t light, const SurfacePoint& at, LightRay& ray) const {
    const Interval range = rules_.shadow(ray.distance, at.error);
    if (!(range.min < range.max)) return false;
    const std::optional<double> mask = world_.through(light, {rules_.leave(at, ray.direction), ray.direction}, range);
    if (mask) ray.distance = *mask;
    return mask.has_value();
}

Rgb Shadows::transmitted(std::uint32_t light_index, const SurfacePoint& at, const LightRay& ray, std::span<const std::uint32_t> inside,
                         ShadowAnswer* answer) {
    ++rays;
    const bool fogged = world_.features.fogged_lights && world_.lights[light_index].media_attenuation;
    Rgb light(1.0);
    if (!tinted_ || opaque_first_) {
        const Interval range = rules_.shadow(ray.distance, at.error);
        if (range.min < range.max && world_.occluded({rules_.leave(at, ray.direction), ray.direction}, range, blockers_[light_index]))
            light = Rgb(0.0);
    }
    if (tinted_ && light != Rgb(0.0))
        light = through_transparent(at, ray, fogged, inside, answer);
    else if (fogged && light != Rgb(0.0))
        light *= atmosphere_.dimmed({at.point, ray.direction}, ray.distance, inside);
    if (answer != nullptr) answer->transmitted = light;
    return light;
}

Rgb Shadows::through_transparent(const SurfacePoint& at, const LightRay& ray, bool fogged, std::span<const std::uint32_t> inside,
                                 ShadowAnswer* answer) {
    Rgb light(1.0);
    inside_.assign(inside.begin(), inside.end());
    SurfacePoint from = at;
    double left = ray.distance;
    for (int i = 0; i < most_shadow_crossings; ++i) {
        const Ray segment{rules_.leave(from, ray.direction), ray.direction};
        const Interval range = rules_.shadow(left, from.error);
        Hit hit;
        const bool met = range.min < range.max && world_.nearest(segment, range, RayKind::shadow, hit);
        if (fogged) light *= atmosphere_.dimmed({from.point, ray.direction}, met ? hit.shape.t : left, inside_);
        if (!met) return light;
        const CompiledObject& object = world_.objects[hit.object];
        if (!world_.materials[object.material].can_transmit) return Rgb(0.0);
        if (answer != nullptr) answer->crossed.push_back(hit.object);

        const Vec3 point = segment.at(hit.shape.t);
        const Vec3 normal = world_.normal(hit, point);
        const Vec3 facing = dot(normal, ray.direction) > 0.0 ? -normal : normal;
        light *= filtered(hit, point, ray.direction, facing);
        fade(object.interior, hit.shape.t, light);
        if (light == Rgb(0.0)) return light;

        left -= hit.shape.t;
        from = {.point = point,
                .normal = facing,
                .side = world_.flat_side(hit, normal),
                .direction = ray.direction,
                .t = hit.shape.t,
                .error = rules_.point_error(point, hit.shape.t),
                .object = hit.object};
    }
    return Rgb(0.0);
}

Rgb Shadows::filtered(const Hit& hit, const Vec3& point, const Vec3& direction, const Vec3& normal) {
    const CompiledObject& object = world_.objects[hit.object];
    const bool two_faced = !world_.materials[object.material].interior_layers.empty();
    const bool inside = two_faced && world_.met_from_inside(hit, point, direction);
    const double caustics = world_.interiors[object.interior].caustics;
    const auto layer_filter = [&](const LayerSample& layer) {
        const double cos = dot(layer.bumped ? layer.normal : normal, direction);
        const double focus = caustics == 0.0 ? 1.0 : 1.0 + std::pow(std::fmin(std::fabs(cos), 1.0), caustics);
        return focus * (layer.color.filter * layer.color.rgb + Rgb(layer.color.transmit));
    };
    const SampledTexture& texture = layers_.at(object, inside, {hit, point, normal, direction});
    Rgb filter(1.0);
    if (texture.shares.empty()) {
        for (const LayerSample& layer : texture.layers) filter *= layer_filter(layer);
        return filter;
    }
    Rgb sum(0.0);
    double shown = 0.0;  // less than 1 where some textures had too little weight
    std::size_t i = 0;
    for (const TextureShare& share : texture.shares) {
        for (filter = Rgb(1.0); i < share.end; ++i) filter *= layer_filter(texture.layers[i]);
        sum += share.weight * filter;
        shown += share.weight;
    }
    return shown * sum;
}

void Shadows::fade(std::uint32_t interior, double segment, Rgb& light) {
    const CompiledInterior& medium = world_.interiors[interior];
    for (std::size_t i = 0; i < inside_.size(); ++i) {
        if (inside_[i] != interior) continue;
        if (medium.fade_power > 0.0) light *= distance_fade(segment, medium.fade_distance, medium.fade_power, medium.fade_color);
        inside_.erase(inside_.begin() + static_cast<std::ptrdiff_t>(i));
        return;
    }
    inside_.push_back(interior);
}

Rgb Shadows::area(const LightSource& source, std::uint32_t index, const Rgb& color, const SurfacePoint& at,
                  std::span<const std::uint32_t> inside, RayNode* log) {
    const AreaLight& area = *source.area();
    const AreaGrid grid(source.light(), at.point);
    const std::int64_t count = std::int64_t{area.size1} * area.size2;
    const bool cached = count <= most_cached_samples;
    if (cached && samples_.size() < static_cast<std::size_t>(count)) samples_.resize(static_cast<std::size_t>(count));
    if (++stamp_ == 0) {
        for (Cached& sample : samples_) sample.stamp = 0;
        stamp_ = 1;
    }
    const auto ask = [&](int u, int v) {
        ShadowAnswer answer{
            index, static_cast<std::uint32_t>(v) * static_cast<std::uint32_t>(area.size1) + static_cast<std::uint32_t>(u), Rgb(1.0), {}};
        LightRay ray = source.towards(grid.position(u, v), at.point);
        if (source.light().mask && !comes_through(index, at, ray)) return Rgb(0.0);
        const Rgb light = color * transmitted(index, at, ray, inside, log != nullptr ? &answer : nullptr);
        if (log != nullptr) log->shadows.push_back(std::move(answer));
        return light;
    };
    auto sample = [&](int u, int v) {
        if (!cached) return ask(u, v);
        Cached& entry = samples_[static_cast<std::size_t>(std::int64_t{v} * area.size1 + u)];
        if (entry.stamp != stamp_) entry = {ask(u, v), stamp_};
        return entry.light;
    };
    constexpr int always = 100;
    return average_corners({0, 0, area.size1 - 1, area.size2 - 1}, 0, area.adaptive.value_or(always), sample);
}

}  // namespace rt
