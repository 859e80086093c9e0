// The names of the shading terms that can be selected, as options, scenes and tables write them.
#pragma once

#include "commands/names.h"
#include "shading/terms.h"

namespace rt {

inline constexpr NameTable<Distribution, 5> distribution_names{{{"blinn", Distribution::blinn},
                                                                {"blinn-inverse-roughness", Distribution::blinn_inverse_roughness},
                                                                {"beckmann", Distribution::beckmann},
                                                                {"ggx", Distribution::ggx},
                                                                {"gaussian", Distribution::gaussian}}};
inline constexpr NameTable<Masking, 7> masking_names{{{"cook-torrance", Masking::cook_torrance},
                                                      {"ggx", Masking::ggx},
                                                      {"ggx-hc", Masking::ggx_hc},
                                                      {"beckmann", Masking::beckmann},
                                                      {"beckmann-hc", Masking::beckmann_hc},
                                                      {"beckmann-rational", Masking::beckmann_rational},
                                                      {"none", Masking::none}}};
inline constexpr NameTable<Fresnel, 7> fresnel_names{{{"one", Fresnel::one},
                                                      {"constant", Fresnel::constant},
                                                      {"schlick", Fresnel::schlick},
                                                      {"schlick-linear", Fresnel::schlick_linear},
                                                      {"schlick-f82", Fresnel::schlick_f82},
                                                      {"dielectric", Fresnel::dielectric},
                                                      {"conductor", Fresnel::conductor}}};
inline constexpr NameTable<Diffuse, 4> diffuse_names{
    {{"lambert", Diffuse::lambert}, {"oren-nayar", Diffuse::oren_nayar}, {"gooch", Diffuse::gooch}, {"none", Diffuse::none}}};

}  // namespace rt
