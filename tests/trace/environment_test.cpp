// Which pixel of the surroundings a direction sees.
#include "trace/environment.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/source.h"
#include "tests/trace/tracer_scene.h"

namespace rt::environment_test {
namespace {

using namespace tracer_test;

Film one_color(const Rgb& c, int side = 2) {
    Film film(side, side);
    for (Pixel& p : film.pixels) p = {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), 0.0f};
    return film;
}

/// Red is the column, green the row.
Film numbered(int width, int height) {
    Film film(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) film.at(x, y) = {static_cast<float>(x), static_cast<float>(y), 0.0f, 0.0f};
    return film;
}

TEST(Environment, longitude_and_latitude) {
    const Environment sky = Environment::latitude_longitude(numbered(8, 4));
    // The middle of the picture, between columns 3 and 4 and rows 1 and 2.
    EXPECT_RGB_NEAR(sky.at({0, 0, 1}), Rgb(3.5, 1.5, 0), 1e-9);
    EXPECT_RGB_NEAR(sky.at({5, 0, 0}), Rgb(5.5, 1.5, 0), 1e-9);
    EXPECT_RGB_NEAR(sky.at({-5, 0, 0}), Rgb(1.5, 1.5, 0), 1e-9);
    EXPECT_RGB_NEAR(sky.at({0, 0, -1}), Rgb(3.5, 1.5, 0), 1e-9) << "between the last and the first column";
    EXPECT_NEAR(sky.at({0, 1, 0}).g, 0.0, 1e-9);
    EXPECT_NEAR(sky.at({0, -1, 0}).g, 3.0, 1e-9);
    // 45 degrees up: a quarter from the top, between rows 0 and 1.
    EXPECT_NEAR(sky.at({0, 1, 1}).g, 0.5, 1e-9);
}

TEST(Environment, faces_of_a_cube) {
    std::array<Film, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) faces[i] = one_color(Rgb(static_cast<double>(i)));
    const Environment flat = Environment::cube(faces);
    const Vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(flat.at(axes[i] + Vec3(0.1, -0.2, 0.3)).r, static_cast<double>(i)) << i;
    // Right and up of each face: the pixel of a corner two thirds out.
    for (std::size_t i = 0; i < 6; ++i) faces[i] = numbered(2, 2);
    const Environment cube = Environment::cube(faces);
    const Vec3 right[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    const Vec3 up[] = {{0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_RGB_NEAR(cube.at(axes[i] + 0.7 * right[i] + 0.6 * up[i]), Rgb(1, 0, 0), 1e-12) << i;
}

TEST(Environment, what_is_no_direction_sees_black) {
    std::array<Film, 6> faces;
    faces.fill(one_color(Rgb(1.0)));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(Environment::cube(faces).at({nan, nan, nan}), Rgb(0.0));
    EXPECT_EQ(Environment::cube(faces).at({0, 0, 0}), Rgb(0.0));
    EXPECT_EQ(Environment::latitude_longitude(one_color(Rgb(1.0))).at({nan, 0, 1}), Rgb(0.0));
}

TEST(Environment, pictures_that_make_no_cube_are_refused) {
    std::array<Film, 6> faces;
    faces.fill(one_color(Rgb(1.0)));
    faces[3] = one_color(Rgb(1.0), 3);
    EXPECT_THROW(Environment::cube(faces), OptionError);
    faces.fill(numbered(2, 3));
    EXPECT_THROW(Environment::cube(faces), OptionError);
    EXPECT_THROW(Environment::latitude_longitude(Film()), OptionError);
}

TEST(Environment, is_what_mirrors_and_the_camera_see_instead_of_the_background) {
    Finish mirror = plain();
    mirror.reflection.min = mirror.reflection.max = Rgb(0.5);
    std::array<Film, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) faces[i] = one_color(Rgb(static_cast<double>(i + 1)));
    TraceOptions options = povray_options();
    options.environment = std::make_shared<const Environment>(Environment::cube(faces));
    Traced t(scene_with({object(floor_plane(), texture(color(Rgb(0.0)), mirror))}, {}, Rgb(9.0)), options);
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0.1, 1, 0}).rgb, Rgb(3.0), 1e-12);
    EXPECT_RGB_NEAR(t.look({0, 1, 0}, {0.1, -1, 0}).rgb, Rgb(1.5), 1e-12);
    EXPECT_EQ(t.look({0, 1, 0}, {0.1, 1, 0}).transmittance, 0.0);
}

}  // namespace
}  // namespace rt::environment_test
