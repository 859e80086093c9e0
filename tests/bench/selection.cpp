// What choosing the terms at run time costs inside the loop, to be counted by callgrind: tests/bench/selection_cost.
//
// usage: selection selected|called|inlined|switches PRESET
//
// Each way evaluates r of the same inputs and prints the same sum over the bits of all values:
//   selected  the model holds what was chosen at run time, as in the renderer
//   called    the combination is written into the loop, which calls its function
//   inlined   the same with everything in one piece
//   switches  asks at each evaluation what was chosen
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "shading/kernels.h"
#include "tests/bench/shading_inputs.h"

namespace rt::bench {

namespace {

struct Fixed {
    std::string_view name;
    MicrofacetTerms terms;
    bool shares = true;
};

constexpr Fixed presets[] = {{"modern", {.D = Distribution::ggx, .G = Masking::ggx, .F = Fresnel::schlick}},
                             {"classic", {.D = Distribution::beckmann, .G = Masking::cook_torrance, .F = Fresnel::schlick}},
                             {"course-blinn", {.D = Distribution::blinn, .G = Masking::cook_torrance, .F = Fresnel::schlick}},
                             {"reference", {.D = Distribution::ggx, .G = Masking::ggx_hc, .F = Fresnel::conductor}},
                             {"lecture", lecture_terms(), false}};

/// Some finishes of one choice: as in a picture, their numbers are not known ahead of an evaluation.
using Finishes = std::array<SurfaceModel, 8>;

Finishes finishes_of(const Fixed& preset) {
    Finishes finishes;
    for (std::size_t i = 0; i < finishes.size(); ++i) {
        const double step = static_cast<double>(i);
        SurfaceModel& model = finishes[i];
        model.terms = preset.terms;
        model.shares = preset.shares;
        model.s = 0.3 + 0.05 * step;
        model.alpha = 0.1 + 0.1 * step;
        for (Interface& x : model.interface) x = interface_of(1.2 + 0.1 * step, preset.terms.F == Fresnel::conductor ? 3.0 : 0.0);
        prepare(model);
    }
    return finishes;
}

template <std::size_t Preset>
[[gnu::noinline, gnu::flatten]] Rgb fixed_highlight(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
    return microfacet_highlight(presets[Preset].terms, model, at, l, tint);
}

std::uint64_t bits(const Rgb& r) {
    return std::bit_cast<std::uint64_t>(r.r) + 3 * std::bit_cast<std::uint64_t>(r.g) + 5 * std::bit_cast<std::uint64_t>(r.b);
}

/// ka + lc (rd + s rs), with the highlight by `way`.
template <typename Highlight>
std::uint64_t sum_of_r(const std::vector<Input>& from, const Finishes& finishes, const Highlight& way) {
    std::uint64_t sum = 0;
    for (const Input& x : from) {
        const SurfaceModel& model = finishes[x.finish];
        sum += bits(x.ka + x.lc * (model.diffuse_share * x.n_dot_l * x.kd + model.s * way(model, x.at, x.l, x.tint)));
    }
    return sum;
}

using Loop = std::uint64_t (*)(const std::vector<Input>&, const Finishes&);

[[gnu::noinline]] std::uint64_t loop_selected(const std::vector<Input>& from, const Finishes& finishes) {
    std::uint64_t sum = 0;
    for (const Input& x : from) sum += bits(complete_r(finishes[x.finish], x));
    return sum;
}

[[gnu::noinline]] std::uint64_t loop_switches(const std::vector<Input>& from, const Finishes& finishes) {
    return sum_of_r(from, finishes, highlight_by_switches);
}

template <std::size_t Preset>
[[gnu::noinline]] std::uint64_t loop_called(const std::vector<Input>& from, const Finishes& finishes) {
    return sum_of_r(from, finishes, [](const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
        return fixed_highlight<Preset>(model, at, l, tint);
    });
}

template <std::size_t Preset>
[[gnu::noinline, gnu::flatten]] std::uint64_t loop_inlined(const std::vector<Input>& from, const Finishes& finishes) {
    return sum_of_r(from, finishes, [](const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
        return microfacet_highlight(presets[Preset].terms, model, at, l, tint);
    });
}

constexpr Loop called[] = {loop_called<0>, loop_called<1>, loop_called<2>, loop_called<3>, loop_called<4>};
constexpr Loop inlined[] = {loop_inlined<0>, loop_inlined<1>, loop_inlined<2>, loop_inlined<3>, loop_inlined<4>};

Loop loop_of(std::string_view way, std::size_t preset) {
    if (way == "selected") return loop_selected;
    if (way == "switches") return loop_switches;
    if (way == "called") return called[preset];
    return way == "inlined" ? inlined[preset] : nullptr;
}

int run(std::string_view way, std::string_view name) {
    for (std::size_t i = 0; i < std::size(presets); ++i) {
        if (presets[i].name != name || !loop_of(way, i)) continue;
        const std::uint64_t sum = loop_of(way, i)(prepared_inputs(), finishes_of(presets[i]));
        std::printf("%016llx\n", static_cast<unsigned long long>(sum));
        return 0;
    }
    std::fputs("usage: selection selected|called|inlined|switches modern|classic|course-blinn|reference|lecture\n", stderr);
    return 1;
}

}  // namespace

}  // namespace rt::bench

int main(int argc, char** argv) { return rt::bench::run(argc > 1 ? argv[1] : "", argc > 2 ? argv[2] : ""); }
