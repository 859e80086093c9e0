// The course's rules, one by one, in scenes whose answers can be written down.
#include <gtest/gtest.h>

#include "shading/course_terms.h"
#include "tests/trace/tracer_scene.h"
#include "trace/course_surface.h"
#include "trace/pixel_rays.h"

namespace rt::course_test {
namespace {

using namespace tracer_test;

TraceOptions by(const CourseRules& rules = {}) {
    TraceOptions options;
    options.course = rules;
    return options;
}

CourseRules with(bool CourseRules::*rule) {
    CourseRules rules;
    rules.*rule = true;
    return rules;
}

Finish mirror(double reflection) {
    Finish f = plain();
    f.reflection.min = f.reflection.max = Rgb(reflection);
    return f;
}

/// A floor that shows its pigment, wherever the lamps are.
Object glowing_floor(double height, const Rgb& c) { return object(floor_plane(height), texture(color(c), plain(Rgb(1.0)))); }

Object glass_ball(const Vec3& centre, double radius, const Rgb& pigment, double filter, double ior) {
    Interior interior;
    interior.ior = ior;
    return object(Sphere{centre, radius}, texture(color(pigment, filter), plain()), interior);
}

const Vec3 down(0, -1, 0);

TEST(CourseLight, AmbientOnceAndDiffuseForEachLamp) {
    const Vec3 a(3, 4, 0), b(0, 5, 0);
    Traced t(scene_with({object(floor_plane(), texture(color({0.5, 1.0, 0.2}), plain(Rgb(0.3), 0.8)))},
                        {point_light(a, {1, 0.5, 0.25}), point_light(b, Rgb(0.1))}),
             by());
    const Rgb lamps = 0.8 * (Rgb(1, 0.5, 0.25) * 0.8 + Rgb(0.1));
    EXPECT_RGB_NEAR(t.look({0, 2, 0}, down).rgb, Rgb(0.5, 1.0, 0.2) * (Rgb(0.3) + lamps), 1e-14);
}

TEST(CourseLight, NothingBehindAnythingAndNoBackground) {
    Traced t(scene_with({}, {}, Rgb(0.7)), by());
    EXPECT_EQ(t.look({0, 0, 0}, down).rgb, Rgb(0.0));
}

TEST(CourseHighlight, BlinnPhongsExponentFollowsFromTheRoughness) {
    EXPECT_DOUBLE_EQ(course::blinn_phong(0.9, 0.5), std::pow(0.9, 6.0));
    EXPECT_DOUBLE_EQ(course::blinn_phong(0.5, 1.0), 1.0);   // exponent 0
    EXPECT_DOUBLE_EQ(course::blinn_phong(0.5, 2.0), 1.0);   // not below 0
    EXPECT_DOUBLE_EQ(course::blinn_phong(-0.5, 0.5), 0.0);  // nor the cosine
    EXPECT_DOUBLE_EQ(course::blinn_phong(1.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(course::blinn_phong(0.999, 0.0), 0.0);
}

TEST(CourseHighlight, HasTheColourOfThePigmentAndNoCosine) {
    Finish f = plain();
    f.specular = 0.5;
    f.roughness = 0.5;
    // Light and viewer at 60 degrees on opposite sides: n.h = 1, n.l = 1/2.
    const double s = std::sin(pi / 3), c = 0.5;
    Traced t(scene_with({object(floor_plane(), texture(color({1.0, 0.5, 0.25}), f))}, {point_light(Vec3(10 * s, 10 * c, 0), Rgb(0.8))}),
             by());
    EXPECT_RGB_NEAR(t.look({-3 * s, 3 * c, 0}, {s, -c, 0}).rgb, 0.8 * 0.5 * Rgb(1.0, 0.5, 0.25), 1e-13);
}

TEST(CourseHighlight, CookTorranceInClosedForm) {
    const Vec3 n(0, 1, 0);
    const double roughness = 0.6, alpha = 0.36, ior = 1.5, f0 = 0.04;
    EXPECT_NEAR(course::cook_torrance(n, n, n, roughness, ior), f0 / (4 * pi * alpha * alpha), 1e-15);
    // 60 degrees on both sides: D = 1/(pi alpha^2), G = G1^2 with tan^2 = 3, F = F(1/2).
    const double s = std::sin(pi / 3), c = 0.5, a2 = alpha * alpha;
    const double G1 = 2 / (1 + std::sqrt(1 + 3 * a2)), F = f0 + (1 - f0) / 32;
    EXPECT_NEAR(course::cook_torrance(n, {s, c, 0}, {-s, c, 0}, roughness, ior), G1 * G1 * F / (pi * a2 * 4 * c), 1e-14);
    // Nearly along the surface the divisor stays at 4/16.
    const double v = 1.0 / 64, sv = std::sqrt(1 - v * v);
    const Vec3 grazing(sv, v, 0), h = unit(n + grazing);
    const double hn = dot(h, n), D = a2 / (pi * sqr(hn * hn * (a2 - 1) + 1));
    const double Gv = 2 / (1 + std::sqrt(1 + a2 * (1 - v * v) / (v * v))), Fh = f0 + (1 - f0) * std::pow(1 - hn, 5);
    EXPECT_NEAR(course::cook_torrance(n, n, grazing, roughness, ior), D * Gv * Fh / 0.25, 1e-14);
    EXPECT_EQ(course::cook_torrance(n, n, -n, roughness, ior), 0.0);  // no half vector
    EXPECT_EQ(course::cook_torrance(n, n, n, 0.0, ior), 0.0);
}

TEST(CourseHighlight, AltbrdfChangesTheHighlightAlone) {
    Finish f = plain(Rgb(0.1), 0.4);
    f.specular = 0.5, f.roughness = 0.6, f.ior = 1.5;
    Interior interior;
    interior.ior = 1.5;
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(0.5)), f), interior)}, {point_light({0, 9, 0})}),
             by(with(&CourseRules::cook_torrance)));
    const double highlight = 0.04 / (4 * pi * 0.36 * 0.36);
    EXPECT_RGB_NEAR(t.look({0, 2, 0}, down).rgb, Rgb(0.5 * (0.1 + 0.4 + 0.5 * highlight)), 1e-14);
}

TEST(CourseShares, SumToOne) {
    for (const double filter : {0.0, 0.4, 1.0})
        for (const double reflection : {0.0, 0.3, 1.0})
            for (const double F : {0.0, 0.25, 1.0})
                for (const bool total : {false, true}) {
                    const RayNode::Shares s = course::shares({.filter = filter, .reflection = reflection}, F, total);
                    EXPECT_NEAR(s.local + s.reflection + s.transmission, 1.0, 1e-15);
                    EXPECT_DOUBLE_EQ(s.local, (1 - filter) * (1 - reflection));
                    EXPECT_DOUBLE_EQ(s.transmission, total ? 0.0 : filter * (1 - F));
                }
}

TEST(CourseShares, MirrorsShowWhatTheySeeInTheColourOfThePigment) {
    Finish f = mirror(0.75);
    f.ambient = Rgb(0.4);
    Traced t(scene_with({object(floor_plane(), texture(color({1, 0.5, 0.25}), f)), glowing_floor(10, Rgb(0.8))}), by());
    EXPECT_RGB_NEAR(t.look({0, 2, 0}, down).rgb, Rgb(1, 0.5, 0.25) * (0.25 * 0.4 + 0.75 * 0.8), 1e-14);
}

TEST(CourseShares, FresnelMirrorsTransparentObjectsBySchlicksLaw) {
    const Scene scene = scene_with(
        {object(floor_plane(), texture(color(Rgb(1.0), 0.5), plain())), glowing_floor(10, Rgb(0.8)), glowing_floor(-10, Rgb(0.2))});
    Scene glass = scene;
    Interior interior;
    interior.ior = 1.5;
    glass.objects[0].interior = Shared<Interior>(interior);
    Traced off(glass, by()), on(glass, by(with(&CourseRules::fresnel)));
    EXPECT_RGB_NEAR(off.look({0, 2, 0}, down).rgb, Rgb(0.5 * 0.2), 1e-14);
    EXPECT_RGB_NEAR(on.look({0, 2, 0}, down).rgb, Rgb(0.5 * 0.96 * 0.2 + 0.5 * 0.04 * 0.8), 1e-14);
}

TEST(CourseShares, TotalReflectionTakesTheTransmittedShare) {
    // From inside a ball of glass at 45 degrees and more nothing leaves.
    Traced t(scene_with({glass_ball({0, 0, 0}, 1, Rgb(0.5), 0.8, 2.0)}), by());
    RayLog log;
    t.tracer->camera_ray({{0.8, 0, 0}, Vec3(0, 1, 0)}, log);
    EXPECT_EQ(log.nodes[0].shares->transmission, 0.0);
    EXPECT_DOUBLE_EQ(log.nodes[0].shares->reflection, 0.8);
    EXPECT_TRUE(log.nodes[0].inside);
    EXPECT_EQ(log.nodes[1].kind, RayNode::Kind::reflected);
}

TEST(CourseTransmission, TakesThePigmentOnEntryAlone) {
    const Rgb pigment(1, 0.5, 0.25);
    Traced t(scene_with({glass_ball({0, 5, 0}, 1, pigment, 0.5, 1.0), glowing_floor(0, Rgb(0.8))}), by());
    EXPECT_RGB_NEAR(t.look({0, 9, 0}, down).rgb, 0.5 * 0.5 * 0.8 * pigment, 1e-14);
}

TEST(CourseTransmission, FadesByBeersLawInstead) {
    const Rgb pigment(1, 0.5, 0.25);
    Traced t(scene_with({glass_ball({0, 5, 0}, 1, pigment, 0.5, 1.0), glowing_floor(0, Rgb(0.8))}), by(with(&CourseRules::beers)));
    const double d = 2.0 - CourseRules::offset;
    const Rgb left(1.0, std::exp(-0.15 * d * 0.5), std::exp(-0.15 * d * 0.75));
    EXPECT_RGB_NEAR(t.look({0, 9, 0}, down).rgb, 0.5 * 0.5 * 0.8 * left, 1e-14);
}

TEST(CourseTransmission, BendsBySnellsLawInAndOut) {
    Traced t(scene_with({glass_ball({0, 0, 0}, 1, Rgb(1.0), 1.0, 1.5)}), by());
    RayLog log;
    const double sin_in = 0.6;
    t.tracer->camera_ray({{sin_in, 3, 0}, down}, log);
    ASSERT_EQ(log.nodes.size(), 3u);
    const auto sine = [](const Vec3& n, const Vec3& d) { return length(cross(n, d)); };
    EXPECT_NEAR(sine(log.nodes[0].normal, log.nodes[1].ray.direction), sin_in / 1.5, 1e-12);
    EXPECT_NEAR(sine(log.nodes[1].normal, log.nodes[2].ray.direction), sine(log.nodes[1].normal, log.nodes[1].ray.direction) * 1.5, 1e-12);
    EXPECT_FALSE(log.nodes[0].inside);
    EXPECT_TRUE(log.nodes[1].inside);
    EXPECT_EQ(log.nodes[2].end, RayNode::End::background);
}

TEST(CourseRays, SixAfterTheCameras) {
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(1.0)), mirror(1.0))),
                         object(floor_plane(5), texture(color(Rgb(1.0)), mirror(1.0)))}),
             by());
    RayLog log;
    t.tracer->camera_ray({{0, 2, 0}, down}, log);
    EXPECT_EQ(log.nodes.size(), 7u);
    EXPECT_EQ(log.nodes.back().level, 7);
    EXPECT_EQ(log.nodes.back().shares->reflection, 1.0);  // what it would have taken
}

TEST(CourseRays, BeginAThousandthAlongThemselves) {
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(1.0), 0.5), mirror(0.5)))}), by());
    RayLog log;
    const Vec3 d = unit(Vec3(3, -4, 0));
    t.tracer->camera_ray({{0, 4, 0}, d}, log);
    ASSERT_EQ(log.nodes.size(), 3u);
    EXPECT_EQ(log.nodes[1].kind, RayNode::Kind::reflected);
    EXPECT_RGB_NEAR(log.nodes[1].ray.origin, Vec3(3.0006, 0.0008, 0), 1e-14);
    EXPECT_EQ(log.nodes[2].kind, RayNode::Kind::refracted);
    EXPECT_RGB_NEAR(log.nodes[2].ray.origin, Vec3(3.0006, -0.0008, 0), 1e-14);
}

TEST(CourseShadows, AreCastByTransparentObjectsToo) {
    const Object floor = object(floor_plane(), texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0)));
    const std::vector<Light> lamp{point_light({0, 10, 0})};
    Traced free(scene_with({floor}, lamp), by()), shaded(scene_with({floor, glass_ball({0, 5, 0}, 1, Rgb(1.0), 1.0, 1.0)}, lamp), by());
    const Vec3 from(3, 2, 0), towards(-3, -2, 0);
    EXPECT_RGB_NEAR(free.look(from, towards).rgb, Rgb(1.0), 1e-14);
    EXPECT_EQ(shaded.look(from, towards).rgb, Rgb(0.0));
    // ... but not by one behind the lamp.
    Traced behind(scene_with({floor, glass_ball({0, 12, 0}, 1, Rgb(1.0), 1.0, 1.0)}, lamp), by());
    EXPECT_RGB_NEAR(behind.look(from, towards).rgb, Rgb(1.0), 1e-14);
}

TEST(CourseShadows, BeginAThousandthAlongTheNormalOnTheViewersSide) {
    // The floor is seen through the narrow hole of a disc that hides it from the lamp at its side, unless the shadow ray begins above.
    const auto brightness_under = [](double height) {
        Traced t(scene_with({object(floor_plane(), texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0))),
                             object(Disc{Vec3(0, height, 0), Vec3(0, 1, 0), 1.0, 0.0005}, texture(color(Rgb(1.0)), plain()))},
                            {point_light({10, 5, 0})}),
                 by());
        return t.look({0, 2, 0}, down).rgb.r;
    };
    EXPECT_NEAR(brightness_under(0.0009), 5.0 / std::sqrt(125.0), 1e-14);
    EXPECT_EQ(brightness_under(0.002), 0.0);
}

TEST(CourseNormals, AreNotTurnedToTheViewer) {
    // Seen from inside, the wall of a ball turns its back to the lamp beside the viewer.
    Traced t(scene_with({object(Sphere{Vec3(0.0), 5}, texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0)))}, {point_light({1, 0, 0})}), by());
    RayLog log;
    EXPECT_EQ(t.tracer->camera_ray({{0, 0, 0}, Vec3(0, 0, 1)}, log).rgb, Rgb(0.0));
    EXPECT_RGB_NEAR(log.nodes[0].normal, Vec3(0, 0, 1), 1e-15);
    EXPECT_EQ(log.nodes[0].shadows.at(0).transmitted, Rgb(1.0));  // the lamp is seen, only behind the surface
}

TEST(CourseNormals, OfTrianglesStandWhereCornersGoCounterClockwise) {
    const auto light_on = [](const Triangle& triangle) {
        Traced t(scene_with({object(triangle, texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0)))}, {point_light({0, 10, 0})}), by());
        return t.look({0, 2, 0}, down).rgb.r;
    };
    const Vec3 a(-1, 0, 1), b(1, 0, 1), c(0, 0, -1);
    EXPECT_NEAR(light_on({a, b, c}), 1.0, 1e-14);
    EXPECT_EQ(light_on({a, c, b}), 0.0);
}

TEST(CourseShow, PigmentsOrNormalsAlone) {
    CourseRules rules;
    rules.show = CourseShow::pigment;
    const Scene scene = scene_with({object(Sphere{Vec3(0.0), 1}, texture(color({0.1, 0.2, 0.3}), mirror(0.5)))}, {point_light({9, 9, 9})});
    Traced pigments(scene, by(rules));
    EXPECT_EQ(pigments.look({0, 3, 0}, down).rgb, Rgb(0.1, 0.2, 0.3));
    rules.show = CourseShow::normals;
    Traced normals(scene, by(rules));
    EXPECT_RGB_NEAR(normals.look({0, 3, 0}, down).rgb, Rgb(0.5, 1.0, 0.5), 1e-15);
}

/// A surface that shines alike to all sides, wherever the lamp: a highlight of exponent 0.
Texture luminous(double radiance) {
    Finish f = plain();
    f.specular = radiance;
    f.roughness = 1.0;
    return texture(color(Rgb(1.0)), f);
}

TEST(CourseIndirect, ReplacesAmbientByTheMeanOfWhatArrives) {
    CourseRules rules;
    rules.indirect_samples = {64};
    // A floor in the middle of a ball that shines with 0.3: all that arrives is 0.3, tinted by nothing.
    Traced t(scene_with({object(Sphere{Vec3(0.0), 50}, luminous(0.3)),
                         object(Disc{Vec3(0.0), Vec3(0, 1, 0), 1, 0}, texture(color(Rgb(0.5)), plain(Rgb(0.9))))},
                        {point_light({0, 20, 0})}),
             by(rules));
    EXPECT_RGB_NEAR(t.look({0, 2, 0}, down).rgb, Rgb(0.3), 1e-14);
}

TEST(CourseIndirect, WeighsDirectionsByTheirCosine) {
    CourseRules rules;
    rules.indirect_samples = {64 * 64};
    // A ball of radius 3 at distance 5 above: the share of a cosine-weighted hemisphere is (3/5)^2. The lamp lies on
    // the floor, so all that the floor sees of the ball is lit.
    Traced t(scene_with({object(Sphere{Vec3(0, 5, 0), 3}, luminous(1.0)), object(floor_plane(), texture(color(Rgb(1.0)), plain()))},
                        {point_light({0, 0.01, 0})}),
             by(rules));
    EXPECT_RGB_NEAR(t.look({1.0, 1.5, 0}, {-1.0, -1.5, 0}).rgb, Rgb(0.36), 0.002);
}

TEST(CourseIndirect, BouncesAsOftenAsAsked) {
    Object wall = object(Sphere{Vec3(0.0), 50}, luminous(0.3));
    wall.inverse = true;
    const Scene scene =
        scene_with({wall, object(Disc{Vec3(0.0), Vec3(0, 1, 0), 0.01, 0}, texture(color(Rgb(0.5)), plain()))}, {point_light({0, 20, 0})});
    const auto light = [&](std::vector<int> samples) {
        CourseRules rules;
        rules.indirect_samples = std::move(samples);
        return Traced(scene, by(rules)).look({0, 2, 0}, down).rgb.r;
    };
    // The wall shines with 0.3 by itself, and with what it gathers from the wall.
    EXPECT_NEAR(light({64}), 0.3, 1e-12);
    EXPECT_NEAR(light({64, 16}), 0.6, 1e-12);
    EXPECT_NEAR(light({16, 9, 4}), 0.9, 1e-12);
    EXPECT_NEAR(light({7, 3}), 0.6, 1e-12);  // no squares
}

TEST(CourseIndirect, IsTheSameForAnyThreadsAndRegion) {
    CourseRules rules;
    rules.indirect_samples = {9, 4};
    Traced t(scene_with({object(Sphere{Vec3(0, 1, 0), 1}, texture(color({1, 0.5, 0.2}), plain(Rgb(0.0), 0.8))),
                         object(floor_plane(), texture(color(Rgb(0.9)), plain(Rgb(0.0), 0.8)))},
                        {point_light({5, 5, -5})}),
             by(rules));
    t.world->camera = {Projection::perspective, {0, 2, -6}, {0, -0.1, 1}, {1.2, 0, 0}, {0, 0.9, 0}};
    RenderOptions options;
    options.width = 24, options.height = 18, options.threads = 1, options.trace = by(rules);
    const Film whole = render(*t.world, options).film;
    options.threads = 4;
    EXPECT_EQ(render(*t.world, options).film.pixels, whole.pixels);
    const PixelRays pixel = trace_pixel(*t.world, options, 12, 10);
    EXPECT_EQ(pixel.pixel, whole.at(12, 10));
    ASSERT_EQ(pixel.samples.size(), 1u);
    EXPECT_EQ(static_cast<float>(pixel.samples[0].nodes[0].radiance.r), whole.at(12, 10).r);
}

TEST(CoursePixel, HasATreeForEachSampleOfItsGrid) {
    Traced t(scene_with({object(Sphere{Vec3(0.0), 1}, texture(color(Rgb(1.0)), plain(Rgb(0.2), 0.8)))}, {point_light({5, 5, -5})}), by());
    t.world->camera = {Projection::perspective, {0, 0, -3}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    RenderOptions options;
    options.width = options.height = 8;
    options.trace = by();
    options.sampling.method = Sampling::Method::grid;
    options.sampling.depth = 3;
    const PixelRays pixel = trace_pixel(*t.world, options, 3, 5);
    ASSERT_EQ(pixel.samples.size(), 9u);
    double sum = 0;
    for (const RayLog& log : pixel.samples) sum += static_cast<float>(log.nodes[0].radiance.g);
    EXPECT_FLOAT_EQ(pixel.pixel.g, static_cast<float>(sum / 9));
    EXPECT_EQ(pixel.pixel, render(*t.world, options).film.at(3, 5));
}

TEST(CourseTracer, OverflowIsInfiniteAndNeverNoNumber) {
    Finish f = plain(Rgb(1e300), 1e300);
    Traced t(scene_with({object(floor_plane(), texture(color({1e300, 0, 1}), f))}, {point_light({0, 5, 0}, {1e300, 1e300, 0})}), by());
    const Rgb light = t.look({0, 2, 0}, down).rgb;
    EXPECT_EQ(light.r, infinity);
    EXPECT_EQ(light.g, infinity);  // 1e600 of light on a black pigment
    EXPECT_EQ(light.b, 1e300);
}

TEST(CourseTracer, ALampOnTheSurfaceOrBehindTheViewersBackMakesNoFault) {
    Finish f = plain(Rgb(0.1), 0.5);
    f.specular = 0.5, f.roughness = 0.1;
    const Object floor = object(floor_plane(), texture(color(Rgb(1.0)), f));
    for (const bool cook_torrance : {false, true}) {
        CourseRules rules;
        rules.cook_torrance = cook_torrance;
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0, 0.001, 0), Vec3(0, -3, 0)}) {
            Traced t(scene_with({floor}, {point_light(place)}), by(rules));
            const double light = t.look({0, 2, 0}, down).rgb.r;
            EXPECT_TRUE(std::isfinite(light) && light >= 0.1) << place.y << " " << light;
        }
    }
}

TEST(CourseTracer, ManyRaysBringWhatEachBringsAndTheRecordAddsUp) {
    CourseRules rules = with(&CourseRules::fresnel);
    rules.beers = true;
    Traced t(scene_with({glass_ball({0, 1, 0}, 1, {0.9, 0.7, 0.5}, 0.7, 1.4), glass_ball({1.5, 1, 1}, 1, {0.4, 0.7, 0.9}, 0.5, 1.6),
                         object(floor_plane(), texture(color(Rgb(0.9)), mirror(0.4)))},
                        {point_light({5, 5, -5})}),
             by(rules));
    std::vector<Ray> rays;
    for (double x = -2; x < 2; x += 0.037) rays.push_back({{0, 2, -5}, unit(Vec3(x, 0.3 * x - 0.3, 5))});
    std::vector<Radiance> light(rays.size());
    t.tracer->camera_rays(rays, light);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RayLog log;
        EXPECT_EQ(light[i].rgb, t.tracer->camera_ray(rays[i], log).rgb) << i;
        EXPECT_EQ(log.nodes[0].radiance, light[i].rgb) << i;
        RayLog again = log;
        for (RayNode& node : again.nodes) node.reflection = node.refraction = node.radiance = Rgb(0.0);
        total(again);  // from the factors alone
        EXPECT_RGB_NEAR(again.nodes[0].radiance, light[i].rgb, 1e-14);
    }
}

}  // namespace
}  // namespace rt::course_test
