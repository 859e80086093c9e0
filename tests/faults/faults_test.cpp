// explain names faults of a tracer: every fault of faults.py on every scene that is its subject, at pixels that a rule chooses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/faults/measure.h"
#include "tests/faults/random_scene.h"

namespace rt::test {
namespace {

struct Scene {
    const char* name;
    std::vector<std::string> options;
};

/// Written before the rules were looked at.
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

TEST(Faults, Written) {
    std::vector<Tally> tallies(all_faults().size());
    unsigned seed = 0;
    for (const Scene& scene : written) {
        const Subject subject(fmt::format("{}/tests/faults/scenes/{}.pov", PROJECT_ROOT, scene.name), scene.options, 32, 24);
        const std::vector<std::uint16_t> healthy = subject.picture();
        for (std::size_t i = 0; i < tallies.size(); ++i) measure(subject, healthy, static_cast<Fault>(i), 3, ++seed, tallies[i]);
    }
    fmt::print("{}", table(tallies));
}

TEST(Faults, Drawn) {
    const std::vector<std::string> rules[] = {
        {"-fresnel"}, {"--profile=povray", "--shading=povray"}, {"-fresnel", "-beers"}, {"--profile=povray"}, {}};
    std::vector<Tally> tallies(all_faults().size());
    for (unsigned seed = 0; seed < 15; ++seed) {
        const std::vector<std::string>& options = rules[seed % std::size(rules)];
        const bool course = options.empty() || options[0] == "-fresnel";
        const std::string file = testing::TempDir() + fmt::format("raytrace_fault_{}.pov", seed);
        std::ofstream(file) << random_scene_text(course, seed);
        const Subject subject(file, options, 32, 24);
        const std::vector<std::uint16_t> healthy = subject.picture();
        for (std::size_t i = 0; i < tallies.size(); ++i)
            measure(subject, healthy, static_cast<Fault>(i), 2, seed * 100 + static_cast<unsigned>(i), tallies[i]);
    }
    fmt::print("{}", table(tallies));
}

}  // namespace
}  // namespace rt::test
