// Tables and noises against numbers that POV-Ray 3.7 gave, and their properties.
#include "patterns/noise.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "patterns/hash.h"
#include "patterns/pattern.h"

namespace rt::noise_test {
namespace {

const Vec3 p{.37, -.81, 1.23};
constexpr NoiseGenerator generators[] = {NoiseGenerator::original, NoiseGenerator::range_corrected, NoiseGenerator::perlin};

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

TEST(Hash, Permutation) {
    const int first[] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(permutation[i], first[i]);
    EXPECT_EQ(permutation[4095], 3088);
    EXPECT_EQ(hash3(1, 2, 3), 560);
    EXPECT_EQ(hash3(1 - 4096, 2 + 8192, 3), 560);
    EXPECT_EQ(std::set<int>(permutation.begin(), permutation.begin() + 4096).size(), 4096U);
    EXPECT_TRUE(std::equal(permutation.begin(), permutation.begin() + 4096, permutation.begin() + 4096));
}

TEST(Hash, CellNumbers) {
    const double first[] = {0.8147236919, 0.1354770041, 0.9057919341, 0.8350085898};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(cell_numbers()[i], first[i], 1e-10);
}

TEST(Noise, ThreeGenerators) {
    EXPECT_NEAR(noise(NoiseGenerator::original, p), 0.453513239849, 1e-12);
    EXPECT_NEAR(noise(NoiseGenerator::range_corrected, p), 0.492762252072, 1e-12);
    EXPECT_NEAR(noise(NoiseGenerator::perlin, p), 0.593539037638, 1e-12);
}

TEST(Noise, Vector) { expect_near(vector_noise(p), {-0.046486760151, 0.239985944101, -0.332096061449}, 1e-12); }

TEST(Noise, Turbulence) {
    expect_near(vector_turbulence(Turbulence{}, p), {0.076113337098, 0.221355116675, -0.436519825547}, 1e-12);
    EXPECT_NEAR(scalar_turbulence(NoiseGenerator::range_corrected, Turbulence{}, p), 1.120109491771, 1e-12);
    EXPECT_NEAR(scalar_turbulence(NoiseGenerator::original, Turbulence{}, p), 1.060488337098, 1e-12);
}

TEST(Noise, OneOctaveIsPlainNoise) {
    const Turbulence one{Vec3(1.0), 1};
    expect_near(vector_turbulence(one, p), vector_noise(p), 0.0);
    EXPECT_EQ(scalar_turbulence(NoiseGenerator::original, one, p), noise(NoiseGenerator::original, p));
}

TEST(Noise, HasNoStepsBetweenCells) {
    TableRandom draw{7};
    for (int i = 0; i < 300; ++i) {
        Vec3 q(draw() % 400 - 200, draw() % 4000 * 0.001, draw() % 4000 * -0.001);
        const Vec3 below = q - Vec3(1e-9, 0.0, 0.0), above = q + Vec3(1e-9, 0.0, 0.0);
        for (const NoiseGenerator g : generators) EXPECT_NEAR(noise(g, below), noise(g, above), 1e-7) << q.x;
        expect_near(vector_noise(below), vector_noise(above), 1e-7);
    }
}

TEST(Noise, StaysInItsRangeWhereverItIsAsked) {
    const double far[] = {0.0,
                          -0.0,
                          1e9,
                          -1e9,
                          4503599627370495.5,
                          -4503599627370495.5,
                          1e300,
                          -1e300,
                          std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    for (const double x : far)
        for (const NoiseGenerator g : generators) {
            const double n = noise(g, {x, 0.3, -x});
            EXPECT_TRUE(n >= 0.0 && n <= 1.0) << x;
        }
}

TEST(Noise, WhereNumbersHaveNoFractionEveryCellIsTheFirst) {
    for (const double far : {5e15, -1e300, std::numeric_limits<double>::infinity()}) {
        for (const NoiseGenerator g : generators) EXPECT_EQ(noise(g, {far, 0.3, 0.7}), noise(g, {0.0, 0.3, 0.7})) << far;
        EXPECT_EQ(vector_noise({0.3, far, 0.7}), vector_noise({0.3, 0.0, 0.7})) << far;
        EXPECT_EQ(cell_of(far), 0);
    }
    EXPECT_EQ(cell_of(-0.5), -1);
    EXPECT_EQ(cell_of(4503599627370495.5), 4503599627370495);
}

TEST(Noise, WaveSources) {
    const auto sources = wave_sources(3);
    expect_near(sources[0].center, {-0.604378213, 0.492048408, -0.626590248}, 1e-9);
    expect_near(sources[1].center, {-0.552573104, -0.246075339, -0.796310173}, 1e-9);
    expect_near(sources[2].center, {-0.444551085, 0.623328985, 0.643300326}, 1e-9);
    const double frequencies[] = {0.919115879, 0.960041200, 0.433169652};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(sources[i].frequency, frequencies[i], 1e-9);
}

}  // namespace
}  // namespace rt::noise_test
