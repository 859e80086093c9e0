// Rows of single terms, from cosines that are taken as exact.
#include "commands/brdf_rows.h"
#include "shading/terms.h"

namespace rt {

std::vector<double> brdf_D_row(const BrdfRow& row) {
    const double alpha = row.number("alpha");
    const Incline h = incline(row.number("nh"));
    const auto value = [&](Distribution kind) { return D(kind, h.cos * h.cos, h.sin2, alpha); };
    const double beckmann = value(Distribution::beckmann);
    return {value(Distribution::blinn), beckmann, value(Distribution::ggx), 0.25 * pi * beckmann};
}

std::vector<double> brdf_G_row(const BrdfRow& row) {
    const double alpha = row.number("alpha");
    HalfGeometry g;
    g.l = incline(row.number("nl"));
    g.v = incline(row.number("nv"));
    // n.h and v.h need not belong to the other cosines; any |s| does: masking takes the ratio n.s / s.s = n.h / (2 v.h) only.
    g.v_dot_h = row.number("vh");
    g.n_dot_s = row.number("nh");
    g.s_dot_s = 2.0 * g.v_dot_h;
    const auto of = [&](Masking kind) { return G(kind, g, alpha); };
    // G of a pair whose other direction is the normal is the G1 of the one.
    const auto alone = [&](Masking kind, const Incline& x) { return G(kind, {.l = {1.0, 0.0}, .v = x}, alpha); };
    return {of(Masking::cook_torrance),
            alone(Masking::ggx, g.v),
            alone(Masking::ggx, g.l),
            of(Masking::ggx),
            of(Masking::ggx_hc),
            alone(Masking::beckmann, g.v),
            of(Masking::beckmann),
            of(Masking::beckmann_hc),
            alone(Masking::beckmann_rational, g.v),
            visibility(Masking::cook_torrance, g, alpha),
            visibility(Masking::ggx, g, alpha),
            visibility(Masking::ggx_hc, g, alpha),
            visibility(Masking::beckmann, g, alpha)};
}

std::vector<double> brdf_F_row(const BrdfRow& row) {
    const double c = row.number("c");
    const Interface plain = interface_of(row.number("ior"));
    const Interface metal = interface_of(row.number("ior"), row.number("k"));
    return {plain.f0,
            metal.f0,
            F(Fresnel::schlick, plain, c),
            F(Fresnel::schlick_linear, plain, c),
            F(Fresnel::dielectric, plain, c),
            F(Fresnel::conductor, metal, c),
            F(Fresnel::schlick, metal, c)};
}

}  // namespace rt
