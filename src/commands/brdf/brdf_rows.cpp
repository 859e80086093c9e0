#include "commands/brdf/brdf_rows.h"

#include <fmt/format.h>

#include <cmath>

namespace rt {

namespace {

using Tolerance = std::function<double(const BrdfRow&, double)>;

constexpr double half_ulp = 0x1p-53;

/// `units` half units in the last place of the wanted value, and `absolute`.
Tolerance within(double units, double absolute) {
    return [=](const BrdfRow&, double want) { return half_ulp * units * std::fabs(want) + absolute; };
}

/// The same with `base + slope times` what the row says in `column`.
Tolerance within(double base, double slope, std::string_view column, double absolute) {
    return [=](const BrdfRow& row, double want) {
        return half_ulp * (base + slope * row.number(column, domain::not_negative)) * std::fabs(want) + absolute;
    };
}
Tolerance by_condition(std::string_view column) { return within(32.0, 4.0, column, 1e-60); }

/// D by its own conditioning: the logarithm of its value and the exponent's argument tan^2 / alpha^2.
double tolerance_D(const BrdfRow& row, double want) {
    if (want == 0.0) return 1e-300;
    const double size = std::fabs(want);
    const double nh = row.number("nh", domain::cosine), alpha = row.number("alpha", domain::not_negative);
    const double tan_over_alpha = std::sqrt((1.0 - nh) * (1.0 + nh)) / nh / alpha;
    return half_ulp * (32.0 + 4.0 * std::fabs(std::log(size)) + 4.0 * tan_over_alpha * tan_over_alpha) * size + 1e-300;
}

/// F is singular where total reflection begins.
double tolerance_F(const BrdfRow& row, double want) {
    return row.text("class") == "critical" ? 4e-7 : half_ulp * 256.0 * std::fabs(want) + 1e-300;
}

std::vector<JudgedColumn> all_within(const std::vector<std::string_view>& columns, const Tolerance& tolerance) {
    std::vector<JudgedColumn> judged;
    for (const std::string_view column : columns) judged.push_back({column, tolerance});
    return judged;
}

std::vector<BrdfKind> term_kinds() {
    return {
        {"terms_D", {"D_blinn", "D_beckmann", "D_ggx", "D_4m2"}, brdf_D_row, all_within({"D_blinn", "D_beckmann", "D_ggx"}, tolerance_D)},
        {"terms_G",
         {"G_ct", "G1_ggx_v", "G1_ggx_l", "G_ggx", "G_ggx_hc", "G1_beck_v", "G_beck", "G_beck_hc", "G1_beck_rat_v", "Vis_ct", "Vis_ggx",
          "Vis_ggx_hc", "Vis_beck"},
         brdf_G_row,
         all_within({"G_ct", "G_ggx", "G_ggx_hc", "G_beck", "Vis_ct", "Vis_ggx"}, within(256.0, 1e-300))},
        {"terms_F",
         {"F0", "F0k", "F_schlick", "F_schlick1", "F_dielectric", "F_conductor", "F_schlick_k"},
         brdf_F_row,
         all_within({"F_schlick", "F_dielectric", "F_conductor"}, tolerance_F)}};
}

std::vector<BrdfKind> form_kinds() {
    const std::vector<std::string_view> general{"D", "G", "F", "rd", "rs", "r"};
    return {{"contract", general, brdf_general_row, {{"r", within(4.0, 1e-16)}}},
            {"general_r", general, brdf_general_row, {{"rs", by_condition("kappa_rs")}, {"r", by_condition("kappa_r")}}},
            {"seed0_effectsbrowser",
             {"ambient", "diffuse", "phong_spec", "ct_linear", "ct_simplified", "ct_vh", "cube", "F_linear", "F5_nv", "cube_lit"},
             brdf_effects_row,
             {{"ct_linear", by_condition("kappa_linear")},
              {"ct_simplified", by_condition("kappa_simplified")},
              {"ct_vh", by_condition("kappa_vh")},
              {"cube", by_condition("kappa_cube")},
              {"ambient", within(64.0, 0.0)},
              {"diffuse", within(256.0, 1e-15)},
              {"phong_spec", within(64.0, 64.0, "power", 1e-15)}}},
            {"seed2_gooch",
             {"k_spec", "k_spec_literal", "gooch_literal", "gooch"},
             brdf_gooch_row,
             {{"k_spec", by_condition("kappa")},
              {"k_spec_literal", by_condition("kappa_literal")},
              {"gooch", within(0.0, 1e-14)},
              {"gooch_literal", within(0.0, 1e-14)}}},
            {"seed3_phong_lights",
             {"dist", "cos_spot", "nl", "La", "Ld", "Ls", "Ls_seed", "att", "kspot", "total", "total_seed"},
             brdf_phong_row,
             {{"La", within(64.0, 0.0)},
              {"Ld", within(0.0, 1e-13)},
              {"att", within(256.0, 0.0)},
              {"total", within(1e-9 / half_ulp, 1e-9)},
              {"total_seed", within(1e-9 / half_ulp, 1e-9)}}},
            {"seed4_lecture", {"D", "G", "F", "spec", "I"}, brdf_lecture_row, {{"I", by_condition("kappa")}}}};
}

}  // namespace

const std::vector<BrdfKind>& brdf_kinds() {
    static const std::vector<BrdfKind> kinds = [] {
        std::vector<BrdfKind> all = form_kinds();
        for (BrdfKind& kind : term_kinds()) all.push_back(std::move(kind));
        return all;
    }();
    return kinds;
}

const BrdfKind* find_brdf_kind(std::string_view name) {
    for (const BrdfKind& kind : brdf_kinds())
        if (kind.name == name) return &kind;
    return nullptr;
}

std::string brdf_kind_names() {
    std::string names;
    for (const BrdfKind& kind : brdf_kinds()) names += fmt::format("{}{}", names.empty() ? "" : ", ", kind.name);
    return names;
}

}  // namespace rt
