// Mirrors, transparency, refraction, limits: closed forms.
#include <gtest/gtest.h>
#include <pthread.h>

#include "tests/trace/tracer_scene.h"

namespace rt::tracer_path_test {
namespace {

using namespace tracer_test;

const Rgb sky(0.3, 0.5, 0.7);

Finish mirror(const Rgb& min, const Rgb& max) {
    Finish f = plain();
    f.reflection.min = min, f.reflection.max = max;
    return f;
}

TEST(Mirror, reflectivity_goes_from_min_to_max) {
    Finish f = mirror({0.1, 0.2, 0.3}, {0.9, 0.8, 0.7});
    f.reflection.falloff = 3;
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(0.5)), f))}, {}, sky));
    const double k = std::pow(1 - 0.6, 3);
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0.8, -0.6, 0}).rgb, (k * f.reflection.max + (1 - k) * f.reflection.min) * sky, 1e-12);
    EXPECT_EQ(t.tracer->counts().reflected, 1u);
}

TEST(Mirror, fresnel_exponent_and_metallic) {
    Finish f = mirror(Rgb(0.1), Rgb(0.9));
    f.reflection.fresnel = true;
    Interior glass;
    glass.ior = 1.5;
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(0.5)), f), glass)}, {}, sky));
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0, -1, 0}).rgb, (0.04 * 0.9 + 0.96 * 0.1) * sky, 1e-12);

    f = mirror(Rgb(0.5), Rgb(0.5));
    f.reflection.exponent = 2;
    Traced root(scene_with({object(floor_plane(), texture(color(Rgb(0.5)), f))}, {}, {0.25, 0.0, -0.5}));
    EXPECT_RGB_NEAR(root.look({0, 1, 0}, {0, -1, 0}).rgb, Rgb(0.25, 0, 0), 1e-12);

    f = mirror(Rgb(0.5), Rgb(0.5));
    f.reflection.metallic = 1;
    Traced metal(scene_with({object(floor_plane(), texture(color({1, 0.5, 0.1}), f))}, {}, sky));
    EXPECT_RGB_NEAR(metal.look({0, 1, 0}, {0, -1, 0}).rgb, 0.5 * Rgb(1, 0.5, 0.1) * sky, 1e-9);
}

/// Two facing mirrors with ambient a and reflection r: a ray that may enter `levels` surfaces gathers a geometric series.
Scene facing_mirrors(double a, double r) {
    Finish f = mirror(Rgb(r), Rgb(r));
    f.ambient = Rgb(a);
    return scene_with({object(floor_plane(), texture(color(Rgb(1.0)), f)), object(floor_plane(1), texture(color(Rgb(1.0)), f))});
}

double series(double a, double r, int terms) {
    double sum = 0;
    for (int i = 0; i < terms; ++i) sum += a * std::pow(r, i);
    return sum;
}

TEST(Limits, max_trace_level_ends_in_black) {
    for (const int level : {1, 2, 5, 20}) {
        Scene s = facing_mirrors(0.1, 0.9);
        s.settings.max_trace_level = level;
        Traced t(std::move(s));
        EXPECT_NEAR(t.look({0, 0.5, 0}, {0.1, -1, 0}).rgb.g, series(0.1, 0.9, level), 1e-12) << level;
    }
    TraceOptions options = povray_options();
    options.max_trace_level = 3;
    Traced t(facing_mirrors(0.1, 0.9), options);
    EXPECT_NEAR(t.look({0, 0.5, 0}, {0.1, -1, 0}).rgb.g, series(0.1, 0.9, 3), 1e-12);
}

TEST(Limits, adc_bailout_ends_in_black) {
    Scene s = facing_mirrors(0.1, 0.9);
    s.settings.max_trace_level = 20;
    s.settings.adc_bailout = 0.5;
    Traced t(std::move(s));
    EXPECT_NEAR(t.look({0, 0.5, 0}, {0.1, -1, 0}).rgb.g, series(0.1, 0.9, 7), 1e-12) << "0.9^6 = 0.53 is traced, 0.9^7 is not";
}

TEST(Transparency, every_surface_filters_and_straight_rays_are_no_level) {
    const PigmentColor glass = color({0.9, 0.5, 0.2}, 0.6, 0.3);
    const Rgb W = 0.6 * glass.rgb + Rgb(0.3), S = 0.1 * 0.2 * glass.rgb;
    Scene s = scene_with({object(Box{Vec3(-5, -1, -5), Vec3(5, 0, 5)}, texture(glass, plain(Rgb(0.2)))),
                          object(Box{Vec3(-5, -3, -5), Vec3(5, -2, 5)}, texture(glass, plain(Rgb(0.2))))},
                         {}, sky);
    s.settings.max_trace_level = 2;
    Traced t(std::move(s));
    const Radiance seen = t.look({0, 1, 0}, {0.1, -1, 0.2});
    EXPECT_RGB_NEAR(seen.rgb, S + W * (S + W * (S + W * (S + W * sky))), 1e-12);
    EXPECT_EQ(t.tracer->counts().refracted, 4u);

    Scene once = t.scene;
    once.settings.max_trace_level = 1;
    Traced black(std::move(once));
    EXPECT_RGB_NEAR(black.look({0, 1, 0}, {0.1, -1, 0.2}).rgb, S, 1e-12);
}

TEST(Transparency, transmittance_is_the_grey_share_of_the_background) {
    const PigmentColor glass = color({0.2, 0.4, 0.6}, 0.5);
    Scene s = scene_with({object(Sphere{Vec3(0.0), 1.0}, texture(glass, plain()))}, {}, Rgb(0.0));
    s.background = color(Rgb(0.0), 0.0, 1.0);
    Traced t(std::move(s));
    const double grey_W = 0.297 * 0.1 + 0.589 * 0.2 + 0.114 * 0.3;
    EXPECT_NEAR(t.look({0, 0, -3}, {0, 0, 1}).transmittance, grey_W * grey_W * t.world->background_transmit, 1e-12);
    EXPECT_EQ(t.look({0, 0, -3}, {0, 0, -1}).transmittance, t.world->background_transmit);
}

TEST(Transparency, conserve_energy_dims_only_what_is_transmitted) {
    Finish f = mirror(Rgb(0.4), Rgb(0.4));
    f.conserve_energy = true;
    Traced t(scene_with({object(Disc{Vec3(0.0), Vec3(0, 1, 0), 9, 0}, texture(color(Rgb(1.0), 0, 0.5), f))}, {}, sky));
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0, -1, 0}).rgb, 0.4 * sky + 0.5 * 0.6 * sky, 1e-12);
}

TEST(Transparency, a_negative_transmit_subtracts_what_lies_behind) {
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(0.25), 0.0, -1.0), plain(Rgb(1.0))))}, {}, sky));
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0, -1, 0}).rgb, 2.0 * Rgb(0.25) - sky, 1e-12);
}

TEST(Visibility, a_camera_that_sees_nothing_there_is_black_and_clear) {
    Scene scene = scene_with({object(floor_plane(), texture(color(Rgb(0.25)), plain(Rgb(1.0))))}, {}, sky);
    scene.camera.projection = Projection::fisheye;
    Traced t(scene);
    const Radiance corner = t.pixel(0, 0, 16, 16), middle = t.pixel(8, 8, 16, 16);
    EXPECT_EQ(corner.rgb, Rgb(0.0));
    EXPECT_EQ(corner.transmittance, 1.0);
    EXPECT_NE(middle.rgb, Rgb(0.0));
    RayLog log;
    t.tracer->camera_ray(camera_ray(t.world->camera, 0.5, 0.5, 16, 16), log);
    EXPECT_EQ(log.nodes.size(), 1u);
    std::array<Ray, 2> rays{camera_ray(t.world->camera, 0.5, 0.5, 16, 16), camera_ray(t.world->camera, 8.5, 8.5, 16, 16)};
    std::array<Radiance, 2> light;
    t.tracer->camera_rays(rays, light);
    EXPECT_EQ(light[0].transmittance, 1.0);
    EXPECT_EQ(light[1].rgb, middle.rgb);
}

TEST(Refraction, a_slab_shifts_the_ray_and_a_prism_bends_it) {
    // Below the slab lies a checkered floor: the cell that is met tells where the ray came out.
    Interior glass;
    glass.ior = 1.5;
    const Object slab = object(Box{Vec3(-50, -2, -50), Vec3(50, 0, 50)}, texture(color(Rgb(1.0), 0, 1), plain()), glass);
    const Object floor = object(floor_plane(-2.5), texture(checker(color({1, 0, 0}), color({0, 1, 0})), plain(Rgb(1.0))));
    Traced t(scene_with({slab, floor}, {}, sky));
    for (double x = -7.93; x < 8; x += 0.37) {
        const Vec3 d = unit(Vec3(1, -1, 0));
        const double inside = 2 * std::tan(std::asin(d.x / 1.5));
        const double out_x = x + 1 + inside + 0.5;  // enters at x + 1 from height 1
        const bool odd = (static_cast<int>(std::floor(out_x)) + static_cast<int>(std::floor(-2.5))) % 2 != 0;
        EXPECT_EQ(t.look({x, 1, 0.5}, d).rgb, odd ? Rgb(0, 1, 0) : Rgb(1, 0, 0)) << x;
    }
}

TEST(Refraction, total_reflection_is_not_filtered_and_replaces_the_mirror) {
    Interior glass;
    glass.ior = 1.5;
    // Enter from the left at 45 degrees: 28.1 inside, meets the top at 61.9 (total), leaves through the right side.
    const PigmentColor pigment = color({0.9, 0.5, 0.2}, 1.0);
    Traced bare(scene_with({object(Box{Vec3(-1.0), Vec3(1.0)}, texture(pigment, plain()), glass)}, {}, sky));
    const Radiance r = bare.look({-2, -0.5, 0.1}, {1, 1, 0});
    EXPECT_RGB_NEAR(r.rgb, pigment.rgb * pigment.rgb * sky, 1e-12);
    EXPECT_EQ(bare.tracer->counts().reflected, 1u);
    EXPECT_EQ(bare.tracer->counts().refracted, 2u);
    EXPECT_EQ(r.transmittance, 0.0);

    // With mirrors and three levels: the left side's mirror shows sky, the top's is replaced, the right side's and what is behind it are
    // black.
    Finish f = mirror(Rgb(0.25), Rgb(0.25));
    f.ambient = Rgb(0.4);
    const PigmentColor half = color(pigment.rgb, 0.5);
    Scene s = scene_with({object(Box{Vec3(-1.0), Vec3(1.0)}, texture(half, f), glass)}, {}, sky);
    s.settings.max_trace_level = 3;
    Traced t(std::move(s));
    const Rgb own = 0.4 * 0.5 * half.rgb, W = 0.5 * half.rgb;
    EXPECT_RGB_NEAR(t.look({-2, -0.5, 0.1}, {1, 1, 0}).rgb, 0.25 * sky + own + W * (own + own), 1e-12);
    EXPECT_EQ(t.tracer->counts().reflected, 3u);
}

TEST(Refraction, total_reflection_has_the_colours_of_the_topmost_film) {
    Interior glass;
    glass.ior = 1.5;
    Finish film = plain();
    film.irid = Irid{.amount = 0.5, .thickness = 0.8};
    const Texture clear = texture(color(Rgb(1.0), 1.0), plain()), filmed = texture(color(Rgb(1.0), 1.0), film);
    const auto seen = [&](const std::vector<Texture>& layers) {
        Traced t(scene_with({object(Box{Vec3(-1.0), Vec3(1.0)}, layers, glass)}, {}, sky));
        return t.look({-2, -0.5, 0.1}, {1, 1, 0}).rgb;
    };
    // The way of the test above; at the top the cosine is the sine of the refracted ray.
    const double path = 2.0 * pi * 0.8 * 2.0 * (std::sqrt(0.5) / 1.5);
    const Rgb factor(1.0 + 0.5 * std::cos(path / 0.70), 1.0 + 0.5 * std::cos(path / 0.52), 1.0 + 0.5 * std::cos(path / 0.48));
    EXPECT_RGB_NEAR(seen({filmed}), factor * sky, 1e-12);
    EXPECT_RGB_NEAR(seen({clear, filmed}), factor * sky, 1e-12);
    EXPECT_RGB_NEAR(seen({filmed, clear}), sky, 1e-12);
}

TEST(Refraction, nested_media_follow_the_list_not_the_normals) {
    // Three overlapping slabs, entered in the order A, B, C and left in the order A, C, B. A is not the last entered: leaving it does not
    // bend.
    const double ior[3] = {1.2, 1.5, 1.3}, top[3] = {0, -0.5, -1}, bottom[3] = {-2, -4, -3};
    std::vector<Object> objects;
    for (int i = 0; i < 3; ++i) {
        Interior medium;
        medium.ior = ior[i];
        objects.push_back(object(Box{Vec3(-20, bottom[i], -20), Vec3(20, top[i], 20)}, texture(color(Rgb(1.0), 0, 1), plain()), medium));
    }
    objects.push_back(object(floor_plane(-4.5), texture(checker(color({1, 0, 0}), color({0, 1, 0})), plain(Rgb(1.0)))));
    Scene s = scene_with(objects);
    s.settings.max_trace_level = 12;
    Traced t(std::move(s));
    const Vec3 d = unit(Vec3(1, -1, 0));
    const auto run = [&](double index, double depth) { return depth * d.x / index / std::sqrt(1 - sqr(d.x / index)); };
    for (double x = -5.95; x < 5; x += 0.31) {
        const double out_x = x + 1 + run(1.2, 0.5) + run(1.5, 0.5) + run(1.3, 2) + run(1.5, 1) + run(1.0, 0.5);
        const bool odd = (static_cast<int>(std::floor(out_x)) + static_cast<int>(std::floor(-4.5))) % 2 != 0;
        EXPECT_EQ(t.look({x, 1, 0.5}, d).rgb, odd ? Rgb(0, 1, 0) : Rgb(1, 0, 0)) << x;
    }
}

TEST(Refraction, camera_inside_an_object_leaves_it_first) {
    Interior glass;
    glass.ior = 1.5;
    Scene s = scene_with({object(Sphere{Vec3(0.0), 2.0}, texture(color({0.9, 0.8, 0.7}, 1.0), plain()), glass)}, {}, sky);
    s.camera.location = {0, 1.9, 0};
    Traced t(std::move(s));
    ASSERT_EQ(t.world->camera_interiors.size(), 1u);
    EXPECT_RGB_NEAR(t.look({0, 1.9, 0}, {0, -1, 0}).rgb, Rgb(0.9, 0.8, 0.7) * sky, 1e-12);
    // Sideways the ray meets the sphere at asin(0.95) from its normal: total reflection for ever, hence black.
    EXPECT_EQ(t.look({0, 1.9, 0}, {1, 0, 0}).rgb, Rgb(0.0));
}

TEST(Refraction, opaque_bodies_around_the_camera_count_and_ior_0_is_1) {
    Finish f = mirror(Rgb(0.0), Rgb(1.0));
    f.reflection.fresnel = true;
    f.ambient = Rgb(0.1);
    Interior glass;
    glass.ior = 1.5;
    const Object ball = object(Sphere{Vec3(0.0), 1.0}, texture(color(Rgb(1.0)), f), glass);
    const Object shell = object(Sphere{Vec3(0.0), 20.0}, texture(color(Rgb(1.0)), plain(Rgb(0.5))));
    Scene s = scene_with({ball, shell});
    s.camera.location = {0, 0, -5};
    Traced t(std::move(s));
    EXPECT_EQ(t.world->camera_interiors.size(), 1u);
    EXPECT_RGB_NEAR(t.look({0, 0, -5}, {0, 0, 1}).rgb, Rgb(0.1 + 0.04 * 0.5), 1e-12);

    glass.ior = 0.0;
    Traced zero(scene_with({object(Sphere{Vec3(0.0), 1.0}, texture(color(Rgb(1.0), 0, 0.5), f), glass)}, {}, sky));
    EXPECT_RGB_NEAR(zero.look({0, 0.7, -5}, {0, 0, 1}).rgb, Rgb(0.05) + 0.5 * (Rgb(0.05) + 0.5 * sky), 1e-12) << "straight, no mirror";
}

TEST(Refraction, fading_media_dim_transmitted_light_only) {
    Interior medium;
    medium.fade_distance = 2, medium.fade_power = 2, medium.fade_color = {0.5, 0.2, 0.0};
    const Object box = object(Box{Vec3(-9, -4, -9), Vec3(9, 0, 9)}, texture(color(Rgb(1.0), 0, 0.5), plain(Rgb(0.2))), medium);
    Traced t(scene_with({box}, {}, sky));
    const Rgb fade = medium.fade_color + (Rgb(1.0) - medium.fade_color) / 5.0;
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0, -1, 0}).rgb, Rgb(0.1) + 0.5 * (Rgb(0.1) + 0.5 * fade * sky), 1e-12);
}

TEST(Visibility, no_image_and_no_reflection) {
    Object ball = object(Sphere{Vec3(0, 1, 0), 0.5}, texture(color({1, 0, 0}), plain(Rgb(1.0))));
    const Object glass = object(Disc{Vec3(0, 3, 0), Vec3(0, 1, 0), 9, 0}, texture(color(Rgb(1.0), 0, 1), plain()));
    const Object floor = object(floor_plane(), texture(color({0, 0, 1}), [] {
                                    Finish f = mirror(Rgb(0.5), Rgb(0.5));
                                    f.ambient = Rgb(1.0);
                                    return f;
                                }()));
    ball.no_image = true;
    Traced hidden(scene_with({ball, glass, floor}));
    EXPECT_EQ(hidden.look({0, 4, 0}, {0, -1, 0}).rgb, Rgb(0.5, 0, 1)) << "unseen through glass, seen in the mirror";
    ball.no_image = false;
    ball.no_reflection = true;
    Traced unmirrored(scene_with({ball, glass, floor}));
    EXPECT_EQ(unmirrored.look({0, 4, 0}, {0, -1, 0}).rgb, Rgb(1, 0, 0));
    EXPECT_EQ(unmirrored.look({0, 0.2, 0}, {0, -1, 0}).rgb, Rgb(0, 0, 1));
}

// Sanitizers make every stack frame several times as large.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t small_stack = 16 * 1024 * 1024;
#else
constexpr std::size_t small_stack = 512 * 1024;
#endif

TEST(Limits, deepest_recursion_and_endless_glass_fit_a_small_stack) {
    Scene deep = facing_mirrors(0.001, 1.0);
    deep.settings.max_trace_level = 256;
    std::vector<Object> panes;
    for (int i = 0; i < 5000; ++i) panes.push_back(object(floor_plane(-0.01 * i), texture(color(Rgb(1.0), 0, 1), plain(Rgb(1.0)))));
    struct Result {
        Traced mirrors, glass;
        double mirrored = 0, through = 0;
    } result{Traced(std::move(deep)), Traced(scene_with(panes, {}, sky))};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, small_stack);
    pthread_t thread;
    ASSERT_EQ(pthread_create(
                  &thread, &attributes,
                  [](void* p) -> void* {
                      auto& r = *static_cast<Result*>(p);
                      r.mirrored = r.mirrors.look({0, 0.5, 0}, {0.1, -1, 0}).rgb.g;
                      r.through = r.glass.look({0, 1, 0}, {0.1, -1, 0}).rgb.g;
                      return nullptr;
                  },
                  &result),
              0);
    pthread_join(thread, nullptr);
    EXPECT_NEAR(result.mirrored, 0.256, 1e-12);
    EXPECT_NEAR(result.through, 0.5, 1e-12);
}

}  // namespace
}  // namespace rt::tracer_path_test
