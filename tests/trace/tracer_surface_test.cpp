// Finishes and the surface procedure: pixels that POV-Ray 3.7 measured, and closed forms.
#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"

namespace rt::tracer_surface_test {
namespace {

using namespace tracer_test;

// ---- pixels of POV-Ray 3.7 itself: 16x12, linear, 16 bits ----

Scene golden_scene(const Finish& finish, const PigmentColor& pigment, const Interior& interior) {
    Finish floor = plain(Rgb(0.2), 0.5);
    Scene s = scene_with({object(floor_plane(-1), texture(checker(color(Rgb(0.9)), color(Rgb(0.2))), floor)),
                          object(Sphere{Vec3(0.0), 1.0}, texture(pigment, finish), interior)},
                         {point_light({4, 6, -5}, {0.9, 0.8, 0.7})}, {0.3, 0.5, 0.7});
    s.camera.location = {0, 1, -5};
    s.camera.look_at = Vec3(0, 0.3, 0);
    s.camera.right = {4.0 / 3.0, 0, 0};
    return s;
}

void expect_golden(Traced&& t, const Rgb& p85, const Rgb& p97) {
    EXPECT_RGB_NEAR(t.pixel(8, 5, 16, 12).rgb, p85, 1.01e-5);
    EXPECT_RGB_NEAR(t.pixel(9, 7, 16, 12).rgb, p97, 1.01e-5);
    EXPECT_RGB_NEAR(t.pixel(6, 4, 16, 12).rgb, Rgb(0.20063, 0.19834, 0.19605), 1.01e-5);
    EXPECT_RGB_NEAR(t.pixel(12, 9, 16, 12).rgb, Rgb(0.11334, 0.10520, 0.09705), 1.01e-5);
}

const PigmentColor golden_pigment = color({0.5, 0.4, 0.3});

TEST(GoldenPixels, matte) {
    expect_golden(Traced(golden_scene(Finish{}, golden_pigment, {})), {0.29694, 0.21561, 0.14524}, {0.20127, 0.14757, 0.10059});
}

TEST(GoldenPixels, shiny) {
    Finish f;
    f.phong = 0.5, f.phong_size = 20, f.specular = 0.3, f.roughness = 0.02;
    expect_golden(Traced(golden_scene(f, golden_pigment, {})), {0.56779, 0.45635, 0.35590}, {0.20127, 0.14757, 0.10059});
}

TEST(GoldenPixels, mirror) {
    Finish f;
    f.reflection.min = Rgb(0.1), f.reflection.max = Rgb(0.8);
    expect_golden(Traced(golden_scene(f, golden_pigment, {})), {0.36167, 0.32348, 0.29627}, {0.23749, 0.18114, 0.13150});
}

TEST(GoldenPixels, glass) {
    Finish f = plain(Rgb(0.0), 0.05);
    f.reflection.max = Rgb(1.0), f.reflection.fresnel = true, f.conserve_energy = true, f.specular = 0.4, f.roughness = 0.01;
    Interior interior;
    interior.ior = 1.5, interior.fade_distance = 1, interior.fade_power = 1001, interior.fade_color = {0.6, 0.9, 0.8};
    expect_golden(Traced(golden_scene(f, color({0.95, 0.98, 1}, 0.9), interior)), {0.12131, 0.14540, 0.13449}, {0.11220, 0.31829, 0.38596});
}

// ---- closed forms ----

TEST(LocalLight, ambient_emission_and_diffuse_of_a_lit_plane) {
    Finish f = plain({0.2, 0.4, 0.6}, 0.8);
    f.emission = {0.01, 0.02, 0.03};
    f.brilliance = 3.5;
    Scene s = scene_with({object(floor_plane(), texture(color({0.5, 0.25, 1.0}), f))}, {point_light({0, 4, 0}, {0.9, 0.6, 0.3})});
    s.settings.ambient_light = {2, 1, 0.5};
    Traced t(std::move(s));
    for (const double x : {0.0, 1.0, 3.0, 20.0}) {
        const double cosine = 4 / std::hypot(4.0, x), diffuse = 0.8 * std::pow(cosine, 3.5);
        const Rgb want = {0.5 * (0.4 + 0.01 + diffuse * 0.9), 0.25 * (0.4 + 0.02 + diffuse * 0.6), 0.3 + 0.03 + diffuse * 0.3};
        EXPECT_RGB_NEAR(t.look({x, 1, 0}, {0, -1, 0}).rgb, want, 1e-12);
        EXPECT_RGB_NEAR(t.look({x, 5, 0}, {0, -1, 0}).rgb, want, 1e-12);
    }
    EXPECT_RGB_NEAR(t.look({0, -1, 0}, {0, 1, 0}).rgb, Rgb(0.5 * 0.41, 0.25 * 0.42, 0.33), 1e-12) << "the light is behind";
}

TEST(LocalLight, back_diffuse_and_double_illumination) {
    Finish f = plain(Rgb(0.0), 0.5);
    f.diffuse_back = 0.3;
    f.phong = 0.7;
    Traced back(scene_with({object(Disc{Vec3(0.0), Vec3(0, 1, 0), 1, 0}, texture(color(Rgb(1.0)), f))}, {point_light({0, 4, 3})}));
    EXPECT_RGB_NEAR(back.look({0, -1, 0}, {0, 1, 0}).rgb, Rgb(0.3 * 0.8), 1e-12);
    f.diffuse_back = 0.0;
    Object both = object(Disc{Vec3(0.0), Vec3(0, 1, 0), 1, 0}, texture(color(Rgb(1.0)), f));
    both.double_illuminate = true;
    Traced t(scene_with({both}, {point_light({0, 4, 3})}));
    EXPECT_RGB_NEAR(t.look({0, -1, 0}, {0, 1, 0}).rgb, Rgb(0.5 * 0.8), 1e-12);
}

TEST(LocalLight, highlights_do_not_depend_on_opacity_and_metallic_tints_them) {
    Finish f = plain();
    f.phong = 0.5, f.phong_size = 3, f.specular = 0.25, f.roughness = 0.1;
    const Vec3 light{3, 4, 0};
    const Object clear = object(Disc{Vec3(0.0), Vec3(0, 1, 0), 1, 0}, texture(color({1, 0.5, 0}, 0.0, 1.0), f));
    Traced t(scene_with({clear}, {point_light(light)}));
    const Vec3 l = unit(light), v(0, 1, 0), h = unit(l + v);
    const double want = 0.5 * std::pow(l.y, 3) + 0.25 * std::pow(h.y, 10);
    EXPECT_RGB_NEAR(t.look({0, 5, 0}, {0, -1, 0}).rgb, Rgb(want), 1e-12);

    f.metallic = 0.5;
    Traced metal(scene_with({object(Disc{Vec3(0.0), Vec3(0, 1, 0), 1, 0}, texture(color({1, 0.5, 0}), f))}, {point_light(light)}));
    const double x = std::acos(l.y) / (pi / 2), F = 0.014567225 / sqr(x - 1.12) - 0.011612903;
    EXPECT_RGB_NEAR(metal.look({0, 5, 0}, {0, -1, 0}).rgb, want * Rgb(1, 1 - 0.25 * (1 - F), 1 - 0.5 * (1 - F)), 1e-12);
}

TEST(LocalLight, negative_coefficients_of_lobes_mean_none) {
    Finish f = plain(Rgb(0.5), -0.4);
    f.phong = -0.3, f.specular = -0.3, f.diffuse_back = -0.2;
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(1.0)), f))}, {point_light({1, 4, 0}), point_light({0, -4, 0})}));
    EXPECT_EQ(t.look({0, 1, 0}, {0, -1, 0}).rgb, Rgb(0.5));
}

TEST(LocalLight, layers_filter_what_lies_below) {
    const Finish f = plain(Rgb(1.0));
    const PigmentColor bottom = color({0.2, 0.4, 0.6}), top = color({0.8, 0.5, 0.3}, 0.3, 0.2);
    Traced t(scene_with({object(floor_plane(), {texture(bottom, f), texture(top, f)})}));
    const Rgb W = 0.3 * top.rgb + Rgb(0.2);
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0.3, -1, 0.2}).rgb, 0.5 * top.rgb + W * bottom.rgb, 1e-12);
}

TEST(LocalLight, opacity_before_language_version_3_7) {
    Scene s = scene_with({object(floor_plane(), texture(color({0.2, 0.5, 0.1}, 0.4, 0.3), plain(Rgb(1.0))))});
    s.language_version = 3.6;
    Traced t(std::move(s));
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0, -1, 0}).rgb, (1 - (0.4 * 0.5 + 0.3)) * Rgb(0.2, 0.5, 0.1), 1e-12);
}

TEST(LocalLight, interior_texture_is_seen_from_inside) {
    Object o = object(Sphere{Vec3(0.0), 2.0}, texture(color({1, 0, 0}), plain(Rgb(1.0))));
    o.interior_texture = TextureLayers(std::vector<Texture>{texture(color({0, 1, 0}), plain(Rgb(1.0)))});
    Traced t(scene_with({o}));
    EXPECT_EQ(t.look({0, 0, 0}, {1, 2, 3}).rgb, Rgb(0, 1, 0));
    EXPECT_EQ(t.look({0, 0, -5}, {0, 0, 1}).rgb, Rgb(1, 0, 0));
}

// ---- the general form ----

long double naive_lobe(const Vec3& n, const Vec3& l, const Vec3& v, long double alpha) {
    const Vec3 h = unit(l + v);
    const long double nl = dot(n, l), nv = dot(n, v), nh = dot(n, h), a2 = alpha * alpha;
    const long double D = a2 / (static_cast<long double>(pi) * sqr(nh * nh * (a2 - 1) + 1));
    const auto G1 = [&](long double c) { return 2 / (1 + std::sqrt(1 + a2 * (1 - c * c) / (c * c))); };
    return D * G1(nl) * G1(nv) / (4 * nv);
}

TEST(GeneralForm, diffuse_and_microfacet_shares) {
    Finish f = plain(Rgb(0.1), 0.6);
    f.specular = 0.7, f.roughness = 0.5, f.phong = 0.2;
    TraceOptions options;
    Interior glass;
    glass.ior = 2.0;
    const Rgb pigment(0.9, 0.5, 0.2);
    Traced t(scene_with({object(floor_plane(), texture(color(pigment), f), glass)}, {point_light({3, 4, 0}, {0.9, 0.8, 0.7})}), options);
    const Vec3 n(0, 1, 0), l = unit(Vec3(3, 4, 0)), v = unit(Vec3(-3, 4, 1));
    const double f0 = 1.0 / 9.0, c = dot(l, unit(l + v)), F = f0 + (1 - f0) * std::pow(1 - c, 5);
    const double spec = 0.7 * static_cast<double>(naive_lobe(n, l, v, 0.25)) * F;
    const double phong_cos = dot(2.0 * v.y * n - v, l);
    const Rgb want = 0.1 * pigment + Rgb(0.9, 0.8, 0.7) * (0.3 * 0.6 * 0.8 * pigment + Rgb(spec + 0.2 * std::pow(phong_cos, 40)));
    EXPECT_RGB_NEAR(t.look(v, -v).rgb, want, 1e-12);

    f.metallic = 1.0;
    f.phong = 0.0;
    Traced metal(scene_with({object(floor_plane(), texture(color(pigment), f), glass)}, {point_light({3, 4, 0})}), options);
    const Rgb F_metal = f0 * pigment + (Rgb(1.0) - f0 * pigment) * std::pow(1 - c, 5);
    EXPECT_RGB_NEAR(metal.look(v, -v).rgb, 0.1 * pigment + 0.3 * 0.6 * 0.8 * pigment + spec / F * F_metal, 1e-12);
}

TEST(GeneralForm, equals_povray_where_no_finish_has_specular) {
    Finish f = plain(Rgb(0.1), 0.6);
    f.phong = 0.5, f.brilliance = 2, f.reflection.min = f.reflection.max = Rgb(0.2);
    const auto scene = [&] {
        return scene_with({object(Sphere{Vec3(0.0), 1.0}, texture(color({0.9, 0.5, 0.2}, 0.2, 0.1), f)),
                           object(floor_plane(-1), texture(color(Rgb(0.5)), f))},
                          {point_light({3, 4, -5})}, {0.1, 0.2, 0.3});
    };
    TraceOptions general = povray_options();
    general.shading = ShadingModel::general;
    Traced a(scene(), general), b(scene());
    for (double x = -2.0; x < 2.0; x += 0.05) EXPECT_EQ(a.look({0, 0.5, -4}, {x, -0.3, 4}).rgb, b.look({0, 0.5, -4}, {x, -0.3, 4}).rgb);
}

// ---- quality ----

TEST(Quality, follows_povray_s_numbers) {
    EXPECT_FALSE(Quality::povray(1).lighting);
    EXPECT_TRUE(Quality::povray(2).lighting);
    EXPECT_FALSE(Quality::povray(3).shadows);
    EXPECT_TRUE(Quality::povray(4).shadows);
    EXPECT_TRUE(Quality::povray(5).quick_colors);
    EXPECT_FALSE(Quality::povray(5).transmission);
    EXPECT_TRUE(Quality::povray(6).transmission);
    EXPECT_FALSE(Quality::povray(7).reflection);
    for (const int n : {8, 9, 10, 11}) EXPECT_TRUE(Quality::povray(n).reflection);
}

TEST(Quality, without_lighting_the_lowest_visible_layer_s_pigment_is_shown) {
    TraceOptions options = povray_options();
    options.quality = Quality::povray(0);
    const PigmentColor bottom = color({0.2, 0.4, 0.6}), top = color({0.8, 0.4, 0.3}, 0.3, 0.2);
    Traced t(scene_with({object(floor_plane(), {texture(bottom, Finish{}), texture(top, Finish{})})}, {point_light({0, 4, 0})}), options);
    EXPECT_EQ(t.look({0, 1, 0}, {0, -1, 0}).rgb, bottom.rgb);
}

TEST(Quality, quick_colours_stand_for_pigments_up_to_5) {
    Pigment pigment = checker(color({1, 0, 0}), color({1, 0, 0}));
    pigment.quick_color = color({0, 0, 1});
    const Scene s = scene_with({object(floor_plane(), texture(pigment, plain(Rgb(1.0))))});
    for (const auto& [quality, want] : {std::pair{5, Rgb(0, 0, 1)}, std::pair{6, Rgb(1, 0, 0)}}) {
        TraceOptions options = povray_options();
        options.quality = Quality::povray(quality);
        Traced t(s, options);
        EXPECT_RGB_NEAR(t.look({0.5, 1, 0.5}, {0, -1, 0}).rgb, want, 1e-15);
    }
}

}  // namespace
}  // namespace rt::tracer_surface_test
