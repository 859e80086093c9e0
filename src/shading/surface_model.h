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
};

/// What `metallic` multiplies F0 by, so that the tint of a highlight or mirror fades towards grazing.
inline Rgb metallic_f0(const Rgb& pigment, double metallic) {
    return metallic > 0.0 ? Rgb(1.0) + metallic * (pigment - Rgb(1.0)) : Rgb(1.0);
}

/// F per channel. `tint` is what F0 is multiplied by in the terms that start from F0; the exact ones take their colour from the indices.
inline Rgb reflectance(const SurfaceModel& model, const HalfGeometry& g, const Rgb& tint) {
    if (model.colorless && tint == Rgb(1.0)) return Rgb(reflectance(model.terms, model.interface[0], g));
    Rgb result;
    for (int channel = 0; channel < 3; ++channel) {
        Interface x = model.interface[channel];
        x.f0 *= tint[channel];
        result[channel] = reflectance(model.terms, x, g);
    }
    return result;
}

/// The highlight of a lamp of unit colour, to be multiplied by s: n.l rs, or Phong's lobe. `g` is of the same n, l and v; directions at or
/// below the surface never come here but for ungated Phong.
inline Rgb highlight(const SurfaceModel& model, const Vec3& n, const Vec3& l, const Vec3& v, const HalfGeometry& g, const Rgb& tint) {
    switch (model.specular) {
        case SurfaceModel::Specular::none:
            return Rgb(0.0);
        case SurfaceModel::Specular::phong:
            return Rgb(model.clamp_after ? phong_clamped_after(n, l, v, model.exponent) : phong(n, l, v, model.exponent, model.phong_gate));
        case SurfaceModel::Specular::blinn_phong:
            return Rgb(blinn_phong(g, model.exponent));
        case SurfaceModel::Specular::microfacet:
            return microfacet_lobe(model.terms, g, model.alpha) * reflectance(model, g, tint);
    }
    return Rgb(0.0);
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
