// Adaptive sampling: the error falls below what is asked for, with the same bytes for any number of threads.
#include "trace/progressive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/source.h"
#include "tests/trace/tracer_scene.h"
#include "trace/error_estimate.h"

namespace rt::progressive_test {
namespace {

/// Under one light, seen by the same camera.
World world_of(std::vector<Object> objects) {
    using namespace tracer_test;
    Scene scene;
    scene.camera.location = Vec3(0.0, 1.5, -5.0);
    scene.lights = {point_light(Vec3(5.0, 8.0, -5.0))};
    scene.objects = std::move(objects);
    return compile(scene, {}, [](std::string_view) {});
}

Object ball(const Vec3& centre, double radius, const Rgb& rgb, double reflection = 0.0) {
    using namespace tracer_test;
    Finish finish = plain(Rgb(0.1), 0.7);
    finish.reflection.min = finish.reflection.max = Rgb(reflection);
    return object(Sphere{centre, radius}, texture(color(rgb), finish));
}

Object ground(const PigmentColor& one, const PigmentColor& other) {
    using namespace tracer_test;
    return object(Plane{Vec3(0.0, 1.0, 0.0), 0.0}, texture(checker(one, other), plain(Rgb(0.1), 0.7)));
}

/// A ball over a checkered plane.
const World& world() {
    using tracer_test::color;
    static const World made =
        world_of({ball(Vec3(0.2, 1.0, 0.0), 1.0, Rgb(0.8, 0.3, 0.2)), ground(color(Rgb(0.9)), color(Rgb(0.1, 0.2, 0.1)))});
    return made;
}

/// Small balls in the dark and their shadows on each other.
const World& balls() {
    static const World made = [] {
        std::vector<Object> objects;
        for (int i = 0; i < 25; ++i)
            objects.push_back(ball(Vec3(i % 5 - 2.0, 0.7 * (i / 5), 0.3 * (i % 3)), 0.3, Rgb(0.2 * (i % 5), 0.2 * (i / 5), 0.5)));
        return world_of(std::move(objects));
    }();
    return made;
}

/// Mirrors that see each other and the ground.
const World& mirrors() {
    using tracer_test::color;
    static const World made = world_of({ball(Vec3(-1.1, 1.0, 0.0), 1.0, Rgb(0.2), 0.7), ball(Vec3(1.1, 1.0, 0.0), 1.0, Rgb(0.2), 0.7),
                                        ground(color(Rgb(0.3, 0.2, 0.1)), color(Rgb(0.3, 0.2, 0.1)))});
    return made;
}

RenderOptions options_of(double max_error, int threads = 2) {
    RenderOptions options;
    options.width = 64, options.height = 48;
    options.threads = threads;
    options.sampling = {.method = Sampling::Method::adaptive, .max_error = max_error};
    options.trace = tracer_test::povray_options();
    return options;
}

double rmse(const Film& a, const Film& b, const Encoding& display) {
    double sum = 0.0;
    const auto shown = [&](float v) { return std::clamp(encode(v, display), 0.0, 1.0); };
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Pixel &p = a.pixels[i], &q = b.pixels[i];
        for (const auto& [u, v] : {std::pair{p.r, q.r}, std::pair{p.g, q.g}, std::pair{p.b, q.b}})
            sum += (shown(u) - shown(v)) * (shown(u) - shown(v));
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

TEST(Progressive, SameBytesForAnyNumberOfThreads) {
    const RenderResult one = render(world(), options_of(0.01, 1));
    ASSERT_TRUE(one.convergence);
    EXPECT_GT(one.convergence->rounds, 1);
    for (const int threads : {2, 5}) {
        const RenderResult other = render(world(), options_of(0.01, threads));
        EXPECT_EQ(other.film.pixels, one.film.pixels) << threads;
        EXPECT_EQ(other.convergence->error, one.convergence->error) << threads;
        EXPECT_EQ(other.counts.camera, one.counts.camera) << threads;
    }
}

TEST(Progressive, BeginsWithThePlainPicture) {
    RenderOptions options = options_of(1.0);
    const RenderResult first = render(world(), options);
    options.sampling.method = Sampling::Method::none;
    EXPECT_EQ(first.film.pixels, render(world(), options).film.pixels);
    EXPECT_TRUE(first.convergence->reached);
    EXPECT_EQ(first.convergence->rounds, 0);
}

/// Of all scenes that were looked at the true error was at least E/8 where the first sample is not already better than E.
TEST(Progressive, TheTrueErrorIsBelowTheOneAskedForButNotFarBelow) {
    for (const auto& [name, scene] : {std::pair{"ball", &world()}, std::pair{"balls", &balls()}, std::pair{"mirrors", &mirrors()}}) {
        RenderOptions options = options_of(0.0);
        options.sampling = {.method = Sampling::Method::grid, .depth = 32};
        const Film converged = render(*scene, options).film;
        for (const double e : {0.03, 0.02, 0.01, 0.005}) {
            const RenderResult result = render(*scene, options_of(e));
            EXPECT_TRUE(result.convergence->reached);
            EXPECT_LE(*result.convergence->error, e);
            const double error = rmse(result.film, converged, options.display);
            EXPECT_LT(error, e) << name;
            EXPECT_GT(error, e / 8.0) << name << ", " << e;
            RecordProperty(std::string(name) + " " + std::to_string(e), std::to_string(error / e));
        }
    }
}

TEST(Progressive, WhatIsKnownOfPixelsMustFitInMemory) {
    EXPECT_NO_THROW(check_picture_memory(60'000, 10, 10'000'000));
    try {
        check_picture_memory(60'000, 10, 10'000'000, SampledPicture::memory(60'000, 10));
        FAIL() << "fits";
    } catch (const LimitError& error) {
        EXPECT_STREQ(error.what(), "A picture of 60000 x 10 needs 0.1 GB of memory; 0.0 GB are available");
    }
}

RenderOptions plain_options() {
    RenderOptions options = options_of(0.0);
    options.sampling.method = Sampling::Method::none;
    options.width = 67, options.height = 45;
    return options;
}

/// Of the lower third hardly a pixel is black: where the ground's dark and light fields meet, what is made up may be.
bool shows_ground(const Film& film) {
    const auto third = static_cast<std::ptrdiff_t>(film.pixels.size() / 3);
    return std::count(film.pixels.end() - third, film.pixels.end(), Pixel{}) < third / 8;
}

TEST(Progressive, EveryStepHasTheSamplesOfTheOnesBeforeAndTheLastIsThePlainPicture) {
    const RenderOptions options = plain_options();
    const Film plain = render(world(), options).film;
    ProgressiveOptions steps;
    steps.first_spacing = 16;
    std::vector<int> spacings;
    steps.after_step = [&](const Film& film, const Convergence& reached) {
        spacings.push_back(reached.spacing);
        for (int y = 0; y < options.height; y += reached.spacing)
            for (int x = 0; x < options.width; x += reached.spacing) EXPECT_EQ(film.at(x, y), plain.at(x, y)) << reached.spacing;
        EXPECT_TRUE(shows_ground(film)) << reached.spacing;
        return true;
    };
    const RenderResult result = render_progressive(world(), options, steps);
    EXPECT_EQ(spacings, (std::vector<int>{16, 8, 4, 2, 1}));
    EXPECT_EQ(result.film.pixels, plain.pixels);
    EXPECT_EQ(result.counts.camera, plain.pixels.size());  // no sample is taken twice
    EXPECT_EQ(result.convergence->traced, 1.0);
}

TEST(Progressive, ARegionLiesWhereItDoesInAPlainPicture) {
    for (const bool only : {false, true}) {
        RenderOptions options = plain_options();
        options.region = Region{5, 7, 40, 30};
        options.only_region = only;
        ProgressiveOptions steps;
        steps.first_spacing = 8;
        EXPECT_EQ(render_progressive(world(), options, steps).film.pixels, render(world(), options).film.pixels) << only;
    }
}

TEST(Progressive, ADeadlineThatIsOverLeavesTheFirstStepMadeWhole) {
    const Deadline past{};
    ProgressiveOptions steps;
    steps.first_spacing = 16;
    steps.deadline = &past;
    Film first;
    steps.after_step = [&](const Film& film, const Convergence&) {
        EXPECT_TRUE(first.pixels.empty());
        first = film;
        return true;
    };
    const RenderResult result = render_progressive(world(), plain_options(), steps);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.convergence->spacing, 16);
    EXPECT_EQ(result.counts.camera, 5u * 3u);
    EXPECT_EQ(result.film.pixels, first.pixels);
}

TEST(Progressive, ADeadlineInARoundKeepsThePictureBeforeIt) {
    Deadline deadline = Deadline::max();
    ProgressiveOptions steps;
    steps.deadline = &deadline;
    Film before;
    steps.after_step = [&](const Film& film, const Convergence& reached) {
        before = film;
        if (reached.rounds == 2) deadline = Deadline{};
        return true;
    };
    const RenderResult result = render_progressive(world(), options_of(1e-4), steps);
    EXPECT_TRUE(result.complete);
    EXPECT_FALSE(result.convergence->reached);
    EXPECT_EQ(result.convergence->rounds, 2);
    EXPECT_EQ(result.film.pixels, before.pixels);
}

TEST(Progressive, AStopBetweenStepsIsIncompleteButWhole) {
    std::atomic<bool> stop{false};
    RenderOptions options = plain_options();
    options.stop = &stop;
    ProgressiveOptions steps;
    steps.first_spacing = 4;
    steps.after_step = [&](const Film&, const Convergence& reached) { return stop = reached.spacing == 2, true; };
    const RenderResult result = render_progressive(world(), options, steps);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.convergence->spacing, 2);
    EXPECT_TRUE(shows_ground(result.film));
}

TEST(Progressive, AnEndOfSamplesIsTold) {
    ProgressiveOptions few;
    few.most_samples = 16;
    const RenderResult result = render_progressive(world(), options_of(1e-4), few);
    EXPECT_TRUE(result.complete);
    EXPECT_FALSE(result.convergence->reached);
    EXPECT_EQ(result.convergence->most, 16);
    EXPECT_GT(*result.convergence->error, 1e-4);
}

}  // namespace
}  // namespace rt::progressive_test
