#include "world/model_choice.h"

#include "shading/kernels.h"

namespace rt {

namespace {

double mapped_alpha(const std::optional<double>& roughness, AlphaMapping mapping) {
    constexpr double default_roughness = 0.05;
    if (!roughness) mapping = AlphaMapping::povray;
    const double r = std::fmax(0.0, roughness.value_or(default_roughness));
    switch (mapping) {
        case AlphaMapping::roughness2:
            return r * r;
        case AlphaMapping::povray:
            return std::sqrt(2.0 / (1.0 / r + 2.0));
        case AlphaMapping::direct:
            return r;
    }
    return r;
}

/// The exponent whose highlight is as wide as the microfacet lobe: 2 / roughness^2 - 2, roughness^2 being the alpha where one is stated.
/// A finish that states neither has its phong_size.
double exponent_of(const ModelChoice& choice, const Finish& finish) {
    if (!choice.alpha && !finish.roughness) return finish.phong_size;
    const double width = choice.alpha ? *choice.alpha : sqr(*finish.roughness);
    return std::fmin(std::fmax(0.0, 2.0 / width - 2.0), largest_exponent);
}

/// By the stated reflectance or the stated indices, of which the object's own may be one.
Interface interface_for(const ModelChoice& choice, double ior, int channel) {
    if (choice.f0) return interface_of_f0((*choice.f0)[channel]);
    return interface_of(choice.eta ? (*choice.eta)[channel] : ior, choice.k ? (*choice.k)[channel] : 0.0);
}

}  // namespace

SurfaceModel fill(const ModelChoice& choice, const Finish& finish, double ior, AlphaMapping mapping) {
    SurfaceModel model = choice.model;
    if (choice.blinn_inverse_roughness && model.terms.D == Distribution::blinn) model.terms.D = Distribution::blinn_inverse_roughness;
    // Where the diffuse term has what the highlight leaves, it cannot leave less than nothing.
    model.s = choice.s.value_or(std::fmin(std::fmax(finish.specular, 0.0), model.shares ? 1.0 : largest_lobe));
    model.alpha = std::fmax(choice.alpha_floor, choice.alpha.value_or(mapped_alpha(finish.roughness, choice.mapping.value_or(mapping))));
    model.exponent = choice.exponent.value_or(exponent_of(choice, finish));
    model.terms.factor = choice.norm * choice.units * choice.dw;
    model.env_dw = choice.dw;
    for (int channel = 0; channel < 3; ++channel) model.interface[channel] = interface_for(choice, ior, channel);
    model.colorless = model.interface[0] == model.interface[1] && model.interface[0] == model.interface[2];
    prepare(model);
    return model;
}

}  // namespace rt
