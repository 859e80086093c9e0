// Bytes from linear values: the closed forms of the curves, clamp, rounding, alpha and dithering.
#include "film/encode.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "film/quantiser.h"

namespace rt {
namespace {

const Curve linear{Curve::Kind::power, 1.0};
const Curve srgb{Curve::Kind::srgb, 1.0};
Curve power(double g) { return {Curve::Kind::power, g}; }

Encoding encoding(Curve working, Curve file, int bits = 8) {
    Encoding e;
    e.working = working, e.file = file, e.bits = bits;
    return e;
}

long double srgb_of(long double x) { return x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1.0L / 2.4L) - 0.055L; }
long double from_srgb(long double x) { return x < 0.04045L ? x / 12.92L : std::pow((x + 0.055L) / 1.055L, 2.4L); }
int rounded(long double e, int levels = 255) { return static_cast<int>(std::floor(std::fmin(std::fmax(e, 0.0L), 1.0L) * levels + 0.5L)); }

/// Patches from darkness to beyond white.
const std::vector<double> patches{-0.2, 0.0,  0.0005, 0.003, 0.0031308, 0.01, 0.04045, 0.05, 0.1, 0.18,
                                  0.25, 0.35, 0.5,    0.65,  0.73,      0.8,  0.9,     0.99, 1.0, 1.5};

struct Case {
    const char* name;
    Encoding encoding;
    long double (*expected)(long double);
};

class Bytes : public testing::TestWithParam<Case> {};

TEST_P(Bytes, FollowTheFormula) {
    for (const int bits : {8, 16}) {
        Encoding e = GetParam().encoding;
        e.bits = bits;
        for (const double v : patches) {
            EXPECT_EQ(quantise(v, e), rounded(GetParam().expected(v), bits == 8 ? 255 : 65535)) << v << " at " << bits << " bits";
        }
    }
}

long double clipped(long double v) { return std::fmax(v, 0.0L); }
long double same(long double v) { return v; }
Encoding legacy(Curve file) {
    Encoding e = encoding(power(2.2), file);
    e.raw = true;
    return e;
}

INSTANTIATE_TEST_SUITE_P(
    Rules, Bytes,
    testing::Values(
        Case{"linear_to_srgb", encoding(linear, srgb), srgb_of},
        Case{"power_to_srgb", encoding(power(2.2), srgb), [](long double v) { return srgb_of(std::pow(clipped(v), 2.2L)); }},
        Case{"srgb_to_srgb", encoding(srgb, srgb), same},  //
        Case{"linear_to_linear", encoding(linear, linear), same},
        Case{"linear_to_power", encoding(linear, power(2.2)), [](long double v) { return std::pow(clipped(v), 1 / 2.2L); }},
        Case{"equal_powers_cancel", encoding(power(2.2), power(2.2)), same},
        Case{"powers_combine", encoding(power(1.8), power(2.2)), [](long double v) { return std::pow(clipped(v), 1.8L / 2.2L); }},
        Case{"srgb_to_linear", encoding(srgb, linear), from_srgb},
        Case{"srgb_to_power", encoding(srgb, power(2.2)), [](long double v) { return std::pow(clipped(from_srgb(v)), 1 / 2.2L); }},
        Case{"legacy", legacy(srgb), same}, Case{"legacy_ignores_file_gamma", legacy(power(2.2)), same},
        Case{"nearly_one_is_one", encoding(power(1.0099), power(0.9901)), same}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Encode, KnownBytes) {
    // Middle grey, the eighteen per cent card and the joint of the two branches.
    EXPECT_EQ(quantise(0.5, encoding(linear, srgb)), 188);
    EXPECT_EQ(quantise(0.18, encoding(linear, srgb)), 118);
    EXPECT_EQ(quantise(0.0031308, encoding(linear, srgb)), 10);
    EXPECT_EQ(quantise(0.5, encoding(linear, linear)), 128);
    EXPECT_EQ(quantise(0.25, encoding(linear, power(2.0))), 128);
}

TEST(Encode, NotANumberIsBlackAndInfinityWhite) {
    const Encoding e = encoding(linear, srgb);
    EXPECT_EQ(quantise(std::numeric_limits<double>::quiet_NaN(), e), 0);
    EXPECT_EQ(quantise(std::numeric_limits<double>::infinity(), e), 255);
    EXPECT_EQ(quantise(-std::numeric_limits<double>::infinity(), e), 0);
}

TEST(Encode, LinearLightIsNotClamped) {
    EXPECT_EQ(to_linear(2.5, encoding(linear, srgb)), 2.5);
    EXPECT_EQ(to_linear(-0.5, encoding(linear, srgb)), -0.5);
    EXPECT_NEAR(to_linear(2.5, encoding(power(2.2), srgb)), std::exp(2.2 * std::log(2.5)), 1e-12);
    EXPECT_NEAR(to_linear(0.0625, encoding(power(2.2), srgb)), std::exp2(-8.8), 1e-15);
    EXPECT_EQ(to_linear(-0.5, encoding(power(2.2), srgb)), 0.0);
}

/// Every float around every step, the ends, and a walk over all exponents: a table that disagrees with the formula anywhere near a step is
/// found here, and between steps both are constant because the formula never falls.
class Tables : public testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(Tables, EqualTheFormula) {
    const auto [which, bits] = GetParam();
    const Encoding all[] = {encoding(linear, srgb, bits),           encoding(linear, linear, bits),    encoding(power(2.2), srgb, bits),
                            encoding(power(1.8), power(2.2), bits), encoding(srgb, power(2.2), bits),  encoding(linear, power(30.0), bits),
                            encoding(power(30.0), linear, bits),    encoding(linear, power(2.2), bits)};
    const Encoding& e = all[which];
    const Quantiser table(e, 1u << 24);
    constexpr float largest = std::numeric_limits<float>::infinity();
    const auto check = [&](float v) { ASSERT_EQ(table(v), quantise(v, e)) << std::bit_cast<std::uint32_t>(v); };
    for (std::uint32_t bucket = 0; bucket < 0x7f800000u; bucket += 9973) check(std::bit_cast<float>(bucket));
    for (const float v : {0.0f, -0.0f, -1.0f, 1.0f, 2.0f, largest, -largest, std::numeric_limits<float>::quiet_NaN()}) check(v);
    const int levels = (1 << bits) - 1;
    const Encoding back = encoding(e.file, e.working);
    for (int k = 1; k <= levels; k += bits == 8 ? 1 : 7) {
        float v = static_cast<float>(encode((k - 0.5) / levels, back));
        for (int i = 0; i < 6; ++i) v = std::nextafter(v, -largest);
        for (int i = 0; i < 12; ++i, v = std::nextafter(v, largest)) check(v);
    }
}

INSTANTIATE_TEST_SUITE_P(Curves, Tables, testing::Combine(testing::Range(0, 8), testing::Values(8, 16)));

TEST(Quantise, FilmRowsFromTheTop) {
    Film film(2, 2);
    film.at(0, 0) = {1.0f, 0.5f, 0.0f, 0.0f};
    film.at(1, 1) = {0.0f, 0.25f, 2.0f, 0.0f};
    const std::vector<std::uint16_t> expected{255, 128, 0, 0, 0, 0, 0, 0, 0, 0, 64, 255};
    EXPECT_EQ(quantise(film, encoding(linear, linear)), expected);
}

std::vector<std::uint16_t> with_alpha(Pixel p, Encoding e) {
    Film film(1, 1);
    film.at(0, 0) = p;
    e.alpha = true;
    return quantise(film, e);
}

TEST(Alpha, ColourIsDividedByCoverageInLinearLight) {
    using Numbers = std::vector<std::uint16_t>;
    EXPECT_EQ(with_alpha({0.0f, 0.0f, 0.0f, 1.0f}, encoding(linear, srgb)), (Numbers{0, 0, 0, 0}));
    EXPECT_EQ(with_alpha({0.1f, 0.2f, 0.05f, 0.5f}, encoding(linear, linear)), (Numbers{51, 102, 26, 128}));
    EXPECT_EQ(with_alpha({0.1f, 0.2f, 0.05f, 0.75f}, encoding(linear, srgb)),
              (Numbers{static_cast<std::uint16_t>(rounded(srgb_of(0.4L))), static_cast<std::uint16_t>(rounded(srgb_of(0.8L))),
                       static_cast<std::uint16_t>(rounded(srgb_of(0.2L))), 64}));
    EXPECT_EQ(with_alpha({0.2f, 0.3f, 0.5f, 0.0f}, encoding(linear, linear)), (Numbers{51, 77, 128, 255}));
}

TEST(Alpha, BrightPixelsRaiseIt) {
    // Grey value of the premultiplied colour 2.468, 0.4114, 0.01645 is 0.9772: more than the coverage 0.8227.
    const Pixel p{2.468144f, 0.4113573f, 0.0164543f, 0.1772853f};
    const long double grey = 0.297L * 2.468144L + 0.589L * 0.4113573L + 0.114L * 0.0164543L;
    const auto numbers = with_alpha(p, encoding(linear, linear, 16));
    EXPECT_EQ(numbers[3], rounded(grey, 65535));
    EXPECT_EQ(numbers[0], 65535);
    EXPECT_NEAR(numbers[1], 65535 * 0.4113573 / static_cast<double>(grey), 1.0);
}

}  // namespace
}  // namespace rt
