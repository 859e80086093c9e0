// Workers, tiles and limits; and the same bytes whatever the split of the work.
#include "trace/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <xmmintrin.h>

#include <limits>
#include <mutex>
#include <set>
#include <thread>

#include "core/source.h"
#include "tests/trace/tracer_scene.h"

namespace rt::render_test {
namespace {

using testing::HasSubstr;

const World& world() {
    static const World made = tracer_test::small_world();
    return made;
}

RenderOptions options_of(Sampling::Method method, int threads) {
    RenderOptions options;
    options.width = 83, options.height = 57;
    options.threads = threads;
    options.sampling = {method, 2, 0.1, 2.5, 16};
    options.trace = tracer_test::povray_options();
    return options;
}

class SameBytes : public testing::TestWithParam<Sampling::Method> {};

TEST_P(SameBytes, ForAnyNumberOfThreads) {
    const RenderResult one = render(world(), options_of(GetParam(), 1));
    EXPECT_TRUE(one.complete);
    EXPECT_EQ(one.threads, 1);
    std::set<float> values;
    for (const Pixel& p : one.film.pixels) values.insert(p.g);
    EXPECT_GT(values.size(), 500u) << "a dull picture proves nothing";
    for (const int threads : {2, 7}) {
        const RenderResult other = render(world(), options_of(GetParam(), threads));
        EXPECT_EQ(other.film.pixels, one.film.pixels) << threads;
        EXPECT_EQ(other.threads, threads);
    }
}

TEST_P(SameBytes, ForAnySplitIntoRegions) {
    RenderOptions options = options_of(GetParam(), 2);
    const Film whole = render(world(), options).film;
    for (const auto& [columns, rows] : {std::pair{83, 1}, std::pair{1, 57}, std::pair{83, 57}, std::pair{19, 23}}) {
        Film joined(options.width, options.height);
        const int step_x = columns == 83 ? 40 : 29, step_y = rows == 57 ? 31 : 17;
        for (int y = 0; y < 57; y += step_y) {
            for (int x = 0; x < 83; x += step_x) {
                options.region = Region{x, y, x + step_x, y + step_y};
                const Film part = render(world(), options).film;
                for (int j = 0; j < 57; ++j) {
                    for (int i = 0; i < 83; ++i) {
                        const bool inside = i >= x && i < x + step_x && j >= y && j < y + step_y;
                        if (inside) {
                            joined.at(i, j) = part.at(i, j);
                        } else {
                            ASSERT_EQ(part.at(i, j), Pixel{}) << "outside the region";
                        }
                    }
                }
            }
        }
        ASSERT_EQ(joined.pixels, whole.pixels) << step_x << " x " << step_y;
    }
}

TEST_P(SameBytes, InAFilmOfTheRegionAlone) {
    RenderOptions options = options_of(GetParam(), 2);
    options.region = Region{29, 17, 58, 90};  // beyond the picture's lower edge
    const Film whole = render(world(), options).film;
    options.only_region = true;
    const Film part = render(world(), options).film;
    ASSERT_EQ(part.width, 29);
    ASSERT_EQ(part.height, 57 - 17);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) ASSERT_EQ(part.at(x, y), whole.at(x + 29, y + 17)) << x << " " << y;
}

INSTANTIATE_TEST_SUITE_P(Methods, SameBytes,
                         testing::Values(Sampling::Method::none, Sampling::Method::grid, Sampling::Method::povray1,
                                         Sampling::Method::povray2));

TEST(Render, CountsRaysOfAllWorkers) {
    const RenderResult result = render(world(), options_of(Sampling::Method::none, 3));
    EXPECT_EQ(result.counts.camera, 83u * 57u);
    EXPECT_GT(result.counts.shadow, 0u);
    EXPECT_GT(result.counts.reflected, 0u);
    EXPECT_GT(result.counts.refracted, 0u);
    EXPECT_EQ(render(world(), options_of(Sampling::Method::grid, 3)).counts.camera, 4u * 83u * 57u);
}

TEST(Render, TransmittanceOnlyWithAlpha) {
    RenderOptions options = options_of(Sampling::Method::none, 1);
    EXPECT_EQ(render(world(), options).film.at(0, 0).transmittance, 0.0f);
    options.alpha = true;
    EXPECT_EQ(render(world(), options).film.at(0, 0).transmittance, 1.0f);
    EXPECT_EQ(render(world(), options).film.at(41, 56).transmittance, 0.0f);
}

TEST(Render, NonFinitePixelsAreCountedAndBlack) {
    Scene scene;
    World empty = compile(scene, {}, [](std::string_view) {});
    empty.background = Rgb(NAN, 1.0, 1.0);
    const RenderResult result = render(empty, options_of(Sampling::Method::none, 2));
    EXPECT_EQ(result.non_finite, 83u * 57u);
    EXPECT_EQ(result.film.at(3, 3), Pixel{});
}

TEST(Render, LightBeyondSinglePrecisionIsTheBrightestThatAFilmHolds) {
    Scene scene;
    World empty = compile(scene, {}, [](std::string_view) {});
    empty.background = Rgb(1e200, -1e200, 1.0);
    const RenderResult result = render(empty, options_of(Sampling::Method::none, 2));
    EXPECT_EQ(result.non_finite, 0u);
    EXPECT_EQ(result.film.at(3, 3), (Pixel{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest(), 1.0f, 0.0f}));
}

TEST(Render, ProgressGrowsToOne) {
    RenderOptions options = options_of(Sampling::Method::none, 2);
    std::vector<double> seen;
    options.progress = [&](double done) { seen.push_back(done); };
    render(world(), options);
    ASSERT_FALSE(seen.empty());
    EXPECT_EQ(seen.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(Render, AStopBeforeTheFirstTileLeavesNothing) {
    const std::atomic<bool> stop{true};
    RenderOptions options = options_of(Sampling::Method::povray1, 2);
    options.stop = &stop;
    options.progress = [](double) { ADD_FAILURE() << "there is none"; };
    const RenderResult result = render(world(), options);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.counts.camera, 0u);
    EXPECT_EQ(result.film.pixels, Film(83, 57).pixels);
}

TEST(Render, TheDeepestRecursionFitsTheStack) {
    using namespace tracer_test;
    Scene scene;
    Finish mirror = plain(Rgb(0.001), 0.0);
    mirror.reflection.min = mirror.reflection.max = Rgb(1.0);
    scene.objects = {object(Sphere{Vec3(0.0), 50.0}, texture(color(Rgb(1.0)), mirror))};
    scene.camera.location = Vec3(1.0, 2.0, 3.0);
    const World hall = compile(scene, {}, [](std::string_view) {});
    RenderOptions options = options_of(Sampling::Method::none, 2);
    options.trace.max_trace_level = 256;
    options.trace.adc_bailout = 0.0;
    const RenderResult result = render(hall, options);
    EXPECT_GE(result.counts.reflected, 255u * 83u * 57u);
    EXPECT_NEAR(result.film.at(40, 30).r, 0.256, 1e-4);
}

TEST(Limits, ImpossiblePicturesAreRefused) {
    EXPECT_THROW(picture_memory(0, 10), LimitError);
    EXPECT_THROW(picture_memory(10, -1), LimitError);
    EXPECT_THROW(picture_memory(2147483647, 2147483647), LimitError);
    EXPECT_EQ(picture_memory(1 << 20, 1 << 20), std::uint64_t{16} << 40);
    EXPECT_NO_THROW(check_picture_memory(1000, 1000, 16'000'000));
    EXPECT_GT(available_memory(), std::uint64_t{1} << 20);
    try {
        check_picture_memory(100000, 50000, 8'000'000'000);
        FAIL();
    } catch (const LimitError& error) {
        EXPECT_STREQ(error.what(), "A picture of 100000 x 50000 needs 80.0 GB of memory; 8.0 GB are available");
    }
    RenderOptions options = options_of(Sampling::Method::none, 1);
    options.width = options.height = 1 << 26;
    EXPECT_THROW(render(world(), options), LimitError);
    options = options_of(Sampling::Method::grid, 1);
    options.sampling.depth = 1 << 30;
    EXPECT_THROW(render(world(), options), LimitError);
}

TEST(Workers, EveryTileHasTheDefaultFloatingPointState) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040);  // flush to zero, denormals are zero: new threads inherit it
    std::mutex mutex;
    std::set<unsigned> states;
    for_each_tile(3, 50, [&](int, std::size_t) {
        const std::lock_guard lock(mutex);
        // The low six bits only record what has happened.
        states.insert(_mm_getcsr() & ~0x3fu);
        _mm_setcsr(_mm_getcsr() | 0x8040);  // as a library might
    });
    EXPECT_EQ(_mm_getcsr() & ~0x3fu, (before | 0x8040) & ~0x3fu) << "the caller's own state stays";
    _mm_setcsr(before);
    EXPECT_EQ(states, (std::set<unsigned>{0x1f80}));
}

TEST(Workers, EveryTileComesOnce) {
    for (const int threads : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> times(100);
        const int workers = for_each_tile(threads, times.size(), [&](int, std::size_t tile) { ++times[tile]; });
        EXPECT_GE(workers, 1);
        EXPECT_LE(workers, 100);
        for (const auto& t : times) ASSERT_EQ(t, 1);
    }
    EXPECT_EQ(for_each_tile(4, 0, [](int, std::size_t) { FAIL(); }), 1);
}

TEST(Workers, TheFirstExceptionReachesTheCaller) {
    std::atomic<int> calls{0};
    const auto work = [&](int, std::size_t tile) {
        ++calls;
        if (tile == 3) throw LimitError("tile 3");
        std::this_thread::yield();
    };
    EXPECT_THROW(for_each_tile(1, 1000, work), LimitError);
    EXPECT_EQ(calls, 4);
    calls = 0;
    EXPECT_THROW(for_each_tile(4, 1000000, work), LimitError);
    EXPECT_LT(calls, 1000000) << "the others stop soon";
}

TEST(Workers, StacksAreDeep) {
    pthread_attr_t small, before;
    pthread_getattr_default_np(&before);
    pthread_getattr_default_np(&small);
    pthread_attr_setstacksize(&small, 256 * 1024);  // as under a small "ulimit -s"
    pthread_setattr_default_np(&small);
    std::atomic<std::size_t> least{std::size_t{1} << 40};
    for_each_tile(2, 2, [&](int, std::size_t) {
        pthread_attr_t own;
        pthread_getattr_np(pthread_self(), &own);
        std::size_t size = 0;
        pthread_attr_getstacksize(&own, &size);
        pthread_attr_destroy(&own);
        least = std::min(least.load(), size);
    });
    EXPECT_GE(least, std::size_t{15} << 20);
    std::size_t after = 0;
    pthread_attr_t now;
    pthread_getattr_default_np(&now);
    pthread_attr_getstacksize(&now, &after);
    EXPECT_EQ(after, 256u * 1024u) << "the process's default stays";
    pthread_setattr_default_np(&before);
    for (pthread_attr_t* attributes : {&small, &before, &now}) pthread_attr_destroy(attributes);
}

}  // namespace
}  // namespace rt::render_test
