// The program on scenes whose pixels follow from a formula. The formulas stand in the heads of pov/closed_form/*.pov and are computed here
// without any of the program's code but the reading of the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

#include "film/image_file.h"

namespace closed_form_test {
namespace {

struct Colour {
    double r, g, b;
};
Colour operator*(double k, const Colour& c) { return {k * c.r, k * c.g, k * c.b}; }
Colour operator*(const Colour& a, const Colour& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
Colour operator+(const Colour& a, const Colour& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
Colour grey(double k) { return {k, k, k}; }

/// Pixel value at u (to the right) and v (up), both in -1/2 .. 1/2; nothing where an edge runs through the pixel's centre.
using Formula = std::function<std::optional<Colour>(double u, double v)>;
struct Case {
    const char* scene;
    Formula formula;
};

double square(double x) { return x * x; }
double smooth(double q) { return q <= 0 ? 0 : q >= 1 ? 1 : q * q * (3 - 2 * q); }
double cosine_of(double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); }

/// For the scenes under the orthographic camera: x = 8 u, y = 6 v.
Formula on_wall(std::function<std::optional<Colour>(double x, double y)> formula) {
    return [formula = std::move(formula)](double u, double v) { return formula(8 * u, 6 * v); };
}

Colour lambert(double x, double y) { return (0.1 + 0.7 * 3 / std::sqrt(square(x - 1) + square(y + 0.5) + 9)) * Colour{0.8, 0.5, 0.3}; }

Colour light_fade(double x, double y) {
    const double r = std::sqrt(x * x + y * y + 4);
    return 0.6 * 2 / r * 2 / (1 + std::pow(r / 2.5, 3)) * Colour{0.9, 0.8, 0.7};
}

Colour spotlight(double x, double y) {
    const double a = 5 / std::sqrt(x * x + y * y + 25);
    return grey(0.9 * std::pow(a, 5) * smooth((a - cosine_of(30)) / (cosine_of(15) - cosine_of(30))));
}

Colour cylinder_light(double x, double y) {
    const double r = std::sqrt(x * x + y * y), w = 1 - r / 2.5;
    if (w <= 0) return grey(0);
    return grey(0.8 * w * w * (r > 1 ? smooth(w / (1 - 1 / 2.5)) : 1));
}

Colour checker(double x, double y) {
    const double n = std::floor(x / 0.7) + std::floor(y / 0.7) + std::floor(0.25 / 0.7);
    return std::fmod(n, 2) == 0 ? Colour{0.9, 0.8, 0.1} : Colour{0.1, 0.2, 0.6};
}

Colour sphere_lambert(double x, double y) {
    const double s = 1 - (x * x + y * y) / 4;
    return s < 0 ? Colour{0.2, 0.3, 0.4} : 0.8 * std::sqrt(s) * Colour{0.9, 0.6, 0.3};
}

Colour phong(double x, double y) {
    const double r = std::sqrt(square(x - 0.7) + square(y - 0.4) + 16);
    return 0.75 * std::pow(4 / r, 12) * Colour{0.8, 0.9, 1};
}

Colour specular(double x, double y) {
    const double r = std::sqrt(square(x + 1) + y * y + 16);
    const std::array<double, 3> h{(-1 - x) / r, -y / r, -4 / r - 1};  // L + V
    const double n_dot_h = -h[2] / std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    return 0.6 * std::pow(n_dot_h, 1 / 0.04) * Colour{1, 0.9, 0.8};
}

Colour mirror(double u, double v) {
    const Colour sky{0.4, 0.6, 0.9};
    if (v > 0) return sky;
    const double c = -v / std::sqrt(square(4.0 / 3 * u) + v * v + 1);
    return grey(0.05) + (0.9 * (1 - c) + 0.1 * c) * sky;
}

Colour fresnel(double u, double v) {
    if (v > 0) return grey(1);
    const double c = -v / std::sqrt(square(4.0 / 3 * u) + v * v + 1), g = std::sqrt(1.5 * 1.5 + c * c - 1);
    return grey(0.5 * square((g - c) / (g + c)) * (1 + square((c * (g + c) - 1) / (c * (g - c) + 1))));
}

Colour refraction(double u, double v) {
    const double t = std::sqrt(square(4.0 / 3 * u) + v * v);
    const double sine_inside = t / std::sqrt(t * t + 1) / 1.5;
    const double R = 6 * t + sine_inside / std::sqrt(1 - sine_inside * sine_inside);
    return 0.9 / std::sqrt(R * R + 1) * Colour{1, 0.8, 0.6};
}

Colour attenuation(double u, double v) {
    const double s = std::sqrt(square(4.0 / 3 * u) + v * v + 1);
    const auto through = [&](double f) { return u < 0 ? std::exp(-(1 - f) * s / 0.7) : f + (1 - f) / (1 + square(s / 0.7)); };
    return {through(0.8), through(0.5), through(0.2)};
}

Colour layers(double x, double y) {
    const Colour wall{0.3, 0.6, 0.9}, top{0.2, 0.4, 0.8}, below{0.9, 0.5, 0.1};
    if (std::fabs(x) > 2 || std::fabs(y) > 1.5) return 0.8 * wall;
    return 0.8 * (0.3 * top + (0.5 * top + grey(0.2)) * (0.6 * below + 0.4 * wall));
}

std::optional<Colour> smooth_triangle(double x, double y) {
    const double top = (y + 2) / 4.5, right = (x + 3 * (1 - top)) / 6, left = 1 - top - right;
    const double least = std::min({top, right, left});
    if (std::fabs(least) < 1e-9) return {};
    if (least < 0) return Colour{0, 0, 0.2};
    const double nx = 0.6 * (right - left), ny = 0.6 * top, nz = -0.8;
    return grey(0.9 * 0.8 / std::sqrt(nx * nx + ny * ny + nz * nz));
}

Colour tinted_shadow(double x, double y) {
    const Colour lit = grey(0.8 * 4 / std::sqrt(x * x + y * y + 16));
    const bool shadow = std::fabs(x) < 1.5 && std::fabs(y) < 1;
    return shadow ? lit * (0.6 * Colour{0.9, 0.5, 0.2} + grey(0.3)) : lit;
}

Colour torus_lambert(double x, double y) {
    const double q = 1 - square((std::sqrt(x * x + y * y) - 1.8) / 0.6);
    return q < 0 ? Colour{0.1, 0.2, 0.3} : 0.9 * std::sqrt(q) * Colour{0.9, 0.8, 0.4};
}

class ClosedForm : public testing::TestWithParam<Case> {};

TEST_P(ClosedForm, EveryPixelWithinOneStepOf16Bits) {
    constexpr int width = 96, height = 72;
    const std::string scene = GetParam().scene, picture = testing::TempDir() + "closed_form_" + scene + ".png";
    const std::string command = std::string("'") + PROGRAM + "' '+I" + PROJECT_ROOT + "/pov/closed_form/" + scene + ".pov' '+O" + picture +
                                "' +W96 +H72 -A -D -GA +FN16 File_Gamma=1.0 --shading povray >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const rt::StoredImage image = rt::read_image(picture);
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    ASSERT_EQ(image.max_value, 65535);
    int wrong = 0, compared = 0;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const auto expected = GetParam().formula((i + 0.5) / width - 0.5, 0.5 - (j + 0.5) / height);
            if (!expected) continue;
            ++compared;
            const float* stored = &image.values[static_cast<std::size_t>((j * width + i) * image.channels)];
            const double channels[] = {expected->r, expected->g, expected->b};
            for (int k = 0; k < 3; ++k) {
                const double value = 65535 * std::clamp(channels[k], 0.0, 1.0);
                if (std::fabs(stored[k] - value) > 1.0 && wrong++ < 5)
                    ADD_FAILURE() << scene << " pixel (" << i << ", " << j << ") channel " << k << ": " << stored[k] << ", not " << value;
            }
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(compared, width * height * 9 / 10);
    std::remove(picture.c_str());
}

INSTANTIATE_TEST_SUITE_P(Scenes, ClosedForm,
                         testing::Values(Case{"lambert", on_wall(lambert)}, Case{"light_fade", on_wall(light_fade)},
                                         Case{"spotlight", on_wall(spotlight)}, Case{"cylinder_light", on_wall(cylinder_light)},
                                         Case{"checker", on_wall(checker)}, Case{"sphere_lambert", on_wall(sphere_lambert)},
                                         Case{"phong", on_wall(phong)}, Case{"specular", on_wall(specular)}, Case{"mirror", mirror},
                                         Case{"fresnel", fresnel}, Case{"refraction", refraction}, Case{"attenuation", attenuation},
                                         Case{"layers", on_wall(layers)}, Case{"smooth_triangle", on_wall(smooth_triangle)},
                                         Case{"tinted_shadow", on_wall(tinted_shadow)}, Case{"torus_lambert", on_wall(torus_lambert)}),
                         [](const auto& info) { return std::string(info.param.scene); });

}  // namespace
}  // namespace closed_form_test
