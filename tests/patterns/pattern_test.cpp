// What holds for every pattern, whatever its values are.
#include "patterns/pattern.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "patterns/perturb.h"
#include "tests/patterns/cases.h"

namespace rt::pattern_test {
namespace {

constexpr int last_kind = static_cast<int>(PatternKind::wrinkles);

TEST(Pattern, WordsNameKinds) {
    for (int i = 0; i <= last_kind; ++i) {
        const auto kind = static_cast<PatternKind>(i);
        EXPECT_EQ(pattern_kind(name(kind)), kind);
        EXPECT_EQ(make_pattern(kind).kind, kind);
    }
    EXPECT_FALSE(pattern_kind("sphere"));
    EXPECT_EQ(wave_type("scallop_wave"), WaveType::scallop);
    EXPECT_FALSE(wave_type("scallop"));
}

TEST(Pattern, TriangleWavesOfItsOwn) {
    for (int i = 0; i <= last_kind; ++i) {
        const auto kind = static_cast<PatternKind>(i);
        const bool triangle =
            kind == PatternKind::marble || kind == PatternKind::wood || kind == PatternKind::spiral1 || kind == PatternKind::spiral2;
        EXPECT_EQ(make_pattern(kind).wave, triangle ? WaveType::triangle : WaveType::ramp) << name(kind);
    }
}

TEST(Pattern, CellsHaveTheirNumbersUntilAFrequencyIsStated) {
    for (int i = 0; i <= last_kind; ++i) {
        const auto kind = static_cast<PatternKind>(i);
        EXPECT_EQ(make_pattern(kind).frequency, has_cells(kind) ? 0.0F : 1.0F) << name(kind);
    }
    Pattern faces = make_pattern(PatternKind::cubic);
    const Vec3 last_face(0.1, 0.2, -1.0);
    ASSERT_EQ(raw_cell(faces, last_face), 5);
    EXPECT_EQ(pattern_value(faces, last_face), 5.0);
    faces.phase = 0.5F;
    EXPECT_EQ(pattern_value(faces, last_face), 5.0) << "no phase without frequency";
    faces.frequency = 0.5F;
    EXPECT_EQ(pattern_value(faces, last_face), std::fmod(3.0, 1.00001));
}

TEST(Pattern, WithoutASurfaceSlopeAndAngleAreZero) {
    EXPECT_EQ(raw_value(make_pattern(PatternKind::slope), Vec3(1.0)), 0.0);
    EXPECT_EQ(raw_value(make_pattern(PatternKind::aoi), Vec3(1.0)), 0.0);
    const PatternSurface seen{Vec3(0, 1, 0), Vec3(0, -1, 0)};
    EXPECT_EQ(raw_value(make_pattern(PatternKind::slope), Vec3(1.0), seen), 1.0);
    EXPECT_EQ(raw_value(make_pattern(PatternKind::aoi), Vec3(1.0), seen), 1.0);
}

TEST(Pattern, NumbersOfItsOwn) {
    EXPECT_EQ(std::get<BrickNumbers>(make_pattern(PatternKind::brick).numbers), (BrickNumbers{{8, 3, 4.5}, .5}));
    EXPECT_EQ(std::get<DensityNumbers>(make_pattern(PatternKind::density_file).numbers).interpolate, 0);
    EXPECT_EQ(std::get<FacetsNumbers>(make_pattern(PatternKind::facets).numbers), (FacetsNumbers{.1F, 0, 2}));
    EXPECT_EQ(std::get<WavesNumbers>(make_pattern(PatternKind::waves).numbers).sources->size(), 10U);
}

TEST(Pattern, ThreeStepsMakeTheValue) {
    for (const auto& [text, pattern] : pattern_cases())
        for (const Vec3& p : case_points()) {
            const Vec3 q = pattern_point(pattern, p);
            EXPECT_EQ(pattern_value(pattern, p), wave_value(pattern, raw_value(pattern, q))) << text;
            EXPECT_EQ(pattern_cell(pattern, p), raw_cell(pattern, q)) << text;
        }
}

/// Measured along the x axis.
TEST(Pattern, TurbulenceMovesASpiralAndShiftsIt) {
    const auto values = [](PatternKind kind, const std::array<double, 6>& measured) {
        Pattern pattern = make_pattern(kind);
        pattern.numbers = SpiralNumbers{3};
        pattern.wave = WaveType::ramp;
        pattern.turbulence = Turbulence{Vec3(.7, 0, 0)};
        append(pattern, Transform::translate({.2, .3, .1}));
        for (std::size_t i = 0; i < measured.size(); ++i)
            EXPECT_NEAR(pattern_value(pattern, {static_cast<double>(i) - 2.5, 0, 0}), measured[i], 2e-5) << name(kind) << ' ' << i;
    };
    values(PatternKind::spiral1, {.54079, .55554, .78714, .23323, .82066, .96934});
    values(PatternKind::spiral2, {.80966, .86166, .08827, .20708, .21869, .91559});
}

TEST(Pattern, TransformsOfAChainAreOneStep) {
    Pattern pattern = make_pattern(PatternKind::bozo);
    append(pattern, Transform::scale(Vec3(2.0)));
    append(pattern, Transform::translate({1, 2, 3}));
    EXPECT_EQ(pattern.warps.size(), 1U);
    pattern.warps.emplace_back(RepeatWarp{});
    append(pattern, Transform::scale(Vec3(3.0)));
    EXPECT_EQ(pattern.warps.size(), 3U);
    EXPECT_EQ(pattern_point(make_pattern(PatternKind::bozo), {1, 2, 3}), Vec3(1, 2, 3));
}

/// Points far away, on axes and no points at all: nothing crashes, cells stay in their range.
TEST(Pattern, AnyPointMayBeAsked) {
    const double odd[] = {0.0,
                          -0.0,
                          1.0,
                          -1.0,
                          1e-300,
                          1e9,
                          -1e9,
                          1e20,
                          -1e20,
                          1e300,
                          std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    for (const auto& [text, pattern] : pattern_cases())
        for (const double x : odd)
            for (const double z : odd) {
                const Vec3 p(x, 0.5, z);
                const int cell = pattern_cell(pattern, p);
                EXPECT_TRUE(cell >= 0 && cell < std::max(1, cell_count(pattern.kind))) << text << " " << x << " " << z;
                const bool near = std::fabs(x) < 1e10 && std::fabs(z) < 1e10;
                EXPECT_TRUE(!near || std::isfinite(pattern_value(pattern, p))) << text << " " << x << " " << z;
            }
}

/// What POV-Ray's parser lets through.
TEST(Pattern, NumbersThatMakeNoSenseDoNoHarm) {
    std::vector<Pattern> odd;
    for (const double metric : {0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        odd.push_back(make_pattern(PatternKind::crackle));
        odd.back().numbers = CrackleNumbers{metric, -1.0, {-1, 1, 0}, false};
    }
    for (const double size : {0.0, -1.0, 1e-300}) {
        odd.push_back(make_pattern(PatternKind::brick));
        odd.back().numbers = BrickNumbers{{size, 1, size}, size};
    }
    odd.push_back(make_pattern(PatternKind::gradient));
    odd.back().numbers = GradientNumbers{Vec3(0.0)};
    odd.push_back(make_pattern(PatternKind::mandel));
    odd.back().numbers = FractalNumbers{1, false, Vec2(0.0), -3};
    odd.push_back(make_pattern(PatternKind::bozo));
    odd.back().warps = {BlackHoleWarp{Vec3(0.0), 0.0}, BlackHoleWarp{Vec3(0.0), -1.0}, MappingWarp{},
                        Turbulence{Vec3(1.0), -5, 0.0F, 0.0F}};
    for (const Pattern& pattern : odd)
        for (const Vec3& p : case_points()) {
            const double v = pattern_value(pattern, p);
            EXPECT_FALSE(v < 0.0) << name(pattern.kind);
            EXPECT_LT(pattern_cell(pattern, p), std::max(1, cell_count(pattern.kind)));
        }
}

TEST(Pattern, BricksOfNoSizeAreMortar) {
    for (const Vec3& p : case_points()) {
        Pattern pattern = make_pattern(PatternKind::brick);
        pattern.numbers = BrickNumbers{{0, 1, 1}, .5};
        EXPECT_EQ(pattern_cell(pattern, p), 0);
    }
}

TEST(Normal, FacetsOfNoSizeAreNone) {
    Pattern facets = make_pattern(PatternKind::facets);
    std::get<FacetsNumbers>(facets.numbers).size = 0.0F;
    EXPECT_EQ(perturbed(facets, Bump{}, {0, 1, 0}, {.3, .4, .5}), Vec3(0, 1, 0));
}

TEST(Pattern, EqualValuesAreEqualPatterns) {
    const auto cases = pattern_cases();
    for (std::size_t i = 1; i < cases.size(); ++i) {
        EXPECT_EQ(cases[i].pattern, Pattern(cases[i].pattern));
        EXPECT_NE(cases[i].pattern, cases[i - 1].pattern) << cases[i].text;
    }
}

TEST(Pattern, ABlackHoleStaysInItsBlock) {
    BlackHoleWarp hole{{.2, .9, .1}, .5};
    hole.repeat = {1.2, 0, .3};
    EXPECT_TRUE(fit_repeat(hole));
    EXPECT_EQ(hole.center, Vec3(.5, .9, .5));
    EXPECT_EQ(hole.repeat, Vec3(1.2, 0, 1));
    EXPECT_FALSE(fit_repeat(hole));
}

TEST(Normal, NoAmountTurnsNothing) {
    Bump flat;
    flat.amount = 0.0F;
    const Vec3 n0 = unit(Vec3(.2, .9, -.3));
    for (const auto& [text, pattern] : pattern_cases()) EXPECT_EQ(perturbed(pattern, flat, n0, {.3, .4, .5}), n0) << text;
}

TEST(Normal, ThereAndBackIsTheSameNormal) {
    Pattern pattern = make_pattern(PatternKind::bozo);
    append(pattern, Transform::scale({.4, 1.3, .8}));
    pattern.warps.emplace_back(RepeatWarp{});
    append(pattern, Transform::rotate({20, 30, 50}, Rotation::povray));
    const Vec3 n = unit(Vec3(.2, .9, -.3));
    for (const bool scale : {true, false}) {
        Bump bump;
        bump.scale = scale;
        const Vec3 back = out_of_pattern(pattern, bump, into_pattern(pattern, bump, n));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], n[i], 1e-15);
    }
}

TEST(Normal, SlopeMaps) {
    const std::vector<SlopeEntry> slopes{{0.2, 1.0, 0.0}, {0.6, 3.0, 0.0}};
    EXPECT_EQ(slope_height(slopes, 0.1), 1.0);
    EXPECT_EQ(slope_height(slopes, 0.7), 3.0);
    EXPECT_DOUBLE_EQ(slope_height(slopes, 0.4), 2.0);
    EXPECT_DOUBLE_EQ(slope_height(slopes, 0.3), 1.0 + 2.0 * (3.0 / 16.0 - 2.0 / 64.0));
    EXPECT_EQ(slope_height({}, 0.4), 0.4);
    const std::vector<SlopeEntry> tilted{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}};
    EXPECT_DOUBLE_EQ(slope_height(tilted, 0.3), 0.3);
}

TEST(Normal, ValuesComputedElsewhereTurnItAlike) {
    const Pattern granite = make_pattern(PatternKind::granite);
    const Bump bump;
    const Vec3 n0 = unit(Vec3(.2, .9, -.3)), q(.3, .4, .5);
    std::array<double, 4> values{};
    const auto points = difference_points(bump, q);
    for (std::size_t i = 0; i < 4; ++i) values[i] = pattern_value(granite, points[i]);
    EXPECT_EQ(perturbed_by(bump, n0, values), perturbed(granite, bump, n0, q));
}

}  // namespace
}  // namespace rt::pattern_test
