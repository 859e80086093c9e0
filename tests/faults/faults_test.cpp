// explain names the faults of a tracer: each fault of program/faults.py on each scene, at the pixel that it changes most and at some drawn
// ones. A name is right if right_names() has it: a table that was written before the first measurement, but for the pigment that a mirror
// does not put on, which counts since the second.
//
// Where A is our JSON and B the course's printrays, much of B is not told:   kinds named right in 90 % of their cases,  of all cases
//                                                                            JSON         JSON and printrays            JSON
//     scenes/, which the rules had not seen                                  30 of 43     21 of 43                      81 %
//     scenes/, after the rules were mended by them                           38 of 43     25 of 43                      97.2 %
//     drawn scenes, which the rules have not seen                            37 of 41     29 of 41                      96.5 %
// All of these leave out black, the 44th fault: a record of a pixel that is black cannot tell why all of them are, and "no usual cause" is
// what most of its cases are called. With it: 38 of 44 and 94.0 % of all cases, 37 of 42 and 93.8 %.
// Four of these kinds go by a wider name than their own (wrong exponent, wrong diffuse light, filter): half_unnormalised,
// light_unnormalised, white_lights, opaque_shadows. Below 90 % on the drawn scenes stay offset_missing and offset_reversed (where one lamp
// alone is hidden, something behind it may hide it as well), fresnel_sides where POV-Ray's rules are followed, and local_unscaled (where
// a surface has no other light than ambient). No drawn scene shows shadow_from_behind (81 % on the written ones) or no_antialiasing (all).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/faults/measure.h"
#include "tests/faults/random_scene.h"

namespace rt::test::faults_test {
namespace {

namespace fs = std::filesystem;

struct Scene {
    const char* name;
    std::vector<std::string> options;
};

const std::vector<Scene> written{
    {"course_shelf", {"-ss=2"}},
    {"course_bubbles", {"-fresnel"}},
    {"course_prism", {"-fresnel", "-beers"}},
    {"course_mirrors", {}},
    {"course_leaf", {}},
    {"course_marble", {"-altbrdf"}},
    {"lamp_table", {"--profile=povray", "--shading=povray"}},
    {"goblets", {"--profile=povray"}},
    {"gem_mesh", {"--profile=povray", "--ss=2"}},
    {"gallery_wall", {"--profile=povray", "--shading=povray"}},
};

const std::vector<std::string> rules_of_drawn[] = {
    {"-fresnel"}, {"--profile=povray", "--shading=povray"}, {"-fresnel", "-beers"}, {"--profile=povray"}, {}};
constexpr unsigned drawn = 15;

constexpr int no_case = -1;  ///< instead of a rate: the fault changes no record

/// Measured rates of right names in percent: of the drawn scenes by JSON, JSON and printrays, JSON and a tree, and of the written ones by
/// JSON.
struct Measured {
    Fault fault;
    int json, printrays, tree, written;
};
constexpr Measured measured[] = {
    {Fault::mirrored, 100, 100, 100, 100},
    {Fault::upside_down, 100, 100, 100, 100},
    {Fault::half_pixel, 100, 100, 100, 100},
    {Fault::normal_side, 100, 96, 96, 100},
    {Fault::triangle_side, 100, 100, 100, 100},
    {Fault::normal_by_matrix, 98, 98, 98, 100},
    {Fault::normal_in_object_space, 93, 93, 93, 100},
    {Fault::normal_unnormalised, 100, 96, 96, 100},
    {Fault::half_unnormalised, 100, 100, 100, 100},
    {Fault::light_unnormalised, 100, 82, 91, 100},
    {Fault::object_space_distance, 96, 96, 96, 95},
    {Fault::offset_missing, 78, 40, 78, 70},
    {Fault::offset_reversed, 75, 22, 75, 84},
    {Fault::no_shadows, 100, 98, 100, 100},
    {Fault::opaque_shadows, 100, 39, 100, 100},
    {Fault::glass_without_shadow, 100, 98, 98, 100},
    {Fault::shadow_from_behind, no_case, no_case, no_case, 81},
    {Fault::unfiltered, 97, 97, 97, 100},
    {Fault::mirror_untinted, 100, 7, 7, 100},
    {Fault::depth_short, 100, 100, 100, 100},
    {Fault::depth_long, 100, 100, 100, 100},
    {Fault::ior_inverted, 100, 71, 71, 100},
    {Fault::unbent, 100, 100, 100, 100},
    {Fault::no_fresnel, 97, 50, 50, 100},
    {Fault::fresnel_sides, 53, 50, 50, 94},
    {Fault::no_absorption, 100, 100, 100, 100},
    {Fault::no_total_reflection, 100, 100, 100, 100},
    {Fault::no_transmission, 98, 98, 98, 96},
    {Fault::no_reflection, 91, 91, 91, 97},
    {Fault::wrong_mirror, 100, 100, 100, 100},
    {Fault::no_ambient, 100, 100, 100, 100},
    {Fault::no_diffuse, 100, 100, 100, 100},
    {Fault::no_specular, 98, 76, 76, 97},
    {Fault::wrong_exponent, 100, 93, 93, 100},
    {Fault::phong_for_blinn, 97, 94, 94, 89},
    {Fault::white_lights, 100, 78, 91, 100},
    {Fault::one_light, 100, 91, 100, 100},
    {Fault::lit_from_behind, 100, 60, 97, 100},
    {Fault::local_unscaled, 85, 85, 85, 96},
    {Fault::no_background, 100, 100, 100, 100},
    {Fault::gamma_twice, 100, 100, 100, 97},
    {Fault::gamma_missing, 100, 100, 100, 75},
    {Fault::no_antialiasing, no_case, no_case, no_case, 100},
    {Fault::black, 0, 0, 0, 0},
};
static_assert(std::size(measured) == 44);

/// The rate is at least the measured one, and there are cases if and only if there were.
void expect_rate(const Count& count, int rate, std::string_view fault) {
    if (rate == no_case)
        EXPECT_EQ(count.cases, 0) << fault;
    else
        EXPECT_GT(count.cases, 0) << fault;
    EXPECT_GE(std::lround(100.0 * count.rate()), rate) << fault;
}

/// Black has no right name. By JSON 38 cases have no usual cause, on the written scenes as on the drawn ones; the others are called a wrong
/// gamma.
void expect_black_unnamed(const std::vector<Tally>& tallies) {
    const Count& count = tallies[static_cast<std::size_t>(Fault::black)].by_form[0];
    EXPECT_EQ(count.named.at(Cause::other), 38);
    EXPECT_EQ(count.named.at(Cause::gamma), count.cases - 38);
    EXPECT_EQ(count.right, 0);
}

int reliable(const std::vector<Tally>& tallies, Form form) {
    return static_cast<int>(std::count_if(tallies.begin(), tallies.end(), [&](const Tally& tally) {
        const Count& count = tally.by_form[static_cast<std::size_t>(form)];
        return count.cases > 0 && count.rate() >= 0.9;
    }));
}

void measure_all(const Subject& subject, int more, unsigned seed, std::vector<Tally>& tallies) {
    const std::vector<std::uint16_t> healthy = subject.picture();
    for (std::size_t i = 0; i < tallies.size(); ++i)
        measure(subject, healthy, static_cast<Fault>(i), more, seed + static_cast<unsigned>(i), tallies[i]);
}

TEST(Faults, ChangePicturesAndAreNamedOnWrittenScenes) {
    std::vector<Tally> tallies(all_faults().size());
    for (unsigned k = 0; k < written.size(); ++k) {
        const std::string file = fmt::format("{}/tests/faults/scenes/{}.pov", PROJECT_ROOT, written[k].name);
        measure_all(Subject(file, written[k].options, 32, 24), 3, 1 + 44 * k, tallies);
    }
    fmt::print("{}", table(tallies));
    for (const Measured& m : measured) {
        const auto i = static_cast<std::size_t>(m.fault);
        EXPECT_GE(tallies[i].pictures, 2) << all_faults()[i].name;
        expect_rate(tallies[i].by_form[0], m.written, all_faults()[i].name);
    }
    expect_black_unnamed(tallies);
    EXPECT_GE(reliable(tallies, Form::json), 38);
}

TEST(Faults, AreNamedOnScenesThatTheRulesHaveNotSeen) {
    const std::string file = testing::TempDir() + fmt::format("raytrace_drawn_{}.pov", getpid());
    std::vector<Tally> tallies(all_faults().size());
    for (unsigned seed = 0; seed < drawn; ++seed) {
        const std::vector<std::string>& options = rules_of_drawn[seed % std::size(rules_of_drawn)];
        const bool course = options.empty() || options[0] == "-fresnel";
        std::ofstream(file) << random_scene_text(course, seed);
        measure_all(Subject(file, options, 32, 24), 2, 100 * seed, tallies);
    }
    fs::remove(file);
    fmt::print("{}", table(tallies));
    for (const Measured& m : measured) {
        const auto i = static_cast<std::size_t>(m.fault);
        const auto& by_form = tallies[i].by_form;
        expect_rate(by_form[0], m.json, all_faults()[i].name);
        expect_rate(by_form[1], m.printrays, all_faults()[i].name);
        expect_rate(by_form[2], m.tree, all_faults()[i].name);
    }
    expect_black_unnamed(tallies);
    EXPECT_GE(reliable(tallies, Form::json), 37);
    EXPECT_GE(reliable(tallies, Form::printrays), 29);
}

std::string contents(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// The picture that a program makes with a value of RAYTRACE_FAULT; its exit status and messages if it makes none.
std::string picture_of(const char* program, const std::string& fault) {
    const std::string base = testing::TempDir() + fmt::format("raytrace_faults_{}", getpid());
    const std::string command =
        fmt::format("RAYTRACE_FAULT={} '{}' render '{}/tests/faults/scenes/course_leaf.pov' 32 24 -o {}.ppm 2> {}.txt", fault, program,
                    PROJECT_ROOT, base, base);
    const int status = std::system(command.c_str());
    const std::string result = status == 0 ? contents(base + ".ppm") : fmt::format("{} {}", WEXITSTATUS(status), contents(base + ".txt"));
    fs::remove(base + ".ppm");
    fs::remove(base + ".txt");
    return result;
}

TEST(FaultyProgram, HasTheFaultsThatAreNamedAndNoOthers) {
    const std::string right = picture_of(PROGRAM, "");
    EXPECT_EQ(right.substr(0, 2), "P6");
    EXPECT_EQ(picture_of(FAULTY_PROGRAM, ""), right);
    const std::string dim = picture_of(FAULTY_PROGRAM, "no_ambient"), both = picture_of(FAULTY_PROGRAM, "no_ambient,mirrored");
    EXPECT_NE(dim, right);
    EXPECT_NE(both, right);
    EXPECT_NE(both, dim);
    EXPECT_EQ(picture_of(FAULTY_PROGRAM, "nonsense").substr(0, 69),
              "1 raytrace_faulty: RAYTRACE_FAULT: unknown fault 'nonsense', expected");
}

TEST(Product, KnowsNothingOfFaults) {
    EXPECT_EQ(picture_of(PROGRAM, "black"), picture_of(PROGRAM, ""));
    EXPECT_EQ(contents(PROGRAM).find("RAYTRACE_FAULT"), std::string::npos);
    EXPECT_NE(contents(FAULTY_PROGRAM).find("RAYTRACE_FAULT"), std::string::npos);
}

}  // namespace
}  // namespace rt::test::faults_test
