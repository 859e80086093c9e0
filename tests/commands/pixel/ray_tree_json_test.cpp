// The rays of a pixel as JSON: the record's own numbers to the last bit, in every profile and shading.
#include "commands/pixel/ray_tree_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::ray_tree_json_test {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

const std::string deep_scene = std::string("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 9 }\n") + test::glass_scene;

Vec3 vector(const json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

TEST(RayTreeJson, HasTheRecordsNumbersToTheLastBit) {
    TracedPixel pixel;
    pixel.scene.objects.resize(1);
    pixel.scene.objects[0].shape = Sphere{Vec3(0.0), 1.0};
    RayNode node;
    node.object = 0;
    node.ray = {{0.1, 1.0 / 3.0, -0.0}, {5e-324, 1e300, std::nextafter(1.0, 2.0)}};
    node.t = 2.0 / 3.0;
    node.radiance = {std::sqrt(2.0), pi, 1e-9};
    pixel.rays.samples.emplace_back().nodes = {node};
    const json ray = json::parse(ray_tree_json(pixel)).at("samples").at(0).at(0);
    EXPECT_EQ(vector(ray.at("origin")), node.ray.origin);
    EXPECT_TRUE(std::signbit(ray.at("origin").at(2).get<double>()));
    EXPECT_EQ(vector(ray.at("direction")), node.ray.direction);
    EXPECT_EQ(ray.at("hit").at("t").get<double>(), node.t);
    EXPECT_EQ(vector(ray.at("radiance")), node.radiance);
    EXPECT_TRUE(ray.at("parent").is_null());
    EXPECT_FALSE(ray.contains("shares"));
    EXPECT_FALSE(ray.at("hit").contains("object_ray"));
}

TEST(RayTreeJson, NamesNumbersThatAreNotFinite) {
    TracedPixel pixel;
    RayNode node;
    node.end = RayNode::End::background;
    node.background = {infinity, -infinity, std::nan("")};
    pixel.rays.samples.emplace_back().nodes = {node};
    const json ray = json::parse(ray_tree_json(pixel)).at("samples").at(0).at(0);
    EXPECT_EQ(ray.at("background"), (json{"Infinity", "-Infinity", "NaN"}));
    EXPECT_EQ(ray.at("end"), "background");
    EXPECT_FALSE(ray.contains("hit"));
}

class RayTreeProgram : public testing::Test {
protected:
    RayTreeProgram() { here.write("a.pov", deep_scene); }
    json tree(const Words& options, const char* command = "pixeltrace") {
        Words words{command, "a.pov", "40", "32", "17", "20", "--json"};
        words.insert(words.end(), options.begin(), options.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return json::parse(outcome.out);
    }
    test::Workplace here;
};

/// The bytes of a pixel of a.png, counted from the top left.
json bytes_of_picture(int x, int y) {
    const StoredImage image = read_image("a.png");
    const auto first = static_cast<std::size_t>((y * image.width + x) * image.channels);
    return {image.values.at(first), image.values.at(first + 1), image.values.at(first + 2)};
}

TEST_F(RayTreeProgram, TellsOfThePicturesPixelInEveryProfileAndShading) {
    for (const Words& options : std::vector<Words>{{"--profile=csc473"},
                                                   {"--profile=povray"},
                                                   {"--profile=povray", "--shading=povray"},
                                                   {"--profile=povray", "--material=shiny-gold"},
                                                   {"--profile=povray", "--ss=2"}}) {
        Words render{"a.pov", "--size=40x32", "-q", "-o", "a.png"};
        render.insert(render.end(), options.begin(), options.end());
        ASSERT_EQ(run(render).status, 0);
        const json got = tree(options);
        const bool course = options[0] == "--profile=csc473";
        EXPECT_EQ(got.at("pixel").at("origin"), course ? "bottom left" : "top left");
        EXPECT_EQ(got.at("pixel").at("color"), bytes_of_picture(17, course ? 31 - 20 : 20)) << options.back();
        EXPECT_EQ(got.at("profile"), course ? "csc473" : "povray");
        EXPECT_EQ(got.at("samples").size(), options.back() == "--ss=2" ? 4u : 1u);
        EXPECT_EQ(tree(options, "printrays"), got);
    }
}

TEST_F(RayTreeProgram, ContributionsSumToTheRadianceAndParentsComeFirst) {
    for (const char* option : {"--profile=csc473", "--shading=povray", "--profile=povray"}) {
        const json rays = tree({option}).at("samples").at(0);
        ASSERT_GT(rays.size(), 2u);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Vec3 sum(0.0);
            for (const char* part : {"ambient", "diffuse", "specular", "reflection", "refraction", "background"})
                sum += vector(rays[i].at(part));
            EXPECT_LT(length(sum - vector(rays[i].at("radiance"))), 1e-12) << option << " ray " << i;
            if (i > 0) {
                EXPECT_LT(rays[i].at("parent").get<std::size_t>(), i);
            }
            EXPECT_EQ(rays[i].contains("hit"), rays[i].at("end") == "surface");
            EXPECT_EQ(rays[i].contains("shares"), rays[i].contains("hit") && option == std::string("--profile=csc473"));
        }
    }
}

TEST_F(RayTreeProgram, TheScenesDepthCountsUnderPovraysProfile) {
    const auto deepest = [](const json& tree) {
        int level = 0;
        for (const json& ray : tree.at("samples").at(0)) level = std::max(level, ray.at("level").get<int>());
        return level;
    };
    here.write("a.pov", deep_scene + "global_settings { max_trace_level 2 }\n");
    EXPECT_EQ(deepest(tree({"--profile=povray"})), 3);  // the last one is not followed
    EXPECT_GT(deepest(tree({"--shading=povray"})), 3);
}

TEST_F(RayTreeProgram, GoesWithTheTwoCommandsThatTellOfAllRays) {
    EXPECT_EQ(run({"pixelray", "a.pov", "8", "6", "1", "1", "--json"}).err,
              "raytrace: option '--json' goes with printrays and pixeltrace\n");
    EXPECT_EQ(run({"pixeltrace", "a.pov", "8", "6", "1", "1", "--jsn"}).err, "raytrace: unknown option '--jsn'; did you mean '--json'?\n");
}

}  // namespace
}  // namespace rt::ray_tree_json_test
