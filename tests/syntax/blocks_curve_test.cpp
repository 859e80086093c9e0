// Shapes made of curves and fields: prism, lathe, sor, blob, superellipsoid, bicubic_patch, text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_curve_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string error_of(const std::string& text) { return parse_block(text).error; }

template <typename S>
S only_further(const std::string& text) {
    return std::get<S>(only_shape<FurtherShape>(text));
}

/// The warnings of a scene, and how many objects it has.
void expect_warning(const std::string& text, const std::string& warning, std::size_t objects) {
    const ParsedScene parsed = parse_block(text);
    EXPECT_EQ(parsed.error, "") << text;
    EXPECT_THAT(parsed.messages, ElementsAre(HasSubstr(warning))) << text;
    EXPECT_EQ(parsed.scene.objects.size(), objects) << text;
}

TEST(Prisms, LinearLoops) {
    const Prism p = only_further<Prism>("prism { 1, -1, 8, <0,0>,<3,0>,<0,3>,<0,0>, <1,1>,<2,1>,<1,2>,<1,1> open sturm }");
    EXPECT_EQ(p.low, -1.0);
    EXPECT_EQ(p.high, 1.0);
    EXPECT_TRUE(p.open);
    EXPECT_FALSE(p.conic);
    EXPECT_EQ(p.outline->pieces.size(), 6u);
    EXPECT_EQ(p.outline->pieces[3].points[0], Vec2(1, 1));
    expect_warning("prism { -1, 1, 3, <0,0>,<1,0>,<0,1> }", "Linear prism not closed. Closing it.", 1);
    EXPECT_EQ(only_further<Prism>("prism { -1, 1, 3, <0,0>,<1,0>,<0,1> }").outline->pieces.size(), 3u);
    EXPECT_EQ(only_further<Prism>("prism { -1 1 5 <0,0> <1,0> <0,1> <0,0> <2,2> }").outline->pieces.size(), 3u);
    EXPECT_EQ(error_of("prism { -1, 1, 2, <0,0>,<1,0> }"), "Prism with linear splines must have at least three points.");
    EXPECT_EQ(error_of("prism { -1, 1, 4, <0,0,3>,<1,0>,<0,1>,<0,0> }"), "UV_Vector expected but vector or color expression found.");
    EXPECT_EQ(error_of("prism { -1, 1, 4, <0,0>,<1,0>,<0,1>,<0,0> sturm open }"), "No matching } in 'prism', open found instead");
}

TEST(Prisms, BentLoops) {
    const Prism q = only_further<Prism>("prism { conic_sweep quadratic_spline 0, 1, 5, <0,0>,<1,0>,<0,1>,<0,0>,<1,0> }");
    EXPECT_TRUE(q.conic);
    ASSERT_EQ(q.outline->pieces.size(), 3u);
    EXPECT_EQ(q.outline->pieces[0].points[0], Vec2(1, 0));
    EXPECT_EQ(q.outline->pieces[2].points[3], Vec2(1, 0));
    EXPECT_EQ(only_further<Prism>("prism { cubic_spline -1, 1, 6, <0,0>,<1,0>,<0,1>,<0,0>,<1,0>,<0,1> }").outline->pieces.size(), 3u);
    EXPECT_EQ(error_of("prism { quadratic_spline -1, 1, 4, <0,0>,<1,0>,<0,1>,<0,0> }"),
              "Prism with quadratic splines must have at least five points.");
    EXPECT_EQ(error_of("prism { linear_spline cubic_spline -1, 1, 4, <0,0>,<1,0>,<0,1>,<0,0> }"),
              "Prism with cubic splines must have at least six points.");
    const ParsedScene open = parse_block("prism { cubic_spline -1, 1, 6, <0,0>,<1,0>,<0,1>,<0,0>,<2,0>,<0,1> }");
    EXPECT_EQ(open.error, "Too few points in prism.");
    EXPECT_THAT(open.messages, ElementsAre(HasSubstr("Prism not closed. Ignoring it.")));
}

TEST(Prisms, BezierLoops) {
    const Prism b = only_further<Prism>("prism { bezier_spline 0, 1, 8, <0,0>,<1,0>,<0,1>,<1,2>, <1,2>,<1,1>,<0,1>,<0,0> }");
    EXPECT_EQ(b.outline->pieces.size(), 2u);
    EXPECT_EQ(only_further<Prism>("prism { bezier_spline 0, 1, 4, <0,0>,<1,0>,<0,1>,<0,0> }").outline->pieces.size(), 1u);
    expect_warning("prism { bezier_spline 0, 1, 4, <0,0>,<1,0>,<0,1>,<1,2> }", "Prism not closed. Ignoring it.", 0);
    EXPECT_EQ(error_of("prism { bezier_spline -1, 1, 6, <0,0>,<1,0>,<0,1>,<0,0>,<2,0>,<0,1> }"),
              "Prism with Bezier splines must have four points per segment.");
}

TEST(Lathes, Curves) {
    EXPECT_EQ(only_further<Lathe>("lathe { 3, <-1,0>,<1,1>,<0,2> sturm }").curve->pieces.size(), 2u);
    EXPECT_EQ(only_further<Lathe>("lathe { cubic_spline linear_spline 3 <0,0> <1,1> <0,2> }").curve->pieces.size(), 2u);
    EXPECT_EQ(only_further<Lathe>("lathe { quadratic_spline 3, <0,0>,<1,1>,<0,2> }").curve->pieces.size(), 1u);
    EXPECT_EQ(only_further<Lathe>("lathe { bezier_spline 4, <-1,0>,<1,1>,<0,2>,<1,1> }").curve->pieces.size(), 1u);
    EXPECT_EQ(error_of("lathe { 1, <0,0> }"), "Lathe with linear splines must have at least two points.");
    EXPECT_EQ(error_of("lathe { quadratic_spline 2, <0,0>,<1,1> }"), "Lathe with quadratic splines must have at least three points.");
    EXPECT_EQ(error_of("lathe { cubic_spline 3, <0,0>,<1,1>,<0,2> }"), "Prism with cubic splines must have at least four points.");
    EXPECT_EQ(error_of("lathe { bezier_spline 5, <0,0>,<1,1>,<0,2>,<1,1>,<2,2> }"),
              "Lathe with Bezier splines must have four points per segment.");
    EXPECT_EQ(error_of("lathe { 3, <1,0>,<-1,1>,<0,2> }"), "Incorrect point in lathe.");
    EXPECT_EQ(error_of("lathe { bezier_spline 4, <-1,0>,<-1,1>,<-1,1>,<.5,2> }"), "Incorrect point in lathe.");
    EXPECT_EQ(error_of("lathe { 3, <0,0>,<1,1>,<0,2> open }"), "No matching } in 'lathe', open found instead");
}

TEST(Lathes, SurfacesOfRevolution) {
    const Sor s = only_further<Sor>("sor { 4, <0,0>, <1,1>, <2,3>, <3,4> open sturm }");
    EXPECT_TRUE(s.open);
    ASSERT_EQ(s.slices->size(), 1u);
    // Slopes of r^2: 2 * 1 * (2 - 0) / (3 - 0) and 2 * 2 * (3 - 1) / (4 - 1), over a height of 2.
    EXPECT_THAT((*s.slices)[0].radius2, ElementsAre(1.0, testing::DoubleNear(1.0 + 2.0 / 3.0 * 4.0 / 3.0, 1e-15),
                                                    testing::DoubleNear(4.0 - 2.0 / 3.0 * 8.0 / 3.0, 1e-15), 4.0));
    EXPECT_FALSE(only_further<Sor>("sor { 4 <0,1> <1,1> <1,2> <1,2> }").open);
    const std::string wrong = "Incorrect point in surface of revolution.";
    EXPECT_EQ(error_of("sor { 3, <0,0>,<1,1>,<1,2> }"), "Surface of revolution must have at least four points.");
    for (const char* points : {"<0,0>,<1,2>,<1,1>,<1,3>", "<0,0>,<1,1>,<1,1>,<1,3>", "<0,2>,<1,1>,<1,2>,<1,3>", "<0,0>,<1,1>,<1,2>,<1,1>",
                               "<-1,0>,<1,1>,<1,2>,<1,3>", "<0,0>,<1,1>,<1,2>,<-1,3>"})
        EXPECT_EQ(error_of(std::string("sor { 4, ") + points + " }"), wrong) << points;
    EXPECT_EQ(error_of("sor { 4, <0,0>,<1,1>,<1,2>,<1,3> sturm open }"), "No matching } in 'sor', open found instead");
}

TEST(Blobs, Components) {
    const Blob b = only_further<Blob>(
        "blob { sphere { x, 2, strength 3 } threshold .5 cylinder { 0, y, -1, 1 translate z } component 4, 5, z sturm hierarchy off }");
    EXPECT_EQ(b.data->threshold, 0.5);
    ASSERT_EQ(b.data->components.size(), 3u);
    EXPECT_EQ(b.data->components[0].base, Vec3(1, 0, 0));
    EXPECT_EQ(b.data->components[0].strength, 3.0);
    EXPECT_EQ(b.data->components[1].radius, 1.0);
    EXPECT_EQ(b.data->components[1].own_offset, Vec3(0, 0, -1));
    EXPECT_EQ(b.data->components[1].box.max.z, 2.0 + 0x1p-50 * 2.0);
    EXPECT_EQ(b.data->components[2].strength, 4.0);
    EXPECT_EQ(b.data->components[2].radius, 5.0);
    EXPECT_EQ(only_further<Blob>("blob { sphere { 0, 1 1 } }").data->threshold, 1.0);
    EXPECT_THAT(parse_block("blob { sphere { 0, 0, 1 } sphere { 0, 1, 0 } }").scene.objects, IsEmpty());
}

TEST(Blobs, Errors) {
    for (const char* text :
         {"blob { }", "blob { threshold .5 }", "blob { threshold .5 box { 0, 1 } }", "blob { threshold .5, sphere { 0, 1, 1 } }"})
        EXPECT_EQ(error_of(text), "Need at least one component in a blob.") << text;
    EXPECT_EQ(error_of("blob { sphere { 0, 1 } }"), "Expected 'numeric expression', } found instead");
    EXPECT_EQ(error_of("blob { cylinder { 0, 0, 1, 1 } }"), "Degenerate cylindrical component in blob.");
    EXPECT_EQ(error_of("blob { sphere { 0, 1, 1 no_shadow } }"), "No matching } in 'sphere', no_shadow found instead");
    EXPECT_EQ(error_of("blob { component 1,1,0 pigment { rgb 1 } component 1,1,0 }"), "No matching } in 'blob', component found instead");
    EXPECT_EQ(error_of("blob { sphere { 0, 1, 1 interior_texture { pigment { rgb 1 } } } }"),
              "No matching } in 'sphere', interior_texture found instead");
}

TEST(Superellipsoids, Exponents) {
    EXPECT_EQ(only_further<Superellipsoid>("superellipsoid { <.3,.4> }"), (Superellipsoid{0.3, 0.4}));
    EXPECT_EQ(only_further<Superellipsoid>("superellipsoid { .3 }"), (Superellipsoid{0.3, 0.3}));
    expect_warning("superellipsoid { <0,.3> }", "It is not visible.", 0);
    EXPECT_EQ(error_of("superellipsoid { .3, .3 }"), "No matching } in 'superellipsoid', , found instead");
    EXPECT_EQ(error_of("superellipsoid { .3 sturm }"), "Keyword 'sturm' cannot be used with this object.");
}

constexpr const char* sixteen =
    "<0,0,0>,<1,0,0>,<2,0,0>,<3,0,0>,<0,1,0>,<1,1,0>,<2,1,0>,<3,1,0>,<0,2,0>,<1,2,0>,<2,2,0>,<3,2,0>,<0,3,0>,<1,3,0>,<2,3,0>,<3,3,0>";

TEST(BicubicPatches, BecomeMeshes) {
    const Mesh one = only_shape<Mesh>(std::string("bicubic_patch { type 0 ") + sixteen + " }");
    EXPECT_EQ(one.data->faces.size(), 2u);
    EXPECT_EQ(one.data->vertices[2], Vec3(3, 3, 0));
    EXPECT_NEAR(std::fabs(one.data->normals[0].z), 1.0, 1e-15);
    EXPECT_EQ(only_shape<Mesh>(std::string("bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 3 ") + sixteen + " }").data->faces.size(),
              64u);
    expect_warning(std::string("bicubic_patch { type 2 ") + sixteen + " }", "Patch type no longer supported. Using type 1.", 1);
    EXPECT_EQ(error_of(std::string("bicubic_patch { ") + sixteen + " }"), "Undefined bicubic patch type.");
    EXPECT_EQ(error_of("bicubic_patch { type 0 <0,0,0>,<1,0,0> }"), "Expected 'numeric expression', } found instead");
    EXPECT_THAT(parse_block("bicubic_patch { type 0 0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,0 }").scene.objects, IsEmpty());
}

/// Pieces are halved until they are flat, which depends on how large the patch is in the end. Numbers of POV-Ray's triangles.
TEST(BicubicPatches, AreAsFineAsTheyHaveToBe) {
    const auto faces = [](const std::string& flatness, const std::string& moved) {
        const std::string patch = "bicubic_patch { type 1 u_steps 3 v_steps 3 flatness " + flatness +
                                  "<0,0,2>,<1,0,0>,<2,0,0>,<3,0,-2>,<0,1,0>,<1,1,0>,<2,1,0>,<3,1,0>,<0,2,0>,<1,2,0>,<2,2,0>,<3,2,0>,<0,3,2>"
                                  ",<1,3,0>,<2,3,0>,<3,3,-2> ";
        return only_shape<Mesh>(patch + moved + " }").data->faces.size();
    };
    EXPECT_EQ(faces("0", ""), 128u);
    EXPECT_EQ(faces("0.5", "scale 2"), 80u);
    EXPECT_EQ(faces("0.8", "scale 2"), 44u);
    EXPECT_EQ(faces("1", "rotate 30 scale 2"), 32u);
    EXPECT_EQ(faces("3", "scale 2"), 2u);
    EXPECT_EQ(faces("2.5", "scale 20"), 128u);
}

/// u along the rows as they are written, v from row to row; between four stated corners at the hit, not at the triangles' corners.
TEST(BicubicPatches, TexturesSeeThePatchsCoordinates) {
    const auto seen = [](const std::string& head, std::size_t face, double b, double c) {
        const Mesh mesh = only_shape<Mesh>("bicubic_patch { type 1 " + head + sixteen + " }");
        ShapeHit hit{};
        hit.u = b, hit.v = c;
        return uv(*mesh.data, face, hit);
    };
    EXPECT_EQ(seen("", 0, 0.0, 0.0), Vec2(0, 0));
    EXPECT_EQ(seen("", 0, 1.0, 0.0), Vec2(1, 0));
    EXPECT_EQ(seen("", 0, 0.0, 1.0), Vec2(1, 1));
    EXPECT_EQ(seen("", 1, 0.0, 1.0), Vec2(0, 1));
    EXPECT_EQ(seen("u_steps 1 v_steps 1 ", 7, 0.25, 0.25), Vec2(0.5 + 0.5 * 0.25, 0.5 + 0.5 * 0.5));
    const std::string corners = "uv_vectors <0, 0>, <2, 0>, <1, 1>, <0.25, 1.5> ";
    EXPECT_EQ(seen(corners, 0, 1.0, 0.0), Vec2(2, 0));
    EXPECT_EQ(seen(corners, 1, 0.0, 1.0), Vec2(0.25, 1.5));
    EXPECT_EQ(seen(corners, 0, 0.0, 0.5), 0.25 * (Vec2(2, 0) + Vec2(1, 1) + Vec2(0.25, 1.5))) << "in the middle of the diagonal";
}

TEST(Texts, Errors) {
    EXPECT_EQ(error_of("text { \"timrom.ttf\" \"A\" 1, 0 }"), "Expected 'ttf or internal', string literal found instead");
    const ParsedScene missing = parse_block("text { ttf \"no such font\" \"A\" 1, 0 }");
    EXPECT_EQ(missing.error, "Cannot open font file.");
    EXPECT_THAT(missing.messages,
                ElementsAre(HasSubstr("Cannot find file 'no such font', even after trying to append file type extension.")));
    EXPECT_EQ(error_of("text { ttf \"timrom.ttf\" \"A\" 1 }"), "Expected 'numeric expression', } found instead");
    ParseOptions options;
    options.read_include = [](const std::string& path) -> std::optional<std::string> {
        return path == "bad.ttf" ? std::optional<std::string>("no font at all") : std::nullopt;
    };
    EXPECT_EQ(parse_block("text { ttf \"bad.ttf\" \"A\" 1, 0 }", options).error, "Cannot read the font file 'bad.ttf'.");
}

// With the fonts that POV-Ray installs, where it is installed.
TEST(Texts, Letters) {
    const std::string text = "text { ttf \"timrom.ttf\" \"AV g\" 0.25, <0.125, 0, 0.5> }";
    if (parse_block(text).error == "Cannot open font file.") GTEST_SKIP() << "POV-Ray's fonts are not installed";
    const Text line = only_further<Text>(text);
    ASSERT_EQ(line.glyphs->size(), 3u);  // the space has no outline
    const std::vector<Glyph>& glyphs = *line.glyphs;
    EXPECT_EQ(glyphs[0].outline.min.x, 0.0);
    EXPECT_EQ(glyphs[0].low, 0.0);
    EXPECT_EQ(glyphs[0].high, 0.25);
    EXPECT_EQ(glyphs[1].low, 0.0);
    EXPECT_LT(glyphs[2].outline.min.y, -0.1);  // g reaches below the line
    // Spread out by 1/8: A and V overlap by their kerning, and not without it.
    EXPECT_LT(glyphs[1].outline.min.x, glyphs[0].outline.max.x + 0.125);
    EXPECT_GT(glyphs[2].outline.min.x, glyphs[1].outline.max.x);
    for (const Glyph& glyph : glyphs)
        for (std::size_t i = 1; i < glyph.outline.pieces.size(); ++i) {
            const Vec2 start = glyph.outline.pieces[i].points[0], end = glyph.outline.pieces[i - 1].points[3];
            if (start == end) continue;
            // A new contour begins: some piece ends where it does.
            bool closed = false;
            for (const CurvePiece& piece : glyph.outline.pieces) closed |= piece.points[3] == start;
            EXPECT_TRUE(closed);
        }
    EXPECT_EQ(only_further<Text>("text { internal 1 \"A\" 1, 0 }").glyphs->front().outline, glyphs[0].outline);
    EXPECT_EQ(only_further<Text>("text { internal 7 \"P\" 1, 0 }"), only_further<Text>("text { ttf \"povlogo\" \"P\" 1, 0 }"));
    EXPECT_EQ(only_further<Text>("text { ttf \"timrom\", \"A\", -1, 0 }").glyphs->front().low, -1.0);
    EXPECT_THAT(parse_block("text { ttf \"timrom.ttf\" \"\" 1, 0 }").scene.objects, IsEmpty());
}

}  // namespace
}  // namespace rt::blocks_curve_test
