#include "trace/lighting.h"

#include "shading/optics.h"
#include "shading/povray_finish.h"
#include "trace/footprint.h"
#include "trace/grain.h"

namespace rt {
namespace {

bool has_highlight(const SurfaceModel& model) { return model.s != 0.0 && model.specular != SurfaceModel::Specular::none; }

/// Whether the highlight does not ask on which side the lamp is.
bool is_ungated(const SurfaceModel& model) {
    return has_highlight(model) && model.specular == SurfaceModel::Specular::phong && !model.phong_gate;
}

bool is_microfacet(const SurfaceModel& model) { return model.specular == SurfaceModel::Specular::microfacet; }

bool is_dark(const Rgb& light) { return std::fabs(light.r) < 1e-10 && std::fabs(light.g) < 1e-10 && std::fabs(light.b) < 1e-10; }

}  // namespace

Lighting::Lighting(const World& world, const TraceOptions& options, const DistanceRules& rules)
    : world_(world),
      general_(options.shading == ShadingModel::general && world.features.catalogue),
      facing_(options.shading == ShadingModel::general ? least_cosine : facing_cosine),
      cast_shadows_(options.quality.shadows && options.shadows != ShadowKind::none),
      shadows_(world, rules, options) {
    for (const Light& light : world.lights) sources_.emplace_back(light, options.lamps);
}

Lighting::View Lighting::view(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside,
                              RayNode* log) const {
    View view{.at = at, .layers = layers, .inside = inside, .both_sides = world_.objects[at.object].double_illuminate, .log = log};
    bool inclined = false, sine = false;
    for (const ActiveLayer& layer : layers) {
        const Finish& finish = layer.finish->finish;
        const SurfaceModel& model = layer.finish->model;
        const bool takes_diffuse = layer.opacity != 0.0 && (!general_ || model.diffuse_share != 0.0);
        view.any_diffuse |= finish.diffuse > 0.0 && takes_diffuse;
        view.back_diffuse |= finish.diffuse_back > 0.0 && takes_diffuse;
        view.any_highlight |= finish.phong > 0.0 || (general_ ? has_highlight(model) : finish.specular > 0.0);
        if (!general_) continue;
        view.unshadowed |= model.diffuse == Diffuse::gooch || model.ambient_per_light;
        view.ungated |= is_ungated(model);
        sine |= has_highlight(model) && model.sine_of_view;
        inclined |= has_highlight(model) || model.diffuse == Diffuse::oren_nayar;
    }
    if (view.any_highlight) view.mirrored = reflect(at.direction, at.normal);
    if (inclined) view.seen = viewed_point(at.normal, -at.direction, sine);
    return view;
}

void Lighting::light_layers(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside,
                            LocalLight& result, RayNode* log) {
    const View shared = view(at, layers, inside, log);
    if (!shared.any_diffuse && !shared.any_highlight && !shared.back_diffuse && !shared.unshadowed) return;
    const bool grouped = world_.features.light_groups;
    for (std::uint32_t i = 0; i < sources_.size(); ++i)
        if (!grouped || world_.lights_up(i, at.object)) one_light(sources_[i], i, shared, result);
}

void Lighting::direct(const SurfacePoint& at, std::span<const ActiveLayer> layers, std::span<const std::uint32_t> inside,
                      LocalLight& result, RayNode* log) {
    if (world_.features.normals) return light_bumped(at, layers, inside, result, log);
    light_layers(at, layers, inside, result, log);
}

/// Layers that share a normal share the shadow rays.
[[gnu::noinline]] void Lighting::light_bumped(const SurfacePoint& at, std::span<const ActiveLayer> layers,
                                              std::span<const std::uint32_t> inside, LocalLight& result, RayNode* log) {
    const auto normal_of = [&](const ActiveLayer& layer) { return layer.bumped ? layer.normal : at.normal; };
    for (std::size_t first = 0, end = 0; first < layers.size(); first = end) {
        SurfacePoint bumped = at;
        bumped.normal = normal_of(layers[first]);
        for (end = first + 1; end < layers.size() && normal_of(layers[end]) == bumped.normal;) ++end;
        light_layers(bumped, layers.subspan(first, end - first), inside, result, log);
    }
}

/// Can light from this side contribute anything?
bool Lighting::is_seen(const View& view, double n_dot_l, bool shadowless) const {
    if (n_dot_l >= facing_ || view.both_sides) return view.any_diffuse || (view.any_highlight && !shadowless);
    return (view.back_diffuse || (view.ungated && !shadowless)) && !std::isnan(n_dot_l);
}

void Lighting::one_light(const LightSource& source, std::uint32_t index, const View& view, LocalLight& result) {
    const Light& light = source.light();
    const SurfacePoint& at = view.at;
    const bool illuminates_by_area = source.area() != nullptr && source.area()->area_illumination;
    LightRay ray = source.towards(light.location, at.point);
    const double n_dot_l = dot(at.normal, ray.direction);
    if (view.unshadowed && !std::isnan(n_dot_l)) add_unshadowed(source, view, ray, n_dot_l, result);
    if (!illuminates_by_area && !is_seen(view, n_dot_l, light.shadowless)) return;

    Rgb arriving = light.color;
    if (!illuminates_by_area) arriving *= source.attenuation(at.point, ray);
    if (is_dark(arriving)) return;
    const bool is_shadowed = cast_shadows_ && !light.shadowless;
    if (light.mask && !(is_shadowed && source.area() != nullptr) && !shadows_.comes_through(index, at, ray)) return;
    if (is_shadowed) {
        if (source.area() != nullptr) {
            arriving = shadows_.area(source, index, arriving, at, view.inside, view.log);
        } else {
            arriving *= transmitted(index, view, ray);
        }
        if (arriving == Rgb(0.0)) return;
    }
    if (illuminates_by_area) {
        area_illumination(source, arriving, view, result);
    } else {
        add(view, source, ray, n_dot_l, arriving, result);
    }
}

Rgb Lighting::transmitted(std::uint32_t index, const View& view, const LightRay& ray) {
    if (view.log == nullptr) return shadows_.transmitted(index, view.at, ray, view.inside, nullptr);
    ShadowAnswer answer{index, 0, Rgb(1.0), {}};
    const Rgb light = shadows_.transmitted(index, view.at, ray, view.inside, &answer);
    view.log->shadows.push_back(std::move(answer));
    return light;
}

void Lighting::area_illumination(const LightSource& source, const Rgb& light, const View& view, LocalLight& result) const {
    const AreaLight& area = *source.area();
    const AreaGrid grid(source.light(), view.at.point);
    const double share = 1.0 / (static_cast<double>(area.size1) * area.size2);
    for (int j = 0; j < area.size2; ++j) {
        for (int i = 0; i < area.size1; ++i) {
            const Vec3 location = grid.position(i, j);
            const LightRay ray = source.towards(location, view.at.point);
            const double n_dot_l = dot(view.at.normal, ray.direction);
            if (!is_seen(view, n_dot_l, source.light().shadowless)) continue;
            const Rgb arriving = share * source.attenuation(view.at.point, ray) * light;
            add(view, source, ray, n_dot_l, arriving, result);
        }
    }
}

void Lighting::add(const View& view, const LightSource& source, const LightRay& ray, double n_dot_l, const Rgb& light,
                   LocalLight& result) const {
    const Vec3& l = ray.direction;
    const bool front = n_dot_l >= facing_ || view.both_sides;
    const double cos = std::fabs(n_dot_l);
    for (const ActiveLayer& layer : view.layers) {
        const Finish& finish = layer.finish->finish;
        Rgb arriving = layer.above * light;
        if (world_.features.grain && finish.irid)
            arriving *= film_factor(*finish.irid, world_, view.at.point, n_dot_l, dot(view.at.normal, view.at.direction));
        double diffuse = std::fmax(0.0, front ? finish.diffuse : finish.diffuse_back) * layer.opacity;
        if (general_) diffuse *= diffuse_factor(layer.finish->model, view.seen, l, cos);
        if (diffuse != 0.0 && cos > 0.0) {
            double strength = diffuse * diffuse_cosine(cos, finish.brilliance);
            if (world_.features.grain && finish.crand != 0.0) strength = std::fmax(0.0, strength - finish.crand * chance_at(view.at.point));
            result.diffuse += strength * (layer.color.rgb * arriving);
        }
        if (source.light().shadowless || !view.any_highlight) continue;
        if (front) result.specular += arriving * povray_highlights(view, layer, l, n_dot_l);
        if (general_ && has_highlight(layer.finish->model) && (front || is_ungated(layer.finish->model)))
            result.specular += arriving * (view.at.footprint == nullptr || !is_microfacet(layer.finish->model)
                                               ? catalogue_highlight(view, layer, l, n_dot_l)
                                               : widened_highlight(view, layer, source, ray));
    }
}

/// What a lamp adds whether or not its light arrives: Gooch's tones, averaged over the lamps, and ambient light by the lamp.
void Lighting::add_unshadowed(const LightSource& source, const View& view, const LightRay& ray, double n_dot_l, LocalLight& result) const {
    for (const ActiveLayer& layer : view.layers) {
        const SurfaceModel& model = layer.finish->model;
        const Rgb through = layer.above * layer.opacity;
        if (model.diffuse == Diffuse::gooch) {
            const GoochTones& tones = model.gooch;
            const Rgb kd = layer.finish->finish.diffuse * layer.color.rgb;
            const Rgb cool = tones.cool + tones.cool_share * kd, warm = tones.warm + tones.warm_share * kd;
            const double towards = tones.as_printed ? -n_dot_l : n_dot_l;
            const Rgb tone(gooch(towards, cool.r, warm.r), gooch(towards, cool.g, warm.g), gooch(towards, cool.b, warm.b));
            result.diffuse += through * tone / static_cast<double>(sources_.size());
        }
        if (model.ambient_per_light) {
            const double left = model.attenuate_ambient ? source.attenuation(view.at.point, ray) : 1.0;
            result.ambient +=
                left * through * source.light().color * layer.color.rgb * (layer.finish->finish.ambient * world_.ambient_light);
        }
    }
}

/// Factor on the light that arrives, for POV-Ray's phong and, without the general form, its specular together.
Rgb Lighting::povray_highlights(const View& view, const ActiveLayer& layer, const Vec3& l, double n_dot_l) const {
    const Finish& finish = layer.finish->finish;
    double lobes = 0.0;
    if (finish.phong > 0.0) lobes += finish.phong * phong_lobe(dot(view.mirrored, l), finish.phong_size);
    if (finish.specular > 0.0 && !general_) {
        const Vec3 half = l - view.at.direction;
        const double size = length(half);
        if (size > 0.0) lobes += finish.specular * specular_lobe(dot(half, view.at.normal) / size, layer.finish->specular_exponent);
    }
    Rgb sum(lobes);
    if (lobes != 0.0 && finish.metallic > 0.0) sum *= metallic_tint(layer.color.rgb, finish.metallic, std::fabs(n_dot_l));
    return sum;
}

/// Factor on the light that arrives. Lobes without a Fresnel term are tinted as POV-Ray tints its own.
Rgb Lighting::catalogue_highlight(const View& view, const ActiveLayer& layer, const Vec3& l, double n_dot_l) const {
    const SurfaceModel& model = layer.finish->model;
    const double metallic = layer.finish->finish.metallic;
    const Rgb lobe = model.s * highlight(model, view.seen, l, metallic_f0(layer.color.rgb, metallic));
    const bool tinted = metallic > 0.0 && model.specular != SurfaceModel::Specular::microfacet;
    return tinted ? lobe * metallic_tint(layer.color.rgb, metallic, std::fabs(n_dot_l)) : lobe;
}

/// The same, at least as wide as a sample.
Rgb Lighting::widened_highlight(const View& view, const ActiveLayer& layer, const LightSource& source, const LightRay& ray) const {
    SurfaceModel wide = layer.finish->model;
    wide.alpha = widened_alpha(wide.alpha, view.at, source, ray);
    return wide.s * highlight(wide, view.seen, ray.direction, metallic_f0(layer.color.rgb, layer.finish->finish.metallic));
}

}  // namespace rt
