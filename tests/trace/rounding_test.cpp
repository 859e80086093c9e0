// Workers that round in another way: the state, the same bytes for any number of threads, and a mathematical library that bears it.
#include "trace/rounding.h"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <array>
#include <cmath>
#include <mutex>
#include <set>

#include "tests/trace/tracer_scene.h"
#include "trace/pixel_rays.h"

namespace rt::rounding_test {
namespace {

constexpr std::array all{Rounding::nearest, Rounding::downward, Rounding::upward, Rounding::toward_zero};

/// Not a constant to the compiler.
double quotient(double a, double b) {
    volatile double kept = a;
    return kept / b;
}

TEST(Rounding, IsWhatTheProcessorDoes) {
    const double below = std::nextafter(1.0 / 3.0, 0.0), above = std::nextafter(1.0 / 3.0, 1.0);  // the nearest one is below a third
    const auto third = [](Rounding rounding, double sign) -> double {
        const RoundingScope scope(rounding);
        volatile double result = quotient(sign, 3.0);
        return result;
    };
    EXPECT_EQ(third(Rounding::nearest, 1.0), 1.0 / 3.0);
    EXPECT_EQ(third(Rounding::downward, 1.0), 1.0 / 3.0);
    EXPECT_EQ(third(Rounding::upward, 1.0), above);
    EXPECT_EQ(third(Rounding::toward_zero, 1.0), 1.0 / 3.0);
    EXPECT_EQ(third(Rounding::downward, -1.0), -above);
    EXPECT_EQ(third(Rounding::upward, -1.0), -1.0 / 3.0);
    EXPECT_EQ(third(Rounding::toward_zero, -1.0), -1.0 / 3.0);
    EXPECT_LT(below, 1.0 / 3.0);
}

TEST(Rounding, EndsWithItsScope) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(0x9fc0);  // flush to zero, denormals are zero
    {
        const RoundingScope scope(Rounding::upward);
        EXPECT_EQ(_mm_getcsr() & ~0x3fu, 0x5f80u);
    }
    EXPECT_EQ(_mm_getcsr() & ~0x3fu, 0x9fc0u);
    _mm_setcsr(before);
}

TEST(Rounding, OfEveryTileIsTheOneAskedFor) {
    for (const Rounding rounding : all) {
        std::mutex mutex;
        std::set<unsigned> states;
        const auto work = [&](int, std::size_t) {
            const std::lock_guard lock(mutex);
            states.insert(_mm_getcsr() & ~0x3fu);
            _mm_setcsr(0x1f80);  // as a library might
        };
        for_each_tile(3, 50, work, rounding);
        EXPECT_EQ(states, (std::set<unsigned>{0x1f80u | static_cast<unsigned>(rounding) << 13}));
    }
}

World small_world() {
    using namespace tracer_test;
    Scene scene;
    scene.camera.location = Vec3(0.1, 1.5, -5.0);
    scene.lights = {point_light(Vec3(5.0, 8.0, -5.0))};
    Finish mirror = plain(Rgb(0.1), 0.5);
    mirror.reflection.min = mirror.reflection.max = Rgb(0.6);
    Interior glass;
    glass.ior = 1.5;
    scene.objects.push_back(object(Sphere{Vec3(-0.8, 1.0, 0.0), 1.0}, texture(color(Rgb(0.8, 0.3, 0.2)), mirror)));
    scene.objects.push_back(object(Sphere{Vec3(1.1, 0.8, -0.9), 0.8}, texture(color(Rgb(0.9), 0.8), plain(Rgb(0.0), 0.2)), glass));
    scene.objects.push_back(object(Plane{Vec3(0.0, 1.0, 0.0), 0.0}, texture(color(Rgb(0.9)), plain(Rgb(0.1), 0.7))));
    return compile(scene, {}, [](std::string_view) {});
}

TEST(Rounding, MovesThePictureByItsLastBitsAndTheSameForAnyNumberOfThreads) {
    const World world = small_world();
    RenderOptions options;
    options.width = 40, options.height = 30;
    const Film nearest = render(world, options).film;
    for (const Rounding rounding : {Rounding::downward, Rounding::upward, Rounding::toward_zero}) {
        options.rounding = rounding;
        options.threads = 1;
        const Film film = render(world, options).film;
        EXPECT_NE(film.pixels, nearest.pixels);
        for (std::size_t i = 0; i < film.pixels.size(); ++i) EXPECT_NEAR(film.pixels[i].g, nearest.pixels[i].g, 1e-5) << i;
        for (const int threads : {2, 5}) {
            options.threads = threads;
            EXPECT_EQ(render(world, options).film.pixels, film.pixels);
        }
    }
}

TEST(Rounding, HoldsForTheRecordOfAPixelsRays) {
    const World world = small_world();
    RenderOptions options;
    options.width = 40, options.height = 30;
    const PixelPlace place{20, 20};
    std::set<double> lengths;
    for (const Rounding rounding : all) {
        options.rounding = rounding;
        const PixelRays rays = trace_pixel(world, options, place.x, place.y);
        EXPECT_NEAR(rays.samples[0].nodes[0].radiance.g, rays.pixel.g, 1e-7);
        lengths.insert(rays.samples[0].nodes[0].t);
        trace_pixels(world, options, {&place, 1}, [&](std::size_t, const std::vector<RayLog>& samples) {
            EXPECT_EQ(samples[0].nodes[0].t, rays.samples[0].nodes[0].t);
            return true;
        });
    }
    EXPECT_GE(lengths.size(), 2u);
}

/// Largest difference from what the library says when it rounds to nearest, in units in the last place.
template <typename F>
double worst_ulps(F f, double low, double high, Rounding rounding) {
    double worst = 0.0;
    for (int i = 0; i <= 4000; ++i) {
        const double x = low + (high - low) * i / 4000.0;
        const double usual = f(x);
        double other = 0.0;
        {
            const RoundingScope scope(rounding);
            other = f(x);
        }
        const double ulp = std::nextafter(std::fabs(usual), infinity) - std::fabs(usual);
        worst = std::max(worst, std::fabs(usual - other) / ulp);
    }
    return worst;
}

TEST(Rounding, IsBorneByTheMathematicalLibrary) {
    using Function = double (*)(double);
    const struct {
        const char* name;
        Function f;
        double low, high;
    } cases[] = {{"exp", [](double x) { return std::exp(x); }, -40.0, 40.0},
                 {"log", [](double x) { return std::log(x); }, 1e-3, 50.0},
                 {"log1p", [](double x) { return std::log1p(x); }, -0.9, 9.0},
                 {"expm1", [](double x) { return std::expm1(x); }, -9.0, 9.0},
                 {"pow 1/2.4", [](double x) { return std::pow(x, 1 / 2.4); }, 0.0, 4.0},
                 {"pow 40", [](double x) { return std::pow(x, 40.0); }, 0.0, 1.1},
                 {"sin", [](double x) { return std::sin(x); }, -20.0, 20.0},
                 {"cos", [](double x) { return std::cos(x); }, -20.0, 20.0},
                 {"tan", [](double x) { return std::tan(x); }, -1.5, 1.5},
                 {"atan", [](double x) { return std::atan(x); }, -9.0, 9.0},
                 {"acos", [](double x) { return std::acos(x); }, -1.0, 1.0},
                 {"erf", [](double x) { return std::erf(x); }, -3.0, 3.0},
                 {"erfc", [](double x) { return std::erfc(x); }, -3.0, 9.0},
                 {"cbrt", [](double x) { return std::cbrt(x); }, -3.0, 9.0}};
    for (const auto& c : cases)
        for (const Rounding rounding : all) EXPECT_LE(worst_ulps(c.f, c.low, c.high, rounding), 8.0) << c.name;
}

}  // namespace
}  // namespace rt::rounding_test
