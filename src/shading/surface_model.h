// What a surface does with light that arrives, chosen from the catalogue, with all its numbers in place.
#pragma once

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
    OrenNayar oren_nayar;
    GoochTones gooch;
};

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

}  // namespace rt
