// Scenes that hang by their last bits in known places, and scenes that do not.
#include "commands/trade/instability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/job/job_steps.h"
#include "tests/commands/support.h"

namespace rt::instability_test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Field;

class Unstable : public testing::Test {
protected:
    Instability of(const std::string& scene, int threads = 1) {
        place_.write("scene.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n" + scene);
        RenderJob job;
        job.scene = "scene.pov";
        job.width = width, job.height = height, job.threads = threads;
        if (change) change(job);
        const Scene read = read_scene(job, message_sink(true));
        return instability(job, read, render_options(job, read));
    }
    static std::size_t count(const Instability& map, UnstableCause cause) { return map.by_cause[static_cast<std::size_t>(cause)]; }

    int width = 32, height = 16;
    std::function<void(RenderJob&)> change;

private:
    test::Workplace place_;
};

constexpr const char* table = R"(
    camera { location <0, 2, -6> look_at <0, 0.5, 0> }
    light_source { <4, 6, -5>, 1 }
    plane { y, 0 pigment { checker rgb 1 rgb 0.2 } }
    sphere { <-1, 1, 0>, 1 pigment { rgbf <1, 0.9, 0.9, 0.8> } finish { specular 0.3 } interior { ior 1.5 fade_power 1 fade_distance 2 } }
    sphere { <1, 1, 1>, 1 pigment { rgb <0.2, 0.5, 1> } finish { reflection 0.5 } }
    box { <0, 0, -2>, <0.7, 0.6, -1.5> pigment { rgb <1, 0.5, 0> } rotate 20*y }
)";

TEST_F(Unstable, NothingOfAPlainScene) {
    const Instability map = of(table);
    EXPECT_TRUE(map.complete);
    EXPECT_THAT(map.pixels, testing::IsEmpty());
    EXPECT_THAT(map.by_cause, Each(0u));
    EXPECT_THAT(map.by_variant, Each(0u));
    EXPECT_EQ(map.picture.width, 32);
    EXPECT_EQ(map.picture.height, 16);
}

/// Every other column of pixels looks at an edge. Patterns decide 1e-10 beside the coordinate.
constexpr const char* edges_on_pixels = R"(
    camera { orthographic location <0.25, -0.3, -10> direction z right 16*x up 8*y rotate <10, 30, 0> }
    plane { z, 0 pigment { checker rgb 1 rgb 0 translate <1e-10, 0, 1e-10 - 0.5> scale <1, 100, 100> } finish { ambient 1 } rotate <10, 30, 0> }
)";

TEST_F(Unstable, APatternsEdgeOnPixelCentres) {
    const Instability map = of(edges_on_pixels);
    EXPECT_GT(map.pixels.size(), 64u) << "of 256 on an edge";
    EXPECT_EQ(count(map, UnstableCause::pattern), map.pixels.size());
    for (const UnstablePixel& p : map.pixels) {
        EXPECT_EQ(p.x % 2, 1) << p.x << ' ' << p.y;
        EXPECT_DOUBLE_EQ(p.moved, 1.0);
    }
}

TEST_F(Unstable, TwoSurfacesInOnePlane) {
    const Instability map = of(R"(
        camera { orthographic location <0.1, 0.1, -10> direction z right 8*x up 4*y rotate <10, 30, 20> }
        plane { z, 0.1 pigment { rgb 1 } finish { ambient 1 } rotate <10, 30, 20> }
        disc { 0.1*z, z, 1.5 pigment { rgb <1, 0, 0> } finish { ambient 1 } rotate <10, 30, 20> }
    )");
    EXPECT_GT(map.pixels.size(), 20u);
    EXPECT_EQ(count(map, UnstableCause::coincident), map.pixels.size());
    for (const UnstablePixel& p : map.pixels) {
        const double x = (p.x + 0.5) / 4 - 4 + 0.1, y = 2 - (p.y + 0.5) / 4 + 0.1;
        EXPECT_LT(std::hypot(x, y), 1.5) << p.x << ' ' << p.y;
    }
}

TEST_F(Unstable, ABoxWhoseSideIsSeenEdgeOn) {
    const Instability map = of(R"(
        camera { orthographic location <0.3, 0.3, -10> direction z right 8*x up 4*y rotate <10, 30, 20> }
        box { <-1.075, -1, 0>, <1.6, 1, 1> pigment { rgb 1 } finish { ambient 1 } rotate <10, 30, 20> }
    )");
    EXPECT_GT(map.pixels.size(), 0u);
    EXPECT_EQ(count(map, UnstableCause::silhouette), map.pixels.size());
    for (const UnstablePixel& p : map.pixels) EXPECT_EQ(p.x, 10) << "where x = -1.075";
}

TEST_F(Unstable, WeightsOnTheEdgeOfTheBailout) {
    const Instability map = of(R"(
        global_settings { adc_bailout 0.3*0.3*0.3 max_trace_level 20 }
        camera { orthographic location <0.01, 0.02, -5> direction z right 8*x up 4*y }
        box { <-9, -9, -10>, <9, 9, 10> pigment { rgb 1 } finish { ambient 0.5 diffuse 0 reflection 0.3 } }
    )");
    EXPECT_EQ(map.pixels.size(), static_cast<std::size_t>(width * height));
    EXPECT_EQ(count(map, UnstableCause::depth), map.pixels.size());
}

TEST_F(Unstable, TheSameForAnyNumberOfThreads) {
    const Instability one = of(edges_on_pixels, 1), several = of(edges_on_pixels, 5);
    ASSERT_EQ(one.pixels.size(), several.pixels.size());
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        const UnstablePixel &a = one.pixels[i], &b = several.pixels[i];
        EXPECT_EQ(std::tie(a.x, a.y, a.cause, a.moved), std::tie(b.x, b.y, b.cause, b.moved));
    }
    EXPECT_EQ(one.by_variant, several.by_variant);
    EXPECT_EQ(one.picture.pixels, several.picture.pixels);
}

TEST_F(Unstable, ThePictureShowsTheCauseOverTheDimmedScene) {
    const Instability map = of(edges_on_pixels);
    std::vector<bool> unstable(map.picture.pixels.size());
    for (const UnstablePixel& p : map.pixels) unstable[static_cast<std::size_t>(p.y) * 32 + p.x] = true;
    for (std::size_t i = 0; i < unstable.size(); ++i) {
        const Pixel& p = map.picture.pixels[i];
        if (unstable[i])
            EXPECT_EQ(p, (Pixel{0.05f, 0.8f, 0.05f, 0.0f}));
        else
            EXPECT_TRUE(p == (Pixel{0.15f, 0.15f, 0.15f, 0.0f}) || p == Pixel{}) << p.r;
    }
}

TEST_F(Unstable, RandomDirectionsHaveNoMap) {
    change = [](RenderJob& job) {
        job.profile = Profile::csc473;
        job.course.emplace().indirect_samples = {4};
    };
    EXPECT_THROW(of("camera { location <0, 0, 5> look_at <0, 0, 0> } sphere { <0, 0, 0>, 1 pigment { color rgb <1, 0, 0> } }"),
                 OptionError);
}

TEST_F(Unstable, AStopLeavesNothing) {
    std::atomic<bool> stop{true};
    test::Workplace place;
    place.write("s.pov", std::string("#version 3.7;") + table);
    RenderJob job;
    job.scene = "s.pov";
    job.width = 8, job.height = 6;
    const Scene scene = read_scene(job, message_sink(true));
    RenderOptions options = render_options(job, scene);
    options.stop = &stop;
    EXPECT_FALSE(instability(job, scene, options).complete);
}

Instability of_extreme_geometry(const std::string& name) {
    RenderJob job;
    job.scene = std::string(PROJECT_ROOT) + "/pov/extremes/geometry/" + name + ".pov";
    job.width = 64, job.height = 48, job.threads = 1;
    const Scene read = read_scene(job, message_sink(true));
    return instability(job, read, render_options(job, read));
}

TEST(UnstableGeometry, OnlySurfacesInOnePlane) {
    const Instability map = of_extreme_geometry("decals");
    EXPECT_GT(map.pixels.size(), 200u);
    EXPECT_EQ(map.by_cause[static_cast<std::size_t>(UnstableCause::coincident)], map.pixels.size());
    for (const std::string name : {"scale_1e9", "far_1e8", "sheets_1e-9", "shells_1e-9", "needles_1e9", "mirrors_box", "touching_1e-9"})
        EXPECT_THAT(of_extreme_geometry(name).pixels, testing::IsEmpty()) << name;
}

}  // namespace
}  // namespace rt::instability_test
