// Directive comments: `//! raytrace: key=value key=value`.
#pragma once

#include <array>
#include <string_view>

#include "syntax/reader.h"

namespace rt {

/// Every key that a choice may have. Values, and which keys this version selects, are the business of whoever uses them.
inline constexpr std::array<std::string_view, 40> choice_keys{"shading",
                                                              "distances",
                                                              "precision",
                                                              "preset",
                                                              "material",
                                                              "diffuse",
                                                              "D",
                                                              "G",
                                                              "F",
                                                              "alpha",
                                                              "alpha-floor",
                                                              "env",
                                                              "env-clamp",
                                                              "s",
                                                              "eta",
                                                              "k",
                                                              "f0",
                                                              "exponent",
                                                              "sigma",
                                                              "fresnel-arg",
                                                              "half",
                                                              "norm",
                                                              "blinn-power",
                                                              "units",
                                                              "dw",
                                                              "denominator",
                                                              "raw",
                                                              "ambient",
                                                              "attenuate-ambient",
                                                              "clamp",
                                                              "phong-gate",
                                                              "gooch",
                                                              "att",
                                                              "att-coefficients",
                                                              "range",
                                                              "spot",
                                                              "edges",
                                                              "edge-width",
                                                              "edge-color",
                                                              "edge-angle"};

/// Takes a directive comment that comes next and adds its choices to `options`; false if none comes next.
/// Fails at the first word that is no key=value or has an unknown key.
bool accept_choices(Reader& reader, std::vector<SceneOption>& options);

}  // namespace rt
