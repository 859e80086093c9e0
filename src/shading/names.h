// The names under which the catalogue is selected, and the text each comes from: the one table for the command line, scenes and help.
// S0: an early real-time demo of Cook and Torrance's model; S1: a course chapter on microfacets; S2: a project that joins Cook-Torrance
// and Gooch; S3: Phong with three kinds of lamps; S4: lecture slides; X: in none of them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "shading/lamps.h"
#include "shading/models.h"

namespace rt {

template <typename T>
struct Named {
    std::string_view name;
    T value;
    std::string_view origin;
};

/// The value of that name, or nothing.
template <typename T, std::size_t N>
std::optional<T> find_named(const std::array<Named<T>, N>& table, std::string_view name) {
    for (const Named<T>& entry : table)
        if (entry.name == name) return entry.value;
    return std::nullopt;
}

/// "ggx, beckmann, ...".
template <typename T, std::size_t N>
std::string known_names(const std::array<Named<T>, N>& table) {
    std::string text;
    for (const Named<T>& entry : table) text += (text.empty() ? "" : ", ") + std::string(entry.name);
    return text;
}

inline constexpr std::array<Named<Distribution>, 4> distribution_names{{{"ggx", Distribution::ggx, "S1"},
                                                                        {"beckmann", Distribution::beckmann, "S0 S1 S4"},
                                                                        {"blinn", Distribution::blinn, "S1"},
                                                                        {"gaussian", Distribution::gaussian, "X"}}};
inline constexpr std::array<Named<Masking>, 7> masking_names{{{"ggx", Masking::ggx, "S1"},
                                                              {"ggx-hc", Masking::ggx_hc, "X"},
                                                              {"cook-torrance", Masking::cook_torrance, "S0 S1 S2 S4"},
                                                              {"beckmann", Masking::beckmann, "X"},
                                                              {"beckmann-hc", Masking::beckmann_hc, "X"},
                                                              {"beckmann-rational", Masking::beckmann_rational, "X"},
                                                              {"none", Masking::none, "X"}}};
inline constexpr std::array<Named<Fresnel>, 7> fresnel_names{{{"schlick", Fresnel::schlick, "S0 S1 S2"},
                                                              {"schlick-linear", Fresnel::schlick_linear, "S0"},
                                                              {"schlick-f82", Fresnel::schlick_f82, "X"},
                                                              {"dielectric", Fresnel::dielectric, "S4"},
                                                              {"conductor", Fresnel::conductor, "S4"},
                                                              {"constant", Fresnel::constant, "X"},
                                                              {"one", Fresnel::one, "X"}}};
inline constexpr std::array<Named<Diffuse>, 4> diffuse_names{{{"lambert", Diffuse::lambert, "S0 S1 S2 S3 S4"},
                                                              {"oren-nayar", Diffuse::oren_nayar, "S1"},
                                                              {"gooch", Diffuse::gooch, "S2"},
                                                              {"none", Diffuse::none, "S0"}}};

inline constexpr std::array<Named<Surroundings>, 5> surroundings_names{{{"finish", Surroundings::finish, "X"},
                                                                        {"mirror", Surroundings::mirror, "S0"},
                                                                        {"fresnel", Surroundings::fresnel, "X"},
                                                                        {"albedo", Surroundings::albedo, "X"},
                                                                        {"ct-effects", Surroundings::ct_effects, "S0"}}};

inline constexpr std::array<Named<Attenuation>, 4> attenuation_names{{{"none", Attenuation::none, "S0 S1 S4"},
                                                                      {"1+d+d2", Attenuation::one_d_d2, "S3"},
                                                                      {"polynomial", Attenuation::polynomial, "X"},
                                                                      {"inverse-square", Attenuation::inverse_square, "X"}}};

/// What `shading` selects beside POV-Ray's own finish model.
enum class Model { cook_torrance, phong, blinn_phong, ct_effects, ct_effects_linear, lecture, none };
inline constexpr std::array<Named<Model>, 8> model_names{{{"general", Model::cook_torrance, "S1"},
                                                          {"cook-torrance", Model::cook_torrance, "S1 S2"},
                                                          {"phong", Model::phong, "S3"},
                                                          {"blinn-phong", Model::blinn_phong, "S0"},
                                                          {"ct-effects", Model::ct_effects, "S0"},
                                                          {"ct-effects-linear", Model::ct_effects_linear, "S0"},
                                                          {"lecture", Model::lecture, "S4"},
                                                          {"none", Model::none, "X"}}};

/// A preset is a row of choices, a material a row of constants; written as in a scene's comment.
inline constexpr std::array<Named<std::string_view>, 8> preset_names{
    {{"modern", "shading=cook-torrance D=ggx G=ggx F=schlick", "S1"},
     {"classic", "shading=cook-torrance D=beckmann G=cook-torrance F=schlick", "S0 S4"},
     {"course-blinn", "shading=cook-torrance D=blinn G=cook-torrance F=schlick", "S1"},
     {"reference", "shading=cook-torrance D=ggx G=ggx-hc F=conductor", "X"},
     {"effects", "shading=ct-effects dw=1e-4 env=ct-effects", "S0"},
     {"lecture", "shading=lecture", "S4"},
     {"gooch-ct", "shading=cook-torrance D=beckmann G=cook-torrance F=schlick diffuse=gooch", "S2"},
     {"phong-lights", "shading=phong att=1+d+d2", "S3"}}};

/// What bodies are made of, but for k_d, which the pigment gives (a dull blue body's is about <0.1, 0.2, 0.7>). Indices at about 650, 550
/// and 450 nm. Where the lobe is narrow a mirror ray stands for what it gathers of the surroundings, weighed by the lobe's albedo; a sharp
/// picture on a dull surface would be wrong, so dull ones have their highlights and ambient light only. The mirror's lobe has no width and
/// no highlight: all of it is the mirror ray.
inline constexpr std::array<Named<std::string_view>, 5> material_names{
    {{"shiny-gold", "eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.04 s=0.9 env=albedo", "S0"},
     {"dull-gold", "eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.3 s=0.7", "S0"},
     {"dull-blue", "eta=1.5 alpha=0.4 s=0.3", "S0"},
     {"silver", "eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.05 s=0.95 env=albedo", "S0"},
     {"mirror", "f0=0.98 alpha=0 s=1 env=fresnel", "S0"}}};

}  // namespace rt
