// Rays of many pixels: those that one pixel alone has, and their light is the picture's, on any number of threads.
#include "trace/pixel_rays.h"

#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"

namespace rt::pixel_rays_test {
namespace {

std::vector<PixelPlace> every_third(int width, int height) {
    std::vector<PixelPlace> places;
    for (int y = 1; y < height; y += 3)
        for (int x = 1; x < width; x += 3) places.push_back({x, y});
    return places;
}

class PixelRaysTest : public testing::TestWithParam<int> {
protected:
    PixelRaysTest() : world(tracer_test::small_world()) {
        options.width = 32, options.height = 24;
        options.threads = GetParam();
        options.sampling.method = Sampling::Method::grid;
        options.sampling.depth = 2;
    }
    World world;
    RenderOptions options;
};

TEST_P(PixelRaysTest, AverageToThePicture) {
    const Film film = render(world, options).film;
    const std::vector<PixelPlace> places = every_third(options.width, options.height);
    std::vector<int> calls(places.size(), 0);
    std::vector<std::vector<RayLog>> rays(places.size());
    EXPECT_TRUE(trace_pixels(world, options, places, [&](std::size_t i, const std::vector<RayLog>& samples) {
        ++calls[i];
        rays[i] = samples;
        return true;
    }));
    EXPECT_EQ(calls, std::vector<int>(places.size(), 1));
    std::size_t deep = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_EQ(rays[i].size(), 4u);
        Rgb mean(0.0);
        for (const RayLog& log : rays[i]) {
            mean += log.nodes.front().radiance / 4.0;
            deep += log.nodes.size() > 3;
        }
        const Pixel& pixel = film.at(places[i].x, places[i].y);
        EXPECT_LT(length(mean - Rgb(pixel.r, pixel.g, pixel.b)), 1e-6) << places[i].x << ", " << places[i].y;
        const PixelRays alone = trace_pixel(world, options, places[i].x, places[i].y);
        EXPECT_EQ(alone.pixel, pixel);
        for (std::size_t s = 0; s < 4; ++s) {
            EXPECT_EQ(signature(alone.samples[s]), signature(rays[i][s]));
            EXPECT_EQ(alone.samples[s].nodes.front().radiance, rays[i][s].nodes.front().radiance);
        }
    }
    EXPECT_GT(deep, 20u);
}

TEST_P(PixelRaysTest, StopWhenAsked) {
    std::atomic<bool> stop{false};
    options.stop = &stop;
    std::atomic<std::size_t> taken{0};
    const std::vector<PixelPlace> places(1000, {16, 12});
    EXPECT_FALSE(trace_pixels(world, options, places, [&](std::size_t, const std::vector<RayLog>&) {
        ++taken;
        stop = true;
        return true;
    }));
    EXPECT_LT(taken, 100u);
}

TEST_P(PixelRaysTest, StopBetweenTheSamplesOfAPixel) {
    std::atomic<bool> stop{true};
    options.stop = &stop;
    const PixelRays none = trace_pixel(world, options, 16, 12);
    EXPECT_TRUE(none.samples.empty());
    std::atomic<std::size_t> taken{0};
    EXPECT_FALSE(trace_pixels(world, options, std::vector<PixelPlace>(9, {16, 12}), [&](std::size_t, const std::vector<RayLog>&) {
        ++taken;
        return true;
    }));
    EXPECT_EQ(taken, 0u);
}

TEST_P(PixelRaysTest, EndWhenNoMoreAreWanted) {
    std::atomic<std::size_t> taken{0};
    const std::vector<PixelPlace> places(1000, {16, 12});
    EXPECT_FALSE(trace_pixels(world, options, places, [&](std::size_t, const std::vector<RayLog>&) { return ++taken < 10; }));
    EXPECT_LT(taken, 20u);
}

INSTANTIATE_TEST_SUITE_P(Threads, PixelRaysTest, testing::Values(1, 3));

TEST(PixelRays, FollowsFewRaysUnlessASampleBringsMany) {
    RenderOptions options;
    options.trace.max_trace_level = 3;
    const auto expect = [&](int camera, int further) {
        const std::optional<FewRays> few = few_rays_of_pixel(options, 9);
        ASSERT_TRUE(few);
        EXPECT_EQ(few->camera, camera);
        EXPECT_EQ(few->further, further);
        EXPECT_TRUE(few->shaded);
    };
    expect(2, 3);
    options.trace.max_trace_level.reset();
    expect(2, 9);
    options.trace.course.emplace();
    options.sampling.method = Sampling::Method::grid;
    options.sampling.depth = 3;
    expect(18, 6);
    options.trace.course->indirect_samples = {64};
    EXPECT_FALSE(few_rays_of_pixel(options, 9));
    options.trace.course.emplace();
    options.sampling.method = Sampling::Method::povray1;
    EXPECT_FALSE(few_rays_of_pixel(options, 9));
    options.sampling.method = Sampling::Method::none;
    options.edges.kind = EdgeOptions::Kind::crease;
    EXPECT_FALSE(few_rays_of_pixel(options, 9));
}

}  // namespace
}  // namespace rt::pixel_rays_test
