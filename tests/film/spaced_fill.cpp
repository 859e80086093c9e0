// Pixels made up between known ones.
#include "film/spaced_fill.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace rt {
namespace {

/// A film with a value of (x, y) at every `spacing`-th pixel of every such row, and nothing elsewhere.
struct Sparse {
    template <class Value>
    Sparse(int width, int height, int spacing, Value value) : film(width, height), known(film.pixels.size()) {
        for (int y = 0; y < height; y += spacing)
            for (int x = 0; x < width; x += spacing) set(x, y, value(x, y));
    }
    void set(int x, int y, float v) {
        film.at(x, y) = {v, 2.0f * v, 3.0f * v, 0.0f};
        known[static_cast<std::size_t>(y) * film.width + x] = 1;
    }
    Film film;
    std::vector<std::uint8_t> known;
};

TEST(SpacedFill, ACubicInEachDirectionIsMadeUpExactlyInside) {
    const auto cubic = [](int x, int y) { return static_cast<float>(20'000 + x * x * x - 40 * x * x + 3 * x * y + y * y * y); };
    Sparse sparse(25, 33, 2, cubic);
    fill_between(sparse.film, 2, sparse.known);
    for (int y = 3; y <= 29; ++y) {
        for (int x = 3; x <= 21; ++x) {
            EXPECT_EQ(sparse.film.at(x, y).r, cubic(x, y)) << x << ", " << y;
            EXPECT_EQ(sparse.film.at(x, y).b, 3.0f * cubic(x, y)) << x << ", " << y;
        }
    }
}

TEST(SpacedFill, HalvesUntilAllIsFilledAndALineStaysALine) {
    const auto line = [](int x, int y) { return static_cast<float>(100 + x - y); };
    Sparse sparse(200, 100, 16, line);
    fill_between(sparse.film, 16, sparse.known);
    for (int y = 48; y <= 52; ++y)
        for (int x = 48; x < 150; ++x) EXPECT_EQ(sparse.film.at(x, y).r, line(x, y)) << x << ", " << y;
}

TEST(SpacedFill, KnownPixelsStay) {
    Sparse sparse(9, 9, 4, [](int, int) { return 1.0f; });
    sparse.set(2, 0, 7.0f);
    fill_between(sparse.film, 4, sparse.known);
    EXPECT_EQ(sparse.film.at(2, 0).r, 7.0f);
    EXPECT_EQ(sparse.film.at(6, 0).r, 1.0f);
    EXPECT_EQ(sparse.film.at(1, 0).r, (-1.0f + 9.0f + 63.0f - 1.0f) / 16.0f);
}

TEST(SpacedFill, RepeatsTheLastOneBeyondAnEdge) {
    Sparse sparse(7, 1, 4, [](int x, int) { return static_cast<float>(x); });
    fill_between(sparse.film, 4, sparse.known);
    EXPECT_EQ(sparse.film.at(6, 0).r, (0.0f * -1.0f + 9.0f * 4.0f + 9.0f * 4.0f - 4.0f) / 16.0f);
    Sparse one(3, 2, 16, [](int, int) { return 5.0f; });
    fill_between(one.film, 16, one.known);
    for (const Pixel& p : one.film.pixels) EXPECT_EQ(p, (Pixel{5.0f, 10.0f, 15.0f, 0.0f}));
}

TEST(SpacedFill, NothingIsDarkerThanBlackNorNotFinite) {
    Sparse sparse(13, 1, 4, [](int x, int) { return x == 4 ? 16.0f : 0.0f; });
    sparse.film.at(8, 0).r = std::numeric_limits<float>::quiet_NaN();
    fill_between(sparse.film, 4, sparse.known);
    EXPECT_EQ(sparse.film.at(10, 0).r, 0.0f);
    EXPECT_EQ(sparse.film.at(6, 0).r, 9.0f);
    for (int x = 0; x < 13; ++x) EXPECT_TRUE(x == 8 || sparse.film.at(x, 0).r >= 0.0f) << x;
}

}  // namespace
}  // namespace rt
