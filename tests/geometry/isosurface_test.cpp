// Isosurfaces: where POV-Ray's own search ends. The places were told by its trace().
#include "geometry/isosurface.h"

#include <gtest/gtest.h>

namespace rt::isosurface_test {
namespace {

using Op = Function::Op;

/// x^2 + y^2 + z^2 - c, times a sign.
std::shared_ptr<const Function> ball(double c = 1.0, double sign = 1.0) {
    Function f;
    f.parameters = 3;
    f.stack = 3;
    for (std::uint32_t i = 0; i < 3; ++i) {
        f.steps.push_back({.op = Op::argument, .index = i});
        f.steps.push_back({.op = Op::argument, .index = i});
        f.steps.push_back({.op = Op::multiply});
        if (i > 0) f.steps.push_back({.op = Op::add});
    }
    f.steps.push_back({.op = Op::constant, .value = c});
    f.steps.push_back({.op = Op::subtract});
    f.steps.push_back({.op = Op::constant, .value = sign});
    f.steps.push_back({.op = Op::multiply});
    return std::make_shared<const Function>(f);
}

/// sin(10 x)
std::shared_ptr<const Function> waves() {
    Function f;
    f.parameters = 3;
    f.stack = 2;
    f.steps = {{.op = Op::argument, .index = 0}, {.op = Op::constant, .value = 10.0}, {.op = Op::multiply}, {.op = Op::sin}};
    return std::make_shared<const Function>(f);
}

Isosurface in_box(std::shared_ptr<const Function> function) {
    Isosurface shape;
    shape.function = std::move(function);
    shape.max_gradient = 5.0;
    shape.accuracy = 0.01;
    shape.container = Box{Vec3(-1.5), Vec3(1.5)};
    return shape;
}

Ray along_x(double from) { return {Vec3(from, 0.2, 0.1), Vec3(1.0, 0.0, 0.0)}; }

/// x of the nearest hit.
double met(const Isosurface& shape, const Ray& ray) {
    ShapeHit hit;
    return intersect(shape, ray, {1e-4, infinity}, hit) ? ray.at(hit.t).x : NAN;
}

std::vector<double> all_met(const Isosurface& shape, const Ray& ray) {
    std::vector<double> places;
    visit_hits(shape, ray, {1e-4, infinity}, [&](const ShapeHit& hit) {
        places.push_back(ray.at(hit.t).x);
        return false;
    });
    return places;
}

TEST(Isosurface, EndsWherePovrayEnds) {
    Isosurface shape = in_box(ball());
    EXPECT_NEAR(met(shape, along_x(-3.0)), -0.97265625, 1e-12);
    EXPECT_NEAR(met(shape, {Vec3(-3.0, 0.2, 0.1), unit(Vec3(1.0, 0.1, 0.0))}), -0.90234375, 1e-12);
    EXPECT_NEAR(met(shape, along_x(0.0)), 0.97890625, 1e-12) << "from inside it begins five accuracies later";
    EXPECT_NEAR(met(shape, {Vec3(0.0, 0.2, 0.1), unit(Vec3(1.0, 0.1, 0.0))}), 0.95049191551765, 1e-12);
    shape.accuracy = 0.001;
    EXPECT_NEAR(met(shape, along_x(-3.0)), -0.97412109375, 1e-12);
    shape.accuracy = 0.01;
    shape.max_gradient = 1.0;
    EXPECT_NEAR(met(shape, along_x(-3.0)), -0.744140625, 1e-12) << "steeper than it was said to be";
    shape = in_box(ball(0.0));
    shape.threshold = 1.0;
    EXPECT_NEAR(met(shape, along_x(-3.0)), -0.97265625, 1e-12);
    shape = in_box(ball());
    shape.container = Sphere{Vec3(0.0), 1.5};
    EXPECT_NEAR(met(shape, along_x(-3.0)), -0.973376051431, 1e-11);
}

TEST(Isosurface, LengthsAreThoseOfTheRay) {
    // Twice as large in the world: x = -1.986328125 there.
    EXPECT_NEAR(met(in_box(ball()), {Vec3(-1.5, 0.1, 0.05), Vec3(0.5, 0.0, 0.0)}), -0.9931640625, 1e-12);
}

TEST(Isosurface, TheContainerClosesIt) {
    Isosurface shape = in_box(ball(4.0));
    EXPECT_EQ(met(shape, along_x(-3.0)), -1.5);
    EXPECT_EQ(met(shape, along_x(0.0)), 1.5);
    ShapeHit hit;
    ASSERT_TRUE(intersect(shape, along_x(-3.0), {}, hit));
    EXPECT_EQ(normal(shape, along_x(-3.0).at(hit.t), hit), Vec3(-1.0, 0.0, 0.0));
    shape.open = true;
    EXPECT_TRUE(std::isnan(met(shape, along_x(-3.0))));
    EXPECT_TRUE(std::isnan(met(shape, along_x(0.0))));
    Isosurface hollow = in_box(ball(1.0, -1.0));
    EXPECT_EQ(met(hollow, along_x(-3.0)), -1.5);
    EXPECT_NEAR(met(hollow, along_x(0.0)), 0.978515625, 1e-12) << "from outside it begins at the origin";
    hollow.open = true;
    EXPECT_NEAR(met(hollow, along_x(-3.0)), -0.97265625, 1e-12);
    hollow.container = Sphere{Vec3(0.0), 1.5};
    hollow.open = false;
    ASSERT_TRUE(intersect(hollow, {Vec3(-3.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0)}, {}, hit));
    EXPECT_EQ(normal(hollow, Vec3(-1.5, 0.0, 0.0), hit), Vec3(-1.5, 0.0, 0.0));
}

TEST(Isosurface, MaxTraceCountsTheContainerToo) {
    Isosurface shape = in_box(waves());
    shape.max_gradient = 10.0;
    shape.accuracy = 0.001;
    EXPECT_EQ(all_met(shape, along_x(-3.0)).size(), 1U);
    ShapeHit behind;
    ASSERT_TRUE(intersect(shape, along_x(-3.0), {1.6, infinity}, behind));
    EXPECT_NEAR(behind.t, 3.0 - 1.256103515625, 1e-12) << "what lies before the interval does not count";
    shape.max_trace = 3;
    const std::vector<double> three = all_met(shape, along_x(-3.0));
    ASSERT_EQ(three.size(), 3U);
    EXPECT_EQ(three[0], -1.5);
    EXPECT_NEAR(three[1], -1.256103515625, 1e-12);
    EXPECT_NEAR(three[2], -0.942141695023, 1e-11) << "it goes on five accuracies behind";
    shape.max_trace = most_isosurface_hits;
    EXPECT_NEAR(met(shape, along_x(-1.45)), -1.25662353515625, 1e-12);
    const std::vector<double> from_inside = all_met(shape, along_x(-1.3));
    EXPECT_NEAR(from_inside.at(0), -1.256104736328, 1e-11);
    EXPECT_NEAR(from_inside.at(7), 0.943285885706, 1e-11);
    shape.open = true;
    EXPECT_NEAR(met(shape, along_x(-3.0)), -1.256103515625, 1e-12);
}

TEST(Isosurface, NormalsAreDifferencesOverAnAccuracy) {
    const Isosurface shape = in_box(ball());
    const Vec3 n = unit(normal(shape, Vec3(-0.97265625, 0.2, 0.1), {}));
    EXPECT_NEAR(n.x, -0.972821726978, 1e-11);
    EXPECT_NEAR(n.y, 0.206094317099, 1e-11);
    EXPECT_NEAR(n.z, 0.105560503880, 1e-11);
}

TEST(Isosurface, ContainsWhatIsBelowTheThreshold) {
    const Isosurface shape = in_box(ball(4.0));
    EXPECT_TRUE(contains(shape, Vec3(1.0, 1.0, 0.0)));
    EXPECT_FALSE(contains(shape, Vec3(1.2, 1.2, 1.2)));
    EXPECT_FALSE(contains(shape, Vec3(1.6, 0.0, 0.0)));
    EXPECT_FALSE(contains(in_box(ball(1.0, -1.0)), Vec3(0.0)));
}

TEST(Isosurface, EndsWhateverItIsAskedFor) {
    Isosurface shape = in_box(waves());
    shape.accuracy = 1e-300;
    shape.max_gradient = 1e300;
    shape.open = true;
    EXPECT_TRUE(std::isnan(met(shape, along_x(-3.0)))) << "too far to search";
    Function nothing;  // 0 / 0
    nothing.parameters = 3;
    nothing.stack = 2;
    nothing.steps = {{.op = Op::constant}, {.op = Op::constant}, {.op = Op::divide}};
    shape.function = std::make_shared<const Function>(nothing);
    shape.accuracy = 1e-3;
    EXPECT_TRUE(std::isnan(met(shape, along_x(-3.0))));
}

}  // namespace
}  // namespace rt::isosurface_test
