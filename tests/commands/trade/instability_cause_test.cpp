// Causes of disagreements between records that are made by hand.
#include "commands/trade/instability_cause.h"

#include <gtest/gtest.h>

#include <functional>

#include "world/compile.h"

namespace rt::instability_cause_test {
namespace {

/// A plane y = 0 and another 1e-7 above it for x > 100, a lamp high over the origin and one on the horizon.
class Cause : public testing::Test {
protected:
    Cause() {
        Scene scene;
        Object plane, disc;
        plane.shape = Plane{{0, 1, 0}, 0.0};
        disc.shape = Disc{{110, 1e-7, 0}, {0, 1, 0}, 10.0, 0.0};
        scene.objects = {plane, disc};
        Light lamp;
        lamp.color = Rgb(1.0);
        scene.lights.assign(2, lamp);
        scene.lights[0].location = {0, 10, 0}, scene.lights[1].location = {1e5, 1, 0};
        world_ = compile(scene, {}, [](std::string_view) {});
    }

    /// A camera's ray straight down onto the plane, its mirrored ray into nothing.
    static RayLog log(double x = 0.0) {
        RayLog log;
        RayNode& node = log.nodes.emplace_back();
        node.ray = {{x, 5, 0}, {0, -1, 0}};
        node.object = 0, node.t = 5.0, node.point = {x, 0, 0}, node.normal = {0, 1, 0};
        node.layers = {{Rgb(1.0), 0, 0}};
        node.shadows = {{0, 0, Rgb(1.0), {}}, {1, 0, Rgb(1.0), {}}};
        RayNode& mirrored = log.nodes.emplace_back();
        mirrored.parent = 0, mirrored.kind = RayNode::Kind::reflected, mirrored.end = RayNode::End::background;
        mirrored.ray = {{x, 0, 0}, {0, 1, 0}};
        return log;
    }

    std::optional<UnstableCause> of(const std::function<void(std::vector<RayNode>&)>& change, double x = 0.0) const {
        RayLog other = log(x);
        change(other.nodes);
        return disagreement(world_, log(x), other);
    }

    World world_;
};

TEST_F(Cause, NoneOfTheSame) {
    EXPECT_EQ(of([](auto&) {}), std::nullopt);
    EXPECT_EQ(of([](auto& n) { n[0].t *= 1.0 + 1e-12, n[0].radiance = Rgb(7.0); }), std::nullopt);
}

TEST_F(Cause, OfTheFirstHit) {
    EXPECT_EQ(of([](auto& n) { n[0].end = RayNode::End::background; }), UnstableCause::silhouette);
    EXPECT_EQ(of([](auto& n) { n[0].object = 1, n[0].t = 7.0; }), UnstableCause::silhouette);
    EXPECT_EQ(of([](auto& n) { n[0].part = 1; }), UnstableCause::silhouette) << "another face of a box";
    EXPECT_EQ(of([](auto& n) { n[0].normal = {1, 0, 0}; }), UnstableCause::silhouette) << "another face of a mesh";
    EXPECT_EQ(of([](auto& n) { n[0].object = 1, n[0].t *= 1.0 + 1e-9; }), UnstableCause::coincident);
    EXPECT_EQ(of([](auto& n) { n[0].object = 1, n[0].normal = {1, 0, 0}; }), UnstableCause::silhouette) << "where two objects meet";
    EXPECT_EQ(of([](auto& n) { n[0].layers[0].rgb = Rgb(0.0); }), UnstableCause::pattern);
}

TEST_F(Cause, OfTheSameObjectsOtherSides) {
    EXPECT_EQ(of([](auto& n) { n[0].t = 7.0; }), UnstableCause::secondary) << "the same face, farther away";
    EXPECT_EQ(of([](auto& n) { n[0].inside = true; }), UnstableCause::secondary);
    EXPECT_EQ(of([](auto& n) { n[0].normal = unit(Vec3(1, 2, 0)); }), UnstableCause::silhouette) << "a face that is turned by 27 degrees";
    EXPECT_EQ(of([](auto& n) { n[0].object = 1, n[0].normal = {0, -1, 0}; }), UnstableCause::coincident) << "the back of another";
}

TEST_F(Cause, OfLaterRays) {
    EXPECT_EQ(of([](auto& n) { n.pop_back(); }), UnstableCause::depth);
    EXPECT_EQ(of([](auto& n) { n.push_back(n[1]); }), UnstableCause::depth);
    EXPECT_EQ(of([](auto& n) { n[1].end = RayNode::End::weight; }), UnstableCause::depth);
    EXPECT_EQ(of([](auto& n) { n[1].end = RayNode::End::level; }), UnstableCause::depth);
    EXPECT_EQ(of([](auto& n) { n[1].kind = RayNode::Kind::refracted; }), UnstableCause::depth);
    EXPECT_EQ(of([](auto& n) { n[1].kind = RayNode::Kind::total; }), UnstableCause::grazing) << "the critical angle";
    EXPECT_EQ(of([](auto& n) { n[1].end = RayNode::End::surface; }), UnstableCause::secondary);
}

TEST_F(Cause, OfShadows) {
    const auto dark = [](std::size_t lamp) { return [lamp](auto& n) { n[0].shadows[lamp].transmitted = Rgb(0.0); }; };
    EXPECT_EQ(of(dark(0)), UnstableCause::shadow);
    EXPECT_EQ(of(dark(1)), UnstableCause::grazing);
    EXPECT_EQ(of(dark(0), 110.0), UnstableCause::coincident) << "the disc is above";
    EXPECT_EQ(of([](auto& n) { n[0].shadows.pop_back(); }), UnstableCause::grazing);
    EXPECT_EQ(of([](auto& n) { n[0].shadows[0].crossed = {1}; }), UnstableCause::shadow);
    EXPECT_EQ(of([](auto& n) { n[0].shadows[0].transmitted = Rgb(0.5); }), std::nullopt);
}

TEST_F(Cause, OfTheFirstDisagreementIsTold) {
    EXPECT_EQ(of([](auto& n) { n[0].layers[0].rgb = Rgb(0.0), n.pop_back(); }), UnstableCause::pattern);
}

TEST_F(Cause, OfLightThatIsSensitive) {
    RayLog plain = log();
    plain.nodes[0].shadows.pop_back();
    EXPECT_EQ(sensitivity(world_, plain), std::nullopt);
    EXPECT_EQ(sensitivity(world_, log()), UnstableCause::grazing) << "a lamp on the horizon";
    EXPECT_EQ(sensitivity(world_, log(110.0)), UnstableCause::coincident);
    plain.nodes[0].ray.direction = unit(Vec3(1, -1e-4, 0));
    EXPECT_EQ(sensitivity(world_, plain), UnstableCause::grazing) << "seen from the side";
}

TEST(Causes, HaveNames) {
    EXPECT_EQ(name_of(unstable_cause_names, UnstableCause::silhouette), "silhouette");
    EXPECT_EQ(name_of(unstable_cause_names, UnstableCause::coincident), "near-coincident");
    EXPECT_EQ(name_of(unstable_cause_names, UnstableCause::grazing), "grazing");
    EXPECT_EQ(name_of(unstable_cause_names, UnstableCause::depth), "depth");
    for (std::size_t i = 0; i < unstable_causes; ++i) EXPECT_EQ(static_cast<std::size_t>(unstable_cause_names[i].second), i);
}

}  // namespace
}  // namespace rt::instability_cause_test
