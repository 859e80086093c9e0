// What a progressive render tells of itself, and how it ends.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "tests/trace/tracer_scene.h"
#include "trace/progressive.h"

namespace rt::progressive_end_test {
namespace {

const World& world() {
    static const World made = tracer_test::small_world();
    return made;
}

RenderOptions options_of(Sampling::Method method, double max_error = 0.01) {
    RenderOptions options;
    options.width = 67, options.height = 45;
    options.threads = 2;
    options.sampling = {.method = method, .max_error = max_error};
    options.trace = tracer_test::povray_options();
    return options;
}

const RenderOptions plain = options_of(Sampling::Method::none);
const RenderOptions adaptive = options_of(Sampling::Method::adaptive);

TEST(ProgressiveEnd, WithoutAListenerTheFirstStepIsMadeWholeToo) {
    const Deadline past{};
    ProgressiveOptions steps{.first_spacing = 16, .deadline = &past, .after_step = {}};
    const RenderResult alone = render_progressive(world(), plain, steps);
    EXPECT_EQ(alone.convergence->traced, 15.0 / (67.0 * 45.0));
    steps.after_step = [](const Film&, const Convergence&) { return true; };
    EXPECT_EQ(render_progressive(world(), plain, steps).film.pixels, alone.film.pixels);
}

TEST(ProgressiveEnd, AListenerMayEndIt) {
    ProgressiveOptions steps{.first_spacing = 16, .after_step = {}};
    steps.after_step = [](const Film&, const Convergence& reached) { return reached.spacing != 4; };
    const RenderResult coarse = render_progressive(world(), plain, steps);
    EXPECT_TRUE(coarse.complete);
    EXPECT_EQ(coarse.convergence->spacing, 4);
    steps.after_step = [](const Film&, const Convergence& reached) { return reached.rounds != 1; };
    EXPECT_EQ(render_progressive(world(), options_of(Sampling::Method::adaptive, 1e-3), steps).convergence->rounds, 1);
}

TEST(ProgressiveEnd, ThePictureOfAllPixelsIsToldWithItsError) {
    ProgressiveOptions steps;
    steps.after_step = [](const Film&, const Convergence& reached) {
        EXPECT_TRUE(reached.error);
        return true;
    };
    render_progressive(world(), adaptive, steps);
    const RenderResult result = render_progressive(world(), plain, {});
    EXPECT_EQ(result.convergence->least, 1);
    EXPECT_EQ(result.convergence->most, 1);
    EXPECT_EQ(result.convergence->mean, 1.0);
    EXPECT_EQ(result.threads, 2);
}

TEST(ProgressiveEnd, AStopInARoundIsTold) {
    std::atomic<bool> stop{false};
    RenderOptions options = options_of(Sampling::Method::adaptive, 1e-4);
    options.stop = &stop;
    ProgressiveOptions steps;
    steps.after_step = [&](const Film&, const Convergence& reached) { return stop = reached.rounds == 1, true; };
    EXPECT_FALSE(render_progressive(world(), options, steps).complete);
}

TEST(ProgressiveEnd, SamplesAreCounted) {
    ProgressiveOptions few{.most_samples = 8, .after_step = {}};
    const RenderResult result = render_progressive(world(), options_of(Sampling::Method::adaptive, 1e-4), few);
    EXPECT_EQ(result.convergence->most, 8);
    EXPECT_EQ(result.convergence->least, 8);
    const RenderResult more = render(world(), adaptive);
    EXPECT_NEAR(more.convergence->mean, static_cast<double>(more.counts.camera) / (67.0 * 45.0), 1e-9);
}

TEST(ProgressiveEnd, ProgressIsOneInTheEndAndByTheErrorBefore) {
    std::vector<double> done, expected;
    RenderOptions options = adaptive;
    options.progress = [&](double d) { done.push_back(d); };
    ProgressiveOptions steps;
    steps.after_step = [&](const Film&, const Convergence& reached) {
        expected.push_back(std::min(1.0, std::pow(0.01 / *reached.error, 4.0 / 3.0)));
        return true;
    };
    render_progressive(world(), options, steps);
    ASSERT_EQ(done, expected);
    EXPECT_LT(done.front(), 1.0);
    EXPECT_EQ(done.back(), 1.0);
    done.clear();
    options.sampling = plain.sampling;
    steps = {.first_spacing = 2, .after_step = {}};
    render_progressive(world(), options, steps);
    EXPECT_EQ(done, (std::vector<double>{34.0 * 23.0 / (67.0 * 45.0), 1.0}));
}

TEST(ProgressiveEnd, ARegionIsSampledWhereItLies) {
    RenderOptions options = adaptive;
    options.region = Region{21, 13, 60, 40};
    options.only_region = true;
    const Film part = render(world(), options).film;
    options.sampling = {.method = Sampling::Method::grid, .depth = 16};
    const Film converged = render(world(), options).film;
    double sum = 0.0;
    for (std::size_t i = 0; i < part.pixels.size(); ++i) {
        const double d = encode(part.pixels[i].g, options.display) - encode(converged.pixels[i].g, options.display);
        sum += d * d;
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(part.pixels.size())), 0.02);
}

TEST(ProgressiveEnd, WhatIsNotFiniteIsBlackAndCounted) {
    Scene scene;
    World empty = compile(scene, {}, [](std::string_view) {});
    empty.background = Rgb(NAN, 1.0, 1.0);
    for (const RenderOptions& options : {plain, adaptive}) {
        const RenderResult result = render_progressive(empty, options, {});
        EXPECT_EQ(result.non_finite, 67u * 45u);
        EXPECT_EQ(result.film.pixels, std::vector<Pixel>(67 * 45));
    }
}

}  // namespace
}  // namespace rt::progressive_end_test
