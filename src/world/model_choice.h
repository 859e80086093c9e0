// What a finish is to be shaded with, before the finish's own numbers are filled in.
#pragma once

#include <optional>

#include "scene/scene.h"
#include "shading/surface_model.h"

namespace rt {

/// How a finish's roughness becomes the microfacet alpha.
enum class AlphaMapping {
    roughness2,  ///< alpha = roughness^2
    povray,      ///< sqrt(2 / (1/roughness + 2)), the width of POV-Ray's exponent
    direct,      ///< alpha = roughness
};

/// A model with numbers that may come from the finish: what is unset does.
struct ModelChoice {
    SurfaceModel model;
    bool brought_terms = false;            ///< the model's terms are those of a model that brings its own, not chosen one by one
    bool blinn_inverse_roughness = false;  ///< Blinn's distribution, if it is chosen, has the power 1/roughness
    std::optional<AlphaMapping> mapping;
    std::optional<double> alpha, exponent, s;
    double alpha_floor = 0.0;                  ///< least alpha, wherever it comes from
    std::optional<Rgb> f0, eta, k;             ///< f0, or the indices
    LampRules lamps;                           ///< of the whole picture
    double norm = 1.0, units = 1.0, dw = 1.0;  ///< factors on the microfacet lobe: of a misprint, of the units, of the lamps' solid angle
};

/// The model with the finish's numbers: s from `specular`, 0 or more and at most 1 where the diffuse term has the rest; alpha and the
/// exponent from `roughness`; the interface from the index of refraction.
SurfaceModel fill(const ModelChoice& choice, const Finish& finish, double ior, AlphaMapping mapping);

}  // namespace rt
