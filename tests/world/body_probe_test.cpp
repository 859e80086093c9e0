// What objects answer while a scene is read.
#include "world/body_probe.h"

#include <gtest/gtest.h>

namespace rt::body_probe_test {
namespace {

Object object(Shape shape, bool inverse = false) {
    Object made;
    made.shape = std::move(shape);
    made.inverse = inverse;
    return made;
}

/// A box without the ball in it.
Bodies hollowed() {
    Bodies bodies;
    bodies.objects = {object(Box{}), object(Sphere{Vec3(0.0), 0.5}, true)};
    SetNode all, box, ball;
    all.kind = SetNode::Kind::all;
    all.size = 3;
    ball.index = 1;
    bodies.sets = {{0, {all, box, ball}, {}}};
    return bodies;
}

TEST(BodyProbe, TracesToTheNearestSurface) {
    const auto probe = make_body_probe({{object(Sphere{}), object(Sphere{Vec3(0.0, 5.0, 0.0), 1.0})}, {}});
    const auto met = probe->trace(Vec3(-3.0, 0.2, 0.1), Vec3(5.0, 0.0, 0.0));
    ASSERT_TRUE(met);
    EXPECT_NEAR(met->point.x, -0.974679434481, 1e-12);
    EXPECT_NEAR(met->normal.x, -0.974679434481, 1e-12);
    EXPECT_NEAR(met->normal.y, 0.2, 1e-12);
    EXPECT_EQ(probe->trace(Vec3(0.0, 9.0, 0.0), Vec3(0.0, -1.0, 0.0)).value().point.y, 6.0);
    EXPECT_FALSE(probe->trace(Vec3(-3.0, 2.0, 0.0), Vec3(1.0, 0.0, 0.0)));
    EXPECT_FALSE(probe->trace(Vec3(0.0), Vec3(0.0)));
    EXPECT_FALSE(probe->trace(Vec3(NAN), Vec3(1.0, 0.0, 0.0)));
}

TEST(BodyProbe, TracesInTheRangeOfPovray) {
    const auto probe = make_body_probe({{object(Plane{Vec3(0.0, 1.0, 0.0), 0.0})}, {}});
    const auto from = [&](double y) { return probe->trace(Vec3(0.0, y, 0.0), Vec3(0.0, -1.0, 0.0)).has_value(); };
    EXPECT_TRUE(from(1e-3));
    EXPECT_FALSE(from(1e-5));
    EXPECT_TRUE(from(9e6));
    EXPECT_FALSE(from(1e8));
}

TEST(BodyProbe, NormalsAreThoseOfTheShapeNotTheViewer) {
    const auto plane = make_body_probe({{object(Plane{Vec3(0.0, 1.0, 0.0), 0.0})}, {}});
    EXPECT_EQ(plane->trace(Vec3(0.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0)).value().normal, Vec3(0.0, 1.0, 0.0));
    const auto inverse = make_body_probe({{object(Sphere{}, true)}, {}});
    EXPECT_EQ(inverse->trace(Vec3(-3.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0)).value().normal.x, 1.0);
    const Triangle up{Vec3(-1.0, 0.0, -1.0), Vec3(1.0, 0.0, -1.0), Vec3(0.0, 0.0, 1.0)};
    EXPECT_EQ(make_body_probe({{object(up)}, {}})->trace(Vec3(0.0, 1.0, 0.0), Vec3(0.0, -1.0, 0.0)).value().normal.y, 1.0);
    const Triangle down{up.a, up.c, up.b};
    EXPECT_EQ(make_body_probe({{object(down)}, {}})->trace(Vec3(0.0, 1.0, 0.0), Vec3(0.0, -1.0, 0.0)).value().normal.y, -1.0);
    const auto met = make_body_probe(hollowed())->trace(Vec3(0.0), Vec3(1.0, 0.0, 0.0));
    EXPECT_EQ(met.value().point.x, 0.5);
    EXPECT_EQ(met.value().normal.x, -1.0);
}

TEST(BodyProbe, ContainsWhatAnyOfItsObjectsContains) {
    Bodies bodies = hollowed();
    bodies.objects.push_back(object(Sphere{Vec3(5.0, 0.0, 0.0), 1.0}));
    const auto probe = make_body_probe(bodies);
    EXPECT_FALSE(probe->contains(Vec3(0.0)));
    EXPECT_TRUE(probe->contains(Vec3(0.7, 0.0, 0.0)));
    EXPECT_TRUE(probe->contains(Vec3(5.5, 0.0, 0.0)));
    EXPECT_FALSE(probe->contains(Vec3(3.0, 0.0, 0.0)));
    EXPECT_TRUE(make_body_probe({{object(Disc{})}, {}})->contains(Vec3(9.0, -1.0, 0.0)));
    EXPECT_FALSE(make_body_probe({})->contains(Vec3(0.0)));
}

}  // namespace
}  // namespace rt::body_probe_test
