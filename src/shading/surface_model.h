// What a surface does with light that arrives, chosen from the catalogue, with all its numbers in place.
#pragma once

#include <memory>

#include "shading/albedo.h"
#include "shading/lamps.h"
#include "shading/models.h"

namespace rt {

/// Colours of Gooch shading: k_cool = cool + cool_share k_d, k_warm = warm + warm_share k_d, with the values their paper shows.
struct GoochTones {
    Rgb cool{0.0, 0.0, 0.4}, warm{0.4, 0.4, 0.0};
    double cool_share = 0.2, warm_share = 0.6;
    bool as_printed = false;  ///< a text's formula with l towards the light: cool where the light falls
};

/// A point of a surface as its viewer sees it, the same for all lamps: unit normal and direction to the viewer, and their angle.
struct ViewedPoint {
    Vec3 n{0.0}, v{0.0};
    Incline incline_v;
};

struct SurfaceModel;
/// highlight() for some of the models: see kernels.h.
using HighlightKernel = Rgb (*)(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint);
/// highlight() for every model: asks at each evaluation what was chosen.
Rgb highlight_by_switches(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint);

/// Light of one lamp: diffuse_share k_d (n.l) rd + s rs, or a highlight without n.l.
struct SurfaceModel {
    enum class Specular : std::uint8_t { none, phong, blinn_phong, microfacet };
    Specular specular = Specular::microfacet;
    Diffuse diffuse = Diffuse::lambert;
    bool shares = true;        ///< the diffuse term has what the highlight leaves, 1 - s
    bool lecture = false;      ///< the diffuse weight is 1 - k_a - s
    bool phong_gate = true;    ///< no highlight where the surface faces away
    bool clamp_after = false;  ///< max(cos^p, 0) as printed: even exponents light the back
    bool ambient_per_light = false, attenuate_ambient = false;
    MicrofacetTerms terms;
    Interface interface[3];  ///< by channel
    bool colorless = true;   ///< the three are one
    double alpha = 0.3;      ///< width of the microfacet lobe
    double exponent = 40.0;  ///< of phong and blinn-phong
    double s = 0.0;          ///< weight of the highlight
    Surroundings env = Surroundings::finish;
    double env_limit = largest_lobe;            ///< largest weight of the mirror direction
    double env_dw = 1.0;                        ///< solid angle of the surroundings as a lamp, for ct-effects
    std::shared_ptr<const AlbedoTable> albedo;  ///< for env albedo; null where the lobe is too narrow to differ from a mirror
    OrenNayar oren_nayar;
    GoochTones gooch;
    // What follows from the choices, by prepare() in kernels.h.
    double diffuse_share = 1.0;  ///< what the diffuse term has of a lamp's light; 0 where it is none or Gooch's
    bool sine_of_view = true;    ///< some term asks for the sine of the angle between n and v
    HighlightKernel kernel = highlight_by_switches;
};

/// What `metallic` multiplies F0 by, so that the tint of a highlight or mirror fades towards grazing.
inline Rgb metallic_f0(const Rgb& pigment, double metallic) {
    return metallic > 0.0 ? Rgb(1.0) + metallic * (pigment - Rgb(1.0)) : Rgb(1.0);
}

/// The point as models see it of which some ask for the sine, or none does: it costs as much as a whole term.
inline ViewedPoint viewed_point(const Vec3& n, const Vec3& v, bool sine) {
    return {n, v, sine ? incline(n, v) : Incline{accurate_dot(n, v), 0.0}};
}

/// F at cosine c of an interface whose channels differ, or that is tinted.
Rgb colored_reflectance(Fresnel kind, const SurfaceModel& model, double c, const Rgb& tint);

/// n.l rs with these terms; the model has the numbers, the factor as well. The compiler takes out every question that constant terms
/// answer.
inline Rgb microfacet_highlight(const MicrofacetTerms& terms, const SurfaceModel& model, const ViewedPoint& at, const Vec3& l,
                                const Rgb& tint) {
    HalfGeometry g;
    if (!half_geometry(at.n, l, at.v, at.incline_v, g)) return Rgb(0.0);
    if (terms.half_of_normal_and_view) halve_normal_and_view(at.n, at.v, g);
    const double lobe = scaled_lobe(model.terms.factor, unscaled_lobe(terms, g, model.alpha));
    const double c = incidence(terms, g);
    if (model.colorless && tint == Rgb(1.0)) return Rgb(lobe * F(terms.F, model.interface[0], c));
    return lobe * colored_reflectance(terms.F, model, c, tint);
}

/// The highlight of a lamp of unit colour in direction `l`, to be multiplied by s: n.l rs, or Phong's lobe. 0 for directions at or below
/// the surface, but for ungated Phong. `tint` is what F0 is multiplied by in the terms that start from F0; the exact ones take their colour
/// from the indices.
inline Rgb highlight(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
    return model.kernel(model, at, l, tint);
}

/// The diffuse term as a factor on k_d (n.l): rd and the share of the light that the highlight leaves to it. Gooch's tones are no such
/// factor.
inline double diffuse_factor(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, double n_dot_l) {
    if (model.diffuse != Diffuse::oren_nayar) [[likely]]
        return model.diffuse_share;
    const double n_dot_v = at.incline_v.cos;
    return n_dot_v > 0.0 && n_dot_l > 0.0 ? model.diffuse_share * model.oren_nayar(n_dot_l, n_dot_v, dot(l, at.v)) : 0.0;
}

/// Cosine outside of an interface of index `eta` for the cosine `cos` inside of it: both sides reflect alike at such a pair of angles. 0
/// where reflection is total.
inline double outside_cosine(double eta, double cos) { return std::sqrt(std::max(0.0, 1.0 - eta * eta * ((1.0 - cos) * (1.0 + cos)))); }

/// Share of the light from the mirror direction, per channel, that goes on to a viewer at cosine `n_dot_v`; `inside` is behind the
/// interface of a transparent body. `tint` as above. Finite; 0 at and below the horizon and where `env` leaves it to the finish.
inline Rgb surroundings_weight(const SurfaceModel& model, double n_dot_v, bool inside, const Rgb& tint) {
    Rgb weight(0.0);
    if (!(n_dot_v > least_cosine)) return weight;
    for (int channel = 0; channel < 3; ++channel) {
        Interface x = model.interface[channel];
        const double cos = inside && x.k == 0.0 ? outside_cosine(x.eta, std::min(1.0, n_dot_v)) : std::min(1.0, n_dot_v);
        x.f0 *= tint[channel];
        switch (model.env) {
            case Surroundings::finish:
                break;
            case Surroundings::mirror:
                weight[channel] = 1.0;
                break;
            case Surroundings::fresnel:
                weight[channel] = F(model.terms.F, x, cos);
                break;
            case Surroundings::albedo:
                weight[channel] = model.albedo ? model.albedo->at(channel, cos, tint[channel]) : F(model.terms.F, x, cos);
                break;
            case Surroundings::ct_effects:
                weight[channel] = effects_environment(x.f0, model.alpha, n_dot_v, model.env_dw);
                break;
        }
        weight[channel] = std::min(model.s * weight[channel], model.env_limit);
    }
    return weight;
}

}  // namespace rt
