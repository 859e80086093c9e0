// Textures of the faces of mesh and mesh2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::mesh_texture_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr std::uint32_t of_object = TextureWeight::of_object;
const std::string names =
    "#declare R = texture { pigment { rgb x } } #declare G = texture { pigment { rgb y } } #declare B = texture { pigment { rgb z } } ";
const std::string corners = "vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> } ";
const std::string list = "texture_list { 3, texture { R } texture { pigment { rgb y } } texture { B }, } ";

ParsedScene parse_mesh(const std::string& body) { return parse_block(names + "mesh { " + body + " }"); }
ParsedScene parse_mesh2(const std::string& body) { return parse_block(names + "mesh2 { " + corners + body + " }"); }

Object only(const ParsedScene& parsed) {
    EXPECT_EQ(parsed.error, "");
    EXPECT_TRUE(parsed.scene.unmodelled.empty());
    return parsed.scene.objects.at(0);
}

FaceTextures faces(const ParsedScene& parsed) {
    const Object object = only(parsed);
    const auto& textures = std::get<Mesh>(object.shape).textures;
    return textures ? **textures : FaceTextures{};
}

Rgb color(const TextureLayers& layers) {
    return std::get<PigmentColor>(std::get<PlainTexture>(layers->front().content).pigment.content).rgb;
}

std::vector<Rgb> colors(const ParsedScene& parsed) {
    const Object object = only(parsed);
    std::vector<Rgb> all;
    if (object.shape_textures)
        for (const TextureLayers& layers : **object.shape_textures) all.push_back(color(layers));
    return all;
}

TEST(MeshTextures, TrianglesNameDeclaredTextures) {
    const ParsedScene parsed = parse_mesh(
        "triangle { 0, x, y texture { G } } triangle { 0, x, z } triangle { 0, y, z uv_vectors 0, 0, 0 texture { R } texture { G } }");
    EXPECT_EQ(faces(parsed), (FaceTextures{false, {0, of_object, 0}})) << "the last of two counts";
    EXPECT_THAT(colors(parsed), ElementsAre(Rgb(0, 1, 0), Rgb(1, 0, 0)));
}

TEST(MeshTextures, ACornerOfATriangleMayHaveItsOwn) {
    const ParsedScene parsed = parse_mesh(
        "triangle { 0, x, y } triangle { 0, x, y texture { G } } smooth_triangle { 0, z, x, z, y, z texture_list { R, G B } } "
        "triangle { 0, x, y texture_list { B B B } } triangle { 0, x, y }");
    EXPECT_EQ(faces(parsed),
              (FaceTextures{true, {of_object, of_object, of_object, 0, 0, 0, 1, 0, 2, 2, 2, 2, of_object, of_object, of_object}}));
    EXPECT_THAT(colors(parsed), ElementsAre(Rgb(0, 1, 0), Rgb(1, 0, 0), Rgb(0, 0, 1)));
}

TEST(MeshTextures, TrianglesThatAreLeftOutTakeTheirTexturesAlong) {
    const ParsedScene parsed = parse_mesh("triangle { 0, x, 2*x texture { R } } triangle { 0, x, y texture { G } } triangle { 0, x, y }");
    EXPECT_EQ(faces(parsed), (FaceTextures{false, {1, of_object}}));
    EXPECT_FALSE(only(parse_mesh("triangle { 0, x, 2*x texture { R } } triangle { 0, x, y }")).shape_textures);
}

TEST(MeshTextures, OfTrianglesMustBeNames) {
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture { pigment { rgb 1 } } }").error,
              "Expected 'texture identifier', pigment found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture { } }").error, "Expected 'texture identifier', } found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture { R scale 2 } }").error, "No matching } in 'texture', scale found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture_list { R G } }").error, "Expected 'texture identifier', } found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture_list { texture { R } } }").error,
              "Expected 'texture identifier', texture found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture_list { R G B B } }").error,
              "No matching } in 'texture_list', texture identifier found instead");
    EXPECT_EQ(parse_mesh("triangle { 0, x, y texture_list { R G B } texture { R } }").error,
              "No matching } in 'triangle', texture found instead");
}

TEST(MeshTextures, Mesh2HasAListAndIndicesOfIt) {
    const ParsedScene one = parse_mesh2(list + "face_indices { 3, <0,1,2>, 2 <0,1,3>, <1,2,3>, 0.9 }");
    EXPECT_EQ(faces(one), (FaceTextures{false, {2, of_object, 0}}));
    EXPECT_THAT(colors(one), ElementsAre(Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)));
    const ParsedScene three = parse_mesh2(list + "face_indices { 3, <0,1,2>, 2, <0,1,1>, 1, <1,2,3>, 0 1, 2 }");
    EXPECT_EQ(faces(three), (FaceTextures{true, {2, 2, 2, 0, 1, 2}})) << "the second face has no area";
    EXPECT_FALSE(std::get<Mesh>(only(parse_mesh2(list + "face_indices { 1, <0,1,2> }")).shape).textures);
    EXPECT_FALSE(only(parse_mesh2(list + "face_indices { 1, <0,1,2> }")).shape_textures);
    EXPECT_FALSE(only(parse_mesh2("texture_list { 0 } face_indices { 1, <0,1,2> }")).shape_textures);
}

TEST(MeshTextures, EqualPlainColoursAreKeptOnce) {
    const ParsedScene parsed = parse_mesh2(
        "texture_list { 5, texture { R } texture { pigment { rgb x } } texture { pigment { rgb x } finish { phong 1 } } "
        "texture { pigment { checker } } texture { pigment { rgb x transmit .5 } } } face_indices { 2, <0,1,2>, 0, 1, 2, <1,2,3>, 0, 3, 4 "
        "}");
    EXPECT_THAT(**only(parsed).shape_textures, SizeIs(4));
    EXPECT_EQ(faces(parsed), (FaceTextures{true, {0, 0, 1, 0, 2, 3}}));
}

TEST(MeshTextures, MistakesInTheListOfMesh2) {
    EXPECT_EQ(parse_mesh2("texture_list { 2, texture { R } } face_indices { 1, <0,1,2>, 0 }").error, "Expected 'texture', } found instead");
    EXPECT_EQ(parse_mesh2("texture_list { 1, texture { R } texture { G } } face_indices { 1, <0,1,2>, 0 }").error,
              "No matching } in 'texture_list', texture found instead");
    EXPECT_EQ(parse_mesh2("texture_list { 2, R, G } face_indices { 1, <0,1,2>, 0 }").error,
              "Expected 'texture', texture identifier found instead");
    EXPECT_EQ(parse_mesh2(list + list + "face_indices { 1, <0,1,2>, 0 }").error, "Expected 'face_indices', texture_list found instead");
    EXPECT_EQ(parse_block("mesh2 { texture_list { 1, texture { } } " + corners + "face_indices { 1, <0,1,2>, 0 } }").error,
              "Vertex vectors not found in mesh2");
    for (const char* index : {"3", "-1", "0, 1, 3"})
        EXPECT_EQ(parse_mesh2(list + "face_indices { 1, <0,1,2>, " + index + " }").error, "Texture index out of range in mesh2.") << index;
    EXPECT_EQ(parse_mesh2("face_indices { 1, <0,1,2>, 0 }").error, "Texture index out of range in mesh2.");
    EXPECT_EQ(parse_mesh2(list + "face_indices { 1, <0,1,2>, 0, 1 }").error, "A face of a mesh2 has one texture index or three.");
}

/// The offset of the checker that the only texture of the object's shape is.
Vec3 checker_offset(const Object& object) {
    const auto& plain = std::get<PlainTexture>((**object.shape_textures).back()->front().content);
    const auto& pattern = std::get<Shared<PatternPigment>>(plain.pigment.content)->pattern.pattern;
    return pattern.warps.empty() ? Vec3(0.0) : std::get<Transform>(pattern.warps.front()).offset;
}

TEST(MeshTextures, MoveWithTheirObject) {
    const std::string mesh =
        "mesh2 { " + corners + "texture_list { 1, texture { pigment { checker } } } face_indices { 2, <0,1,2>, 0, <1,2,3> } ";
    const auto offset = [](const std::string& text) { return checker_offset(only(parse_block(text))); };
    EXPECT_EQ(offset(mesh + "}"), Vec3(0.0));
    EXPECT_EQ(offset(mesh + "translate x texture { pigment { rgb 1 } } translate y }"), Vec3(1, 1, 0));
    EXPECT_EQ(offset(mesh + "uv_mapping translate x }"), Vec3(0.0)) << "its surface takes its coordinates along";
    EXPECT_EQ(offset("#declare M = " + mesh + "translate x } object { M translate y }"), Vec3(1, 1, 0));
    EXPECT_EQ(offset("union { " + mesh + "translate x } sphere { 0, 1 } translate z }"), Vec3(1, 0, 1));
}

TEST(MeshTextures, OneOfAllFacesIsTheObjects) {
    const std::string all = "face_indices { 2, <0,1,2>, 1, <1,2,3>, 1, 1, 1 } ";
    const auto is_plain = [](const Object& object) { return !object.shape_textures && !std::get<Mesh>(object.shape).textures; };
    const Object object = only(parse_mesh2(list + all + "texture { B }"));
    EXPECT_TRUE(is_plain(object));
    EXPECT_EQ(color(*object.texture), Rgb(0, 1, 0));
    EXPECT_FALSE(is_plain(only(parse_mesh2(list + "face_indices { 2, <0,1,2>, 1, <1,2,3>, 2 }"))));
    EXPECT_FALSE(is_plain(only(parse_mesh2(list + "face_indices { 2, <0,1,2>, 1, <1,2,3> }"))));
    EXPECT_FALSE(is_plain(only(parse_mesh2(list + all + "texture { B finish { ior 1.5 } }")))) << "it says what is inside";
    const Object mesh = only(parse_mesh("triangle { 0, x, y texture { R } } triangle { 0, x, z texture_list { R R R } }"));
    EXPECT_TRUE(is_plain(mesh));
    EXPECT_EQ(color(*mesh.texture), Rgb(1, 0, 0));
}

TEST(MeshTextures, CopiesOfAMeshShareThem) {
    const ParsedScene parsed =
        parse_block(names + "#declare M = mesh2 { " + corners + list +
                    "face_indices { 2, <0,1,2>, 0, <1,2,3>, 1 } } object { M translate x } object { M translate y }");
    const auto& objects = parsed.scene.objects;
    EXPECT_EQ(objects.at(0).shape_textures->identity(), objects.at(1).shape_textures->identity());
    EXPECT_EQ(std::get<Mesh>(objects.at(0).shape).textures->identity(), std::get<Mesh>(objects.at(1).shape).textures->identity());
}

TEST(MeshTextures, NeighboursShareEqualOnes) {
    const std::string stated = "mesh2 { " + corners + list + "face_indices { 1, <0,1,2>, 0, 1, 2 } } ";
    const ParsedScene parsed = parse_block(names + stated + "sphere { 0, 1 } " + stated + stated);
    ASSERT_EQ(parsed.error, "");
    const auto identity = [&](std::size_t object) { return (**parsed.scene.objects.at(object).shape_textures).at(1).identity(); };
    EXPECT_EQ(identity(3), identity(2));
    EXPECT_NE(identity(2), identity(0)) << "something else stands between";
}

}  // namespace
}  // namespace rt::mesh_texture_test
