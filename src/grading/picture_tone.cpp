// Mistakes that turn each value of a picture into another, the same everywhere: gamma, exposure, any other curve.
#include <fmt/format.h>

#include "grading/picture_causes.h"

namespace rt {

namespace {

template <typename Curve>
Misfit misfit_of(const Curve& curve, const ColorPicture& expected, const ColorPicture& actual) {
    Misfit left;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        const Color& e = expected.pixels[i];
        left.add(apart({curve(e[0]), curve(e[1]), curve(e[2])}, actual.pixels[i]));
    }
    return left;
}

/// Calls use(x, y) for every pair of an expected and an actual value that are neither black nor cut off at white.
template <typename Use>
void for_inner_values(const ColorPicture& expected, const ColorPicture& actual, const Use& use) {
    constexpr float low = 4.0f / 255.0f, high = 253.0f / 255.0f;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float x = expected.pixels[i][c], y = actual.pixels[i][c];
            if (x >= low && x <= high && y >= low && y <= high) use(static_cast<double>(x), static_cast<double>(y));
        }
}

float srgb_encode(float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f; }
float srgb_decode(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

/// The gain k of least squares, y = k x; 0 if there is nothing to fit.
double gain(const ColorPicture& expected, const ColorPicture& actual) {
    double xy = 0.0, xx = 0.0;
    for_inner_values(expected, actual, [&](double x, double y) { xy += x * y, xx += x * x; });
    return xx > 0.0 ? xy / xx : 0.0;
}

/// The exponent g of least squares in logarithms, y = x^g; 0 if there is nothing to fit.
double exponent(const ColorPicture& expected, const ColorPicture& actual) {
    double xy = 0.0, xx = 0.0;
    for_inner_values(expected, actual, [&](double x, double y) { xy += std::log(x) * std::log(y), xx += std::log(x) * std::log(x); });
    return xx > 0.0 ? xy / xx : 0.0;
}

/// The mean actual value of each expected one, and what it leaves: the best that any curve could do.
Misfit left_by_any_curve(const ColorPicture& expected, const ColorPicture& actual) {
    std::array<double, 256> sum{}, count{};
    const auto bin = [](float v) { return static_cast<std::size_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f))); };
    for (std::size_t i = 0; i < actual.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t b = bin(expected.pixels[i][c]);
            sum[b] += static_cast<double>(actual.pixels[i][c]), ++count[b];
        }
    return misfit_of([&](float v) { return static_cast<float>(sum[bin(v)] / count[bin(v)]); }, expected, actual);
}

}  // namespace

std::vector<Finding> tone_findings(const ColorPicture& expected, const ColorPicture& actual, const Misfit& whole) {
    std::vector<Finding> findings;
    const auto add = [&](const char* cause, const std::string& words, const Misfit& left, double freedom) {
        findings.push_back({cause, fmt::format("{}: {}", words, pixels_left(left, whole, actual)), share_left(left, whole), freedom});
    };
    const auto power = [&](double g) { return [g = static_cast<float>(g)](float v) { return std::pow(std::max(v, 0.0f), g); }; };
    add("gamma twice", "the picture is the expected one encoded by sRGB's curve once more", misfit_of(srgb_encode, expected, actual), 0.0);
    add("gamma missing", "the picture is the expected one without an encoding by sRGB's curve", misfit_of(srgb_decode, expected, actual),
        0.0);
    add("gamma twice", "the picture is the expected one with each value v as v^(1/2.2)", misfit_of(power(1.0 / 2.2), expected, actual),
        0.0);
    add("gamma missing", "the picture is the expected one with each value v as v^2.2", misfit_of(power(2.2), expected, actual), 0.0);
    if (const double g = exponent(expected, actual); g > 0.0)
        add(g < 1.0 ? "gamma twice" : "gamma missing", fmt::format("the picture is the expected one with each value v as v^{:.3f}", g),
            misfit_of(power(g), expected, actual), 0.01);
    if (const double k = gain(expected, actual); k > 0.0) {
        const auto scaled = [k = static_cast<float>(k)](float v) { return std::min(k * v, 1.0f); };
        add("exposure",
            fmt::format("the picture is the expected one {:.3g} times as {}", k >= 1.0 ? k : 1.0 / k, k >= 1.0 ? "bright" : "dark"),
            misfit_of(scaled, expected, actual), 0.01);
    }
    add("another tone curve", "the same expected value always has the same value in the picture, by another curve than the usual ones",
        left_by_any_curve(expected, actual), 0.1);
    return findings;
}

}  // namespace rt
