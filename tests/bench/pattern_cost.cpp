// Nanoseconds per point of each pattern as pigments use it, of the noises and of turbulence: the column "Time" is one value. see README,
// Speed.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "patterns/hash.h"
#include "patterns/pattern.h"
#include "patterns/perturb.h"

namespace rt::bench {

namespace {

constexpr std::size_t inputs = 4096;

/// Points as a ray tracer asks for them: neighbours on a surface, many cells wide.
const std::vector<Vec3>& points() {
    static const auto result = [] {
        std::vector<Vec3> made;
        for (std::size_t i = 0; i < inputs; ++i) {
            const double u = 0.31 * static_cast<double>(i % 64), v = 0.27 * static_cast<double>(i / 64);
            made.emplace_back(u - 10.0, 0.4 * u + 0.1 * v, v - 8.0);
        }
        return made;
    }();
    return result;
}

template <typename Value>
void measure(benchmark::State& state, const Value& value) {
    std::vector<double> to(inputs);
    while (state.KeepRunningBatch(inputs)) {
        for (std::size_t i = 0; i < inputs; ++i) to[i] = value(points()[i]);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
}

void pattern(const std::string& name, const Pattern& measured) {
    benchmark::RegisterBenchmark(name.c_str(), [measured](benchmark::State& state) {
        measure(state, [&](const Vec3& p) { return has_cells(measured.kind) ? pattern_cell(measured, p) : pattern_value(measured, p); });
    });
}

void normal(const std::string& name, PatternKind kind) {
    benchmark::RegisterBenchmark(name.c_str(), [measured = make_pattern(kind)](benchmark::State& state) {
        measure(state, [&](const Vec3& p) { return perturbed(measured, Bump{}, Vec3(0.0, 1.0, 0.0), pattern_point(measured, p)).y; });
    });
}

void register_all() {
    for (int i = 0; i <= static_cast<int>(PatternKind::wrinkles); ++i) {
        Pattern one = make_pattern(static_cast<PatternKind>(i));
        if (!is_computed_elsewhere(one.kind)) pattern(std::string(name(one.kind)), one);
    }
    for (const int g : {1, 2, 3}) {
        Pattern bozo = make_pattern(PatternKind::bozo);
        bozo.noise = static_cast<NoiseGenerator>(g);
        pattern("bozo, generator " + std::to_string(g), bozo);
    }
    for (const PatternKind kind : {PatternKind::bozo, PatternKind::marble, PatternKind::agate}) {
        Pattern turbulent = make_pattern(kind);
        turbulent.turbulence = Turbulence{Vec3(0.5)};
        pattern(std::string(name(kind)) + ", turbulence", turbulent);
    }
    Pattern fractal = make_pattern(PatternKind::mandel);
    std::get<FractalNumbers>(fractal.numbers).iterations = 50;
    pattern("mandel, 50 steps", fractal);
    for (const PatternKind kind :
         {PatternKind::bumps, PatternKind::wrinkles, PatternKind::ripples, PatternKind::granite, PatternKind::crackle})
        normal("normal " + std::string(name(kind)), kind);
}

}  // namespace

}  // namespace rt::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    rt::bench::register_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
