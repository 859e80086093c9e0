// Which textures the faces of a mesh and the components of a blob show.
#include "geometry/texture_weight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/blob.h"
#include "geometry/mesh.h"

namespace rt::texture_weight_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint32_t of_object = TextureWeight::of_object;

std::vector<TextureWeight> shown(const FaceTextures& textures, std::size_t face, double u, double v, double least = 0.0) {
    std::vector<TextureWeight> weights;
    texture_weights(textures, face, {.u = u, .v = v}, least, weights);
    return weights;
}

TEST(FaceTextures, OneNumberAFaceShowsWholly) {
    const FaceTextures textures{false, {7, of_object}};
    EXPECT_THAT(shown(textures, 0, 0.25, 0.25, 0.9), ElementsAre(TextureWeight{7, 1.0}));
    EXPECT_THAT(shown(textures, 1, 0.25, 0.25), ElementsAre(TextureWeight{of_object, 1.0}));
}

TEST(FaceTextures, CornersHaveTheWeightsOfTheHit) {
    const FaceTextures textures{true, {9, 9, 9, 4, 5, of_object}};
    EXPECT_THAT(shown(textures, 1, 0.25, 0.5), ElementsAre(TextureWeight{4, 0.25}, TextureWeight{5, 0.25}, TextureWeight{of_object, 0.5}));
    EXPECT_THAT(shown(textures, 0, 0.25, 0.5, 0.9), ElementsAre(TextureWeight{9, 1.0})) << "no mixture";
}

TEST(FaceTextures, CornersBelowTheLeastWeightDoNotCount) {
    const FaceTextures textures{true, {4, 5, 4}};
    EXPECT_THAT(shown(textures, 0, 0.5, 0.125), ElementsAre(TextureWeight{4, 0.5}, TextureWeight{5, 0.5}));
    EXPECT_THAT(shown(textures, 0, 0.5, 0.125, 0.25), ElementsAre(TextureWeight{4, 0.375}, TextureWeight{5, 0.5}));
    EXPECT_THAT(shown(textures, 0, 0.5, 0.125, 0.375), ElementsAre(TextureWeight{4, 0.375}, TextureWeight{5, 0.5})) << "not below it";
    EXPECT_THAT(shown(textures, 0, 0.5, 0.125, 0.6), IsEmpty());
}

/// Spheres of radius 1 around points of the x axis, of which each has the texture of its number.
struct OnAxis {
    double x, strength;
    std::uint32_t texture;
};

std::vector<TextureWeight> shown(const std::vector<OnAxis>& spheres, const Vec3& point, double least = 0.0) {
    BlobData data;
    for (const OnAxis& sphere : spheres) {
        BlobComponent component;
        component.base = component.cap = {sphere.x, 0, 0};
        component.strength = sphere.strength;
        component.texture = sphere.texture;
        data.components.push_back(component);
    }
    std::vector<TextureWeight> weights;
    texture_weights(Blob{data}, point, least, weights);
    return weights;
}

/// (1 - d^2)^2 is 9/16 at d = 1/2, 1 at d = 0.
TEST(BlobTextures, ComponentsHaveTheSharesOfTheirFields) {
    const Vec3 at(0.0);
    EXPECT_THAT(shown({{0, 1, 3}, {0.5, 16.0 / 3.0, 4}}, at), ElementsAre(TextureWeight{3, 0.25}, TextureWeight{4, 0.75}));
    EXPECT_THAT(shown({{0, 1, 3}, {1.5, 9, 4}, {-1, 9, 5}}, at), ElementsAre(TextureWeight{3, 1.0})) << "the others do not reach it";
    EXPECT_THAT(shown({{0, 3, of_object}, {0, -1, 4}}, at), ElementsAre(TextureWeight{of_object, 0.75}, TextureWeight{4, 0.25}))
        << "what carves has the share of its size";
    EXPECT_THAT(shown({{2, 1, 3}}, at), IsEmpty());
}

TEST(BlobTextures, ComponentsOfOneTextureAreJoined) {
    const Vec3 at(0.0);
    EXPECT_THAT(shown({{0, 1, 3}, {0, 2, 4}, {0, 1, 3}}, at), ElementsAre(TextureWeight{3, 0.5}, TextureWeight{4, 0.5}));
    EXPECT_THAT(shown({{0, 0.1, 3}, {0.1, 0.2, 3}, {0.3, 0.7, 3}}, at), ElementsAre(TextureWeight{3, 1.0})) << "to the last bit";
}

/// As POV-Ray has it each of them counts alone.
TEST(BlobTextures, ComponentsBelowTheLeastShareDoNotCount) {
    const Vec3 at(0.0);
    EXPECT_THAT(shown({{0, 1, 3}, {0, 2, 4}, {0, 1, 3}}, at, 0.3), ElementsAre(TextureWeight{4, 0.5}));
    EXPECT_THAT(shown({{0, 1, 3}, {0, 3, 4}}, at, 0.25), ElementsAre(TextureWeight{3, 0.25}, TextureWeight{4, 0.75})) << "not below it";
}

TEST(BlobTextures, FieldsAreThoseOfComponentsWhereTheyWereMoved) {
    BlobComponent moved, cylinder;
    moved.texture = 1;
    moved.moved = true;
    moved.own_offset = {-0.5, 0, 0};
    cylinder.base = {-1, 0, 0};
    cylinder.cap = {1, 0, 0};
    cylinder.strength = 3.0 * 9.0 / 16.0;
    std::vector<TextureWeight> weights{{7, 0.5}};
    texture_weights(Blob{BlobData{{moved, cylinder}, 1.0}}, Vec3(0.0), 0.0, weights);
    EXPECT_THAT(weights, ElementsAre(TextureWeight{7, 0.5}, TextureWeight{1, 0.25}, TextureWeight{of_object, 0.75}));
}

}  // namespace
}  // namespace rt::texture_weight_test
