#include "tests/patterns/picture_cases.h"

#include "patterns/map.h"
#include "patterns/perturb.h"
#include "tests/patterns/cases.h"

namespace rt {

namespace {

using K = PatternKind;
using Change = std::function<void(Pattern&, Bump&)>;

constexpr double radius = 2.9;

/// A white surface with diffuse 1 shows the cosines to the three lights.
PictureCase normal_case(
    const std::string& text, K kind, float amount, const Change& change = [](Pattern&, Bump&) {}) {
    Pattern pattern = make_pattern(kind);
    Bump bump;
    bump.amount = amount;
    change(pattern, bump);
    return {"pigment { rgb 1 } finish { ambient 0 diffuse 1 } normal { " + text + " }", [pattern, bump](const CapPoint& at) {
                const Vec3 n0 = into_pattern(pattern, bump, at.normal);
                const Vec3 n1 = perturbed(pattern, bump, n0, pattern_point(pattern, at.p), {at.normal, at.direction});
                const Vec3 n = out_of_pattern(pattern, bump, n1);
                Rgb color;
                for (int i = 0; i < 3; ++i) color[i] = std::fmax(0.0, dot(n, light_directions[i]));
                return color;
            }};
}

/// Values as grey, cells as steps of grey.
PictureCase value_case(
    const std::string& text, K kind, const std::function<void(Pattern&)>& change = [](Pattern&) {}) {
    Pattern pattern = make_pattern(kind);
    change(pattern);
    std::string colors = "color_map { [0 rgb 0] [1 rgb 1] }";
    if (has_cells(kind)) {
        colors.clear();
        for (int i = 0; i < cell_count(kind); ++i) colors += (i ? ", rgb " : " rgb ") + std::to_string(i) + "/8";
    }
    const std::string body = has_cells(kind) ? std::string(name(kind)) + colors + text : std::string(name(kind)) + text + " " + colors;
    return {"pigment { " + body + " } finish { ambient 0 diffuse 0 emission 1 }", [pattern](const CapPoint& at) {
                if (has_cells(pattern.kind)) return Rgb(pattern_cell(pattern, at.p) / 8.0);
                return Rgb(pattern_value(pattern, at.p, {at.normal, at.direction}));
            }};
}

void add_own_normals(std::vector<PictureCase>& cases) {
    for (const K kind : {K::bumps, K::dents, K::wrinkles, K::ripples, K::waves, K::quilted})
        cases.push_back(normal_case(std::string(name(kind)) + " .7", kind, .7F));
    cases.push_back(normal_case("ripples .4 frequency 2 phase .2", K::ripples, .4F, [](Pattern& p, Bump&) {
        p.frequency = 2;
        p.phase = .2F;
    }));
    cases.push_back(normal_case("waves .4 frequency 3", K::waves, .4F, [](Pattern& p, Bump&) { p.frequency = 3; }));
    cases.push_back(normal_case("quilted .6 control0 .3 control1 -.7", K::quilted, .6F, [](Pattern& p, Bump&) {
        p.numbers = QuiltedNumbers{.3F, -.7F};
    }));
    cases.push_back(
        normal_case("dents .8 noise_generator 1", K::dents, .8F, [](Pattern& p, Bump&) { p.noise = NoiseGenerator::original; }));
    cases.push_back(normal_case("facets .5 size .4", K::facets, .5F, [](Pattern& p, Bump&) { p.numbers = FacetsNumbers{.4F, 0, 2}; }));
    cases.push_back(normal_case("facets .5 coords .6 size .7", K::facets, .5F, [](Pattern& p, Bump&) {
        p.numbers = FacetsNumbers{.7F, .6F, 2};
    }));
    cases.push_back(normal_case("facets .5 coords .6", K::facets, .5F, [](Pattern& p, Bump&) { p.numbers = FacetsNumbers{.1F, .6F, 2}; }));
    cases.push_back(normal_case("bumps -.7 turbulence .5", K::bumps, -.7F, [](Pattern& p, Bump&) { p.turbulence = Turbulence{Vec3(.5)}; }));
}

void add_bump_maps(std::vector<PictureCase>& cases) {
    for (const int interpolate : {0, 2, 3})
        for (const int type : {0, 1}) {
            const std::string options =
                (interpolate ? " interpolate " + std::to_string(interpolate) : "") + " map_type " + std::to_string(type);
            const std::string text = "bump_map { pgm \"cases.pgm\" gamma 1.0" + options + " bump_size 1.5 } scale 3";
            cases.push_back(normal_case(text, K::bump_map, 1.5F, [&](Pattern& p, Bump&) {
                p.numbers = ImageNumbers{Shared<ValueGrid>(case_picture()), {type, interpolate}};
                append(p, Transform::scale(Vec3(3.0)));
            }));
        }
}

void add_differences(std::vector<PictureCase>& cases) {
    for (const K kind :
         {K::bozo, K::granite, K::leopard, K::marble, K::wood, K::crackle, K::onion, K::radial, K::spiral1, K::cells, K::gradient})
        cases.push_back(normal_case(std::string(name(kind)) +
                                        (kind == K::gradient  ? " x"
                                         : kind == K::spiral1 ? " 1"
                                                              : "") +
                                        " .2",
                                    kind, .2F));
    cases.push_back(normal_case("agate .2 accuracy .01", K::agate, .2F, [](Pattern&, Bump& b) { b.accuracy = .01F; }));
    cases.push_back(normal_case("marble .3 turbulence .4 sine_wave frequency 2", K::marble, .3F, [](Pattern& p, Bump&) {
        p.turbulence = Turbulence{Vec3(.4)};
        p.wave = WaveType::sine;
        p.frequency = 2;
    }));
    cases.push_back(normal_case("gradient <1,1,1> .3 slope_map { [0 <.2,1>] [.4 <1,-.5>] [.4 <.3,0>] [.9 <0,2>] }", K::gradient, .3F,
                                [](Pattern& p, Bump& b) {
                                    p.numbers = GradientNumbers{Vec3(1.0)};
                                    b.slopes = {{0, .2, 1}, {.4, 1, -.5}, {.4, .3, 0}, {.9, 0, 2}};
                                }));
    for (const K kind : {K::checker, K::brick, K::hexagon})
        cases.push_back(normal_case(std::string(name(kind)) + " .3 scale .4 accuracy .3", kind, .3F, [](Pattern& p, Bump& b) {
            b.accuracy = .3F;
            append(p, Transform::scale(Vec3(.4)));
        }));
}

void add_chains(std::vector<PictureCase>& cases) {
    const auto chain = [](Pattern& p) {
        append(p, Transform::scale({.4, 1.3, .8}));
        append(p, Transform::rotate({20, 30, 50}, Rotation::povray));
        append(p, Transform::translate({.1, .2, .3}));
    };
    const std::string text = " scale <.4,1.3,.8> rotate <20,30,50> translate <.1,.2,.3>";
    for (const K kind : {K::bumps, K::granite, K::waves}) {
        cases.push_back(normal_case(std::string(name(kind)) + " .5" + text, kind, .5F, [&](Pattern& p, Bump&) { chain(p); }));
        cases.push_back(normal_case(std::string(name(kind)) + " .5 no_bump_scale" + text, kind, .5F, [&](Pattern& p, Bump& b) {
            chain(p);
            b.scale = false;
        }));
    }
    cases.push_back(normal_case("bumps .5 scale .3 warp { repeat x } rotate 30*y", K::bumps, .5F, [](Pattern& p, Bump&) {
        append(p, Transform::scale(Vec3(.3)));
        p.warps.emplace_back(RepeatWarp{0, 1});
        append(p, Transform::rotate({0, 30, 0}, Rotation::povray));
    }));
}

void add_values(std::vector<PictureCase>& cases) {
    const auto small = [](Pattern& p) { append(p, Transform::scale(Vec3(.4))); };
    for (const K kind : {K::checker, K::brick, K::hexagon, K::square, K::triangular, K::cubic})
        cases.push_back(value_case(" scale .4", kind, small));
    cases.push_back(value_case("", K::aoi));
    cases.push_back(value_case(" <.3,1,-.2>", K::slope, [](Pattern& p) { std::get<SlopeNumbers>(p.numbers).slope = {.3, 1, -.2}; }));
    cases.push_back(value_case(" { <.3,1,-.2>, .6, .9 }", K::slope, [](Pattern& p) {
        auto& numbers = std::get<SlopeNumbers>(p.numbers);
        numbers.slope = {.3, 1, -.2};
        numbers.slope_range = {.6F, .9F};
    }));
    cases.push_back(value_case(" { <.3,1,-.2> altitude <.5,.7,0>, 1, 3 }", K::slope, [](Pattern& p) {
        auto& numbers = std::get<SlopeNumbers>(p.numbers);
        numbers.slope = {.3, 1, -.2};
        numbers.altitude = {.5, .7, 0};
        numbers.altitude_range = {1, 3};
    }));
    cases.push_back(value_case(" { <.3,1,-.2>, .6, .9 altitude <.5,.7,0> }", K::slope, [](Pattern& p) {
        auto& numbers = std::get<SlopeNumbers>(p.numbers);
        numbers.slope = {.3, 1, -.2};
        numbers.slope_range = {.6F, .9F};
        numbers.altitude = {.5, .7, 0};
    }));
}

}  // namespace

const Vec3 light_directions[3] = {unit(Vec3(std::sqrt(2.0), 1.0, 0.0)), unit(Vec3(-std::sqrt(0.5), 1.0, std::sqrt(1.5))),
                                  unit(Vec3(-std::sqrt(0.5), 1.0, -std::sqrt(1.5)))};

std::vector<PictureCase> picture_cases() {
    std::vector<PictureCase> cases;
    add_own_normals(cases);
    add_bump_maps(cases);
    add_differences(cases);
    add_chains(cases);
    add_values(cases);
    return cases;
}

CapPoint cap_point(int column, int row) {
    const double x = -1.25 + 0.5 * column + 0.0, z = 1.25 - 0.5 * row;
    const Vec3 p(x, std::sqrt(radius * radius - x * x - z * z), z);
    return {p, unit(p)};
}

}  // namespace rt
