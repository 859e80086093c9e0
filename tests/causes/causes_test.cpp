// How often the cause of a wrong picture is the right one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "tests/causes/confusion.h"
#include "tests/causes/scene_maker.h"
#include "tests/faults/random_scene.h"

namespace rt::test::causes_test {
namespace {

int from_environment(const char* name, int usual) {
    const char* wanted = std::getenv(name);
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

/// RAYTRACE_CAUSES_WIDTH=320 and RAYTRACE_CAUSES_SCENES=12 for more than the usual tests have time for.
int picture_width() { return from_environment("RAYTRACE_CAUSES_WIDTH", 160); }
unsigned scene_count(int usual) { return static_cast<unsigned>(from_environment("RAYTRACE_CAUSES_SCENES", usual)); }

std::vector<SceneCase> scenes(unsigned first_seed, unsigned count, const std::function<std::string(unsigned)>& text) {
    const std::vector<std::vector<std::string>> options{{}, {"-fresnel"}, {"-ss=3"}, {"-beers"}, {"-altbrdf"}, {}};
    std::vector<SceneCase> cases;
    const int width = picture_width();
    for (unsigned i = 0; i < count; ++i)
        cases.push_back({fmt::format("scene{}", first_seed + i), text(first_seed + i), options[i % options.size()], width, width * 3 / 4});
    return cases;
}

/// Mirrors that face each other: the only scene here that is deep.
const char* const corridor = R"(camera { location <0, 0.5, 3> up <0, 1, 0> right <0, 0, 1.3333> look_at <3, 0.2, 2> }
light_source { <0.5, 2.5, 5> color rgb <1.1, 1, 0.9> }
plane { <1, 0, 0>, -2 pigment { color rgb <0.95, 0.97, 1> } finish { ambient 0.02 diffuse 0.05 reflection 0.95 } }
plane { <-1, 0, 0>, -2.4 pigment { color rgb <1, 0.97, 0.95> } finish { ambient 0.02 diffuse 0.05 reflection 0.95 } }
plane { <0, 1, 0>, -1.2 pigment { color rgb <0.5, 0.6, 0.4> } finish { ambient 0.2 diffuse 0.6 } }
plane { <0, 0, 1>, -4 pigment { color rgb <0.6, 0.5, 0.8> } finish { ambient 0.3 diffuse 0.5 } }
sphere { <0.3, -0.2, 0>, 0.9 pigment { color rgb <0.9, 0.4, 0.3> } finish { ambient 0.2 diffuse 0.6 specular 0.6 roughness 0.2 } }
)";

/// The rules were made while looking at scenes drawn by scene_maker.h.
TEST(Causes, OfTheScenesThatTheRulesWereMadeFor) {
    std::vector<SceneCase> cases = scenes(1, scene_count(3), random_scene);
    cases.push_back({"corridor", corridor, {}, picture_width(), picture_width() * 3 / 4});
    Confusion confusion(cases);
    confusion.run();
    fmt::print("{}", confusion.table());
    EXPECT_GE(confusion.right(), 0.9 * confusion.asked());
}

/// These are drawn by other rules, and nobody looked at them.
TEST(Causes, OfScenesThatTheRulesHaveNotSeen) {
    Confusion confusion(scenes(9101, scene_count(5), [](unsigned seed) { return random_scene_text(true, seed); }));
    confusion.run();
    fmt::print("{}", confusion.table());
    EXPECT_GE(confusion.right(), 0.9 * confusion.asked());
}

/// Scenes of the course that may lie beside the project, without options.
TEST(Causes, OfTheCoursesScenes) {
    const std::filesystem::path folder = std::filesystem::path(PROJECT_ROOT) / "../shared/csc473/inputs";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the course's files are not beside the project";
    std::vector<SceneCase> cases;
    for (const char* name : {"simple_reflect2", "simple_refract", "transforms1", "valentine2", "box2", "specular"}) {
        std::stringstream text;
        text << std::ifstream(folder / (std::string(name) + ".pov")).rdbuf();
        cases.push_back({name, text.str(), {}, picture_width(), picture_width() * 3 / 4});
    }
    Confusion confusion(cases);
    confusion.run();
    fmt::print("{}", confusion.table());
    EXPECT_GE(confusion.right(), 0.9 * confusion.asked());
}

}  // namespace
}  // namespace rt::test::causes_test
