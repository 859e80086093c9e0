#include "shading/surface_model.h"

namespace rt {

Rgb colored_reflectance(Fresnel kind, const SurfaceModel& model, double c, const Rgb& tint) {
    Rgb result;
    for (int channel = 0; channel < 3; ++channel) {
        Interface x = model.interface[channel];
        x.f0 *= tint[channel];
        result[channel] = F(kind, x, c);
    }
    return result;
}

Rgb highlight_by_switches(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
    switch (model.specular) {
        case SurfaceModel::Specular::none:
            return Rgb(0.0);
        case SurfaceModel::Specular::phong:
            return Rgb(model.clamp_after ? phong_clamped_after(at.n, l, at.v, model.exponent, model.phong_gate)
                                         : phong(at.n, l, at.v, model.exponent, model.phong_gate));
        case SurfaceModel::Specular::blinn_phong: {
            HalfGeometry g;
            return Rgb(half_geometry(at.n, l, at.v, at.incline_v, g) ? blinn_phong(g, model.exponent) : 0.0);
        }
        case SurfaceModel::Specular::microfacet:
            return microfacet_highlight(model.terms, model, at, l, tint);
    }
    return Rgb(0.0);
}

}  // namespace rt
