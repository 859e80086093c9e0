// Adaptive sampling: the error falls below what is asked for, with the same bytes for any number of threads.
#include "trace/progressive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/trace/tracer_scene.h"

namespace rt {
namespace {

/// A ball over a checkered plane under one light.
const World& world() {
    using namespace tracer_test;
    static const World made = [] {
        Scene scene;
        scene.camera.location = Vec3(0.0, 1.5, -5.0);
        scene.lights = {point_light(Vec3(5.0, 8.0, -5.0))};
        scene.objects.push_back(object(Sphere{Vec3(0.2, 1.0, 0.0), 1.0}, texture(color(Rgb(0.8, 0.3, 0.2)), plain(Rgb(0.1), 0.7))));
        scene.objects.push_back(
            object(Plane{Vec3(0.0, 1.0, 0.0), 0.0}, texture(checker(color(Rgb(0.9)), color(Rgb(0.1, 0.2, 0.1))), plain(Rgb(0.1), 0.7))));
        return compile(scene, {}, [](std::string_view) {});
    }();
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

const Film& converged() {
    static const Film film = [] {
        RenderOptions options = options_of(0.0);
        options.sampling = {.method = Sampling::Method::grid, .depth = 24};
        return render(world(), options).film;
    }();
    return film;
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

TEST(Progressive, TheErrorFallsWithWhatWasAskedFor) {
    double before = 1.0;
    for (const double e : {0.02, 0.01, 0.005, 0.002}) {
        const RenderResult result = render(world(), options_of(e));
        EXPECT_TRUE(result.convergence->reached);
        EXPECT_LE(result.convergence->error, e);
        const double error = rmse(result.film, converged(), options_of(e).display);
        EXPECT_LT(error, 0.7 * before);
        before = error;
    }
}

TEST(Progressive, AnEndOfSamplesIsTold) {
    ProgressiveOptions few;
    few.most_samples = 16;
    const RenderResult result = render_progressive(world(), options_of(1e-4), few);
    EXPECT_TRUE(result.complete);
    EXPECT_FALSE(result.convergence->reached);
    EXPECT_EQ(result.convergence->most, 16);
    EXPECT_GT(result.convergence->error, 1e-4);
}

}  // namespace
}  // namespace rt
