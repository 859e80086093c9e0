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

using Numbers = std::vector<std::uint16_t>;

Numbers stored(Pixel p, Encoding e) {
    Film film(1, 1);
    film.at(0, 0) = p;
    e.alpha = true;
    return quantise(film, e);
}

std::uint16_t byte_of(long double e) { return static_cast<std::uint16_t>(rounded(e)); }

TEST(Alpha, ColourIsDividedByCoverage) {
    EXPECT_EQ(stored({0.0f, 0.0f, 0.0f, 1.0f}, encoding(linear, srgb)), (Numbers{0, 0, 0, 0}));
    EXPECT_EQ(stored({0.1f, 0.2f, 0.05f, 0.5f}, encoding(linear, linear)), (Numbers{51, 102, 26, 128}));
    EXPECT_EQ(stored({0.1f, 0.2f, 0.05f, 0.75f}, encoding(linear, srgb)),
              (Numbers{byte_of(srgb_of(0.4L)), byte_of(srgb_of(0.8L)), byte_of(srgb_of(0.2L)), 64}));
    EXPECT_EQ(stored({0.2f, 0.3f, 0.5f, 0.0f}, encoding(linear, linear)), (Numbers{51, 77, 128, 255}));
}

TEST(Alpha, DivisionIsInTheWorkingSpace) {
    EXPECT_EQ(stored({0.1f, 0.2f, 0.05f, 0.75f}, encoding(power(2.2), linear)),
              (Numbers{byte_of(std::pow(0.4L, 2.2L)), byte_of(std::pow(0.8L, 2.2L)), byte_of(std::pow(0.2L, 2.2L)), 64}));
}

TEST(Alpha, BrightPixelsRaiseIt) {
    // The grey value of the colour, 0.9772, is more than the coverage, 0.8227.
    const Pixel p{2.468144f, 0.4113573f, 0.0164543f, 0.1772853f};
    const double grey = 0.297 * 2.468144 + 0.589 * 0.4113573 + 0.114 * 0.0164543;
    const Numbers numbers = stored(p, encoding(linear, linear, 16));
    EXPECT_EQ(numbers[3], rounded(grey, 65535));
    EXPECT_EQ(numbers[0], 65535);
    EXPECT_NEAR(numbers[1], 65535 * 0.4113573 / grey, 1.0);
    EXPECT_EQ(stored({5.0f, 5.0f, 5.0f, 1.0f}, encoding(linear, linear)), (Numbers{255, 255, 255, 255}));
    EXPECT_EQ(stored({NAN, 0.0f, 0.0f, 1.0f}, encoding(linear, linear)), (Numbers{0, 0, 0, 0}));
}

/// Error diffusion written out once more, with whole-picture arrays: a row's errors go to cell (x, y), and the first cell of each row reads
/// that of the row before it.
std::vector<int> diffused(const std::vector<double>& values, int width, int height) {
    std::vector<double> errors(values.size() + width + 2, 0.0);
    std::vector<int> bytes;
    const auto at = [&](int x, int y) -> double& { return errors[static_cast<std::size_t>(y) * width + x]; };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double carried = x > 0 ? at(x, y) : y > 0 ? at(0, y - 1) : 0.0;
            const double wanted = values[static_cast<std::size_t>(y) * width + x] + carried;
            bytes.push_back(rounded(wanted));
            const double error = std::fmin(std::fmax(wanted, 0.0), 1.0) - bytes.back() / 255.0;
            if (x + 1 < width) at(x + 1, y) += error * 7 / 16;
            if (y + 1 == height) continue;
            if (x > 0) at(x - 1, y + 1) += error * 3 / 16;
            at(x, y + 1) += error * 5 / 16;
            if (x + 1 < width) at(x + 1, y + 1) += error / 16;
        }
    }
    return bytes;
}

TEST(Dither, SpreadsErrorsAsPovray) {
    const int width = 23, height = 17;
    Film film(width, height);
    std::vector<double> red;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            film.at(x, y).r = static_cast<float>(-0.05 + 1.15 * (x + 0.3 * y) / 28.0);
            red.push_back(film.at(x, y).r);
        }
    }
    Encoding e = encoding(linear, linear);
    e.dither = true;
    const Numbers numbers = quantise(film, e);
    const std::vector<int> expected = diffused(red, width, height);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(numbers[3 * i], expected[i]) << i;
        ASSERT_EQ(numbers[3 * i + 1], 0);
    }
}

TEST(Dither, KeepsTheMeanOfFlatAreas) {
    Film film(64, 64);
    for (Pixel& p : film.pixels) p = {100.3f / 255.0f, 0.0f, 0.0f, 0.3f / 255.0f};
    Encoding e = encoding(linear, linear);
    e.dither = e.alpha = true;
    const Numbers numbers = quantise(film, e);
    double alpha = 0.0;
    for (std::size_t i = 3; i < numbers.size(); i += 4) alpha += numbers[i];
    EXPECT_NEAR(alpha / 4096.0, 254.7, 0.02);
}

// 255 times the float nearest to 0.7 is 178.49999; POV-Ray's single-precision product is 178.5 and its file holds 179. Likewise 0.9 and
// 0.1.
TEST(Quantise, ties_of_plain_values_as_povray_writes_them) {
    Encoding raw;
    raw.raw = true;
    EXPECT_EQ(quantise(0.7f, raw), 179);
    EXPECT_EQ(quantise(0.9f, raw), 230);
    EXPECT_EQ(quantise(0.1f, raw), 26);
    EXPECT_EQ(quantise(0.3f, raw), 77);
}

}  // namespace
}  // namespace rt
