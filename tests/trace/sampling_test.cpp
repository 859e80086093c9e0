// Sampling against direct transcriptions of the methods on pictures that are functions of the plane.
#include "trace/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace rt::sampling_test {
namespace {

/// Discs of several brightnesses, one beyond white and one nearly as the background, and a straight edge.
Pixel scenery(double x, double y) {
    const auto inside = [&](double cx, double cy, double r) { return std::hypot(x - cx, y - cy) < r; };
    if (inside(31.7, 12.1, 9.3)) return {3.0f, 0.2f, 0.1f, 0.0f};
    if (inside(12.3, 30.9, 11.1)) return {0.1f, 0.9f, 0.05f, 0.3f};
    if (inside(50.2, 33.4, 1.7)) return {0.22f, 0.31f, 0.5f, 0.0f};
    if (inside(44.9, 40.2, 0.6)) return {-1.0f, 5.0f, 0.0f, 1.0f};
    if (0.31 * x + y < 6.17) return {0.6f, 0.6f, 0.6f, 0.0f};
    return {0.2f, 0.3f, 0.5f, 0.0f};
}

constexpr int width = 61, height = 45;

/// A picture that is a function of the point alone.
Samples one_by_one(std::function<Pixel(double x, double y, int scale)> sample) {
    return [sample](std::span<const Vec2> points, int scale, std::span<Pixel> pixels) {
        for (std::size_t i = 0; i < points.size(); ++i) pixels[i] = sample(points[i].x, points[i].y, scale);
    };
}

SamplingTask task_of(Sampling::Method method, int depth, double threshold, double gamma = 2.5, int block = 32) {
    SamplingTask task;
    task.sampling = {method, depth, threshold, gamma, block};
    task.comparison.exponent = 1.0 / gamma;
    task.samples = one_by_one([](double x, double y, int scale) { return scenery(x / scale, y / scale); });
    return task;
}

/// The whole picture from tiles of `side`.
Film picture(const SamplingTask& task, int side) {
    Film film(width, height);
    std::vector<Pixel> pixels;
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            const Region tile{x, y, std::min(x + side, width), std::min(y + side, height)};
            EXPECT_EQ(sample_tile(task, tile, pixels), tile.height());
            for (int j = tile.y0; j < tile.y1; ++j) {
                for (int i = tile.x0; i < tile.x1; ++i) film.at(i, j) = pixels[(j - tile.y0) * tile.width() + (i - tile.x0)];
            }
        }
    }
    return film;
}

// The rules once more, in long double and in coordinates whose integers are pixel centres.

struct Color {
    long double c[4] = {};
    Color() = default;
    explicit Color(const Pixel& p) : c{p.r, p.g, p.b, p.transmittance} {}
    Color operator+(const Color& o) const {
        Color s;
        for (int i = 0; i < 4; ++i) s.c[i] = c[i] + o.c[i];
        return s;
    }
    Color operator/(long double d) const {
        Color s;
        for (int i = 0; i < 4; ++i) s.c[i] = c[i] / d;
        return s;
    }
};

Color at(double x, double y) { return Color(scenery(x + 0.5, y + 0.5)); }

long double difference(const Color& a, const Color& b, double gamma) {
    long double sum = std::fabs(a.c[3] - b.c[3]);
    for (int i = 0; i < 3; ++i)
        sum += std::fabs(std::pow(std::fmax(a.c[i], 0.0L), 1.0L / gamma) - std::pow(std::fmax(b.c[i], 0.0L), 1.0L / gamma));
    return sum;
}

/// Method 1, block by block; the picture is keyed by position so that neighbours outside it have a place, too.
std::map<std::pair<int, int>, Color> method1(int depth, double threshold, double gamma, int block) {
    std::map<std::pair<int, int>, Color> result;
    for (int top = 0; top < height; top += block) {
        for (int left = 0; left < width; left += block) {
            std::map<std::pair<int, int>, Color> now;
            std::map<std::pair<int, int>, bool> done;
            const auto again = [&](int x, int y) {
                if (x < left || y < top || done[{x, y}]) return;
                done[{x, y}] = true;
                Color sum = now[{x, y}];
                for (int i = 0; i < depth * depth; ++i)
                    sum = sum + at(x + (i % depth + 0.5) / depth - 0.5, y + (i / depth + 0.5) / depth - 0.5);
                now[{x, y}] = sum / (depth * depth + 1);
            };
            for (int y = top; y < std::min(top + block, height); ++y) {
                for (int x = left; x < std::min(left + block, width); ++x) {
                    const Color centre = now[{x, y}] = at(x, y);
                    for (const auto& [nx, ny] : {std::pair{x - 1, y}, std::pair{x, y - 1}}) {
                        if (!now.count({nx, ny})) now[{nx, ny}] = at(nx, ny);
                        if (difference(centre, now[{nx, ny}], gamma) < threshold) continue;
                        again(nx, ny);
                        again(x, y);
                    }
                }
            }
            for (const auto& [place, color] : now)
                if (place.first >= left && place.second >= top) result[place] = color;
        }
    }
    return result;
}

Color method2(double x, double y, double d, int level, double threshold, double gamma) {
    const Color corners[4] = {at(x - d, y - d), at(x + d, y - d), at(x - d, y + d), at(x + d, y + d)};
    bool differ = false;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) differ = differ || difference(corners[i], corners[j], gamma) >= threshold;
    Color sum;
    for (int i = 0; i < 4; ++i) {
        const double sx = i % 2 ? d / 2 : -d / 2, sy = i / 2 ? d / 2 : -d / 2;
        sum = sum + (level > 0 && differ ? method2(x + sx, y + sy, d / 2, level - 1, threshold, gamma) : corners[i]);
    }
    return sum / 4;
}

void expect_color(const Pixel& p, const Color& c, int x, int y) {
    const float values[4] = {p.r, p.g, p.b, p.transmittance};
    for (int i = 0; i < 4; ++i) ASSERT_NEAR(values[i], static_cast<double>(c.c[i]), 1e-6) << "channel " << i << " of " << x << ", " << y;
}

struct Setting {
    int depth;
    double threshold, gamma;
    int block;
};

class Povray : public testing::TestWithParam<Setting> {};

TEST_P(Povray, FirstMethodIsItsDefinition) {
    const auto [depth, threshold, gamma, block] = GetParam();
    const Film film = picture(task_of(Sampling::Method::povray1, depth, threshold, gamma, block), block);
    auto expected = method1(depth, threshold, gamma, block);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) expect_color(film.at(x, y), expected[{x, y}], x, y);
}

TEST_P(Povray, SecondMethodIsItsDefinition) {
    const auto [depth, threshold, gamma, block] = GetParam();
    const Film film = picture(task_of(Sampling::Method::povray2, depth, threshold, gamma), block);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) expect_color(film.at(x, y), method2(x, y, 0.5, depth - 1, threshold, gamma), x, y);
}

INSTANTIATE_TEST_SUITE_P(Settings, Povray,
                         testing::Values(Setting{3, 0.3, 2.5, 32}, Setting{2, 0.1, 2.5, 32}, Setting{1, 0.0, 2.5, 32},
                                         Setting{3, 0.0, 2.5, 32}, Setting{4, 0.2, 2.5, 8}, Setting{5, 0.05, 1.0, 13},
                                         Setting{3, 1.0, 2.5, 4}, Setting{2, 0.3, 2.5, 64}));

TEST(Sampling, CentresAreTheFunction) {
    const Film film = picture(task_of(Sampling::Method::none, 1, 0.3), 32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) ASSERT_EQ(film.at(x, y), scenery(x + 0.5, y + 0.5));
}

TEST(Sampling, GridIsTheMeanOfALargerPicture) {
    SamplingTask task = task_of(Sampling::Method::grid, 3, 0.3);
    task.samples = one_by_one([](double x, double y, int scale) {
        EXPECT_EQ(scale, 3);
        return Pixel{static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y), 0.0f};
    });
    std::vector<Pixel> pixels;
    sample_tile(task, {4, 7, 6, 8}, pixels);
    // Sub-pixels 12..14 and 15..17 across, 21..23 down.
    EXPECT_EQ(pixels[0].r, 13.5f);
    EXPECT_EQ(pixels[1].r, 16.5f);
    EXPECT_EQ(pixels[0].g, 22.5f);
    EXPECT_EQ(pixels[1].b, 16.5f * 22.5f);
}

TEST(Sampling, GridCountsCoverage) {
    SamplingTask task = task_of(Sampling::Method::grid, 4, 0.3);
    task.samples = one_by_one([](double x, double, int scale) { return Pixel{x / scale < 10.3 ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f}; });
    std::vector<Pixel> pixels;
    sample_tile(task, {9, 0, 12, 1}, pixels);
    EXPECT_EQ(pixels[0].r, 1.0f);
    EXPECT_EQ(pixels[1].r, 0.25f);
    EXPECT_EQ(pixels[2].r, 0.0f);
}

TEST(Sampling, TilesDoNotMatter) {
    for (const Sampling::Method method : {Sampling::Method::grid, Sampling::Method::povray2}) {
        const SamplingTask task = task_of(method, 3, 0.1);
        const Film whole = picture(task, 64);
        for (const int side : {1, 7, 32}) EXPECT_EQ(picture(task, side).pixels, whole.pixels) << side;
    }
}

TEST(Sampling, SharedPointsAreTracedOnce) {
    for (const int depth : {1, 3, 5}) {
        SamplingTask task = task_of(Sampling::Method::povray2, depth, 0.0);
        std::map<std::pair<double, double>, int> asked;
        task.samples = one_by_one([&](double x, double y, int) {
            ++asked[{x, y}];
            return scenery(x, y);
        });
        std::vector<Pixel> pixels;
        sample_tile(task, {10, 10, 14, 13}, pixels);
        const std::size_t steps = std::size_t{1} << (depth - 1);
        EXPECT_EQ(asked.size(), (4 * steps + 1) * (3 * steps + 1));
        for (const auto& [place, times] : asked) EXPECT_EQ(times, 1) << place.first << ", " << place.second;
    }
}

TEST(Sampling, FlatPicturesAreNotSampledAgain) {
    SamplingTask task = task_of(Sampling::Method::povray1, 9, 0.3);
    int asked = 0;
    task.samples = one_by_one([&](double, double, int) { return ++asked, Pixel{0.5f, 0.5f, 0.5f, 0.0f}; });
    std::vector<Pixel> pixels;
    sample_tile(task, {0, 0, 32, 32}, pixels);
    EXPECT_EQ(asked, 32 * 32 + 32 + 32);
}

TEST(Sampling, TransmittanceCountsAsContrast) {
    const Contrast a(Pixel{0.5f, 0.5f, 0.5f, 0.0f}, {}), b(Pixel{0.5f, 0.5f, 0.5f, 0.35f}, {});
    EXPECT_NEAR(distance(a, b), 0.35, 1e-7);
    const Comparison root{0.5, false};
    EXPECT_NEAR(distance(Contrast(Pixel{0.25f, -3.0f, 0.0f, 0.0f}, root), Contrast(Pixel{1.0f, 0.0f, 0.0f, 0.0f}, root)), 0.5, 1e-12);
    const Comparison srgb{0.4, true};
    EXPECT_NEAR(srgb(0.5), std::pow((0.5 + 0.055) / 1.055, 2.4 * 0.4), 1e-12);
    EXPECT_EQ(srgb(-0.5), 0.0);
}

class Stopping : public testing::TestWithParam<Sampling::Method> {};

TEST_P(Stopping, KeepsOnlyRowsThatAreFinal) {
    std::atomic<bool> stop{false};
    SamplingTask task = task_of(GetParam(), 2, 0.3);
    const Film whole = picture(task, 32);
    task.stop = &stop;
    int asked = 0;
    task.samples = one_by_one([&](double x, double y, int scale) {
        if (++asked == 700) stop = true;
        return scenery(x / scale, y / scale);
    });
    std::vector<Pixel> pixels;
    const int rows = sample_tile(task, {0, 0, 32, 32}, pixels);
    EXPECT_GT(rows, 1);
    EXPECT_LT(rows, 32);
    EXPECT_LT(asked, 740);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 32; ++x) ASSERT_EQ(pixels[y * 32 + x], whole.at(x, y)) << x << ", " << y;
}

INSTANTIATE_TEST_SUITE_P(Methods, Stopping,
                         testing::Values(Sampling::Method::none, Sampling::Method::grid, Sampling::Method::povray1,
                                         Sampling::Method::povray2));

}  // namespace
}  // namespace rt::sampling_test
