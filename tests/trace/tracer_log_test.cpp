// The record of a ray's tree, and what may never come out of the tracer.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/trace/tracer_scene.h"

namespace rt::tracer_log_test {
namespace {

using namespace tracer_test;

Scene glass_over_checker() {
    Finish f = plain(Rgb(0.1), 0.4);
    f.reflection.min = f.reflection.max = Rgb(0.3);
    f.reflection.exponent = 2;
    f.phong = 0.4;
    Interior glass;
    glass.ior = 1.4, glass.fade_distance = 1, glass.fade_power = 2;
    AreaLight area;
    area.axis1 = {1, 0, 0}, area.axis2 = {0, 1, 0}, area.size1 = area.size2 = 3;
    Light lamp = point_light({5, 5, -5}, {0.9, 0.8, 0.7}), soft = point_light({-5, 5, -5}, Rgb(0.4));
    soft.area = area;
    return scene_with(
        {object(Sphere{Vec3(0, 1, 0), 1}, {texture(color({0.8, 0.9, 1}, 0.6, 0.2), f), texture(color({1, 0.9, 0.8}, 0.7), f)}, glass),
         object(floor_plane(), texture(checker(color(Rgb(0.9)), color(Rgb(0.1))), f))},
        {lamp, soft}, {0.2, 0.3, 0.4});
}

TEST(RayLog, contributions_add_up_to_the_radiance_and_change_nothing) {
    Traced t(glass_over_checker());
    for (double x = -2; x < 2; x += 0.037) {
        const Ray ray{{0, 2, -5}, unit(Vec3(x, -0.8, 5))};
        RayLog log;
        const Rgb with = t.tracer->camera_ray(ray, log).rgb;
        EXPECT_EQ(with, t.tracer->camera_ray(ray).rgb);
        EXPECT_RGB_NEAR(log.nodes.front().radiance, with, 1e-13);
        for (std::size_t i = 1; i < log.nodes.size(); ++i) EXPECT_LT(log.nodes[i].parent, i);
    }
}

TEST(Tracer, many_rays_bring_what_each_brings) {
    Traced t(glass_over_checker());
    std::vector<Ray> rays;
    for (double x = -2; x < 2; x += 0.037) rays.push_back({{0, 2, -5}, unit(Vec3(x, 0.4 * x - 0.3, 5))});
    std::vector<Radiance> light(rays.size());
    t.tracer->camera_rays(rays, light);
    EXPECT_EQ(t.tracer->counts().camera, rays.size());
    int background = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Radiance alone = t.tracer->camera_ray(rays[i]);
        EXPECT_EQ(light[i].rgb, alone.rgb) << i;
        EXPECT_EQ(light[i].transmittance, alone.transmittance) << i;
        background += alone.rgb == Rgb(0.2, 0.3, 0.4);
    }
    EXPECT_GT(background, 10);
}

TEST(RayLog, records_the_tree) {
    Traced t(glass_over_checker());
    RayLog log;
    t.tracer->camera_ray({{0, 1, -5}, {0, 0, 1}}, log);
    ASSERT_GE(log.nodes.size(), 4u);
    const RayNode& first = log.nodes[0];
    EXPECT_EQ(first.object, 0u);
    EXPECT_NEAR(first.t, 4.0, 1e-12);
    EXPECT_EQ(first.layers.size(), 2u);
    EXPECT_EQ(first.layers[0], color({1, 0.9, 0.8}, 0.7)) << "the last stated layer is the top one";
    EXPECT_EQ(first.shadows.size(), 10u) << "one lamp and nine samples";
    EXPECT_EQ(first.level, 1);
    int reflected = 0, refracted = 0;
    for (const RayNode& node : log.nodes) {
        reflected += node.kind == RayNode::Kind::reflected && node.parent == 0;
        refracted += node.kind == RayNode::Kind::refracted && node.parent == 0;
    }
    EXPECT_EQ(reflected, 2) << "one for each layer";
    EXPECT_EQ(refracted, 1);
}

TEST(RayLog, shadows_name_what_they_crossed) {
    Traced t(glass_over_checker());
    RayLog log;
    t.tracer->camera_ray({{-1.2, 0.4, 1.2}, {0, -1, 0}}, log);
    ASSERT_FALSE(log.nodes[0].shadows.empty());
    EXPECT_EQ(log.nodes[0].shadows[0].crossed, (std::vector<std::uint32_t>{0, 0}));
}

TEST(Signature, is_the_same_inside_of_a_region_and_changes_across_its_edges) {
    Traced t(glass_over_checker());
    const auto sign = [&](double x, double z) {
        RayLog log;
        t.tracer->camera_ray({{x, 0.7, z}, {0, -1, 0}}, log);
        return signature(log);
    };
    EXPECT_EQ(sign(-7.2, -7.3), sign(-7.7, -7.1));
    EXPECT_NE(sign(-7.2, -7.3), sign(-6.9, -7.3)) << "another cell";
    EXPECT_NE(sign(-1.7, 1.7), sign(-7.7, 9.7)) << "a shadow";
    EXPECT_NE(sign(7.2, 7.2), sign(0.2, 0.2)) << "another object";
}

TEST(Tracer, the_same_ray_gives_the_same_bits_whatever_came_before) {
    Traced a(glass_over_checker()), b(glass_over_checker());
    for (double x = -2; x < 2; x += 0.01) b.look({0, 2, -5}, {x, -1, 5});
    for (double x = -2; x < 2; x += 0.1) EXPECT_EQ(a.look({0, 2, -5}, {x, -0.8, 5}).rgb, b.look({0, 2, -5}, {x, -0.8, 5}).rgb);
}

TEST(Tracer, no_finish_light_or_interior_makes_a_nan) {
    std::mt19937_64 random(7);
    const std::vector<double> odd = {0, 0, 1, 0.5, -0.3, 1.2, 40, 1e-3, 1e30, -2, 1e-300, 1000, 1e-12};
    const auto pick = [&] { return odd[random() % odd.size()]; };
    for (int round = 0; round < 300; ++round) {
        Finish f = plain(Rgb(pick()), pick());
        f.diffuse_back = pick(), f.brilliance = pick(), f.phong = pick(), f.phong_size = pick(), f.specular = pick();
        f.roughness = pick(), f.metallic = pick(), f.conserve_energy = round % 2 == 0;
        f.reflection = {Rgb(pick()), Rgb(pick()), pick(), pick(), pick(), round % 3 == 0};
        Interior interior;
        interior.ior = pick(), interior.caustics = pick(), interior.fade_distance = pick(), interior.fade_power = pick(),
        interior.fade_color = Rgb(pick());
        Light lamp = point_light({pick(), pick(), pick()}, Rgb(pick()));
        lamp.type = static_cast<Light::Type>(random() % 3);
        lamp.parallel = round % 5 == 0;
        lamp.point_at = {pick(), pick(), pick()};
        lamp.radius = pick(), lamp.falloff = pick(), lamp.tightness = pick(), lamp.fade_distance = pick(), lamp.fade_power = pick();
        if (round % 4 == 0) {
            lamp.area = AreaLight{{pick(), 0, 0}, {0, pick(), 0}, 2, 3, {}, round % 8 == 0, round % 16 == 0, round % 12 == 0};
        }
        TraceOptions options;
        if (round % 2 == 0) options = povray_options();
        const Texture t = texture(color(Rgb(pick(), pick(), pick()), pick(), pick()), f);
        Traced traced(scene_with({object(Sphere{Vec3(0, 1, 0), 1}, t, interior), object(floor_plane(), t, interior)}, {lamp}, Rgb(0.5)),
                      options);
        for (double x = -2; x <= 2; x += 0.5) {
            const Rgb seen = traced.look({0, 1, -5}, {x, -0.2, 5}).rgb;
            EXPECT_FALSE(std::isnan(seen.r) || std::isnan(seen.g) || std::isnan(seen.b)) << "round " << round << " " << x;
        }
    }
}

}  // namespace
}  // namespace rt::tracer_log_test
