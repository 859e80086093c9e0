// Lines over the picture: where they are, how wide, and that nothing but the point of the picture decides.
#include "trace/edges.h"

#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"
#include "trace/render.h"

namespace rt::edges_test {
namespace {

using namespace tracer_test;

constexpr int side = 96;
const Rgb red{1.0, 0.0, 0.0};

/// An orthographic view along z of [-4, 4]^2: a pixel is 1/12 wide.
Scene flat_view(std::vector<Object> objects) {
    Scene scene = scene_with(std::move(objects), {point_light({3, 5, -9})}, Rgb(0.2));
    scene.camera.projection = Projection::orthographic;
    scene.camera.location = {0, 0, -10};
    scene.camera.right = {8, 0, 0}, scene.camera.up = {0, 8, 0};
    scene.camera.up_or_right_stated = true;
    return scene;
}

World world_of(const Scene& scene) {
    CompileOptions options;
    options.threads = 1;
    return compile(scene, options, [](std::string_view) {});
}

Texture grey_one() { return texture(color(Rgb(0.5)), plain(Rgb(0.1), 0.6)); }
Object ball(const Vec3& centre, double radius) { return object(Sphere{centre, radius}, grey_one()); }
Object wall() { return object(Plane{Vec3(0, 0, -1), -5.0}, grey_one()); }

EdgeOptions lines(EdgeOptions::Kind kind, double width = 1.0) { return {.kind = kind, .width = width, .color = red}; }

/// The picture of lines alone: which pixels' centres are covered.
class Drawing {
public:
    Drawing(const World& world, const EdgeOptions& options) {
        EdgeLines edges(world, options, Distances::scaled, side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) covered_[y][x] = edges.covers({x + 0.5, y + 0.5}, 1);
    }
    bool at(int x, int y) const { return covered_[y][x]; }
    int count() const {
        int sum = 0;
        for (const auto& row : covered_)
            for (const bool pixel : row) sum += pixel;
        return sum;
    }

private:
    bool covered_[side][side] = {};
};

/// Distance of a pixel's centre from the middle of the picture, in pixels.
double radius_at(int x, int y) { return std::hypot(x + 0.5 - 0.5 * side, y + 0.5 - 0.5 * side); }

TEST(Edges, ABallBeforeAWallHasAClosedLineOfTheRightWidth) {
    const World world = world_of(flat_view({wall(), ball(Vec3(0.0), 2.5)}));  // 30 pixels
    for (const double width : {1.5, 4.0}) {
        const Drawing drawing(world, lines(EdgeOptions::Kind::silhouette, width));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double off = std::fabs(radius_at(x, y) - 30.0);
                // Opposite points of eight are up to 8 % nearer to an oblique line than half its width.
                if (off < 0.5 * width * 0.92 - 0.05) {
                    EXPECT_TRUE(drawing.at(x, y)) << width << ": " << x << " " << y;
                }
                if (off > 0.5 * width + 0.05) {
                    EXPECT_FALSE(drawing.at(x, y)) << width << ": " << x << " " << y;
                }
            }
        }
        EXPECT_NEAR(drawing.count(), 2.0 * pi * 30.0 * width, 0.08 * 2.0 * pi * 30.0 * width);
        EXPECT_EQ(Drawing(world, lines(EdgeOptions::Kind::crease, width)).count(), 0) << "a ball has no creases";
    }
}

TEST(Edges, ASmoothBodyHasNoLinesInsideItsOutline) {
    // Balls of all sizes, seen in perspective and cut off by nothing.
    for (const double radius : {0.15, 0.4, 1.0, 3.0}) {
        const World world = world_of(flat_view({ball(Vec3(0.0), radius)}));
        const Drawing drawing(world, lines(EdgeOptions::Kind::all));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (radius_at(x, y) < 12.0 * radius - 0.55) {
                    EXPECT_FALSE(drawing.at(x, y)) << radius << ": " << x << " " << y;
                }
        EXPECT_GT(drawing.count(), 0);
    }
}

TEST(Edges, ABoxHasCreasesWhereItsFacesMeet) {
    Object box = object(Box{Vec3(-1.5), Vec3(1.5)}, grey_one());
    box.transform = Transform::rotate({0, 45, 0}, Rotation::povray);  // two faces, the edge between them in the middle of the picture
    const World world = world_of(flat_view({box}));
    const Drawing creases(world, lines(EdgeOptions::Kind::crease, 2.0)), outlines(world, lines(EdgeOptions::Kind::silhouette, 2.0));
    for (int y = 40; y < 56; ++y) {
        EXPECT_TRUE(creases.at(47, y) && creases.at(48, y)) << y;
        for (int x = 0; x < side; ++x) {
            if (x < 47 || x > 48) {
                EXPECT_FALSE(creases.at(x, y)) << x << " " << y;
            }
            if (x > 24 && x < 71) {
                EXPECT_FALSE(outlines.at(x, y)) << x << " " << y;
            }
        }
    }
    EdgeOptions wide = lines(EdgeOptions::Kind::crease, 2.0);
    wide.crease_angle = 91.0;
    EXPECT_EQ(Drawing(world, wide).count(), 0);
    wide.crease_angle = 89.0;
    EXPECT_GT(Drawing(world, wide).count(), 0);
}

/// Two triangles that make a square of half side 2 in the plane z = 0, of one mesh, the second with its corners in the other order.
Object square_mesh(double lift = 0.0) {
    MeshData data;
    data.vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, lift}};
    data.faces = {{0, 1, 2}, {0, 3, 2}};
    return object(Mesh{Shared<MeshData>(data)}, grey_one());
}

TEST(Edges, CoplanarNeighboursOfOneObjectHaveNone) {
    const Drawing drawing(world_of(flat_view({square_mesh()})), lines(EdgeOptions::Kind::all));
    for (int y = 26; y < 70; ++y)
        for (int x = 26; x < 70; ++x) EXPECT_FALSE(drawing.at(x, y)) << x << " " << y;
    EXPECT_TRUE(drawing.at(24, 40) || drawing.at(23, 40)) << "its outline";
    const Drawing folded(world_of(flat_view({square_mesh(4.0)})), lines(EdgeOptions::Kind::all));
    EXPECT_TRUE(folded.at(47, 48) || folded.at(48, 48)) << "the diagonal of a folded one";
}

TEST(Edges, LooseTrianglesAreOneSurface) {
    const auto square = [](double lift) {
        const Vec3 a(-2, -2, 0), b(2, -2, 0), c(2, 2, 0), d(-2, 2, lift);
        return flat_view({object(Triangle{a, b, c}, grey_one()), object(Triangle{a, d, c}, grey_one())});
    };
    const Drawing flat(world_of(square(0.0)), lines(EdgeOptions::Kind::all)), folded(world_of(square(4.0)), lines(EdgeOptions::Kind::all));
    EXPECT_FALSE(flat.at(47, 48) || flat.at(48, 48)) << "the diagonal is no edge";
    EXPECT_TRUE(folded.at(47, 48) || folded.at(48, 48));
    EXPECT_TRUE(flat.at(24, 40) || flat.at(23, 40)) << "its outline";
}

TEST(Edges, APartOfAnObjectBeforeAnotherHasAnOutline) {
    // A torus from its side, tilted: its near rim stands before its far one.
    Object ring = object(Torus{1.5, 0.5}, grey_one());
    ring.transform = Transform::rotate({-20, 0, 0}, Rotation::povray);
    const World world = world_of(flat_view({ring}));
    const Drawing outlines(world, lines(EdgeOptions::Kind::silhouette)), creases(world, lines(EdgeOptions::Kind::crease));
    int inside = 0;
    for (int y = 0; y < side; ++y) inside += outlines.at(48, y);
    EXPECT_GE(inside, 3) << "top, bottom and the rim between";
    EXPECT_EQ(creases.count(), 0) << "it is smooth";
}

TEST(Edges, APlaneToItsHorizonHasOneLine) {
    Scene scene = scene_with({object(floor_plane(-1.0), grey_one())});
    scene.camera.location = {0, 0, 0};
    scene.camera.direction = {0, 0, 1}, scene.camera.right = {1, 0, 0}, scene.camera.up = {0, 1, 0};
    const Drawing drawing(world_of(scene), lines(EdgeOptions::Kind::all, 1.5));
    for (int y = 0; y < side; ++y) EXPECT_EQ(drawing.at(30, y), y == 47 || y == 48) << y;
}

class EdgesInPictures : public testing::TestWithParam<Sampling::Method> {
protected:
    EdgesInPictures() : world_(world_of(flat_view({wall(), ball({-1, 0.5, 0}, 1.3), ball({0.5, -0.4, 1}, 1.7)}))) {
        options_.width = side, options_.height = 61;
        options_.threads = 1;
        options_.sampling = {GetParam(), 2, 0.1, 2.5, 16};
        options_.edges = lines(EdgeOptions::Kind::all, 1.7);
    }
    World world_;
    RenderOptions options_;
};

TEST_P(EdgesInPictures, SameBytesForThreadsAndRegions) {
    const Film one = render(world_, options_).film;
    int drawn = 0;
    for (const Pixel& p : one.pixels) drawn += p == Pixel{1.0f, 0.0f, 0.0f, 0.0f};
    EXPECT_GT(drawn, 50);
    options_.threads = 3;
    EXPECT_EQ(render(world_, options_).film.pixels, one.pixels);
    Film joined(side, 61);
    for (int y = 0; y < 61; y += 13) {
        for (int x = 0; x < side; x += 29) {
            options_.region = Region{x, y, x + 29, y + 13};
            const Film part = render(world_, options_).film;
            for (std::size_t i = 0; i < joined.pixels.size(); ++i)
                if (part.pixels[i] != Pixel{}) joined.pixels[i] = part.pixels[i];
        }
    }
    EXPECT_EQ(joined.pixels, one.pixels);
}

TEST_P(EdgesInPictures, OffCastsNoRayAndAddsNothing) {
    const RenderResult with = render(world_, options_);
    options_.edges.kind = EdgeOptions::Kind::off;
    const RenderResult without = render(world_, options_);
    EXPECT_GT(with.counts.edge, 0u);
    EXPECT_EQ(without.counts.edge, 0u);
    for (const Pixel& p : without.film.pixels) ASSERT_NE(p, (Pixel{1.0f, 0.0f, 0.0f, 0.0f}));
    if (GetParam() != Sampling::Method::none) return;
    for (std::size_t i = 0; i < with.film.pixels.size(); ++i)
        if (with.film.pixels[i] != Pixel{1.0f, 0.0f, 0.0f, 0.0f}) {
            ASSERT_EQ(with.film.pixels[i], without.film.pixels[i]);
        }
}

INSTANTIATE_TEST_SUITE_P(Methods, EdgesInPictures,
                         testing::Values(Sampling::Method::none, Sampling::Method::grid, Sampling::Method::povray1,
                                         Sampling::Method::povray2));

TEST(Edges, AGridDrawsTheLineOfALargerPicture) {
    const World world = world_of(flat_view({ball({0.3, 0.2, 0}, 2.0)}));
    EdgeLines edges(world, lines(EdgeOptions::Kind::all, 2.0), Distances::scaled, side, side);
    EdgeLines larger(world, lines(EdgeOptions::Kind::all, 6.0), Distances::scaled, 3 * side, 3 * side);
    int drawn = 0;
    for (int y = 0; y < 3 * side; y += 2) {
        for (int x = 0; x < 3 * side; x += 2) {
            const Vec2 point(x + 0.5, y + 0.5);
            const bool covered = edges.covers(point, 3);
            drawn += covered;
            ASSERT_EQ(covered, larger.covers(point, 1)) << x << " " << y;
        }
    }
    EXPECT_GT(drawn, 100);
}

}  // namespace
}  // namespace rt::edges_test
