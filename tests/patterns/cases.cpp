#include "tests/patterns/cases.h"

#include <fmt/format.h>

#include <functional>

#include "patterns/density.h"
#include "patterns/hash.h"

namespace rt {

namespace {

using K = PatternKind;

PatternCase make(
    std::string text, K kind, const std::function<void(Pattern&)>& change = [](Pattern&) {}) {
    PatternCase made{std::move(text), make_pattern(kind)};
    change(made.pattern);
    return made;
}

template <typename Numbers>
PatternCase with(std::string text, K kind, const Numbers& numbers) {
    return make(std::move(text), kind, [&](Pattern& p) { p.numbers = numbers; });
}

PatternCase generator(std::string text, K kind, int g) {
    return make(std::move(text), kind, [&](Pattern& p) { p.noise = static_cast<NoiseGenerator>(g); });
}

PatternCase turbulent(std::string text, K kind, const Turbulence& turbulence) {
    return make(std::move(text), kind, [&](Pattern& p) { p.turbulence = turbulence; });
}

PatternCase waved(std::string text, K kind, WaveType wave, float frequency, float phase, float exponent = 1.0F) {
    return make(std::move(text), kind, [&](Pattern& p) {
        p.wave = wave;
        p.frequency = frequency;
        p.phase = phase;
        p.wave_exponent = exponent;
    });
}

/// Gradients along all axes tell all that a chain does to a point.
PatternCase warped_case(const std::string& chain, const std::vector<Warp>& warps) {
    return make("gradient <1,2,3> " + chain, K::gradient, [&](Pattern& p) {
        p.numbers = GradientNumbers{{1, 2, 3}};
        p.warps = warps;
    });
}

void add_plain(std::vector<PatternCase>& cases) {
    for (const K kind : {K::boxed,     K::bozo,    K::bumps,   K::cells,  K::checker,  K::crackle, K::cubic,   K::cylindrical, K::dents,
                         K::granite,   K::hexagon, K::leopard, K::marble, K::onion,    K::planar,  K::quilted, K::radial,      K::ripples,
                         K::spherical, K::spotted, K::waves,   K::wood,   K::wrinkles, K::agate,   K::brick})
        cases.push_back(make(std::string(name(kind)), kind));
    cases.push_back(with("gradient <1,2,-3>", K::gradient, GradientNumbers{{1, 2, -3}}));
    cases.push_back(with("brick brick_size <1,.7,1.3> mortar .2", K::brick, BrickNumbers{{1, .7, 1.3}, .2}));
    for (const int arms : {1, 3, -4}) {
        cases.push_back(with("spiral1 " + std::to_string(arms), K::spiral1, SpiralNumbers{arms}));
        cases.push_back(with("spiral2 " + std::to_string(arms), K::spiral2, SpiralNumbers{arms}));
    }
    cases.push_back(with("quilted control0 .3 control1 -.7", K::quilted, QuiltedNumbers{.3F, -.7F}));
    cases.push_back(with("crackle form <1,0,0>", K::crackle, CrackleNumbers{2, 0, {1, 0, 0}, false}));
    cases.push_back(with("crackle form <.5,-.3,.4> offset .2", K::crackle, CrackleNumbers{2, .2, {.5, -.3, .4}, false}));
    cases.push_back(with("crackle metric 1", K::crackle, CrackleNumbers{1, 0, {-1, 1, 0}, false}));
    cases.push_back(with("crackle metric 3 offset .1", K::crackle, CrackleNumbers{3, .1, {-1, 1, 0}, false}));
    cases.push_back(with("crackle metric .6", K::crackle, CrackleNumbers{.6, 0, {-1, 1, 0}, false}));
    cases.push_back(with("crackle solid", K::crackle, CrackleNumbers{2, 0, {-1, 1, 0}, true}));
}

void add_noises(std::vector<PatternCase>& cases) {
    for (const int g : {1, 2, 3})
        for (const K kind : {K::bozo, K::dents, K::wrinkles, K::granite, K::agate})
            cases.push_back(generator(std::string(name(kind)) + " noise_generator " + std::to_string(g), kind, g));
    const Turbulence half{Vec3(.5)}, own{{.3, .6, -.2}, 3, .7F, 2.5F};
    const std::string own_text = " turbulence <.3,.6,-.2> octaves 3 omega .7 lambda 2.5";
    for (const K kind : {K::bozo, K::marble, K::wood, K::agate, K::leopard, K::onion, K::crackle}) {
        cases.push_back(turbulent(std::string(name(kind)) + " turbulence .5", kind, half));
        cases.push_back(turbulent(std::string(name(kind)) + own_text, kind, own));
    }
    cases.push_back(make("marble turbulence .5 noise_generator 1", K::marble, [&](Pattern& p) {
        p.turbulence = half;
        p.noise = NoiseGenerator::original;
    }));
    cases.push_back(make("marble turbulence .5 noise_generator 3", K::marble, [&](Pattern& p) {
        p.turbulence = half;
        p.noise = NoiseGenerator::perlin;
    }));
    cases.push_back(make("agate agate_turb .4 octaves 3 lambda 2.3 omega .6", K::agate, [](Pattern& p) {
        p.numbers = AgateNumbers{.4F};
        p.turbulence = Turbulence{Vec3(0.0), 3, .6F, 2.3F};
    }));
    cases.push_back(make("bozo turbulence .5 scale 2", K::bozo, [&](Pattern& p) {
        p.turbulence = half;
        append(p, Transform::scale(Vec3(2.0)));
    }));
    cases.push_back(make("marble warp{turbulence .5}", K::marble, [&](Pattern& p) { p.warps = {half}; }));
}

void add_waves(std::vector<PatternCase>& cases) {
    const struct {
        const char* text;
        WaveType wave;
    } kinds[] = {{"ramp_wave", WaveType::ramp},       {"triangle_wave", WaveType::triangle}, {"sine_wave", WaveType::sine},
                 {"scallop_wave", WaveType::scallop}, {"cubic_wave", WaveType::cubic},       {"poly_wave 2.5", WaveType::poly}};
    for (const auto& [text, wave] : kinds) {
        cases.push_back(waved(std::string("gradient x frequency 2.5 phase .3 ") + text, K::gradient, wave, 2.5F, .3F, 2.5F));
        cases.push_back(waved(std::string("gradient x frequency -1 phase -.7 ") + text, K::gradient, wave, -1, -.7F, 2.5F));
        cases.push_back(waved(std::string("gradient x frequency 0 phase .2 ") + text, K::gradient, wave, 0, .2F, 2.5F));
    }
    cases.push_back(waved("ripples frequency 2 phase .3", K::ripples, WaveType::ramp, 2, .3F));
    cases.push_back(waved("waves frequency 1.5 phase .3", K::waves, WaveType::ramp, 1.5F, .3F));
    cases.push_back(waved("wood sine_wave", K::wood, WaveType::sine, 1, 0));
    cases.push_back(waved("marble frequency 3", K::marble, WaveType::triangle, 3, 0));
}

MappingWarp mapping(MappingWarp::Kind kind, int axis, double exponent, double major = 1.0) {
    Vec3 orientation(0.0);
    orientation[axis] = 1.0;
    return {kind, orientation, exponent, major, 0.0};
}

void add_warps(std::vector<PatternCase>& cases) {
    using M = MappingWarp::Kind;
    const Rotation left = Rotation::povray;
    const Turbulence half{Vec3(.5)};
    cases.push_back(
        warped_case("scale <2,.5,3> rotate <10,20,30> translate <.3,.1,-.2>",
                    {Transform::scale({2, .5, 3}), Transform::rotate({10, 20, 30}, left), Transform::translate({.3, .1, -.2})}));
    cases.push_back(warped_case("warp{turbulence .5} scale 2", {half, Transform::scale(Vec3(2.0))}));
    cases.push_back(warped_case("scale 2 warp{turbulence .5}", {Transform::scale(Vec3(2.0)), half}));
    cases.push_back(warped_case("warp{repeat .7*x}", {RepeatWarp{0, .7F}}));
    cases.push_back(warped_case("warp{repeat 1.3*y offset <.2,.3,.4>}", {RepeatWarp{1, 1.3F, {.2, .3, .4}}}));
    cases.push_back(warped_case("warp{repeat 1.3*z flip z}", {RepeatWarp{2, 1.3F, Vec3(0.0), {0, 0, 1}}}));
    cases.push_back(warped_case("warp{repeat 1.3*z offset .1*x flip <1,1,0>}", {RepeatWarp{2, 1.3F, {.1, 0, 0}, {1, 1, 0}}}));
    cases.push_back(warped_case("warp{repeat -.9*x flip x}", {RepeatWarp{0, -.9F, Vec3(0.0), {1, 0, 0}}}));
    cases.push_back(warped_case("warp{repeat x} warp{repeat 1.4*y}", {RepeatWarp{0, 1}, RepeatWarp{1, 1.4F}}));
    cases.push_back(warped_case("warp{black_hole <.2,.1,.3>, 2.5}", {BlackHoleWarp{{.2, .1, .3}, 2.5}}));
    cases.push_back(warped_case("warp{black_hole <.2,.1,.3>, 2.5 strength 1.8 falloff 1.2 inverse}",
                                {BlackHoleWarp{{.2, .1, .3}, 2.5, 1.8, 1.2, true}}));
    BlackHoleWarp many{{.2, .1, .3}, .7, 1.5, 1.2, false, {1.7, 0, 2}};
    cases.push_back(warped_case("warp{black_hole <.2,.1,.3>, .7 strength 1.5 falloff 1.2 repeat <1.7,0,2>}",
                                (fit_repeat(many), std::vector<Warp>{many})));
    BlackHoleWarp shaken{{.8, .9, .7}, .6, 1.5, 1.2, true, {1.5, 1.9, 2}, {.3, .2, .1}};
    cases.push_back(warped_case("warp{black_hole <.8,.9,.7>, .6 strength 1.5 falloff 1.2 repeat <1.5,1.9,2> turbulence <.3,.2,.1> inverse}",
                                (fit_repeat(shaken), std::vector<Warp>{shaken})));
    for (int axis = 0; axis < 3; ++axis) {
        const std::string o = std::string(" orientation ") + "xyz"[axis];
        cases.push_back(warped_case("warp{spherical" + o + " dist_exp 1}", {mapping(M::spherical, axis, 1)}));
        cases.push_back(warped_case("warp{cylindrical" + o + " dist_exp .5}", {mapping(M::cylindrical, axis, .5)}));
        cases.push_back(warped_case("warp{toroidal" + o + " dist_exp .3 major_radius .8}", {mapping(M::toroidal, axis, .3, .8)}));
        MappingWarp plane = mapping(M::planar, axis, 0);
        plane.distance = .4;
        cases.push_back(warped_case(std::string("warp{planar ") + "xyz"[axis] + ", .4}", {plane}));
    }
    cases.push_back(warped_case("warp{cubic}", {CubicWarp{}}));
}

void add_fractals(std::vector<PatternCase>& cases) {
    const auto add = [&](const std::string& text, K kind, FractalNumbers numbers) {
        for (const int type : {0, 1, 2, 3, 4, 5, 6}) {
            if (kind == K::magnet && (type == 4 || type == 5)) continue;  // squares of large numbers: they keep few digits
            numbers.exterior = numbers.interior = type;
            numbers.exterior_factor = .3;
            numbers.interior_factor = .7;
            const std::string types = fmt::format(" exterior {} .3 interior {} .7 frequency .25 scale 2", type, type);
            cases.push_back(make(text + types, kind, [&](Pattern& p) {
                p.numbers = numbers;
                p.frequency = .25F;
                append(p, Transform::scale(Vec3(2.0)));
            }));
        }
    };
    FractalNumbers numbers;
    numbers.iterations = 12;
    add("mandel 12", K::mandel, numbers);
    add("magnet 1 mandel 12", K::magnet, numbers);
    numbers.magnet = 2;
    add("magnet 2 mandel 12", K::magnet, numbers);
    numbers.c = {.3, -.4};
    add("julia <.3,-.4>, 12", K::julia, numbers);
    numbers.julia = true;
    add("magnet 2 julia <.3,-.4>, 12", K::magnet, numbers);
    for (const int exponent : {3, 4, 7, 33}) {
        numbers.exponent = exponent;
        cases.push_back(with("julia <.3,-.4>, 12 exponent " + std::to_string(exponent), K::julia, numbers));
        cases.push_back(with("mandel 12 exponent " + std::to_string(exponent), K::mandel, numbers));
    }
    cases.push_back(make("mandel 5", K::mandel, [](Pattern& p) { std::get<FractalNumbers>(p.numbers).iterations = 5; }));
}

/// A grid of 3 x 4 x 5 numbers, which the test also writes to cases.df3.
void add_densities(std::vector<PatternCase>& cases) {
    for (int interpolate = 0; interpolate <= 2; ++interpolate) {
        const std::string text = fmt::format("density_file df3 \"cases.df3\" interpolate {} scale 4 translate -2", interpolate);
        cases.push_back(make(text, K::density_file, [&](Pattern& p) {
            p.numbers = DensityNumbers{Shared<ValueGrid>(*read_df3(case_density())), interpolate};
            append(p, Transform::scale(Vec3(4.0)));
            append(p, Transform::translate(Vec3(-2.0)));
        }));
    }
}

/// A picture of 4 x 3 texels, which the tests also write to cases.pgm.
void add_images(std::vector<PatternCase>& cases) {
    for (const int type : {0, 1, 2, 5})
        for (const int interpolate : {0, 2, 3, 4})
            for (const bool once : {false, true}) {
                const std::string options = fmt::format(
                    "map_type {}{}{}", type, interpolate ? fmt::format(" interpolate {}", interpolate) : "", once ? " once" : "");
                cases.push_back(with("image_pattern { pgm \"cases.pgm\" gamma 1.0 " + options + " }", K::image_pattern,
                                     ImageNumbers{Shared<ValueGrid>(case_picture()), {type, interpolate, once}}));
            }
    ImageMapping laid;
    laid.offset = {.3, -.2};
    laid.repeat = {2, 1};
    cases.push_back(with("image_pattern { pgm \"cases.pgm\" gamma 1.0 offset <.3,-.2> repeat <2,1> }", K::image_pattern,
                         ImageNumbers{Shared<ValueGrid>(case_picture()), laid}));
}

}  // namespace

ValueGrid case_picture() {
    ValueGrid grid{4, 3, 1, {}};
    TableRandom draw{4};
    for (int i = 0; i < 12; ++i) grid.values.push_back(static_cast<float>(draw() / 65535.0));
    return grid;
}

std::string case_picture_file() {
    std::string bytes = "P5\n4 3\n65535\n";
    TableRandom draw{4};
    for (int i = 0; i < 12; ++i) {
        const int value = draw();
        bytes += {static_cast<char>(value / 256), static_cast<char>(value % 256)};
    }
    return bytes;
}

std::string case_density() {
    std::string bytes{"\0\3\0\4\0\5", 6};
    TableRandom draw{3};
    for (int i = 0; i < 60; ++i) bytes += static_cast<char>(draw() % 256);
    return bytes;
}

std::vector<PatternCase> pattern_cases() {
    std::vector<PatternCase> cases;
    add_plain(cases);
    add_noises(cases);
    add_waves(cases);
    add_warps(cases);
    add_fractals(cases);
    add_densities(cases);
    add_images(cases);
    return cases;
}

std::vector<Vec3> case_points() {
    std::vector<Vec3> points;
    TableRandom draw{20};
    const auto coordinate = [&] { return (draw() % 6001 - 3000) / 1000.0 + 0.0003; };
    for (int i = 0; i < 16; ++i) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        points.emplace_back(x, y, z);
    }
    points.emplace_back(12345.6, -777.3, 4100.2);
    points.emplace_back(-5000.7, 3.1, 50.2);
    points.emplace_back(0.0004, 0.0003, -0.0002);
    points.emplace_back(0.5, -0.25, 0.75);
    return points;
}

}  // namespace rt
