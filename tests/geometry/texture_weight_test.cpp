// Which textures the faces of a mesh show.
#include "geometry/texture_weight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/mesh.h"

namespace rt {
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

}  // namespace
}  // namespace rt
