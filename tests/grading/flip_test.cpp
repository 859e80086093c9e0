#include "grading/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "grading/difference.h"

namespace rt::flip_test {
namespace {

using Real = long double;
using Colour = std::array<Real, 3>;

// The paper's steps, written down once more: two-dimensional kernels, long double, no tables.
namespace paper {

constexpr Real pi = 3.14159265358979323846264338L;
constexpr Real pixels_per_degree = 3840.0L * pi / 180.0L;

Colour white_xyz(const Colour& c) {
    // sRGB: primaries (0.64, 0.33) (0.30, 0.60) (0.15, 0.06), white (0.3127, 0.3290); the columns' scales solve M (1, 1, 1) = white.
    const Real m[3][3] = {{0.64L / 0.33L, 0.30L / 0.60L, 0.15L / 0.06L}, {1, 1, 1}, {0.03L / 0.33L, 0.10L / 0.60L, 0.79L / 0.06L}};
    const Colour white = {0.3127L / 0.3290L, 1.0L, 0.3583L / 0.3290L};
    const auto det = [](const Real a[3][3]) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    Colour xyz = {0, 0, 0};
    for (int j = 0; j < 3; ++j) {
        Real with_white[3][3];
        for (int r = 0; r < 3; ++r) {
            for (int k = 0; k < 3; ++k) with_white[r][k] = k == j ? white[static_cast<std::size_t>(r)] : m[r][k];
        }
        const Real scale = det(with_white) / det(m);
        for (std::size_t r = 0; r < 3; ++r) xyz[r] += m[r][j] * scale * c[static_cast<std::size_t>(j)] / white[r];
    }
    return xyz;
}

Colour opponent(const Colour& c) {
    const Colour v = white_xyz(c);
    return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
}

/// The inverse of `opponent`, from its values at the three primaries (it is affine).
Colour shown(const Colour& o) {
    const Colour base = opponent({0, 0, 0});
    Real m[3][4];
    for (std::size_t j = 0; j < 3; ++j) {
        Colour unit = {0, 0, 0};
        unit[j] = 1;
        const Colour column = opponent(unit);
        for (std::size_t r = 0; r < 3; ++r) m[r][j] = column[r] - base[r];
    }
    for (std::size_t r = 0; r < 3; ++r) m[r][3] = o[r] - base[r];
    for (int p = 0; p < 3; ++p) {  // Gauss-Jordan; the pivots are not small
        for (int r = 0; r < 3; ++r) {
            const Real factor = r == p ? 0 : m[r][p] / m[p][p];
            for (int k = 0; k < 4; ++k) m[r][k] -= factor * m[p][k];
        }
    }
    Colour c;
    for (std::size_t r = 0; r < 3; ++r) c[r] = std::fmin(std::fmax(m[r][3] / m[r][r], 0.0L), 1.0L);
    return c;
}

Colour hunt_lab(const Colour& c) {
    const Colour v = white_xyz(c);
    const auto f = [](Real t) { return t > 216.0L / 24389.0L ? std::cbrt(t) : (24389.0L / 27.0L * t + 16) / 116; };
    const Real l = 116 * f(v[1]) - 16;
    return {l, l / 100 * 500 * (f(v[0]) - f(v[1])), l / 100 * 200 * (f(v[1]) - f(v[2]))};
}

Real hyab(const Colour& a, const Colour& b) { return std::pow(std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7L); }

Real redistribute(Real difference) {
    const Real most = hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    if (difference < 0.4L * most) return 0.95L * difference / (0.4L * most);
    return 0.95L + 0.05L * (difference - 0.4L * most) / (0.6L * most);
}

template <typename Weight>
Real filtered(const std::vector<Real>& plane, int width, int height, int x, int y, int radius, Weight weight) {
    Real sum = 0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
            const int row = std::clamp(y + j, 0, height - 1), column = std::clamp(x + i, 0, width - 1);
            sum += weight(i, j) * plane[static_cast<std::size_t>(row * width + column)];
        }
    }
    return sum;
}

/// The kernel table of a weight, with the weights of each sign scaled to a sum of one (`signs`) or all together.
template <typename Weight>
std::vector<Real> kernel(int radius, bool signs, Weight weight) {
    std::vector<Real> table;
    Real positive = 0, negative = 0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
            table.push_back(weight(Real(i), Real(j)));
            (table.back() > 0 ? positive : negative) += std::fabs(table.back());
        }
    }
    for (Real& value : table) value /= !signs || value > 0 ? positive : negative;
    return table;
}

struct Maps {
    std::vector<Colour> lab;
    std::vector<Real> edge, point;
};

Maps maps(const std::vector<Colour>& picture, int width, int height) {
    std::array<std::vector<Real>, 3> planes;
    std::vector<Real> luminance;
    for (const Colour& c : picture) {
        const Colour o = opponent(c);
        for (std::size_t i = 0; i < 3; ++i) planes[i].push_back(o[i]);
        luminance.push_back((o[0] + 16) / 116);
    }
    const int reach = static_cast<int>(std::ceil(3 * std::sqrt(0.04L / (2 * pi * pi)) * pixels_per_degree));
    const auto gaussian = [](Real a, Real b, Real i, Real j) {
        return a * std::sqrt(pi / b) * std::exp(-pi * pi * (i * i + j * j) / (pixels_per_degree * pixels_per_degree) / b);
    };
    const std::vector<Real> sensitivity[] = {
        kernel(reach, false, [&](Real i, Real j) { return gaussian(1, 0.0047L, i, j); }),
        kernel(reach, false, [&](Real i, Real j) { return gaussian(1, 0.0053L, i, j); }),
        kernel(reach, false, [&](Real i, Real j) { return gaussian(34.1L, 0.04L, i, j) + gaussian(13.5L, 0.025L, i, j); })};
    const Real s = 0.5L * 0.082L * pixels_per_degree;
    const int extent = static_cast<int>(std::ceil(3 * s));
    const auto g = [&](Real i, Real j) { return std::exp(-(i * i + j * j) / (2 * s * s)); };
    const std::vector<Real> edge = kernel(extent, true, [&](Real i, Real j) { return -i * g(i, j); });
    const std::vector<Real> point = kernel(extent, true, [&](Real i, Real j) { return (i * i / (s * s) - 1) * g(i, j); });

    Maps result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto apply = [&](const std::vector<Real>& plane, const std::vector<Real>& table, int radius, bool transposed) {
                return filtered(plane, width, height, x, y, radius, [&](int i, int j) {
                    const int side = 2 * radius + 1, column = (transposed ? j : i) + radius, row = (transposed ? i : j) + radius;
                    return table[static_cast<std::size_t>(row * side + column)];
                });
            };
            Colour o;
            for (std::size_t i = 0; i < 3; ++i) o[i] = apply(planes[i], sensitivity[i], reach, false);
            result.lab.push_back(hunt_lab(shown(o)));
            result.edge.push_back(std::hypot(apply(luminance, edge, extent, false), apply(luminance, edge, extent, true)));
            result.point.push_back(std::hypot(apply(luminance, point, extent, false), apply(luminance, point, extent, true)));
        }
    }
    return result;
}

}  // namespace paper

LinearPlanes planes_of(const std::vector<Colour>& picture, int width, int height) {
    LinearPlanes planes = {Plane(width, height), Plane(width, height), Plane(width, height)};
    for (std::size_t p = 0; p < picture.size(); ++p) {
        for (std::size_t i = 0; i < 3; ++i) planes[i].values[p] = static_cast<float>(picture[p][i]);
    }
    return planes;
}

std::vector<Colour> blocks(int width, int height, unsigned seed, int size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    std::vector<Colour> tiles(1000), picture;
    for (Colour& tile : tiles) tile = {value(random), value(random), value(random)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) picture.push_back(tiles[static_cast<std::size_t>(x / size + 31 * (y / size))]);
    }
    return picture;
}

TEST(Flip, FollowsThePaperOnEveryPixel) {
    const int width = 37, height = 23;  // no multiple of a block, smaller than twice the kernels
    for (int size : {1, 4, 11}) {
        const std::vector<Colour> a = blocks(width, height, 1, size), b = blocks(width, height, 2, size);
        const Plane error = flip(planes_of(a, width, height), planes_of(b, width, height));
        const paper::Maps of_a = paper::maps(a, width, height), of_b = paper::maps(b, width, height);
        for (std::size_t p = 0; p < a.size(); ++p) {
            const Real colour = paper::redistribute(paper::hyab(of_a.lab[p], of_b.lab[p]));
            const Real feature = std::fmax(std::fabs(of_a.edge[p] - of_b.edge[p]), std::fabs(of_a.point[p] - of_b.point[p]));
            const Real expected = std::pow(colour, 1 - std::sqrt(feature / std::sqrt(2.0L)));
            ASSERT_NEAR(error.values[p], static_cast<double>(expected), 2e-4) << "pixel " << p << ", blocks of " << size;
        }
    }
}

TEST(Flip, FlatPicturesByTheFormula) {
    const auto flat = [](Real r, Real g, Real b) { return planes_of(std::vector<Colour>(30 * 30, Colour{r, g, b}), 30, 30); };
    // Green against blue is the largest difference there is; black against white is 100 in lightness and 0 in chroma.
    EXPECT_NEAR(flip(flat(0, 1, 0), flat(0, 0, 1)).values[450], 1.0, 1e-5);
    EXPECT_NEAR(flip(flat(0, 0, 0), flat(1, 1, 1)).values[450], static_cast<double>(paper::redistribute(std::pow(100.0L, 0.7L))), 3e-5);
    EXPECT_EQ(flip(flat(0.3L, 0.2L, 0.1L), flat(0.3L, 0.2L, 0.1L)).values[450], 0.0f);
}

TEST(Flip, OnlyPixelsNearADifferenceAreTouched) {
    std::vector<Colour> a = blocks(40, 90, 3, 5), b = a;
    b[45 * 40 + 20] = {1, 1, 1};
    const Plane error = flip(planes_of(a, 40, 90), planes_of(b, 40, 90));
    EXPECT_EQ(error.row(34)[20], 0.0f);
    EXPECT_EQ(error.row(56)[20], 0.0f);
    EXPECT_EQ(error.row(45)[9], 0.0f);
    EXPECT_GT(error.row(35)[20], 0.0f);
    EXPECT_GT(error.row(45)[20], 0.01f);
}

TEST(Flip, PercentilesWeightEachPixelWithItsError) {
    Plane error(5, 1);
    error.values = {0.4f, 0.1f, 0.3f, 0.0f, 0.2f};  // running sums 0, 0.1, 0.3, 0.6, 1.0
    const FlipSummary summary = summarise(error);
    EXPECT_FLOAT_EQ(static_cast<float>(summary.mean), 0.2f);
    EXPECT_FLOAT_EQ(static_cast<float>(summary.q1), 0.2f);
    EXPECT_FLOAT_EQ(static_cast<float>(summary.median), 0.3f);
    EXPECT_FLOAT_EQ(static_cast<float>(summary.q3), 0.4f);
    EXPECT_EQ(summary.min, 0.0);
    EXPECT_FLOAT_EQ(static_cast<float>(summary.max), 0.4f);
    EXPECT_EQ(summarise(Plane(4, 4)).q3, 0.0);
}

TEST(Flip, AgreesWithItsAuthorsProgramOnCoursePictures) {
    const std::string shared = PROJECT_ROOT "/../shared/";
    std::ifstream table(shared + "golden/image_difference.csv");
    if (!table) GTEST_SKIP() << "no golden values beside the project";
    int pairs = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.starts_with("#") || line.starts_with("reference")) continue;
        std::stringstream cells(line);
        std::string reference, test, cell;
        std::getline(cells, reference, ',');
        std::getline(cells, test, ',');
        std::vector<double> wanted;
        while (std::getline(cells, cell, ',')) wanted.push_back(std::stod(cell));
        const auto picture = [&](const std::string& name) { return read_image(shared + "csc473/tests/" + name + ".png"); };
        const Difference result = compare(picture(reference), picture(test), {});
        EXPECT_NEAR(result.flip_mean, wanted[0], 5e-6) << line;
        const double others[] = {result.flip_median, result.flip_q1, result.flip_q3, result.flip_min, result.flip_max};
        for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(others[i], wanted[i + 1], 3e-5) << line;
        EXPECT_EQ(result.differing_0, static_cast<std::uint64_t>(wanted[6])) << line;
        EXPECT_EQ(result.differing_1, static_cast<std::uint64_t>(wanted[7])) << line;
        EXPECT_EQ(result.differing, static_cast<std::uint64_t>(wanted[8])) << line;
        ++pairs;
    }
    EXPECT_GT(pairs, 0);
}

}  // namespace
}  // namespace rt::flip_test
