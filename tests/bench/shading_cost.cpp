// Nanoseconds per evaluation of each shading term, of the geometry and of the whole r of each preset, over 4096 prepared inputs: the
// column "Time" is one evaluation. see README, Speed.
#include <benchmark/benchmark.h>

#include <type_traits>

#include "commands/job/model_choices.h"
#include "shading/kernels.h"
#include "shading/names.h"
#include "tests/bench/shading_inputs.h"

namespace rt::bench {

namespace {

const std::vector<Input>& all_inputs() {
    static const std::vector<Input> result = prepared_inputs();
    return result;
}

/// One measured iteration is one evaluation of `evaluate`, over what `arguments` takes of the inputs: no more than is read, so that the
/// caches hold it.
template <typename Arguments, typename Evaluate>
void measure(benchmark::State& state, const Arguments& arguments, const Evaluate& evaluate) {
    std::vector<std::decay_t<decltype(arguments(all_inputs()[0]))>> from;
    for (const Input& x : all_inputs()) from.push_back(arguments(x));
    std::vector<std::decay_t<decltype(evaluate(from[0]))>> to(inputs);
    while (state.KeepRunningBatch(inputs)) {
        for (std::size_t i = 0; i < inputs; ++i) to[i] = evaluate(from[i]);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
}

struct Directions {
    ViewedPoint at;
    Vec3 l;
};
Directions directions(const Input& x) { return {x.at, x.l}; }

void geometry(benchmark::State& state) {
    measure(state, directions, [](const Directions& x) {
        HalfGeometry g;
        half_geometry(x.at.n, x.l, x.at.v, x.at.incline_v, g);
        return g;
    });
}

void view(benchmark::State& state) {
    measure(state, directions, [](const Directions& x) { return incline(x.at.n, x.at.v); });
}

void distribution(benchmark::State& state, Distribution kind) {
    struct Arguments {
        double cos2_h, sin2_h, alpha;
    };
    measure(
        state,
        [](const Input& x) {
            return Arguments{x.g.cos2_h, x.g.sin2_h, x.alpha};
        },
        [kind](const Arguments& x) { return D(kind, x.cos2_h, x.sin2_h, x.alpha); });
}

void masking(benchmark::State& state, Masking kind) {
    struct Arguments {
        HalfGeometry g;
        double alpha;
    };
    measure(
        state,
        [](const Input& x) {
            return Arguments{x.g, x.alpha};
        },
        [kind](const Arguments& x) { return visibility(kind, x.g, x.alpha); });
}

void fresnel(benchmark::State& state, Fresnel kind) {
    struct Arguments {
        Interface interface;
        double c;
    };
    measure(
        state,
        [kind](const Input& x) {
            return Arguments{kind == Fresnel::conductor ? x.metal : x.dielectric, x.g.v_dot_h};
        },
        [kind](const Arguments& x) { return F(kind, x.interface, x.c); });
}

/// The factor on the colour.
void diffuse(benchmark::State& state, Diffuse kind) {
    SurfaceModel model;
    model.diffuse = kind;
    model.oren_nayar = OrenNayar(0.5);
    prepare(model);
    measure(state, directions, [&](const Directions& x) { return diffuse_factor(model, x.at, x.l, x.at.incline_v.cos); });
}

void gooch_tone(benchmark::State& state) {
    measure(
        state, [](const Input& x) { return x.n_dot_l; }, [](double n_dot_l) { return gooch(n_dot_l, 0.2, 0.6); });
}

/// As the renderer has it for each lamp and layer.
void complete(benchmark::State& state, const SurfaceModel& model) {
    measure(
        state, [](const Input& x) { return x; }, [&](const Input& x) { return complete_r(model, x); });
}

/// alpha 0.3 and s 0.5, unless the words say otherwise.
SurfaceModel model_of(std::initializer_list<ModelOption> words) {
    ModelChoice choice;
    choice.s = 0.5;
    choice.alpha = 0.3;
    for (const ModelOption& word : words) choose(choice, word.key, word.value);
    return fill(choice, Finish{}, 1.5, AlphaMapping::roughness2);
}

template <typename T, std::size_t N, typename Run>
void add_all(const char* group, const std::array<Named<T>, N>& names, const Run& run) {
    for (const Named<T>& entry : names)
        benchmark::RegisterBenchmark((std::string(group) + "/" + std::string(entry.name)).c_str(),
                                     [run, value = entry.value](benchmark::State& state) { run(state, value); });
}

}  // namespace

void add_benchmarks() {
    benchmark::RegisterBenchmark("geometry/view", view);
    benchmark::RegisterBenchmark("geometry/half", geometry);
    add_all("D", distribution_names, distribution);
    add_all("V", masking_names, masking);
    add_all("F", fresnel_names, fresnel);
    add_all("diffuse", diffuse_names, diffuse);
    benchmark::RegisterBenchmark("diffuse/gooch-tone", gooch_tone);
    const auto add = [](const std::string& name, const SurfaceModel& model) {
        benchmark::RegisterBenchmark(("r/" + name).c_str(), [model](benchmark::State& state) { complete(state, model); });
    };
    for (const Named<std::string_view>& preset : preset_names)
        add(std::string(preset.name), model_of({{"preset", std::string(preset.name)}}));
    add("reference,shiny-gold", model_of({{"preset", "reference"}, {"material", "shiny-gold"}}));
}

}  // namespace rt::bench

int main(int argc, char** argv) {
    rt::bench::add_benchmarks();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
