// Highlights as wide as a sample, against closed forms.
#include "trace/footprint.h"

#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"

namespace rt::footprint_test {
namespace {

using namespace tracer_test;

/// An orthographic camera that looks along z with samples of size 1/10, over one shiny object.
class Seen {
public:
    explicit Seen(Shape shape) {
        Finish shiny = plain(Rgb(0.0), 0.5);
        shiny.specular = 0.5;
        const Scene scene = scene_with({object(std::move(shape), texture(color(Rgb(1.0)), shiny))});
        world_ = std::make_unique<World>(compile(scene, {}, [](std::string_view) {}));
        world_->camera = {Projection::orthographic, {0, 0, -10}, {0, 0, 1}, {4, 0, 0}, {0, 3, 0}};
        rules_ = std::make_unique<DistanceRules>(Distances::scaled, world_->scene_extent, world_->scene_size);
        footprints_ = std::make_unique<Footprints>(*world_, *rules_, SampleGrid{40, 30});
    }

    /// The width of a lobe of width `alpha` where the camera's ray through (x, y) ends, lit from the camera's side.
    double widened(double alpha, double x, double y, const Vec3& from = {0, 0, -10}, bool parallel = true) {
        const Ray ray{{x, y, -10}, {0, 0, 1}};
        Hit hit;
        if (!world_->nearest(ray, {}, RayKind::image, hit)) throw std::logic_error("nothing there");
        SurfacePoint at;
        at.point = ray.at(hit.shape.t);
        at.normal = world_->normal(hit, at.point);
        if (at.normal.z > 0.0) at.normal = -at.normal;
        at.side = world_->flat_side(hit, at.normal);
        at.direction = ray.direction;
        at.object = hit.object;
        SurfaceFinish finish;
        finish.model.s = 0.5;
        const ActiveLayer layer{.color = {}, .finish = &finish};
        at.footprint = footprints_->around(ray, hit, at, {&layer, 1});
        Light lamp = point_light(from);
        lamp.parallel = parallel;
        lamp.point_at = Vec3(0.0);
        const LightSource source(lamp, {});
        return widened_alpha(alpha, at, source, source.towards(lamp.location, at.point));
    }

private:
    std::unique_ptr<World> world_;
    std::unique_ptr<DistanceRules> rules_;
    std::unique_ptr<Footprints> footprints_;
};

TEST(Footprint, of_a_ball_turns_its_normal_by_a_sample_over_its_radius) {
    // In the middle of the highlight m changes as the normal does: by 0.1 / R both ways.
    for (const double radius : {0.5, 1.0}) {
        const double got = Seen(Sphere{Vec3(0.0), radius}).widened(0.05, 0.0, 0.0);
        EXPECT_NEAR(got * got, 0.05 * 0.05 + 2 * sqr(0.1 / radius) / 12, 2e-5 / sqr(radius)) << radius;
    }
}

TEST(Footprint, of_a_flat_surface_far_from_everything_widens_nothing) {
    EXPECT_NEAR(Seen(Plane{Vec3(0, 0, -1), 0.0}).widened(0.05, 0.3, 0.2), 0.05, 1e-12);
}

TEST(Footprint, of_a_flat_surface_under_a_near_lamp_has_its_directions) {
    // The lamp stands 2 over the plane: l changes by 0.1 / 2 a sample, the half vector by half of that.
    const double got = Seen(Plane{Vec3(0, 0, -1), 0.0}).widened(0.05, 0.0, 0.0, {0, 0, -2}, false);
    EXPECT_NEAR(got * got, 0.05 * 0.05 + 2 * sqr(0.1 / 2 / 2) / 12, 1e-7);
}

TEST(Footprint, at_an_edge_between_flat_faces_widens_nothing) {
    Seen box(Box{Vec3(-1.0), Vec3(1.0)});
    for (const double x : {0.0, 0.99, -0.99}) EXPECT_NEAR(box.widened(0.05, x, 0.99), 0.05, 1e-12) << x;
}

TEST(Footprint, has_a_limit) { EXPECT_NEAR(sqr(Seen(Sphere{Vec3(0.0), 0.03}).widened(0.05, 0.0, 0.0)), 0.05 * 0.05 + 0.18, 1e-12); }

TEST(Footprint, leaves_the_tail_of_a_lobe_nearly_as_it_is) {
    // The lamp stands at 60 degrees: the half vector's slope in the ball's middle is tan 30.
    const double got = Seen(Sphere{Vec3(0.0), 1.0}).widened(0.05, 0.0, 0.0, {10 * std::sqrt(3.0), 0, -10});
    EXPECT_GT(got, 0.05);
    EXPECT_LT(got * got - 0.05 * 0.05, 0.2 * 2 * sqr(0.1) / 12);
}

}  // namespace
}  // namespace rt::footprint_test
