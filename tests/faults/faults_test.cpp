// explain names faults of a tracer: every fault of faults.py on every scene that is its subject, at pixels that a rule chooses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/faults/measure.h"

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

}  // namespace
}  // namespace rt::test
