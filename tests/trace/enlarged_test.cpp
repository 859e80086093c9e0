// Pictures that are traced with fewer pixels than they have.
#include "trace/enlarged.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/source.h"
#include "film/enlarge.h"
#include "tests/trace/tracer_scene.h"

namespace rt::enlarged_test {
namespace {

const World& world() {
    static const World made = tracer_test::small_world();
    return made;
}

RenderOptions options_of(int scale, Sampling::Method method = Sampling::Method::none) {
    RenderOptions options;
    options.width = 83, options.height = 57;
    options.threads = 2;
    options.sampling = {method, 2, 0.1, 2.5, 16};
    options.scale = scale;
    options.trace = tracer_test::povray_options();
    return options;
}

Film enlarged(const Film& film, const RenderOptions& options, Filtered filtered) {
    return enlarge(film, Stretch(film.width, options.width, 0, options.width), Stretch(film.height, options.height, 0, options.height),
                   filtered);
}

/// The picture of an N-th of the sides.
Film traced(RenderOptions options) {
    options.width = scaled_down(options.width, options.scale), options.height = scaled_down(options.height, options.scale);
    options.scale = 1;
    return render(world(), options).film;
}

TEST(Scale, SidesAreRoundedUp) {
    EXPECT_EQ(scaled_down(1, 64), 1);
    EXPECT_EQ(scaled_down(12, 3), 4);
    EXPECT_EQ(scaled_down(13, 3), 5);
    EXPECT_EQ(scaled_down(14, 1), 14);
}

class ScaledPictures : public testing::TestWithParam<Sampling::Method> {};

TEST_P(ScaledPictures, AreSmallerOnesEnlarged) {
    for (const int scale : {2, 3, 5, 64}) {
        const RenderOptions options = options_of(scale, GetParam());
        const RenderResult result = render(world(), options);
        EXPECT_EQ(result.film.pixels, enlarged(traced(options), options, Filtered::square_roots).pixels) << scale;
        EXPECT_TRUE(result.complete);
        const auto pixels = static_cast<std::uint64_t>(scaled_down(83, scale) * scaled_down(57, scale));
        EXPECT_TRUE(GetParam() != Sampling::Method::none || result.counts.camera == pixels) << scale;
    }
}

TEST_P(ScaledPictures, HaveTheSameBytesForAnyNumberOfThreadsAndAnySplit) {
    RenderOptions options = options_of(3, GetParam());
    const Film whole = render(world(), options).film;
    options.threads = 7;
    EXPECT_EQ(render(world(), options).film.pixels, whole.pixels);
    for (const bool only : {false, true}) {
        options.only_region = only;
        for (const Region& region : {Region{0, 0, 29, 57}, Region{29, 11, 30, 12}, Region{70, 40, 90, 60}}) {
            options.region = region;
            const Film part = render(world(), options).film;
            ASSERT_EQ(part.width, only ? std::min(region.x1, 83) - region.x0 : 83);
            const int dx = only ? region.x0 : 0, dy = only ? region.y0 : 0;
            for (int y = 0; y < part.height; ++y) {
                for (int x = 0; x < part.width; ++x) {
                    const bool inside = x + dx >= region.x0 && x + dx < region.x1 && y + dy >= region.y0 && y + dy < region.y1;
                    ASSERT_EQ(part.at(x, y), inside ? whole.at(x + dx, y + dy) : Pixel{}) << x << ", " << y;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfMethods, ScaledPictures,
                         testing::Values(Sampling::Method::none, Sampling::Method::grid, Sampling::Method::povray1,
                                         Sampling::Method::povray2));

TEST(Scale, OfARegionTracesWhatItIsMadeOf) {
    RenderOptions options = options_of(4);
    options.region = Region{40, 20, 44, 24};
    EXPECT_LE(render(world(), options).counts.camera, 25u);
    options.region = Region{40, 20, 40, 20};
    options.only_region = true;
    EXPECT_TRUE(render(world(), options).film.pixels.empty());
}

TEST(Scale, LightIsFilteredByItsRootsAndWhatIsNoneAsItIs) {
    RenderOptions options = options_of(3);
    const Film plain = enlarged(traced(options), options, Filtered::values);
    EXPECT_NE(render(world(), options).film.pixels, plain.pixels);
    RenderOptions gamma = options, srgb = options, raw = options;
    gamma.working_gamma = 2.2;
    srgb.working_srgb = true;
    raw.display.raw = true;
    for (const RenderOptions& other : {gamma, srgb, raw}) EXPECT_EQ(render(world(), other).film.pixels, plain.pixels);
    options.alpha = true;
    EXPECT_EQ(render(world(), options).film.pixels, enlarged(traced(options), options, Filtered::values).pixels);
}

TEST(Scale, LinesAreAsWideAsWithoutItButNotNarrowerThanATracedPixel) {
    RenderOptions options = options_of(4);
    options.edges.kind = EdgeOptions::Kind::silhouette;
    for (const auto& [width, small] : {std::pair{1.0, 1.0}, std::pair{0.5, 0.5}, std::pair{8.0, 2.0}, std::pair{3.0, 1.0}}) {
        options.edges.width = width;
        RenderOptions lines = options;
        lines.edges.width = small;
        EXPECT_EQ(render(world(), options).film.pixels, enlarged(traced(lines), options, Filtered::square_roots).pixels) << width;
    }
}

TEST(Scale, HighlightsAreWidenedToWhatIsTraced) {
    using namespace tracer_test;
    Finish shiny = plain(Rgb(0.1), 0.5);
    shiny.specular = 1.0;
    shiny.roughness = 1e-4;
    Scene scene;
    scene.camera.location = Vec3(0.0, 0.0, -5.0);
    scene.lights = {point_light(Vec3(3.0, 3.0, -5.0))};
    scene.objects = {object(Sphere(Vec3(0.0), 1.0), texture(color(Rgb(0.5)), shiny))};
    CompileOptions compiled;
    compiled.general_shading = true;
    const World shining = compile(scene, compiled, [](std::string_view) {});
    RenderOptions options = options_of(4);
    options.trace = {};
    options.trace.specular_aa = SampleGrid{83, 57};
    RenderOptions small = options;
    small.width = 21, small.height = 15, small.scale = 1;
    small.trace.specular_aa = SampleGrid{21, 15};
    const Film expected = enlarged(render(shining, small).film, options, Filtered::square_roots);
    EXPECT_EQ(render(shining, options).film.pixels, expected.pixels);
    small.trace.specular_aa = SampleGrid{83, 57};
    EXPECT_NE(enlarged(render(shining, small).film, options, Filtered::square_roots).pixels, expected.pixels) << "proves nothing";
}

TEST(Scale, AStopIsTold) {
    const std::atomic<bool> stop{true};
    RenderOptions options = options_of(2);
    options.stop = &stop;
    const RenderResult result = render(world(), options);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.film.width, 83);
}

TEST(Scale, ThePictureItselfMustFitInMemory) {
    RenderOptions options = options_of(64);
    options.width = options.height = 1 << 26;
    EXPECT_THROW(render(world(), options), LimitError);
}

}  // namespace
}  // namespace rt::enlarged_test
