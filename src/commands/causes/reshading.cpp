#include "commands/causes/reshading.h"

#include <vector>

#include "commands/causes/broken_paths.h"
#include "shading/course_terms.h"
#include "shading/optics.h"
#include "trace/course_surface.h"

namespace rt {

namespace {

/// One node of the tree, with what its light needs.
class Place {
public:
    Place(const ShadedScene& shaded, const RayNode& node, const Reshading& how)
        : shaded_(shaded),
          node_(node),
          how_(how),
          to_viewer_(-node.ray.direction),
          normal_(changed_normal(shaded.scene.objects[node.object], node.normal, node.inside, how.normal)) {
        const Finish& finish =
            top_layer(shaded.world.materials[shaded.world.objects[node.object].material].layers, node.point).finish->finish;
        surface_ = {.pigment = node.layers.front().rgb,
                    .filter = node.layers.front().filter,
                    .ambient = finish.ambient.r,
                    .diffuse = finish.diffuse,
                    .specular = finish.specular,
                    .roughness = finish.roughness.value_or(1.0),
                    .reflection = finish.reflection.max.r,
                    .ior = shaded.world.interiors[shaded.world.objects[node.object].interior].ior};
    }

    const course::Surface& surface() const { return surface_; }

    Rgb light() const {
        const Rgb pigment = how_.without_pigment ? Rgb(1.0) : surface_.pigment;
        const bool camera = node_.kind == RayNode::Kind::camera;
        double ambient_count = 1.0;
        Rgb diffuse(0.0), specular(0.0);
        if (how_.ambient_for_each_lamp) ambient_count = static_cast<double>(shaded_.world.lights.size());
        for (const ShadowAnswer& answer : node_.shadows) {
            if (how_.lamps == Reshading::Lamps::first && answer.light > 0) break;
            if (!arrives(answer, camera)) continue;
            add_lamp(shaded_.world.lights[answer.light], diffuse, specular);
        }
        return pigment * (how_.ambient * ambient_count * surface_.ambient + how_.diffuse * diffuse + how_.specular * specular);
    }

private:
    bool arrives(const ShadowAnswer& answer, bool camera) const {
        const std::uint32_t bit = answer.light < 32 ? 1u << answer.light : 0u;
        if (camera && (how_.hidden_lamps & bit) != 0) return false;
        if (camera && (how_.shown_lamps & bit) != 0) return true;
        if (how_.shadows == Reshading::Shadows::none) return true;
        return how_.shadows == Reshading::Shadows::as_found && answer.transmitted != Rgb(0.0);
    }

    void add_lamp(const Light& lamp, Rgb& diffuse, Rgb& specular) const {
        const Vec3 way = lamp.location - node_.point;
        const double distance = length(way);
        if (distance == 0.0) return;
        const Vec3 l = way / distance;
        const double n_dot_l = dot(normal_, l);
        Rgb color = how_.lamps == Reshading::Lamps::white ? Rgb(1.0) : lamp.color;
        if (how_.lamps == Reshading::Lamps::faded) color /= distance * distance;
        diffuse += surface_.diffuse * cosine(n_dot_l, distance) * color;
        if (surface_.specular == 0.0) return;
        const double weight = how_.lobe == Reshading::Lobe::times_n_dot_l ? std::max(0.0, n_dot_l) : 1.0;
        specular += surface_.specular * weight * lobe(how_.cosine == Reshading::Cosine::times_distance ? way : l) * color;
    }

    double cosine(double n_dot_l, double distance) const {
        switch (how_.cosine) {
            case Reshading::Cosine::clamped:
                return std::max(0.0, n_dot_l);
            case Reshading::Cosine::negative_too:
                return n_dot_l;
            case Reshading::Cosine::absolute:
                return std::fabs(n_dot_l);
            case Reshading::Cosine::none:
                return 1.0;
            case Reshading::Cosine::times_distance:
                return std::max(0.0, n_dot_l * distance);
        }
        return 0.0;
    }

    double lobe(const Vec3& l) const {
        const bool cook_torrance = shaded_.rules.cook_torrance != (how_.lobe == Reshading::Lobe::other_model);
        if (cook_torrance) {
            const double roughness = surface_.roughness / std::pow(how_.exponent_scale, 0.25);
            return course::cook_torrance(normal_, unit(l), to_viewer_, roughness, surface_.ior);
        }
        double roughness = surface_.roughness;
        if (how_.lobe == Reshading::Lobe::roughness_not_squared) roughness = std::sqrt(roughness);
        const double exponent = how_.exponent_scale * std::max(0.0, 2.0 / sqr(roughness) - 2.0);
        double cosine = dot(normal_, course::half_vector(l, to_viewer_));
        if (how_.lobe == Reshading::Lobe::half_not_unit) cosine = dot(normal_, l + to_viewer_);
        if (how_.lobe == Reshading::Lobe::phong) cosine = dot(reflect(-l, normal_), to_viewer_);
        return std::pow(std::clamp(cosine, 0.0, 1.0), exponent);
    }

    const ShadedScene& shaded_;
    const RayNode& node_;
    const Reshading& how_;
    Vec3 to_viewer_, normal_;
    course::Surface surface_;
};

/// What a further ray's light is multiplied by in its parent's.
Rgb factor_of(const RayNode& node, const RayNode& parent, const course::Surface& surface, const Reshading& how) {
    const RayNode::Shares shares = parent.shares.value_or(RayNode::Shares{});
    if (node.kind == RayNode::Kind::refracted) return how.refraction * (how.unfiltered ? Rgb(shares.transmission) : node.factor);
    double share = shares.reflection;
    // Of a mirror that is one because nothing passes, only its own share stays.
    if (how.total_reflection_lost && surface.filter > 0.0 && shares.transmission == 0.0)
        share = (1.0 - surface.filter) * surface.reflection;
    return how.reflection * share * (how.untinted_mirrors ? Rgb(1.0) : surface.pigment);
}

}  // namespace

Rgb reshaded(const ShadedScene& shaded, const RayLog& log, const Reshading& how) {
    std::vector<Rgb> light(log.nodes.size(), Rgb(0.0));
    for (std::size_t i = log.nodes.size(); i-- > 0;) {
        const RayNode& node = log.nodes[i];
        if (node.object == RayNode::none || node.level > how.deepest + 1) {
            light[i] = Rgb(0.0);
            continue;
        }
        const double local = how.local_unscaled || !node.shares ? 1.0 : node.shares->local;
        light[i] += local * Place(shaded, node, how).light();
        if (node.parent == RayNode::none) continue;
        const RayNode& parent = log.nodes[node.parent];
        light[node.parent] += factor_of(node, parent, Place(shaded, parent, how).surface(), how) * light[i];
    }
    return log.nodes.empty() ? Rgb(0.0) : light.front();
}

}  // namespace rt
