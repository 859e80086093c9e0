// Pictures made larger.
#include "film/enlarge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rt {
namespace {

template <class Value>
Film film_of(int width, int height, Value value) {
    Film film(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto v = static_cast<float>(value(x, y));
            film.at(x, y) = {v, 2.0f * v, 3.0f * v, v / 64.0f};
        }
    }
    return film;
}

Film enlarged(const Film& film, int width, int height, Filtered filtered = Filtered::values) {
    return enlarge(film, Stretch(film.width, width, 0, width), Stretch(film.height, height, 0, height), filtered);
}

/// Pixels of a picture three times as wide are apart by a third, and every middle one lies on a known one.
TEST(Enlarge, APlaneStaysAPlaneInside) {
    const Film large = enlarged(film_of(10, 8, [](int x, int y) { return 3 * x + 6 * y + 1; }), 30, 24);
    for (int y = 6; y < 18; ++y) {
        for (int x = 6; x < 24; ++x) {
            const float plane = static_cast<float>(x - 1) + 2.0f * static_cast<float>(y - 1) + 1.0f;
            EXPECT_NEAR(large.at(x, y).r, plane, 1e-5 * plane) << x << ", " << y;
            EXPECT_NEAR(large.at(x, y).g, 2.0f * plane, 2e-5 * plane) << x << ", " << y;
            EXPECT_NEAR(large.at(x, y).b, 3.0f * plane, 3e-5 * plane) << x << ", " << y;
            EXPECT_NEAR(large.at(x, y).transmittance, std::min(plane / 64.0f, 1.0f), 1e-6 * plane) << x << ", " << y;
        }
    }
}

/// The cubic goes beyond the largest number there.
TEST(Enlarge, TheLargestNumbersStayNumbers) {
    constexpr float largest = std::numeric_limits<float>::max();
    for (const Filtered filtered : {Filtered::values, Filtered::square_roots}) {
        Film film(4, 4);
        for (int i = 0; i < 16; ++i) film.pixels[static_cast<std::size_t>(i)].r = i % 4 < 2 ? 0.0f : largest;
        for (const Pixel& p : enlarged(film, 12, 12, filtered).pixels) EXPECT_TRUE(std::isfinite(p.r) && p.r >= 0.0f);
    }
}

/// Catmull and Rom's matrix: between b and c of a, b, c, d at t it is b + t (c - a)/2 + t^2 (2a - 5b + 4c - d)/2 + t^3 (-a + 3b - 3c +
/// d)/2.
TEST(Enlarge, LiesOnTheSplineOfCatmullAndRom) {
    const float a = 5, b = 2, c = 11, d = 3;
    const std::vector<float> known{a, b, c, d};
    const Film large = enlarged(film_of(4, 1, [&](int x, int) { return known[static_cast<std::size_t>(x)]; }), 12, 1);
    for (const int thirds : {0, 1, 2, 3}) {
        const double t = thirds / 3.0;
        const double expected = b + t * (c - a) / 2 + t * t * (2 * a - 5 * b + 4 * c - d) / 2 + t * t * t * (-a + 3 * b - 3 * c + d) / 2;
        EXPECT_NEAR(large.at(4 + thirds, 0).r, expected, 1e-5) << thirds;
    }
}

TEST(Enlarge, RepeatsTheLastOneBeyondAnEnd) {
    const Film large = enlarged(film_of(2, 1, [](int x, int) { return x == 0 ? 1.0 : 5.0; }), 6, 1);
    // Two thirds from b to c of 1, 1, 1, 5, by the matrix above.
    const double t = 2.0 / 3.0;
    EXPECT_NEAR(large.at(0, 0).r, 1.0 + t * t * (2 - 5 + 4 - 5) / 2.0 + t * t * t * (-1 + 3 - 3 + 5) / 2.0, 1e-5);
    EXPECT_NEAR(large.at(1, 0).r, 1.0, 1e-6);
    EXPECT_NEAR(large.at(4, 0).r, 5.0, 1e-6);
    for (const Pixel& p : enlarged(film_of(1, 1, [](int, int) { return 7; }), 5, 3).pixels) EXPECT_NEAR(p.r, 7.0, 1e-5);
}

TEST(Enlarge, KeepsItsEndsWhereTheSidesAreNoMultiples) {
    const Film large = enlarged(film_of(4, 1, [](int x, int) { return x + 1; }), 10, 1);
    // Pixel x has its centre at (x + 1/2) 4/10 - 1/2.
    EXPECT_NEAR(large.at(4, 0).r, 4.5 * 0.4 + 0.5, 1e-6);
    EXPECT_NEAR(large.at(5, 0).r, 5.5 * 0.4 + 0.5, 1e-6);
    for (int x = 0; x < 10; ++x) EXPECT_NEAR(large.at(x, 0).r + large.at(9 - x, 0).r, 5.0, 1e-5) << x;
}

TEST(Enlarge, APartIsMadeOfWhatCountsAndNothingElse) {
    const Film small = film_of(9, 7, [](int x, int y) { return (x * 7 + y * 5) % 11; });
    const Film whole = enlarged(small, 26, 20);
    for (const auto& [x0, x1, y0, y1] :
         {std::array{0, 26, 0, 20}, std::array{3, 4, 5, 6}, std::array{11, 20, 7, 19}, std::array{25, 26, 0, 1}}) {
        const Stretch across(9, 26, x0, x1), down(7, 20, y0, y1);
        ASSERT_EQ(across.count(), x1 - x0);
        Film part(across.last() - across.first(), down.last() - down.first());
        EXPECT_LE(part.width, (x1 - x0) * 9 / 26 + 5);
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) part.at(x, y) = small.at(across.first() + x, down.first() + y);
        const Film large = enlarge(part, across, down, Filtered::values);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) EXPECT_EQ(large.at(x - x0, y - y0), whole.at(x, y)) << x << ", " << y;
    }
}

TEST(Enlarge, NothingIsDarkerThanBlackNorMoreThanTransparent) {
    const Film step = film_of(6, 1, [](int x, int) { return x < 3 ? 0.0 : 64.0; });
    bool overshoots = false;
    for (const Pixel& p : enlarged(step, 24, 1).pixels) {
        EXPECT_GE(std::min({p.r, p.g, p.b, p.transmittance}), 0.0f);
        EXPECT_LE(p.transmittance, 1.0f);
        overshoots |= p.r > 64.5f;
    }
    EXPECT_TRUE(overshoots);
}

TEST(Enlarge, RootsAreThoseOfColoursAlone) {
    const Film squares = film_of(5, 5, [](int x, int y) { return (x + y) * (x + y); });
    const Film large = enlarged(squares, 15, 15, Filtered::square_roots);
    const Film plain = enlarged(squares, 15, 15);
    const double root = (7 - 1 + 8 - 1) / 3.0;
    EXPECT_NEAR(large.at(7, 8).r, root * root, 1e-5);
    EXPECT_NEAR(large.at(7, 8).b, 3.0 * root * root, 1e-4);
    EXPECT_EQ(large.at(7, 8).transmittance, plain.at(7, 8).transmittance);
    EXPECT_EQ(enlarged(film_of(2, 2, [](int, int) { return -1; }), 4, 4, Filtered::square_roots).at(1, 1).r, 0.0f);
}

}  // namespace
}  // namespace rt
