// Each mistake of whole pictures, made on a picture of our own, has its name; what is none of them has none.
#include "grading/picture_causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace rt::picture_causes_test {
namespace {

float rounded(float v) { return std::round(255.0f * std::clamp(v, 0.0f, 1.0f)) / 255.0f; }

template <typename Make>
ColorPicture made(int width, int height, const Make& make) {
    ColorPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color c = make(x, y);
            picture.pixels.push_back({rounded(c[0]), rounded(c[1]), rounded(c[2])});
        }
    return picture;
}

/// A shaded disc and a bright bar on a dark floor, with jagged edges; (x, y) in pixels.
Color jagged(float x, float y) {
    const float dx = (x - 40.0f) / 25.0f, dy = (y - 30.0f) / 22.0f, r = dx * dx + dy * dy;
    if (r < 1.0f) return {0.9f - 0.7f * r, 0.3f + 0.2f * dx * dx, 0.15f + 0.1f * r};
    if (x > 70.0f && x < 85.0f && y > 10.0f + 0.4f * x) return {0.2f, 0.6f, 0.75f};
    return y > 45.0f ? Color{0.25f, 0.22f, 0.3f} : Color{0.0f, 0.0f, 0.0f};
}
constexpr int width = 100, height = 80;

ColorPicture scene(float dx = 0.0f, float dy = 0.0f) {
    return made(width, height, [&](int x, int y) { return jagged(static_cast<float>(x) - dx, static_cast<float>(y) - dy); });
}

/// The same, each pixel the mean of 4 x 4 points.
ColorPicture smooth() {
    return made(width, height, [](int x, int y) {
        Color sum{};
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const Color c = jagged(static_cast<float>(x) + 0.25f * static_cast<float>(i) - 0.375f,
                                       static_cast<float>(y) + 0.25f * static_cast<float>(j) - 0.375f);
                for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k] / 16.0f;
            }
        return sum;
    });
}

template <typename Change>
ColorPicture changed(const Change& change) {
    const ColorPicture from = scene();
    return made(width, height, [&](int x, int y) { return change(from, x, y); });
}
ColorPicture curved(const std::function<float(float)>& curve) {
    return changed([&](const ColorPicture& p, int x, int y) {
        return Color{curve(p.at(x, y)[0]), curve(p.at(x, y)[1]), curve(p.at(x, y)[2])};
    });
}

std::string cause(const ColorPicture& expected, const ColorPicture& actual) { return choose(picture_findings(expected, actual)).cause; }

struct Case {
    const char* cause;
    std::function<ColorPicture()> actual;
};

class PictureCause : public testing::TestWithParam<Case> {};

TEST_P(PictureCause, IsNamed) {
    const Verdicts verdicts = choose(picture_findings(scene(), GetParam().actual()));
    EXPECT_EQ(verdicts.cause, GetParam().cause) << testing::PrintToString(verdicts.lines);
    EXPECT_FALSE(verdicts.lines.empty());
}

INSTANTIATE_TEST_SUITE_P(
    , PictureCause,
    testing::Values(
        Case{"black", [] { return curved([](float) { return 0.0f; }); }},  //
        Case{"one colour", [] { return curved([](float) { return 0.4f; }); }},
        Case{"mirrored", [] { return changed([](const ColorPicture& p, int x, int y) { return p.at(width - 1 - x, y); }); }},
        Case{"upside down", [] { return changed([](const ColorPicture& p, int x, int y) { return p.at(x, height - 1 - y); }); }},
        Case{"turned by 180 degrees",
             [] { return changed([](const ColorPicture& p, int x, int y) { return p.at(width - 1 - x, height - 1 - y); }); }},
        Case{"channels swapped",
             [] {
                 return changed([](const ColorPicture& p, int x, int y) { return Color{p.at(x, y)[2], p.at(x, y)[1], p.at(x, y)[0]}; });
             }},
        Case{"channels swapped",
             [] {
                 return changed([](const ColorPicture& p, int x, int y) { return Color{p.at(x, y)[1], p.at(x, y)[2], p.at(x, y)[0]}; });
             }},
        Case{"negative", [] { return curved([](float v) { return 1.0f - v; }); }},
        Case{"gamma twice", [] { return curved([](float v) { return std::pow(v, 1.0f / 2.2f); }); }},
        Case{"gamma twice",
             [] { return curved([](float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f; }); }},
        Case{"gamma missing", [] { return curved([](float v) { return std::pow(v, 2.2f); }); }},
        Case{"gamma missing", [] { return curved([](float v) { return std::pow(v, 1.7f); }); }},
        Case{"exposure", [] { return curved([](float v) { return 1.4f * v; }); }},
        Case{"exposure", [] { return curved([](float v) { return 0.5f * v; }); }},
        Case{"another tone curve", [] { return curved([](float v) { return v > 0.2f && v < 0.6f ? 1.0f - v : v; }); }},
        Case{"shifted", [] { return scene(3.0f, -1.0f); }},  //
        Case{"half-pixel shift", [] { return scene(0.5f, 0.5f); }}, Case{"half-pixel shift", [] { return scene(-0.5f, 0.0f); }},
        Case{"unfinished", [] { return changed([](const ColorPicture& p, int x, int y) { return y > 35 ? Color{} : p.at(x, y); }); }},
        Case{"needless anti-aliasing", smooth},  //
        Case{"noise",
             [] {
                 std::mt19937 random(1);
                 std::normal_distribution<float> step(0.0f, 0.08f);
                 return changed([&](const ColorPicture& p, int x, int y) {
                     return Color{p.at(x, y)[0] + step(random), p.at(x, y)[1] + step(random), p.at(x, y)[2] + step(random)};
                 });
             }},
        Case{"shadow acne",
             [] {
                 std::mt19937 random(2);
                 return changed([&](const ColorPicture& p, int x, int y) {
                     const float k = random() % 3 == 0 ? 0.2f : 1.0f;
                     return Color{k * p.at(x, y)[0], k * p.at(x, y)[1], k * p.at(x, y)[2]};
                 });
             }},
        // No mistake of whole pictures: one thing is missing, or another colour.
        Case{"", [] { return changed([](const ColorPicture& p, int x, int y) { return x > 68 ? p.at(66, y) : p.at(x, y); }); }},
        Case{"", [] {
                 return changed([](const ColorPicture& p, int x, int y) {
                     return x > 68 && y > 30 ? Color{0.9f, 0.1f, 0.1f} : p.at(x, y);
                 });
             }}));

TEST(PictureCauses, SmoothEdgesThatAreJagged) { EXPECT_EQ(cause(smooth(), scene()), "missing anti-aliasing"); }

TEST(PictureCauses, EqualPicturesHaveNone) { EXPECT_TRUE(picture_findings(scene(), scene()).empty()); }

TEST(PictureCauses, TheEvidenceSaysHowManyPixelsAreLeft) {
    ColorPicture actual = changed([](const ColorPicture& p, int x, int y) { return p.at(width - 1 - x, y); });
    actual.pixels[0] = {1.0f, 0.0f, 0.0f};
    const Verdicts verdicts = choose(picture_findings(scene(), actual));
    EXPECT_THAT(verdicts.lines.front(),
                testing::StartsWith("the picture is the expected one mirrored left to right: 1 of 8000 pixels differ then, "));
}

TEST(PictureCauses, NoiseIsRoughAndASurfaceIsNot) {
    std::mt19937 random(3);
    std::normal_distribution<float> step(0.0f, 0.05f);
    const ColorPicture grey = made(width, height, [](int, int) { return Color{0.5f, 0.5f, 0.5f}; });
    const ColorPicture noisy = made(width, height, [&](int, int) {
        return Color{0.5f + step(random), 0.5f + step(random), 0.5f + step(random)};
    });
    EXPECT_NEAR(roughness_of(grey, noisy), 8.0 / 9.0, 0.02);
    EXPECT_LT(roughness_of(grey, made(width, height, [](int, int) { return Color{0.7f, 0.5f, 0.5f}; })), 0.001);
}

}  // namespace
}  // namespace rt::picture_causes_test
