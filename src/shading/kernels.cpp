#include "shading/kernels.h"

#include <array>
#include <utility>

namespace rt {

namespace {

// The enumerations count from 0 to these.
constexpr std::size_t distributions = 1 + static_cast<std::size_t>(Distribution::gaussian);
constexpr std::size_t maskings = 1 + static_cast<std::size_t>(Masking::none);
constexpr std::size_t fresnels = 1 + static_cast<std::size_t>(Fresnel::conductor);

constexpr std::size_t place(Distribution D, Masking G, Fresnel F) {
    return (static_cast<std::size_t>(D) * maskings + static_cast<std::size_t>(G)) * fresnels + static_cast<std::size_t>(F);
}

/// The terms are constants here: the compiler takes the switches away.
template <Distribution D, Masking G, Fresnel F>
[[gnu::flatten]] Rgb fixed_highlight(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
    return microfacet_highlight({.D = D, .G = G, .F = F}, model, at, l, tint);
}

template <std::size_t... I>
constexpr std::array<HighlightKernel, sizeof...(I)> all_kernels(std::index_sequence<I...>) {
    return {fixed_highlight<static_cast<Distribution>(I / (maskings * fresnels)), static_cast<Masking>(I / fresnels % maskings),
                            static_cast<Fresnel>(I % fresnels)>...};
}

constexpr std::array kernels = all_kernels(std::make_index_sequence<distributions * maskings * fresnels>());

bool has_variant(const MicrofacetTerms& terms) {
    return terms.fresnel_at_view || terms.half_of_normal_and_view || terms.clamped_denominator || terms.without_cosine;
}

}  // namespace

void prepare(SurfaceModel& model) {
    const bool has_factor = model.diffuse == Diffuse::lambert || model.diffuse == Diffuse::oren_nayar;
    model.diffuse_share = !has_factor ? 0.0 : model.shares ? 1.0 - model.s : 1.0;
    const bool grooves = model.terms.G == Masking::cook_torrance || model.terms.G == Masking::none;
    model.sine_of_view = model.specular == SurfaceModel::Specular::microfacet && (!grooves || model.terms.half_of_normal_and_view);
    const bool fixed = model.specular == SurfaceModel::Specular::microfacet && !has_variant(model.terms);
    model.kernel = fixed ? kernels[place(model.terms.D, model.terms.G, model.terms.F)] : highlight_by_switches;
}

}  // namespace rt
