// Lights and shadows against closed forms.
#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"
#include "trace/light_source.h"

namespace rt::tracer_light_test {
namespace {

using namespace tracer_test;

const Finish matte = plain(Rgb(0.0), 1.0);

/// The floor y = 0, diffuse 1, white.
Object white_floor() { return object(floor_plane(), texture(color(Rgb(1.0)), matte)); }

/// What the floor sends up from (x, 0, z).
Rgb floor_light(Traced& t, double x, double z = 0.0) { return t.look({x, 0.5, z}, {0, -1, 0}).rgb; }

TEST(LightSource, fades_with_distance_up_to_twice_its_colour) {
    Light l = point_light({0, 3, 0}, {1, 0.5, 0.25});
    l.fade_distance = 4, l.fade_power = 2;
    Traced t(scene_with({white_floor()}, {l}));
    for (const double x : {0.0, 1.0, 4.0, 50.0}) {
        const double d = std::hypot(3.0, x);
        EXPECT_RGB_NEAR(floor_light(t, x), 2 / (1 + sqr(d / 4)) * (3 / d) * l.color, 1e-12);
    }
    l.fade_power = 0;
    Traced plain_light(scene_with({white_floor()}, {l}));
    EXPECT_RGB_NEAR(floor_light(plain_light, 4), 0.6 * l.color, 1e-12);
}

/// By what fog leaves of it, outside of bodies that are not hollow.
TEST(LightSource, media_attenuation_is_that_of_fog) {
    Light l = point_light({0, 5, 0});
    const auto seen = [&](bool attenuated, bool hollow) {
        l.media_attenuation = attenuated;
        Object ball = object(Sphere{Vec3(0, 3, 0), 1.0}, texture(color(Rgb(1.0), 0.0, 1.0), plain()));
        ball.hollow = hollow;
        Scene scene = scene_with({white_floor(), ball}, {l});
        Fog fog;
        fog.distance = 10.0;
        fog.color = color({0.2, 0.4, 0.6}, 0.5);
        scene.fogs.push_back(fog);
        Traced t(std::move(scene));
        return floor_light(t, 0.0);
    };
    const Rgb c(0.2, 0.4, 0.6), filter = Rgb(0.5) + 0.5 * c;
    const auto left = [&](double way) { return std::exp(-way / 10.0) * filter; };
    const Rgb own = (1.0 - std::exp(-0.05)) * c;
    EXPECT_RGB_NEAR(seen(false, true), own + left(0.5), 1e-12);
    EXPECT_RGB_NEAR(seen(true, true), own + left(0.5) * left(2.0) * left(2.0) * left(1.0), 1e-12);
    EXPECT_RGB_NEAR(seen(true, false), own + left(0.5) * left(2.0) * left(1.0), 1e-12);
}

double spot_factor(double angle, double radius, double falloff, double tightness) {
    const double a = std::cos(angle), r = std::cos(radians(radius)), f = std::cos(radians(falloff));
    if (a <= 0) return 0;
    double factor = std::pow(a, tightness);
    if (r > 0 && a < r) {
        const double q = (a - f) / (r - f);
        factor *= a < f ? 0 : q * q * (3 - 2 * q);
    }
    return factor;
}

TEST(LightSource, spot_cone) {
    struct Case {
        double radius, falloff, tightness;
    };
    for (const Case& c : {Case{20, 40, 0}, Case{20, 40, 10}, Case{40, 20, 0}, Case{95, 120, 3}}) {
        Light l = point_light({0, 2, 0});
        l.type = Light::Type::spotlight;
        l.point_at = {0, 0, 0};
        l.radius = c.radius, l.falloff = c.falloff, l.tightness = c.tightness;
        Traced t(scene_with({white_floor()}, {l}));
        for (const double degrees : {0.0, 10.0, 19.9, 20.1, 30.0, 39.9, 40.1, 70.0}) {
            const double angle = radians(degrees), want = std::cos(angle) * spot_factor(angle, c.radius, c.falloff, c.tightness);
            EXPECT_RGB_NEAR(floor_light(t, 2 * std::tan(angle)), Rgb(want), 1e-12);
        }
    }
}

TEST(LightSource, cylinder_light) {
    Light l = point_light({0, 5, 0});
    l.type = Light::Type::cylinder;
    l.point_at = {0, 0, 0};
    l.radius = 1, l.falloff = 2, l.tightness = 0.5;
    Traced t(scene_with({white_floor(), object(floor_plane(6), texture(color(Rgb(1.0)), matte))}, {l}));
    EXPECT_RGB_NEAR(floor_light(t, 0.5), Rgb(std::sqrt(0.75)), 1e-12);
    const double q = 0.25, S = 0.5 * 0.5 * (3 - 2 * 0.5);
    EXPECT_RGB_NEAR(floor_light(t, 1.5), Rgb(std::sqrt(q) * S), 1e-12);
    EXPECT_EQ(floor_light(t, 2.5), Rgb(0.0));
    EXPECT_EQ(t.look({0, 5.5, 0}, {0, 1, 0}).rgb, Rgb(0.0)) << "behind the lamp";
}

TEST(LightSource, parallel_light_is_stopped_only_before_its_plane) {
    Light l = point_light({0, 4, 0});
    l.parallel = true;
    l.point_at = {3, 0, 0};
    const auto world = [&](double y) {
        return scene_with({white_floor(), object(Sphere{Vec3(-y * 0.75, y, 0), 0.5}, texture(color(Rgb(1.0)), matte))}, {l});
    };
    Traced below(world(2)), above(world(8)), none(scene_with({white_floor()}, {l}));
    EXPECT_RGB_NEAR(floor_light(none, 0), Rgb(0.8), 1e-12);
    EXPECT_RGB_NEAR(floor_light(none, 77, 33), Rgb(0.8), 1e-12);
    EXPECT_EQ(floor_light(below, 0), Rgb(0.0));
    EXPECT_RGB_NEAR(floor_light(above, 0), Rgb(0.8), 1e-12) << "a sphere beyond the lamp's plane casts no shadow";
}

TEST(LightSource, at_the_surface_or_black_or_undirected_does_nothing) {
    Light at_point = point_light({0, 0, 0}), black = point_light({0, 1, 0}, Rgb(0.0)), undirected = point_light({0, 3, 0});
    undirected.type = Light::Type::spotlight;
    undirected.point_at = undirected.location;
    undirected.radius = 30, undirected.falloff = 45;
    Traced t(scene_with({white_floor()}, {at_point, black, undirected}));
    EXPECT_EQ(floor_light(t, 0), Rgb(0.0));
    EXPECT_EQ(t.tracer->counts().shadow, 0u);
}

TEST(LightSource, negative_light_darkens) {
    Traced t(scene_with({white_floor()}, {point_light({0, 4, 0}), point_light({0, 4, 0}, Rgb(-0.25))}));
    EXPECT_RGB_NEAR(floor_light(t, 0), Rgb(0.75), 1e-12);
}

TEST(LightSource, shadowless_light_has_no_shadow_and_no_highlight) {
    Finish f = matte;
    f.phong = 1.0;
    Light l = point_light({0, 4, 0});
    l.shadowless = true;
    Traced t(scene_with(
        {object(floor_plane(), texture(color(Rgb(1.0)), f)), object(Sphere{Vec3(0, 2, 0), 0.5}, texture(color(Rgb(1.0)), f))}, {l}));
    EXPECT_RGB_NEAR(floor_light(t, 0), Rgb(1.0), 1e-12);
    EXPECT_EQ(t.tracer->counts().shadow, 0u);
}

// ---- shadows ----

TEST(Shadow, opaque_blocker_and_no_shadow) {
    Object ball = object(Sphere{Vec3(0, 2, 0), 0.5}, texture(color(Rgb(1.0)), matte));
    Traced dark(scene_with({white_floor(), ball}, {point_light({0, 4, 0})}));
    EXPECT_EQ(floor_light(dark, 0), Rgb(0.0));
    ball.no_shadow = true;
    Traced lit(scene_with({white_floor(), ball}, {point_light({0, 4, 0})}));
    EXPECT_RGB_NEAR(floor_light(lit, 0), Rgb(1.0), 1e-12);
}

TEST(Shadow, is_tinted_by_every_transparent_surface) {
    const PigmentColor glass = color({0.9, 0.5, 0.2}, 0.6, 0.3);
    const Rgb W = 0.6 * glass.rgb + Rgb(0.3);
    for (const Distances distances : {Distances::povray, Distances::scaled}) {
        TraceOptions options = povray_options();
        options.distances = distances;
        Traced t(scene_with({white_floor(), object(Sphere{Vec3(0, 2, 0), 0.5}, texture(glass, Finish{}))}, {point_light({0, 4, 0})}),
                 options);
        EXPECT_RGB_NEAR(floor_light(t, 0.1), W * W * (4 / std::hypot(4, 0.1)), 1e-12);

        Interior focus;
        focus.caustics = 2.0;
        Traced c(
            scene_with({white_floor(), object(Sphere{Vec3(0, 2, 0), 0.5}, {texture(glass, Finish{}), texture(glass, Finish{})}, focus)},
                       {point_light({0, 4, 0})}),
            options);
        EXPECT_RGB_NEAR(floor_light(c, 0), 16.0 * W * W * W * W, 1e-11) << "straight through: each of four layers doubles";

        Interior fading;
        fading.fade_distance = 0.5, fading.fade_power = 1, fading.fade_color = Rgb(0.1, 0.2, 0.3);
        Traced f(
            scene_with({white_floor(), object(Sphere{Vec3(0, 2, 0), 0.5}, texture(glass, Finish{}), fading)}, {point_light({0, 4, 0})}),
            options);
        EXPECT_RGB_NEAR(floor_light(f, 0), W * W * (fading.fade_color + (Rgb(1.0) - fading.fade_color) / 3.0), 1e-8);
        fading.fade_power = 0;
        Traced zero(
            scene_with({white_floor(), object(Sphere{Vec3(0, 2, 0), 0.5}, texture(glass, Finish{}), fading)}, {point_light({0, 4, 0})}),
            options);
        EXPECT_RGB_NEAR(floor_light(zero, 0), W * W, 1e-8) << "no fade in shadows without a power";
    }
}

TEST(Shadow, is_cast_by_all_surfaces_or_by_opaque_ones_or_by_none) {
    // Towards the lamp a glass ball stands over (0, 0, 0) and a solid one over (4, 0, 0); a checkered one, half of it glass, over (-4, 0,
    // 0).
    const PigmentColor glass = color(Rgb(1.0), 0.0, 0.5), solid = color(Rgb(1.0));
    const auto ball = [](double x, const auto& pigment) { return object(Sphere{{x, 2, 0}, 0.3}, texture(pigment, matte)); };
    const Scene scene =
        scene_with({white_floor(), ball(0, glass), ball(2, solid), ball(-2, checker(solid, glass))}, {point_light({0, 4, 0})});
    const double far = 4 / std::hypot(4.0, 4.0);
    for (const Distances distances : {Distances::povray, Distances::scaled}) {
        TraceOptions options = povray_options();
        options.distances = distances;
        const auto light = [&](ShadowKind kind, double x) {
            options.shadows = kind;
            Traced t(scene, options);
            const double found = floor_light(t, x).g;
            EXPECT_EQ(t.tracer->counts().shadow, kind == ShadowKind::none ? 0u : 1u);
            return found;
        };
        EXPECT_NEAR(light(ShadowKind::full, 0), 0.25, 1e-12);
        EXPECT_NEAR(light(ShadowKind::full, 4), 0.0, 1e-12);
        EXPECT_LE(light(ShadowKind::full, -4), 0.25);
        EXPECT_NEAR(light(ShadowKind::opaque, 0), 1.0, 1e-12);
        EXPECT_NEAR(light(ShadowKind::opaque, 4), 0.0, 1e-12);
        EXPECT_NEAR(light(ShadowKind::opaque, -4), far, 1e-12) << "light passes somewhere";
        EXPECT_NEAR(light(ShadowKind::none, 0), 1.0, 1e-12);
        EXPECT_NEAR(light(ShadowKind::none, 4), far, 1e-12);
    }
}

TEST(Shadow, light_that_starts_inside_a_medium_fades_from_there) {
    Interior fading;
    fading.fade_distance = 0.5, fading.fade_power = 1000;
    Finish f = matte;
    f.diffuse = 0.5;
    // Seen from inside the ball: its far wall is lit by a lamp outside, through the near wall and the ball.
    Traced t(scene_with({object(Sphere{Vec3(0.0), 1.0}, texture(color(Rgb(1.0), 0.0, 0.5), f), fading)}, {point_light({0, 5, 0})}));
    const Rgb light = t.look({0, 2, 0}, {0, -1, 0}).rgb;
    // Near wall: 0.25 of full light; far wall: 0.25 times the light through near wall (0.5) and two radii of medium, seen through both.
    const double fade = std::exp(-4.0);
    EXPECT_RGB_NEAR(light, Rgb(0.25 + 0.5 * 0.25 * 0.5 * fade), 1e-12);
}

// ---- area lights ----

/// A lamp of n samples along x at height 4 over the floor, and a wall of opaque boxes that hide samples from the point (0, 0, 0).
Scene area_scene(const AreaLight& area, const std::vector<Vec3>& hidden) {
    Light l = point_light({0, 4, 0});
    l.area = area;
    std::vector<Object> objects = {white_floor()};
    for (const Vec3& sample : hidden) objects.push_back(object(Sphere{sample / 2.0, 0.05}, texture(color(Rgb(1.0)), matte)));
    return scene_with(objects, {l});
}

AreaLight row(int n) {
    AreaLight a;
    a.axis1 = {2, 0, 0}, a.axis2 = {0, 0, 2};
    a.size1 = n, a.size2 = 1;
    return a;
}

TEST(AreaLight, corners_are_averaged_recursively) {
    const Vec3 left{-1, 4, 0}, middle{0, 4, 0}, right{1, 4, 0};
    const auto lit = [&](const AreaLight& area, const std::vector<Vec3>& hidden) {
        Traced t(area_scene(area, hidden));
        return floor_light(t, 0).g;
    };
    EXPECT_NEAR(lit(row(2), {left}), 0.5, 1e-12);
    EXPECT_NEAR(lit(row(3), {}), 1.0, 1e-12);
    EXPECT_NEAR(lit(row(3), {left}), 0.75, 1e-12) << "the middle sample counts twice";
    EXPECT_NEAR(lit(row(3), {middle}), 0.5, 1e-12);
    EXPECT_NEAR(lit(row(3), {left, right}), 0.5, 1e-12);
    EXPECT_NEAR(lit(row(4), {{-1.0 / 3, 4, 0}}), 0.75, 1e-12) << "an even row is a plain mean";
    AreaLight adaptive = row(3);
    adaptive.adaptive = 0;
    EXPECT_NEAR(lit(adaptive, {middle}), 1.0, 1e-12) << "equal corners: the middle is not asked";
    EXPECT_NEAR(lit(adaptive, {left}), 0.75, 1e-12);
    AreaLight square = row(3);
    square.size2 = 3;
    EXPECT_NEAR(lit(square, {middle}), 0.75, 1e-12);
    EXPECT_NEAR(lit(square, {left}), 0.875, 1e-12);
}

TEST(AreaLight, samples_of_directed_lights_shine_through_point_at) {
    // The lamp stands over (0, 0, 0) and aims at (0, 2, 0): its left sample's ray through that point goes right, so a ball on the left of
    // the floor's point hides it and the straight ray upwards is free.
    for (const bool parallel : {false, true}) {
        Light l = point_light({0, 4, 0});
        if (parallel) l.parallel = true;
        if (!parallel) l.type = Light::Type::cylinder, l.radius = 5, l.falloff = 9;
        l.point_at = {0, 2, 0};
        l.area = row(2);
        Traced t(scene_with({white_floor(), object(Sphere{Vec3(-0.5, 1, 0), 0.05}, texture(color(Rgb(1.0)), matte))}, {l}));
        EXPECT_NEAR(floor_light(t, 0).g, 0.5, 1e-12) << parallel;
    }
}

TEST(AreaLight, each_sample_is_asked_once) {
    AreaLight square = row(5);
    square.size2 = 4;
    Traced t(area_scene(square, {}));
    floor_light(t, 0);
    EXPECT_EQ(t.tracer->counts().shadow, 20u);
}

TEST(AreaLight, circular_samples_lie_on_a_disc) {
    AreaLight round = row(3);
    round.size2 = 3;
    round.circular = true;
    // Corner (0, 0): a = b = -0.499, moved inwards by max/length = 1/sqrt(2).
    const double c = 2 * -0.499 / std::sqrt(2.0);
    Light lamp = point_light({0, 4, 0});
    lamp.area = round;
    EXPECT_RGB_NEAR(AreaGrid(lamp, Vec3(0.0)).position(0, 0), Vec3(c, 4, c), 1e-15);
    Traced hidden(area_scene(round, {{c, 4, c}}));
    EXPECT_NEAR(floor_light(hidden, 0).g, 1 - 1 / 16.0, 1e-12);
    Traced square_corner(area_scene(round, {{-1, 4, -1}}));
    EXPECT_NEAR(floor_light(square_corner, 0).g, 1.0, 1e-12);
}

TEST(AreaLight, area_illumination_adds_each_sample_s_own_direction) {
    AreaLight area = row(2);
    area.area_illumination = true;
    Traced t(area_scene(area, {}));
    EXPECT_NEAR(floor_light(t, 0).g, 4 / std::hypot(4.0, 1.0), 1e-12);
    const double want = 0.5 * (4 / std::hypot(4.0, 1.0) + 4 / std::hypot(4.0, 3.0));
    EXPECT_NEAR(floor_light(t, 2).g, want, 1e-12);
}

}  // namespace
}  // namespace rt::tracer_light_test
