#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_mesh_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Face = MeshData::Face;
constexpr Face flat{MeshData::flat, MeshData::flat, MeshData::flat};
const std::string corners = "vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0,0,1> } ";

MeshData mesh(const std::string& text) { return *only_shape<Mesh>(text).data; }
MeshData mesh2(const std::string& body) { return mesh("mesh2 { " + corners + body + " }"); }
ParsedScene parse_mesh2(const std::string& body) { return parse_block("mesh2 { " + corners + body + " }"); }

TEST(MeshBlock, FlatTriangles) {
    const MeshData m = mesh("mesh { triangle { 0, x, y } triangle { x y z } }");
    EXPECT_THAT(m.vertices, ElementsAre(Vec3(0.0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)));
    EXPECT_THAT(m.faces, ElementsAre(Face{0, 1, 2}, Face{3, 4, 5}));
    EXPECT_THAT(m.normals, IsEmpty());
    EXPECT_THAT(m.normal_faces, IsEmpty());
}

TEST(MeshBlock, SmoothAndFlatTogether) {
    const MeshData m = mesh("mesh { triangle { 0, x, y } smooth_triangle { 0, 2*z, x, z, y, -z } triangle { x, y, z } }");
    EXPECT_THAT(m.normal_faces, ElementsAre(flat, Face{0, 1, 2}, flat));
    EXPECT_THAT(m.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, -1)));
}

TEST(MeshBlock, DegenerateTrianglesAreLeftOutSilently) {
    const ParsedScene p = parse_block("mesh { triangle { 0, x, 2*x } triangle { 0, x, y } }");
    EXPECT_EQ(std::get<Mesh>(p.scene.objects.at(0).shape).data->faces.size(), 1u);
    EXPECT_THAT(p.messages, IsEmpty());
    EXPECT_EQ(parse_block("mesh { triangle { 0, x, 2*x } }").error, "No triangles in triangle mesh.");
    EXPECT_EQ(parse_block("mesh { sphere { 0, 1 } }").error, "No triangles in triangle mesh.");
}

TEST(MeshBlock, ZeroNormalsBecomeX) {
    const ParsedScene p = parse_block("mesh { smooth_triangle { 0, 0, x, z, y, z } }");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Normal vector in mesh cannot be zero - changing it to <1,0,0>.")));
    EXPECT_EQ(std::get<Mesh>(p.scene.objects.at(0).shape).data->normals[0], Vec3(1, 0, 0));
}

TEST(MeshBlock, WhatElseMayStandInATriangle) {
    EXPECT_EQ(parse_block("mesh { triangle { 0, x, y uv_vectors <0,0>, <1,0>, <0,1> } inside_vector z hierarchy off }").error, "");
    EXPECT_EQ(parse_block("mesh { triangle { 0, x, y pigment { rgb 1 } } }").error, "No matching } in 'triangle', pigment found instead");
}

TEST(Mesh2Block, FacesWithAndWithoutCommas) {
    const MeshData m = mesh2("face_indices { 2, <0,1,2>, <1,2,3> }");
    EXPECT_EQ(m.vertices.size(), 4u);
    EXPECT_THAT(m.faces, ElementsAre(Face{0, 1, 2}, Face{1, 2, 3}));
    EXPECT_EQ(mesh2("face_indices { 2 <0 1 2> <1 2 3>, }"), m);
    EXPECT_EQ(mesh2("face_indices { 2.9, <0.7,1.2,2>, <1,2,3> }"), m);
}

TEST(Mesh2Block, OneNormalAVertexNeedsNoIndices) {
    const MeshData m = mesh2("normal_vectors { 4, z, 2*z, x, y } face_indices { 1, <3,1,2> }");
    EXPECT_THAT(m.normals, ElementsAre(Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    EXPECT_THAT(m.normal_faces, ElementsAre(Face{3, 1, 2}));
}

TEST(Mesh2Block, NormalIndices) {
    const MeshData m = mesh2("normal_vectors { 2, z, x } face_indices { 2, <0,1,2>, <1,2,3> } normal_indices { 1, <0,1,1> }");
    EXPECT_THAT(m.normal_faces, ElementsAre(Face{0, 1, 1}, flat));
    EXPECT_EQ(parse_mesh2("normal_vectors { 2, z, x } face_indices { 1, <0,1,2> }").error, "Missing normal_indicies section in mesh2.");
    EXPECT_EQ(parse_mesh2("normal_vectors { 2, z, x } face_indices { 1, <0,1,2> } normal_indices { 2, <0,1,1>, <0,1,1> }").error,
              "Number of normal indices cannot be more than the number of faces.");
    EXPECT_EQ(parse_mesh2("normal_vectors { 2, z, x } face_indices { 1, <0,1,2> } normal_indices { 1, <0,1,2> }").error,
              "Mesh normal index out of range.");
}

TEST(Mesh2Block, NormalIndicesFollowTheirFacePastADegenerateOne) {
    const MeshData m = mesh2("normal_vectors { 2, z, x } face_indices { 2, <0,1,1>, <1,2,3> } normal_indices { 2, <0,0,0>, <1,1,1> }");
    EXPECT_THAT(m.faces, ElementsAre(Face{1, 2, 3}));
    EXPECT_THAT(m.normal_faces, ElementsAre(Face{1, 1, 1}));
}

TEST(Mesh2Block, IndicesMustBeInRange) {
    for (const char* face : {"<0,1,4>", "<-1,1,2>", "<0,1e20,2>", "4"})
        EXPECT_EQ(parse_mesh2(fmt::format("face_indices {{ 1, {} }}", face)).error, "Mesh face index out of range.") << face;
    EXPECT_EQ(parse_mesh2("face_indices { 1, <0,1,-0.5> }").error, "");
}

TEST(Mesh2Block, OrderOfItsLists) {
    EXPECT_EQ(parse_block("mesh2 { face_indices { 1, <0,1,2> } }").error, "Vertex vectors not found in mesh2");
    EXPECT_EQ(parse_block("mesh2 { normal_vectors { 3, z, z, z } vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,2> } }").error, "");
    EXPECT_EQ(parse_mesh2("").error, "Expected 'face_indices', } found instead");
    EXPECT_EQ(parse_mesh2("face_indices { 1, <0,1,2> } normal_vectors { 1, z }").error,
              "No matching } in 'mesh2', normal_vectors found instead");
    EXPECT_EQ(parse_mesh2("face_indices { 1, <0,1,2> } inside_vector y hierarchy off pigment { rgb 1 }").error, "");
}

TEST(Mesh2Block, CountsAreChecked) {
    EXPECT_EQ(parse_block("mesh2 { vertex_vectors { 0 } face_indices { 0 } }").error, "No vertices in triangle mesh.");
    EXPECT_EQ(parse_mesh2("face_indices { 0 }").error, "No triangles in triangle mesh.");
    EXPECT_EQ(parse_mesh2("face_indices { 2, <0,1,2> }").error, "Expected 'numeric expression', } found instead");
    EXPECT_EQ(parse_block("mesh2 { vertex_vectors { 2, 0, x, y } }").error,
              "No matching } in 'vertex_vectors', vector function 'y' found instead");
}

TEST(Mesh2Block, AStatedCountReservesNoMoreThanTheFileCanHold) {
    EXPECT_EQ(parse_block("mesh2 { vertex_vectors { 4000000000, 0, x } }").error, "Expected 'numeric expression', } found instead");
    EXPECT_EQ(parse_mesh2("face_indices { 1e300, <0,1,2> }").error, "Expected 'numeric expression', } found instead");
    EXPECT_EQ(parse_block("polygon { 4e9, 0, x, y }").error, "Expected 'numeric expression', } found instead");
}

TEST(Mesh2Block, DuplicateListsReplaceTheFirst) {
    const ParsedScene p = parse_block("mesh2 { vertex_vectors { 1, 9 } vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,2> } }");
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("Duplicate vertex_vectors block; ignoring previous block.")));
    EXPECT_EQ(std::get<Mesh>(p.scene.objects.at(0).shape).data->vertices.size(), 3u);
}

TEST(MeshBlock, UvsOfTrianglesStandBesideThem) {
    const ParsedScene p =
        parse_block("mesh { triangle { 0, x, y } triangle { 0, x, y uv_vectors <1,2>, <3,4>, <5,6> } triangle { 0, x, z } }");
    const MeshData& m = *std::get<Mesh>(p.scene.objects.at(0).shape).data;
    EXPECT_THAT(m.uvs, ElementsAre(Vec2(1, 2), Vec2(3, 4), Vec2(5, 6)));
    constexpr Face none{MeshData::flat, MeshData::flat, MeshData::flat};
    EXPECT_THAT(m.uv_faces, ElementsAre(none, Face{0, 1, 2}, none));
    EXPECT_EQ(uv(m, 0, {.u = 0.25, .v = 0.5}), Vec2(0.0));
    EXPECT_EQ(uv(m, 1, {.u = 0.25, .v = 0.5}), Vec2(0.25 * 1 + 0.25 * 3 + 0.5 * 5, 0.25 * 2 + 0.25 * 4 + 0.5 * 6));
}

TEST(Mesh2Block, UvsHaveIndicesOrAreTheVertices) {
    const std::string three = "uv_vectors { 3, <0,0>, <1,0>, <0,1> } ", four = "uv_vectors { 4, <0,0>, <1,0>, <0,1>, <1,1> } ";
    const std::string faces = "face_indices { 3, <0,1,2>, <1,1,2>, <1,2,3> } ";
    EXPECT_THAT(mesh2(three + faces + "uv_indices { 3, <0,1,2>, <0,0,0>, <2,1.9,-0.5> }").uv_faces,
                ElementsAre(Face{0, 1, 2}, Face{2, 1, 0}));
    EXPECT_THAT(mesh2(four + faces).uv_faces, ElementsAre(Face{0, 1, 2}, Face{1, 2, 3}));
    EXPECT_TRUE(mesh2(faces).uv_faces.empty());
    EXPECT_EQ(parse_mesh2(three + faces).error, "Missing uv_indicies section in mesh2.");
    EXPECT_EQ(parse_mesh2(three + faces + "uv_indices { 3, <0,1,2>, <0,0,0>, <2,1,3> }").error, "Mesh UV index out of range.");
    EXPECT_EQ(parse_mesh2(faces + "uv_indices { 3, <0,1,2>, <0,0,0>, <2,1,3> }").error, "Mesh UV index out of range.");
    EXPECT_EQ(parse_mesh2(four + faces + "uv_indices { 2, <0,1,2>, <0,0,0> }").error, "Number of uv indices must equal number of faces.");
}

TEST(Mesh2Block, OnlyDegenerateFacesLeaveNoObject) {
    const ParsedScene p = parse_mesh2("face_indices { 1, <0,1,1> }");
    EXPECT_EQ(p.error, "");
    EXPECT_TRUE(p.scene.objects.empty());
}

TEST(Mesh2Block, ALongList) {
    std::string vertices;
    std::string faces;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        vertices += fmt::format("<{},{},0>,", i, i * i);
        faces += fmt::format("<{},{},{}>,\n", i, (i + 1) % count, (i + 2) % count);
    }
    const MeshData m = mesh(fmt::format("mesh2 {{ vertex_vectors {{ {0}, {1} }} face_indices {{ {0}, {2} }} }}", count, vertices, faces));
    EXPECT_EQ(m.vertices.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(m.vertices[12345], Vec3(12345, 12345.0 * 12345.0, 0));
    EXPECT_EQ(m.faces.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(m.faces.back(), (Face{count - 1, 0, 1}));
}

}  // namespace
}  // namespace rt::blocks_mesh_test
