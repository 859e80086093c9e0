// The same scene at every scale: no acne, no leaks, no light lost, under the scaled distances; and POV-Ray's absolute lengths.
#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"

namespace rt::tracer_scale_test {
namespace {

using namespace tracer_test;

constexpr int width = 40, height = 30;

/// One object of each shape on a floor, glass and mirrors among them, everything multiplied by k and moved by `offset` * k.
Scene scene_of_scale(double k, const Vec3& offset) {
    const auto p = [&](double x, double y, double z) { return k * (Vec3(x, y, z) + offset); };
    Finish dull = plain(Rgb(0.1), 0.7), glass = plain(Rgb(0.0), 0.1);
    glass.reflection.max = Rgb(1.0), glass.reflection.fresnel = true;
    Interior ior;
    ior.ior = 1.5;
    const Texture matte = texture(color({0.8, 0.6, 0.4}), dull);
    const Texture clear = texture(color({0.9, 1.0, 0.9}, 0.9), glass);
    Object torus = object(Torus{0.8 * k, 0.3 * k}, matte);
    torus.transform = Transform::rotate({30, 0, 20}, Rotation::povray).then(Transform::translate(p(-2.2, 1.1, 1)));
    Scene s = scene_with({object(Plane{Vec3(0, 1, 0), p(0, 0, 0).y}, texture(color(Rgb(0.7)), dull)),
                          object(Sphere{p(0, 1, 0), k}, clear, ior), object(Box{p(1.4, 0.2, -1), p(2.4, 1.4, 0)}, matte),
                          object(Cone{p(-1.5, 0.1, -1.5), 0.5 * k, p(-1.5, 1.5, -1.5), 0.1 * k, false}, matte),
                          object(Triangle{p(-3, 0.5, 3), p(3, 0.5, 3.5), p(0, 3, 4)}, matte), torus},
                         {point_light(p(4, 8, -6), {0.9, 0.8, 0.7}), point_light(p(-5, 3, -4), Rgb(0.3))}, {0.2, 0.3, 0.5});
    s.camera.location = p(0.3, 2, -6);
    s.camera.look_at = p(0, 0.9, 0);
    return s;
}

std::vector<Rgb> picture(Traced& t) {
    std::vector<Rgb> out;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) out.push_back(t.pixel(i, j, width, height).rgb);
    }
    return out;
}

int differing(const std::vector<Rgb>& a, const std::vector<Rgb>& b, double tolerance) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += is_near(a[i], b[i], tolerance) ? 0 : 1;
    return count;
}

TEST(ScaledDistances, the_picture_does_not_depend_on_the_scale) {
    Traced reference(scene_of_scale(1.0, Vec3(0.0)), TraceOptions{});
    const std::vector<Rgb> want = picture(reference);
    for (const double k : {1e-6, 1e-3, 37.0, 1e6, 1e9}) {
        Traced t(scene_of_scale(k, Vec3(0.0)), TraceOptions{});
        EXPECT_EQ(differing(picture(t), want, 1e-6), 0) << "scale " << k;
    }
    for (const double away : {1e3, 1e5, 1e7}) {
        Traced t(scene_of_scale(1.0, Vec3(away, -away, 2 * away)), TraceOptions{});
        EXPECT_LE(differing(picture(t), want, 1e-3), 1) << "moved by " << away;
    }
}

TEST(ScaledDistances, agree_with_povray_s_lengths_where_those_are_small) {
    Traced scaled(scene_of_scale(1.0, Vec3(0.0)), TraceOptions{});
    TraceOptions options;
    options.distances = Distances::povray;
    Traced absolute(scene_of_scale(1.0, Vec3(0.0)), options);
    EXPECT_LE(differing(picture(scaled), picture(absolute), 1e-6), 1);
}

/// Light at grazing incidence: every point of a convex shape that faces the lamp is lit.
TEST(ScaledDistances, no_acne_on_any_shape_under_a_grazing_lamp) {
    const Texture white = texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0));
    for (const double k : {1e-6, 1e-3, 1.0, 1e3, 1e9}) {
        const Vec3 c = k * Vec3(1, 2, 3);
        const std::vector<Shape> shapes = {Sphere{c, k},
                                           Box{c - Vec3(k), c + Vec3(k)},
                                           Cone{c - Vec3(0, k, 0), k, c + Vec3(0, k, 0), k, false},
                                           Cone{c - Vec3(0, k, 0), k, c + Vec3(0, k, 0), 0.2 * k, false},
                                           Disc{c, Vec3(0, 1, 0), k, 0},
                                           Plane{Vec3(0, 1, 0), c.y}};
        for (const Shape& shape : shapes) {
            Traced t(scene_with({object(shape, white)}, {point_light(c + k * Vec3(700, 1.2, -300))}), TraceOptions{});
            int lit = 0;
            for (int i = 0; i < 4000; ++i) {
                const Vec3 from = c + k * Vec3(3 * std::sin(i * 0.7), 2 + std::sin(i * 1.3), 3 * std::cos(i * 0.7));
                const Vec3 to = c + 0.95 * k * Vec3(std::sin(i * 2.1), std::sin(i * 0.31), std::cos(i * 1.7));
                RayLog log;
                const Radiance seen = t.tracer->camera_ray({from, unit(to - from)}, log);
                const RayNode& node = log.nodes.front();
                if (node.end != RayNode::End::surface || node.shadows.empty()) continue;
                ++lit;
                ASSERT_EQ(node.shadows[0].transmitted, Rgb(1.0)) << name(shape) << " of size " << k << ", ray " << i;
                ASSERT_GT(seen.rgb.g, 0.0);
            }
            EXPECT_GT(lit, 500) << name(shape);
        }
    }
}

/// A lamp in a closed box lights nothing outside, and a floor that touches a wall lets no light under it.
TEST(ScaledDistances, no_leaks_at_contacts) {
    const Texture white = texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0));
    for (const double k : {1e-6, 1.0, 1e9}) {
        Traced t(scene_with({object(floor_plane(), white), object(Box{k * Vec3(-1, 0, -1), k * Vec3(1, 2, 1)}, white)},
                            {point_light(k * Vec3(0.1, 0.9, 0.2))}),
                 TraceOptions{});
        for (int i = 0; i < 2000; ++i) {
            const double x = 1 + std::pow(10.0, -7.0 + 7.0 * (i % 100) / 100.0);
            const Rgb seen = t.look(k * Vec3(x, 1.0, 0.9 * std::sin(i)), {0, -1, 0}).rgb;
            ASSERT_EQ(seen, Rgb(0.0)) << "scale " << k << " at " << x;
        }
    }
}

TEST(PovrayDistances, are_absolute) {
    const Texture white = texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0));
    const auto shadowed = [&](double radius) {
        Traced t(scene_with({object(floor_plane(), white), object(Sphere{Vec3(0, radius, 0), radius}, white)}, {point_light({0, 4, 0})}));
        return t.look({3 + 0.9 * radius, 1, 0}, {-3, -1, 0}).rgb.g;
    };
    EXPECT_EQ(shadowed(1e-2), 0.0);
    EXPECT_GT(shadowed(4e-4), 0.9) << "blockers within 1e-3 cast no shadow";
    Traced far(scene_with({object(floor_plane(-2e7), texture(color(Rgb(1.0)), plain(Rgb(1.0))))}));
    EXPECT_EQ(far.look({0, 0, 0}, {0, -1, 0}).rgb, Rgb(0.0)) << "nothing exists beyond 1e7";
}

// An interpolated normal faces a light that stands below the triangle's plane: POV-Ray lights the surface, since nothing else is in the
// way. A ray that left along the interpolated normal would meet the triangle itself.
TEST(ScaledDistances, an_open_smooth_face_does_not_shadow_itself) {
    const Vec3 tilted = unit(Vec3(1, 0.5, 0));
    const Scene s = scene_with({object(SmoothTriangle{Vec3(-5, 0, -5), Vec3(-5, 0, 5), Vec3(5, 0, 0), tilted, tilted, tilted},
                                       texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0)))},
                               {point_light({100, -10, 0})});
    for (const TraceOptions& options : {povray_options(), TraceOptions{}}) {
        Traced t(s, options);
        const Vec3 l = unit(Vec3(100, -10, 0));
        EXPECT_RGB_NEAR(t.look({0, 3, 0}, {0, -1, 0}).rgb, Rgb(dot(tilted, l)), 1e-12);
    }
}

}  // namespace
}  // namespace rt::tracer_scale_test
