// What the course's commands print, from records made by hand.
#include "commands/pixel/course_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "commands/pixel/told_pixel_file.h"

namespace rt::course_text_test {
namespace {

TEST(CourseNumbers, HaveFourDecimals) {
    EXPECT_EQ(number_text(1.0), "1.0000");
    EXPECT_EQ(number_text(-2.34564), "-2.3456");
    EXPECT_EQ(number_text(1234567.89012), "1234567.8901");
}

TEST(CourseNumbers, RoundHalvesAwayFromZeroWhateverTheirBits) {
    EXPECT_EQ(number_text(0.24275), "0.2428");  // the nearest double is below
    EXPECT_EQ(number_text(0.192 + 0.00075), "0.1928");
    EXPECT_EQ(number_text(-0.24275), "-0.2428");
    EXPECT_EQ(number_text(0.2427499), "0.2427");
    EXPECT_EQ(number_text(14.244549999), "14.2445");
}

TEST(CourseNumbers, KeepTheSignOfZero) {
    EXPECT_EQ(number_text(0.0), "0.0000");
    EXPECT_EQ(number_text(-0.0), "-0.0000");
    EXPECT_EQ(number_text(-0.00001), "-0.0000");
    EXPECT_EQ(vector_text(Vec3(0, -1e-9, 2)), "{0.0000 -0.0000 2.0000}");
}

TEST(CourseNumbers, AreWhatPrintingWithFourDecimalsGives) {
    const auto expect_printed = [](double x) {
        EXPECT_EQ(number_text(x), fmt::format("{:.4f}", x * (1.0 + 1e-12))) << fmt::format("{:a}", x);
    };
    std::mt19937_64 random(7);
    for (int i = 0; i < 20000; ++i) {
        expect_printed(std::bit_cast<double>(random()));                                   // any double, infinities and NaN among them
        expect_printed(std::ldexp(static_cast<double>(random()), i % 160 - 140));          // near the sizes of scenes
        expect_printed(static_cast<double>(random() % 4000000) / 20000.0);                 // halves of the last digit
        expect_printed(std::nextafter(static_cast<double>(random() % 4000000) / 1e4, 1));  // and whole ones
    }
    for (const double x : {99999999.99995, 1e8, 1e12, 1e300, 4e-5, 5e-5, 0.99995, 0.99994999999}) expect_printed(x), expect_printed(-x);
}

class CourseText : public testing::Test {
protected:
    CourseText() {
        Object sphere, plane;
        sphere.shape = Sphere{Vec3(0.0), 1.0};
        sphere.transform = Transform::scale(Vec3(1, 2, 4)).then(Transform::translate(Vec3(1, 0, 0)));
        plane.shape = Plane{};
        plane.transform = Transform::translate(Vec3(0.0));
        scene.objects = {sphere, plane};
        RayNode camera = surface(0, {{0, 0, 8}, {0, 0, -1}}, 4.0);
        camera.ambient = Rgb(0.1, 0.2, 0.3), camera.radiance = Rgb(0.6, 0.5, 0.4);
        camera.reflection = Rgb(0.25), camera.refraction = Rgb(0.125);
        camera.shares = RayNode::Shares{0.25, 0.25, 0.5};
        camera.shadows = {{0, 0, Rgb(1.0), {}}, {1, 0, Rgb(0.0), {}}};
        RayNode mirrored = surface(1, {{0, 0, 4}, {0, 1, 0}}, 2.0);
        mirrored.parent = 0, mirrored.kind = RayNode::Kind::reflected, mirrored.shares.emplace();
        RayNode in = surface(0, {{0, 0, 4}, {0, 0, -1}}, 8.0);
        in.parent = 0, in.kind = RayNode::Kind::refracted, in.inside = true, in.shares = RayNode::Shares{0, 0, 1};
        RayNode out;
        out.ray = {{0, 0, -4}, {0, 0, -1}};
        out.parent = 2, out.kind = RayNode::Kind::refracted, out.end = RayNode::End::background;
        log.nodes = {camera, mirrored, in, out};
    }
    static RayNode surface(std::uint32_t object, const Ray& ray, double t) {
        RayNode node;
        node.object = object;
        node.ray = ray;
        node.t = t;
        node.point = ray.at(t);
        node.normal = Vec3(0, 0, 1);
        node.layers = {{Rgb(1, 0.5, 0.25), 0.0, 0.0}};
        return node;
    }
    Scene scene;
    RayLog log;
    const PixelName pixel{3, 4, {153, 128, 102}};
};

TEST_F(CourseText, OfOneRay) {
    EXPECT_EQ(pixelray_text(pixel, {{0, 0, 8}, {0, 0.6, -0.8}}), "Pixel: [3, 4] Ray: {0.0000 0.0000 8.0000} -> {0.0000 0.6000 -0.8000}\n");
    EXPECT_EQ(firsthit_text(pixel, scene, log.nodes[0]),
              "Pixel: [3, 4] Ray: {0.0000 0.0000 8.0000} -> {0.0000 0.0000 -1.0000}\n"
              "T = 4.0000\n"
              "Object Type: Sphere\n"
              "Color: 1.0000 0.5000 0.2500\n");
    EXPECT_EQ(pixelcolor_text(pixel, scene, log.nodes[0], "Blinn-Phong"),
              "Pixel: [3, 4] Ray: {0.0000 0.0000 8.0000} -> {0.0000 0.0000 -1.0000}\n"
              "T = 4.0000\n"
              "Object Type: Sphere\n"
              "BRDF: Blinn-Phong\n"
              "Color: (153, 128, 102)\n");
    const std::string none = "Pixel: [3, 4] Ray: {0.0000 0.0000 -4.0000} -> {0.0000 0.0000 -1.0000}\nNo Hit\n";
    EXPECT_EQ(firsthit_text(pixel, scene, log.nodes[3]), none);
    EXPECT_EQ(pixelcolor_text(pixel, scene, log.nodes[3], "Blinn-Phong"), none);
}

TEST_F(CourseText, OfATreeRayByRay) {
    EXPECT_EQ(printrays_text(pixel, scene, {&log, 1}),
              "Pixel: [3, 4] Color: (153, 128, 102)\n"
              "----\n"
              "  Iteration type: Primary\n"
              "             Ray: {0.0000 0.0000 8.0000} -> {0.0000 0.0000 -1.0000}\n"
              " Transformed Ray: {-1.0000 0.0000 2.0000} -> {0.0000 0.0000 -0.2500}\n"
              "      Hit Object: (ID #1 - Sphere)\n"
              "    Intersection: {0.0000 0.0000 4.0000} at T = 4.0000\n"
              "          Normal: {0.0000 0.0000 1.0000}\n"
              "     Final Color: {0.6000 0.5000 0.4000}\n"
              "         Ambient: {0.1000 0.2000 0.3000}\n"
              "         Diffuse: {0.0000 0.0000 0.0000}\n"
              "        Specular: {0.0000 0.0000 0.0000}\n"
              "      Reflection: {0.2500 0.2500 0.2500}\n"
              "      Refraction: {0.1250 0.1250 0.1250}\n"
              "   Contributions: 0.2500 Local, 0.2500 Reflection, 0.5000 Transmission\n"
              "----\n"
              "  Iteration type: Reflection\n"
              "             Ray: {0.0000 0.0000 4.0000} -> {0.0000 1.0000 0.0000}\n"
              "      Hit Object: (ID #2 - Plane)\n"
              "    Intersection: {0.0000 2.0000 4.0000} at T = 2.0000\n"
              "          Normal: {0.0000 0.0000 1.0000}\n"
              "     Final Color: {0.0000 0.0000 0.0000}\n"
              "         Ambient: {0.0000 0.0000 0.0000}\n"
              "         Diffuse: {0.0000 0.0000 0.0000}\n"
              "        Specular: {0.0000 0.0000 0.0000}\n"
              "      Reflection: {0.0000 0.0000 0.0000}\n"
              "      Refraction: {0.0000 0.0000 0.0000}\n"
              "   Contributions: 1.0000 Local, 0.0000 Reflection, 0.0000 Transmission\n"
              "----\n"
              "  Iteration type: Refraction\n"
              "             Ray: {0.0000 0.0000 4.0000} -> {0.0000 0.0000 -1.0000}\n"
              " Transformed Ray: {-1.0000 0.0000 1.0000} -> {0.0000 0.0000 -0.2500}\n"
              "      Hit Object: (ID #1 - Sphere)\n"
              "    Intersection: {0.0000 0.0000 -4.0000} at T = 8.0000\n"
              "          Normal: {0.0000 0.0000 1.0000}\n"
              "     Final Color: {0.0000 0.0000 0.0000}\n"
              "         Ambient: {0.0000 0.0000 0.0000}\n"
              "         Diffuse: {0.0000 0.0000 0.0000}\n"
              "        Specular: {0.0000 0.0000 0.0000}\n"
              "      Reflection: {0.0000 0.0000 0.0000}\n"
              "      Refraction: {0.0000 0.0000 0.0000}\n"
              "   Contributions: 0.0000 Local, 0.0000 Reflection, 1.0000 Transmission\n"
              "      Extra Info: into-object\n"
              "----\n"
              "  Iteration type: Refraction\n"
              "             Ray: {0.0000 0.0000 -4.0000} -> {0.0000 0.0000 -1.0000}\n"
              "  No intersection.\n"
              "      Extra Info: into-air\n"
              "\n\n"
              "--------------------------------------------------------------------------------\n\n");
}

TEST_F(CourseText, ReadBackTellsTheSideThatARefractedRayLeaves) {
    Sources sources;
    sources.add({"rays.txt", printrays_text({0, 0, {}}, scene, std::span(&log, 1))});
    const ToldPixel told = told_pixel_of_text(sources);
    EXPECT_TRUE(told.rounded);
    const std::vector<ToldRay>& rays = told.samples.at(0);
    EXPECT_EQ(rays.at(0).hit->inside, false);
    EXPECT_EQ(rays.at(1).hit->inside, std::nullopt);  // a mirror does not say
    EXPECT_EQ(rays.at(2).hit->inside, true);
}

TEST_F(CourseText, OfATreeDrawn) {
    log.nodes[0].shares.reset();  // another shading has none
    log.nodes[1].object = RayNode::none;
    log.nodes[1].end = RayNode::End::weight;
    EXPECT_EQ(pixeltrace_text(pixel, scene, {&log, 1}),
              "Pixel: [3, 4] Color: (153, 128, 102)\n"
              "o - Iteration type: Primary\n"
              "|              Ray: {0.0000 0.0000 8.0000} -> {0.0000 0.0000 -1.0000}\n"
              "|  Transformed Ray: {-1.0000 0.0000 2.0000} -> {0.0000 0.0000 -0.2500}\n"
              "|       Hit Object: (ID #1 - Sphere)\n"
              "|     Intersection: {0.0000 0.0000 4.0000} at T = 4.0000\n"
              "|           Normal: {0.0000 0.0000 1.0000}\n"
              "|      Final Color: {0.6000 0.5000 0.4000}\n"
              "|          Ambient: {0.1000 0.2000 0.3000}\n"
              "|          Diffuse: {0.0000 0.0000 0.0000}\n"
              "|         Specular: {0.0000 0.0000 0.0000}\n"
              "|       Reflection: {0.2500 0.2500 0.2500}\n"
              "|       Refraction: {0.1250 0.1250 0.1250}\n"
              "|       Shadow Ray: Light[0] arrives\n"
              "|       Shadow Ray: Light[1] is hidden\n"
              "|\\\n"
              "| o - Iteration type: Reflection\n"
              "|                Ray: {0.0000 0.0000 4.0000} -> {0.0000 1.0000 0.0000}\n"
              "|     Not followed: too faint to matter.\n"
              " \\\n"
              "  o - Iteration type: Refraction\n"
              "  |              Ray: {0.0000 0.0000 4.0000} -> {0.0000 0.0000 -1.0000}\n"
              "  |  Transformed Ray: {-1.0000 0.0000 1.0000} -> {0.0000 0.0000 -0.2500}\n"
              "  |       Hit Object: (ID #1 - Sphere)\n"
              "  |     Intersection: {0.0000 0.0000 -4.0000} at T = 8.0000\n"
              "  |           Normal: {0.0000 0.0000 1.0000}\n"
              "  |      Final Color: {0.0000 0.0000 0.0000}\n"
              "  |          Ambient: {0.0000 0.0000 0.0000}\n"
              "  |          Diffuse: {0.0000 0.0000 0.0000}\n"
              "  |         Specular: {0.0000 0.0000 0.0000}\n"
              "  |       Reflection: {0.0000 0.0000 0.0000}\n"
              "  |       Refraction: {0.0000 0.0000 0.0000}\n"
              "  |    Contributions: 0.0000 Local, 0.0000 Reflection, 1.0000 Transmission\n"
              "  |       Extra Info: into-object\n"
              "   \\\n"
              "    o - Iteration type: Refraction\n"
              "                   Ray: {0.0000 0.0000 -4.0000} -> {0.0000 0.0000 -1.0000}\n"
              "        No intersection.\n"
              "            Extra Info: into-air\n"
              "\n"
              "--------------------------------------------------------------------------------\n\n");
}

}  // namespace
}  // namespace rt::course_text_test
