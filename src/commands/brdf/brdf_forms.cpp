// Rows of complete forms: one light, one channel.
#include <fmt/format.h>

#include <algorithm>

#include "commands/brdf/brdf_rows.h"
#include "shading/lamps.h"
#include "shading/models.h"
#include "shading/names.h"

namespace rt {

namespace {

/// The vectors n, l and v of a row and what follows from them; `lit` is false where nothing is reflected.
struct Directions {
    Vec3 n, l, v;
    Incline incline_v;
    HalfGeometry g;
    bool lit;
    explicit Directions(const BrdfRow& row)
        : n(row.vector("n")), l(row.vector("l")), v(row.vector("v")), incline_v(incline(n, v)), lit(half_geometry(n, l, v, incline_v, g)) {}
};

template <typename T, std::size_t N>
T named(const std::array<Named<T>, N>& table, const BrdfRow& row, std::string_view column, std::string_view what) {
    const std::optional<T> value = find_named(table, row.text(column));
    if (!value) row.fail(fmt::format("'{}' is no {}; expected one of {}", row.text(column), what, known_names(table)));
    return *value;
}

double diffuse_factor(Diffuse kind, double sigma, const Directions& at, const BrdfRow& row) {
    switch (kind) {
        case Diffuse::lambert:
            return 1.0;
        case Diffuse::oren_nayar:
            return OrenNayar(sigma)(at.g.l.cos, at.g.v.cos, dot(at.l, at.v));
        case Diffuse::none:
            return 0.0;
        case Diffuse::gooch:
            break;
    }
    row.fail("diffuse 'gooch' needs colours, which this table does not have");
}

/// n.l (D G / (4 n.l n.v)) F, or without n.l.
double reflected(const MicrofacetTerms& terms, const Interface& x, const HalfGeometry& g, double alpha) {
    return microfacet_lobe(terms, g, alpha) * reflectance(terms, x, g);
}

/// |v| without underflow or overflow between.
double safe_length(const Vec3& v) {
    const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return most > 0.0 && std::isfinite(most) ? most * length(v / most) : most;
}

/// v / |v|, and 0 for 0.
Vec3 direction(const Vec3& v) {
    const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return most > 0.0 ? unit(v / std::ldexp(1.0, std::ilogb(most))) : Vec3(0.0);
}

}  // namespace

std::vector<double> brdf_general_row(const BrdfRow& row) {
    const Directions at(row);
    const MicrofacetTerms terms{.D = named(distribution_names, row, "Dname", "D"),
                                .G = named(masking_names, row, "Gname", "G"),
                                .F = named(fresnel_names, row, "Fname", "F"),
                                .without_cosine = true};
    const double alpha = sqr(row.number("roughness", domain::not_negative)), s = row.number("s", domain::share), ka = row.number("ka");
    const Interface x = interface_of(row.number("ior", domain::positive), row.number("k", domain::not_negative));
    const Diffuse diffuse = named(diffuse_names, row, "diffuse", "diffuse term");
    const double kd = row.number("kd"), sigma = row.number("sigma", domain::not_negative), lc = row.number("lc");
    if (!at.lit) return {0.0, 0.0, 0.0, 0.0, 0.0, ka};
    const HalfGeometry& g = at.g;
    const double rd = kd * diffuse_factor(diffuse, sigma, at, row);
    MicrofacetTerms with_cosine = terms;
    with_cosine.without_cosine = false;
    const double lobe = reflected(with_cosine, x, g, alpha);
    return {D(terms.D, g.cos2_h, g.sin2_h, alpha),
            G(terms.G, g, std::min(alpha, greatest_alpha)),
            reflectance(terms, x, g),
            rd,
            reflected(terms, x, g, alpha),
            std::fma(lc, std::fma(s, lobe, g.l.cos * (1.0 - s) * rd), ka)};
}

std::vector<double> brdf_effects_row(const BrdfRow& row) {
    const Directions at(row);
    const double m = row.number("m", domain::not_negative), f0 = row.number("F0", domain::share), ks = row.number("ks"),
                 dw = row.number("dw", domain::not_negative);
    const double il = row.number("il"), kd = row.number("kd"), dc = row.number("dc"), power = row.number("power", domain::not_negative);
    const double ambient = row.number("ka") * dc, n_dot_v = at.incline_v.cos;
    const Interface x{.f0 = f0};
    const double c = std::min(1.0, n_dot_v);
    const double cube = n_dot_v > 0.0 ? ks * effects_environment(f0, m, n_dot_v, dw) : 0.0;
    std::vector<double> values{ambient,  0.0, 0.0, 0.0, 0.0, 0.0, cube, F(Fresnel::schlick_linear, x, c), F(Fresnel::schlick, x, c),
                               cube * il};
    if (!at.lit) return values;
    MicrofacetTerms at_half = effects_terms(dw, false);
    at_half.fresnel_at_view = false;
    values[1] = il * kd * at.g.l.cos * dc;
    values[2] = il * ks * blinn_phong(at.g, power);
    values[3] = ks * reflected(effects_terms(dw, true), x, at.g, m);
    values[4] = ks * reflected(effects_terms(dw, false), x, at.g, m);
    values[5] = ks * reflected(at_half, x, at.g, m);
    return values;
}

std::vector<double> brdf_gooch_row(const BrdfRow& row) {
    const Directions at(row);
    const MicrofacetTerms terms{
        .D = named(distribution_names, row, "Dname", "D"), .G = Masking::cook_torrance, .F = Fresnel::schlick, .without_cosine = true};
    const double alpha = sqr(row.number("roughness", domain::not_negative)), n_dot_l = dot(at.n, at.l);
    const double cool = row.number("kcool"), warm = row.number("kwarm");
    const Interface x = interface_of(row.number("ior", domain::positive));
    std::vector<double> values{0.0, 0.0, gooch(n_dot_l, warm, cool), gooch(n_dot_l, cool, warm)};
    if (!at.lit) return values;
    HalfGeometry literal = at.g;
    halve_normal_and_view(at.n, at.v, literal);
    values[0] = reflected(terms, x, at.g, alpha);
    values[1] = reflected(terms, x, literal, alpha);
    return values;
}

std::vector<double> brdf_phong_row(const BrdfRow& row) {
    const std::string_view light = row.text("light");
    if (light != "parallel" && light != "point" && light != "spot")
        row.fail(fmt::format("'{}' is no light; expected one of parallel, point, spot", light));
    const bool parallel = light == "parallel";
    const Vec3 n = row.vector("n"), p = row.vector("p"), lamp = row.vector("lp"), axis = row.vector("sd");
    const Vec3 to_lamp = parallel ? -lamp : lamp - p;
    const Vec3 l = direction(to_lamp), v = direction(row.vector("e") - p);
    const double distance = parallel ? 0.0 : safe_length(to_lamp), exponent = row.number("shininess", domain::not_negative);
    const double q = row.number("spot_exp", domain::not_negative);
    const AttenuationLaw law{.kind = parallel ? Attenuation::none : Attenuation::one_d_d2, .range = row.number("range", domain::distance)};
    const double La = row.number("Ma") * row.number("Ca");
    const double n_dot_l = dot(n, l), Ld = std::max(n_dot_l, 0.0) * row.number("Md") * row.number("Cd");
    const double color = row.number("Ms") * row.number("Cs");
    const double Ls = color * phong(n, l, v, exponent), Ls_seed = color * phong(n, l, v, exponent, false);
    const double att = parallel ? 1.0 : attenuation(law, distance);
    const double kspot = light == "spot" ? spot(axis, l, q) : 1.0;
    const double cos_spot = light == "spot" ? -dot(l, direction(axis)) : 1.0;
    return {distance, cos_spot, n_dot_l, La, Ld, Ls, Ls_seed, att, kspot, La + kspot * att * (Ld + Ls), kspot * att * (La + Ld + Ls_seed)};
}

std::vector<double> brdf_lecture_row(const BrdfRow& row) {
    const Directions at(row);
    const double m = row.number("m", domain::not_negative), ka = row.number("ka"), ks = row.number("ks"), rho = row.number("rho");
    const double ambient = row.number("Ia") * ka, light = row.number("Ii");
    const Interface x{.eta = row.number("ratio", domain::positive)};
    if (!at.lit) return {0.0, 0.0, 0.0, 0.0, ambient};
    const MicrofacetTerms terms = lecture_terms();
    const double spec = reflected(terms, x, at.g, m);
    return {0.25 * pi * D(terms.D, at.g.cos2_h, at.g.sin2_h, m), G(terms.G, at.g, std::min(m, greatest_alpha)), reflectance(terms, x, at.g),
            spec, std::fma(light, lecture_diffuse(ka, ks) * rho * at.g.l.cos + ks * spec, ambient)};
}

}  // namespace rt
