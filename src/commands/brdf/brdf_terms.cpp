// Rows of single terms, from cosines that are taken as exact.
#include "commands/brdf/brdf_rows.h"
#include "shading/terms.h"

namespace rt {

std::vector<double> brdf_D_row(const BrdfRow& row) {
    const double alpha = row.number("alpha", domain::not_negative);
    const Incline h = incline(row.number("nh", domain::cosine));
    // Facets that look into the surface are none of it.
    const auto value = [&](Distribution kind) { return h.cos < 0.0 ? 0.0 : D(kind, h.cos * h.cos, h.sin2, alpha); };
    const double beckmann = value(Distribution::beckmann);
    return {value(Distribution::blinn), beckmann, value(Distribution::ggx), 0.25 * pi * beckmann};
}

std::vector<double> brdf_G_row(const BrdfRow& row) {
    const double alpha = std::min(row.number("alpha", domain::not_negative), greatest_alpha);
    HalfGeometry g;
    g.l = incline(row.number("nl", domain::cosine));
    g.v = incline(row.number("nv", domain::cosine));
    // n.h and v.h need not belong to the other cosines; any |s| does: masking takes the ratio n.s / s.s = n.h / (2 v.h) only.
    g.v_dot_h = row.number("vh", domain::cosine);
    g.n_dot_s = row.number("nh", domain::cosine);
    g.s_dot_s = 2.0 * g.v_dot_h;
    // Where one direction is not above the surface nothing is reflected, and no half vector of two that are is below it.
    const bool lit = g.l.cos > 0.0 && g.v.cos > 0.0 && g.n_dot_s > 0.0 && g.v_dot_h > 0.0;
    const auto of = [&](Masking kind) { return lit ? G(kind, g, alpha) : 0.0; };
    const auto V = [&](Masking kind) { return lit ? visibility(kind, g, alpha) : 0.0; };
    // G of a pair whose other direction is the normal is the G1 of the one.
    const auto alone = [&](Masking kind, const Incline& x) { return x.cos > 0.0 ? G(kind, {.l = {1.0, 0.0}, .v = x}, alpha) : 0.0; };
    return {of(Masking::cook_torrance), alone(Masking::ggx, g.v), alone(Masking::ggx, g.l),
            of(Masking::ggx),           of(Masking::ggx_hc),      alone(Masking::beckmann, g.v),
            of(Masking::beckmann),      of(Masking::beckmann_hc), alone(Masking::beckmann_rational, g.v),
            V(Masking::cook_torrance),  V(Masking::ggx),          V(Masking::ggx_hc),
            V(Masking::beckmann)};
}

std::vector<double> brdf_F_row(const BrdfRow& row) {
    const double c = row.number("c", domain::cosine);
    const Interface plain = interface_of(row.number("ior", domain::positive));
    const Interface metal = interface_of(row.number("ior", domain::positive), row.number("k", domain::not_negative));
    return {plain.f0,
            metal.f0,
            F(Fresnel::schlick, plain, c),
            F(Fresnel::schlick_linear, plain, c),
            F(Fresnel::dielectric, plain, c),
            F(Fresnel::conductor, metal, c),
            F(Fresnel::schlick, metal, c)};
}

}  // namespace rt
