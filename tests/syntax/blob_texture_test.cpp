// Textures of the components of a blob.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blob_texture_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr std::uint32_t of_object = TextureWeight::of_object;
const std::string names = "#declare R = texture { pigment { rgb x } } #declare G = texture { pigment { rgb y } } ";

Object blob(const std::string& body) {
    const ParsedScene parsed = parse_block(names + "blob { " + body + " }");
    EXPECT_EQ(parsed.error, "") << body;
    return parsed.scene.objects.at(0);
}

std::vector<std::uint32_t> numbers(const Object& object) {
    std::vector<std::uint32_t> all;
    for (const BlobComponent& component : std::get<Blob>(std::get<FurtherShape>(object.shape)).data->components)
        all.push_back(component.texture);
    return all;
}

const PlainTexture& stated(const Object& object, std::size_t number, std::size_t layer = 0) {
    return std::get<PlainTexture>((**object.shape_textures).at(number)->at(layer).content);
}

Rgb color(const Object& object, std::size_t number, std::size_t layer = 0) {
    return std::get<PigmentColor>(stated(object, number, layer).pigment.content).rgb;
}

TEST(BlobTextures, ComponentsNumberTheirs) {
    const Object object = blob(
        "sphere { 0, 1, 1 texture { G } } sphere { 0, 1, 1 } component 1, 1, 0 cylinder { 0, x, 1, 1 pigment { rgb x } } "
        "sphere { 0, 1, 0 pigment { rgb z } } sphere { 0, 1, 1 texture { G } } texture { pigment { rgb 1 } }");
    EXPECT_THAT(numbers(object), ElementsAre(0, of_object, of_object, 1, 0)) << "what has no field is left out";
    ASSERT_THAT(**object.shape_textures, SizeIs(2));
    EXPECT_EQ(color(object, 0), Rgb(0, 1, 0));
    EXPECT_EQ(color(object, 1), Rgb(1, 0, 0));
    EXPECT_EQ(color_of(object).rgb, Rgb(1.0));
    EXPECT_FALSE(blob("sphere { 0, 1, 1 } texture { R }").shape_textures);
}

TEST(BlobTextures, AreStatedAsThoseOfObjects) {
    const Object layered = blob("sphere { 0, 1, 1 texture { R } texture { G } }");
    EXPECT_EQ(color(layered, 0, 0), Rgb(1, 0, 0));
    EXPECT_EQ(color(layered, 0, 1), Rgb(0, 1, 0));
    const Object bare = blob("sphere { 0, 1, 1 finish { diffuse 0.25 } pigment { rgb y } normal { bumps 1 } }");
    EXPECT_EQ(color(bare, 0), Rgb(0, 1, 0));
    EXPECT_EQ(stated(bare, 0).finish.diffuse, 0.25);
    EXPECT_TRUE(stated(bare, 0).normal);
    const Object by_default = blob("#default { pigment { rgb z } } sphere { 0, 1, 1 finish { diffuse 0.5 } } texture { R }");
    EXPECT_EQ(color(by_default, 0), Rgb(0, 0, 1)) << "not the blob's own";
}

/// The offset of the checker that is the top of the only texture stated.
Vec3 offset(const std::string& text) {
    const ParsedScene parsed = parse_block(text);
    EXPECT_EQ(parsed.error, "") << text;
    const TextureLayers& layers = (**parsed.scene.objects.at(0).shape_textures).at(0);
    const auto& pigment = std::get<PlainTexture>(layers->back().content).pigment;
    const auto& pattern = std::get<Shared<PatternPigment>>(pigment.content)->pattern.pattern;
    return pattern.warps.empty() ? Vec3(0.0) : std::get<Transform>(pattern.warps.front()).offset;
}

TEST(BlobTextures, MoveWithWhatMovesTheComponentAfterThem) {
    const auto of = [](const std::string& component, const std::string& whole = "") {
        return "blob { sphere { 0, 1, 1 " + component + " } " + whole + " } ";
    };
    const std::string checker = "pigment { checker } ";
    EXPECT_EQ(offset(of(checker)), Vec3(0.0));
    EXPECT_EQ(offset(of("translate x " + checker)), Vec3(0.0));
    EXPECT_EQ(offset(of("translate x " + checker + "translate y")), Vec3(0, 1, 0));
    EXPECT_EQ(offset(of("pigment { rgb 1 } translate x " + checker)), Vec3(1, 0, 0)) << "a pigment begins where the last one was moved to";
    EXPECT_EQ(offset(of(checker + "translate x texture { " + checker + "}")), Vec3(0.0)) << "a layer that was put on later";
    EXPECT_EQ(offset(of(checker + "translate x", "translate y pigment { rgb 1 } translate z")), Vec3(1, 1, 1));
    EXPECT_EQ(offset(of(checker, "uv_mapping translate x")), Vec3(1, 0, 0)) << "as POV-Ray has it";
    EXPECT_EQ(offset("union { " + of(checker, "uv_mapping") + "translate y }"), Vec3(0, 1, 0));
    EXPECT_EQ(offset(of("texture { uv_mapping " + checker + "}", "translate x")), Vec3(0.0));
    EXPECT_EQ(offset("#declare B = " + of(checker, "translate x") + "object { B translate y }"), Vec3(1, 1, 0));
    EXPECT_EQ(offset("union { " + of(checker + "translate x") + "sphere { 0, 1 } translate z }"), Vec3(1, 0, 1));
}

}  // namespace
}  // namespace rt::blob_texture_test
