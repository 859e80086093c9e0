// Cook-Torrance evaluated by POV-Ray itself. Of each pair of scenes one has the formula as a function over the visible surfaces, written
// from the papers as it stands there and evaluated by POV-Ray; in the other the program shades the same surfaces by its own finish. Each
// case prints its figures.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "film/image_file.h"

namespace povray_formula_test {
namespace {

constexpr double peak_level = 0.9;     // of the brightest pixel in POV-Ray's picture; functions from 1 on would wrap
constexpr double saturation = 0.9999;  // so they are cut here
constexpr double exposures[] = {1, 8, 64};

/// What both pictures show: a unit sphere on a plane, seen and lit from different sides. The sphere casts no shadow, as a formula has none.
const char* const view = R"(
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye_x = 0; #declare Eye_y = 1.5; #declare Eye_z = -2.6;
#declare Lamp_x = 3.5; #declare Lamp_y = 3; #declare Lamp_z = 4;
camera { location <Eye_x, Eye_y, Eye_z> right 4/3*x up y look_at <0.9, -0.1, -0.15> angle 44 }
#declare Ball = sphere { 0, 1 }
#declare Floor = plane { y, -1 }
)";

/// Cook, Torrance 1982 with the distributions of Blinn 1977, Beckmann (normalised) and Walter et al. 2007, and Schlick 1994. n is (A, B,
/// C). %TERMS% states Alpha, D and the rest.
const char* const formula = R"(
#declare Lamp_distance = function(x, y, z) { sqrt(pow(Lamp_x - x, 2) + pow(Lamp_y - y, 2) + pow(Lamp_z - z, 2)) }
#declare Eye_distance = function(x, y, z) { sqrt(pow(Eye_x - x, 2) + pow(Eye_y - y, 2) + pow(Eye_z - z, 2)) }
#declare Lx = function(x, y, z) { (Lamp_x - x) / Lamp_distance(x, y, z) }
#declare Ly = function(x, y, z) { (Lamp_y - y) / Lamp_distance(x, y, z) }
#declare Lz = function(x, y, z) { (Lamp_z - z) / Lamp_distance(x, y, z) }
#declare Vx = function(x, y, z) { (Eye_x - x) / Eye_distance(x, y, z) }
#declare Vy = function(x, y, z) { (Eye_y - y) / Eye_distance(x, y, z) }
#declare Vz = function(x, y, z) { (Eye_z - z) / Eye_distance(x, y, z) }
#declare Sx = function(x, y, z) { Lx(x, y, z) + Vx(x, y, z) }
#declare Sy = function(x, y, z) { Ly(x, y, z) + Vy(x, y, z) }
#declare Sz = function(x, y, z) { Lz(x, y, z) + Vz(x, y, z) }
#declare S_length = function(x, y, z) { sqrt(pow(Sx(x, y, z), 2) + pow(Sy(x, y, z), 2) + pow(Sz(x, y, z), 2)) }
#declare Hx = function(x, y, z) { Sx(x, y, z) / S_length(x, y, z) }
#declare Hy = function(x, y, z) { Sy(x, y, z) / S_length(x, y, z) }
#declare Hz = function(x, y, z) { Sz(x, y, z) / S_length(x, y, z) }
#declare N_dot_L = function(x, y, z, A, B, C) { A * Lx(x, y, z) + B * Ly(x, y, z) + C * Lz(x, y, z) }
#declare N_dot_V = function(x, y, z, A, B, C) { A * Vx(x, y, z) + B * Vy(x, y, z) + C * Vz(x, y, z) }
#declare N_dot_H = function(x, y, z, A, B, C) { A * Hx(x, y, z) + B * Hy(x, y, z) + C * Hz(x, y, z) }
#declare V_dot_H = function(x, y, z) { Vx(x, y, z) * Hx(x, y, z) + Vy(x, y, z) * Hy(x, y, z) + Vz(x, y, z) * Hz(x, y, z) }
#declare Tangent2 = function(nh) { (1 - pow(nh, 2)) / pow(nh, 2) }
%TERMS%
#declare F0 = pow((1.5 - 1) / (1.5 + 1), 2);
#declare F = function(vh) { F0 + (1 - F0) * pow(1 - vh, Power) }
#declare Lobe = function(nl, nv, nh, vh) { nl * D(nh) * G(nl, nv, nh, vh) * F(vh) / (Factor * nl * nv) }
#declare Reflected = function(x, y, z, A, B, C) {
    select(-N_dot_L(x, y, z, A, B, C),
           select(-N_dot_V(x, y, z, A, B, C),
                  Lobe(N_dot_L(x, y, z, A, B, C), N_dot_V(x, y, z, A, B, C), N_dot_H(x, y, z, A, B, C), V_dot_H(x, y, z)), 0), 0)
}
#declare Ball_value = function(x, y, z) { Scale * Reflected(x, y, z, x, y, z) }
#declare Floor_value = function(x, y, z) { Scale * Reflected(x, y, z, 0, 1, 0) }
#declare Shown = finish { ambient 0 diffuse 0 emission 1 }
)";

struct Distribution {
    const char* name;
    const char* text;
};
constexpr Distribution distributions[] = {
    {"beckmann", "#declare D = function(nh) { exp(-Tangent2(nh) / pow(Alpha, 2)) / (pi * pow(Alpha, 2) * pow(nh, 4)) }"},
    {"blinn", "#declare D = function(nh) { pow(nh, 2 / pow(Alpha, 2) - 2) / (pi * pow(Alpha, 2)) }"},
    {"ggx", "#declare D = function(nh) { pow(Alpha, 2) / (pi * pow(pow(nh, 2) * (pow(Alpha, 2) + Tangent2(nh)), 2)) }"},
};

/// One pair of pictures, 4:3.
struct Case {
    Distribution distribution;
    double roughness;
    int width = 160;
    int height() const { return width * 3 / 4; }
};

/// The formula's constants. The defaults are right; others are mistakes that a reader of several texts could make.
struct Constants {
    std::string factor = "4", fresnel_power = "5", groove = "2";
};

std::string terms(const Case& c, const Constants& constants) {
    std::string text =
        fmt::format("#declare Roughness = {};\n#declare Alpha = pow(Roughness, 2);\n#declare Factor = {};\n#declare Power = {};\n",
                    c.roughness, constants.factor, constants.fresnel_power);
    text += fmt::format("#declare G = function(nl, nv, nh, vh) {{ min(1, {0} * nh * nv / vh, {0} * nh * nl / vh) }}\n", constants.groove);
    return text + c.distribution.text;
}

/// Red, green and blue hold the three exposures of one value. `average` divides by their number.
std::string shown(const std::string& value) {
    std::string text = "pigment { average pigment_map {";
    for (int i = 0; i < 3; ++i)
        text += fmt::format(" [1 function {{ min({} * {}(x, y, z), {}) }} color_map {{ [0 rgb 0] [1 rgb 3*{}] }}]", exposures[i], value,
                            saturation, "xyz"[i]);
    return text + " } } finish { Shown }";
}

std::string povray_scene(const Case& c, const Constants& constants, double scale) {
    std::string text = formula;
    const std::string mark = "%TERMS%";
    text.replace(text.find(mark), mark.size(), terms(c, constants));
    return view + fmt::format("#declare Scale = {:.17g};\n", scale) + text + "object { Ball " + shown("Ball_value") +
           " }\nobject { Floor " + shown("Floor_value") + " }\n";
}

std::string our_scene(const Case& c) {
    return view + fmt::format(
                      "light_source {{ <Lamp_x, Lamp_y, Lamp_z>, 1 }}\n"
                      "#declare Shown = finish {{\n    //! raytrace: D={} G=cook-torrance F=schlick\n"
                      "    ambient 0 diffuse 0 specular 1 roughness {}\n}}\n"
                      "object {{ Ball no_shadow finish {{ Shown }} interior {{ ior 1.5 }} }}\n"
                      "object {{ Floor no_shadow finish {{ Shown }} interior {{ ior 1.5 }} }}\n",
                      c.distribution.name, c.roughness);
}

rt::StoredImage picture(const std::string& command, const std::string& scene, const std::string& path, const std::string& text) {
    std::ofstream(scene) << text;
    if (std::system((command + " >/dev/null 2>'" + scene + ".log'").c_str()) != 0) throw std::runtime_error(command);
    const rt::StoredImage image = rt::read_image(path);
    for (const std::string& file : {scene, path, scene + ".log"}) std::remove(file.c_str());
    return image;
}

/// One number a pixel: the program's, in single precision.
std::vector<double> ours(const std::string& name, const Case& c) {
    const std::string base = fmt::format("{}formula_ours_{}_{}", testing::TempDir(), name, getpid());
    const std::string command = fmt::format("'{}' '{}.pov' -W {} -H {} --bits 32 -o '{}.exr'", PROGRAM, base, c.width, c.height(), base);
    const rt::StoredImage image = picture(command, base + ".pov", base + ".exr", our_scene(c));
    std::vector<double> values;
    for (std::size_t i = 0; i < image.values.size(); i += static_cast<std::size_t>(image.channels)) values.push_back(image.values[i]);
    return values;
}

/// POV-Ray's, of the longest exposure that is not cut, divided by its scale. The exposures that are not cut must agree: a value that had
/// wrapped would not.
std::vector<double> povrays(const std::string& name, const Case& c, const Constants& constants, double scale) {
    const std::string base = fmt::format("{}formula_povray_{}_{}", testing::TempDir(), name, getpid());
    const std::string command =
        fmt::format("povray '+I{}.pov' '+O{}.png' +W{} +H{} +FN16 File_Gamma=1.0 -A -D -GA", base, base, c.width, c.height());
    const rt::StoredImage image = picture(command, base + ".pov", base + ".png", povray_scene(c, constants, scale));
    EXPECT_EQ(image.max_value, 65535);
    std::vector<double> values;
    int wrapped = 0;
    for (std::size_t i = 0; i < image.values.size(); i += static_cast<std::size_t>(image.channels)) {
        const double shortest = image.values[i] / 65535.0;
        double value = shortest;
        for (std::size_t k = 1; k < 3; ++k) {
            const double exposed = image.values[i + k] / 65535.0;
            if (exposed < saturation - 1e-4) value = exposed / exposures[k];
            wrapped += std::fabs(std::min(exposures[k] * shortest, saturation) - exposed) > exposures[k] / 65535.0;
        }
        values.push_back(value / scale);
    }
    EXPECT_EQ(wrapped, 0) << name;
    return values;
}

struct Agreement {
    int bright = 0, dark = 0;  ///< pixels above 0.01 of the peak, and the others that show anything
    int bright_within = 0, dark_within = 0;
    double relative = 0.0, of_peak = 0.0;  ///< largest differences of either kind
    double share() const { return std::min(share(bright_within, bright), share(dark_within, dark)); }
    static double share(int part, int all) { return all == 0 ? 1.0 : static_cast<double>(part) / all; }
};

Agreement compare(const std::vector<double>& ours, const std::vector<double>& theirs) {
    const double peak = *std::max_element(ours.begin(), ours.end());
    Agreement result;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double difference = std::fabs(ours[i] - theirs[i]);
        if (theirs[i] > 0.01 * peak) {
            ++result.bright;
            result.bright_within += difference <= 1e-3 * theirs[i];
            result.relative = std::max(result.relative, difference / theirs[i]);
        } else {
            ++result.dark;
            result.dark_within += difference <= 1e-5 * peak;
            result.of_peak = std::max(result.of_peak, difference / peak);
        }
    }
    return result;
}

Agreement agreement(const std::string& name, const Case& c, const Constants& constants) {
    const std::vector<double> mine = ours(name, c);
    const double scale = peak_level / *std::max_element(mine.begin(), mine.end());
    const Agreement result = compare(mine, povrays(name, c, constants, scale));
    fmt::print(
        "{:<28} {:5} bright pixels, {:7.3f} % within 1e-3, at most {:.1e}; {:5} dark, {:7.3f} % within 1e-5 of the peak, at most {:.1e}\n",
        name, result.bright, 100 * Agreement::share(result.bright_within, result.bright), result.relative, result.dark,
        100 * Agreement::share(result.dark_within, result.dark), result.of_peak);
    return result;
}

bool has_povray() { return std::system("povray --version >/dev/null 2>&1") == 0; }

class PovrayFormula : public testing::TestWithParam<Case> {};

TEST_P(PovrayFormula, IsWhatTheProgramRenders) {
    if (!has_povray()) GTEST_SKIP() << "POV-Ray is not installed";
    const Case& c = GetParam();
    const Agreement found = agreement(fmt::format("{}_{}", c.distribution.name, c.roughness), c, {});
    // The criterion is 99 % of the pixels; all of them are that near. What remains is the rounding of POV-Ray's picture to 16 bits: half a
    // step of the exposure that shows it, at most 6.1e-5 of a bright value and 1.3e-7 of the peak.
    EXPECT_EQ(found.share(), 1.0);
    EXPECT_LT(found.relative, 1e-4);
    EXPECT_LT(found.of_peak, 2e-7);
    EXPECT_GE(found.bright, 200);
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const Distribution& distribution : distributions)
        for (const double roughness : {0.1, 0.3, 0.6})
            all.push_back({distribution, roughness, roughness < 0.2 ? 384 : 160});  // narrow lobes cover few pixels
    return all;
}

INSTANTIATE_TEST_SUITE_P(CookTorrance, PovrayFormula, testing::ValuesIn(cases()), [](const auto& info) {
    return fmt::format("{}_0{}", info.param.distribution.name, std::lround(10 * info.param.roughness));
});

/// The comparison tells the right formula from its neighbours.
TEST(PovrayFormula, NoticesMistakes) {
    if (!has_povray()) GTEST_SKIP() << "POV-Ray is not installed";
    const Case ggx{distributions[2], 0.6, 80};
    const std::pair<const char*, Constants> mistakes[] = {
        {"pi_for_4", {.factor = "pi"}}, {"schlick_without_fifth_power", {.fresnel_power = "1"}}, {"groove_without_2", {.groove = "1"}}};
    for (const auto& [name, constants] : mistakes) EXPECT_LT(agreement(name, ggx, constants).share(), 0.9) << name;
}

}  // namespace
}  // namespace povray_formula_test
