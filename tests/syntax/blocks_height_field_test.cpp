// height_field: samples of pictures and functions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_height_field_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Pictures of two columns and two rows by name.
std::optional<PictureFile> picture(const std::string& path) {
    using Kind = PictureFile::Kind;
    if (path == "grey.png") return PictureFile{2, 2, 1, 255, {0, 3, 128, 255}, std::nullopt, Kind::png};
    if (path == "grey.pgm") return PictureFile{2, 2, 1, 255, {0, 3, 128, 255}, std::nullopt};
    if (path == "grey16.png") return PictureFile{2, 2, 1, 65535, {0, 3, 4567, 65535}, std::nullopt, Kind::png};
    if (path == "colour.png") return PictureFile{2, 2, 3, 255, {0, 3, 9, 1, 2, 9, 255, 255, 9, 0, 0, 9}, std::nullopt, Kind::png};
    if (path == "palette.png") return PictureFile{2, 2, 3, 255, std::vector<float>(12, 7), std::nullopt, Kind::png, {0, 1, 2, 255}};
    if (path == "palette.gif") return PictureFile{2, 2, 3, 255, std::vector<float>(12, 7), std::nullopt, Kind::gif};
    if (path == "floats.exr") return PictureFile{2, 2, 3, 0, std::vector<float>(12, 0.5), std::nullopt};
    if (path == "thin.png") return PictureFile{1, 2, 1, 255, {0, 3}, std::nullopt, Kind::png};
    return std::nullopt;
}

ParsedScene parse(const std::string& inside) {
    ParseOptions options;
    options.read_picture = picture;
    return parse_block("height_field { " + inside + " }", options);
}
HeightField field_of(const std::string& inside) {
    const ParsedScene parsed = parse(inside);
    EXPECT_EQ(parsed.error, "") << inside;
    return std::get<HeightField>(std::get<FurtherShape>(parsed.scene.objects.at(0).shape));
}
std::vector<std::uint16_t> heights_of(const std::string& inside) { return field_of(inside).data->heights; }

TEST(HeightFieldBlock, TakesHeightsFromPictures) {
    EXPECT_THAT(heights_of("png \"grey.png\""), ElementsAre(128 * 257, 65535, 0, 2 * 257)) << "the bottom row first; 3 is kept as 2";
    EXPECT_THAT(heights_of("pgm \"grey.pgm\""), ElementsAre(128 * 257, 65535, 0, 3 * 257));
    EXPECT_THAT(heights_of("\"grey16.png\""), ElementsAre(4567, 65535, 0, 3));
    EXPECT_THAT(heights_of("\"colour.png\""), ElementsAre(65535, 0, 3, 258));
    EXPECT_THAT(heights_of("\"palette.png\""), ElementsAre(512, 65280, 0, 256));
    EXPECT_THAT(heights_of("\"grey16.png\" gamma 2"), ElementsAre(318, 65535, 0, 0));
    EXPECT_THAT(heights_of("\"grey16.png\" gamma srgb"), ElementsAre(389, 65535, 0, 0));
    EXPECT_THAT(heights_of("\"colour.png\" gamma 2"), ElementsAre(65535, 0, 0, 1));
}

TEST(HeightFieldBlock, TakesHeightsFromFunctions) {
    EXPECT_THAT(heights_of("function 3, 2 { x/2 + y/4 }"), ElementsAre(16383, 32767, 49151, 0, 16383, 32767)) << "y = 1 comes first";
    EXPECT_THAT(heights_of("function 2.9 2 { select(x - 0.5, 1.5, -0.5) }"), ElementsAre(32766, 32769, 32766, 32769)) << "of 16 bits";
    EXPECT_THAT(heights_of("function 2, 2 { x/0*0 }"), ElementsAre(0, 0, 0, 0)) << "no number";
}

TEST(HeightFieldBlock, ReadsItsModifiersFirst) {
    const HeightField field = field_of("\"grey.png\" smooth water_level 0.3 smooth hierarchy off scale 2");
    EXPECT_EQ(field.normals->size(), 4u);
    EXPECT_EQ(field.lowest, 0.3);
    EXPECT_THAT(*field_of("\"grey.png\"").normals, IsEmpty());
    EXPECT_EQ(parse("\"grey.png\" scale 2 smooth").error, "No matching } in 'height_field', smooth found instead");
    EXPECT_EQ(parse("\"grey.png\" smooth off").error, "No matching } in 'height_field', float function 'off' found instead");
    EXPECT_EQ(parse("\"grey.png\" sturm").error, "Keyword 'sturm' cannot be used with this object.");
    EXPECT_EQ(parse("\"grey.png\" interpolate 2").error, "No matching } in 'height_field', interpolate found instead");
}

TEST(HeightFieldBlock, RefusesWhatIsNoField) {
    EXPECT_EQ(parse("pigment { rgb 1 }").error, "Expected 'map file spec', pigment found instead");
    EXPECT_EQ(parse("smooth \"grey.png\"").error, "Expected 'map file spec', smooth found instead");
    EXPECT_EQ(parse("gif png \"grey.png\"").error, "Expected 'string expression', png found instead");
    EXPECT_EQ(parse("\"none.png\"").error, "Cannot find image file.");
    EXPECT_EQ(parse("\"palette.gif\"").error, "'height_field of a GIF's palette' is not modelled.");
    EXPECT_EQ(parse("\"floats.exr\"").error, "'height_field of a picture of floats' is not modelled.");
    EXPECT_EQ(parse("function -2, 2 { x }").error, "The number of a height field's columns or rows is below 0.");
    EXPECT_EQ(parse("function 2000000000, 2000000000 { x }").error, "A height field has at most 1073741824 samples.");
    EXPECT_EQ(parse("function 2 { x }").error, "Expected 'numeric expression', { found instead");
    for (const char* const thin : {"\"thin.png\"", "function 1, 5 { x }", "function 0, 2 { x }"}) {
        const ParsedScene parsed = parse(thin);
        EXPECT_EQ(parsed.error, "") << thin;
        EXPECT_THAT(parsed.messages, ElementsAre(HasSubstr("A height field of less than two columns or rows is not visible."))) << thin;
        EXPECT_THAT(parsed.scene.objects, IsEmpty()) << thin;
    }
}

TEST(HeightFieldBlock, CountsWhatAFunctionCosts) {
    ParseOptions options;
    options.max_replayed_bytes = 10'000;
    EXPECT_THROW(parse_text({"test.pov", "height_field { function 100, 100 { x } }"}, options, [](std::string_view) {}), LimitError);
}

}  // namespace
}  // namespace rt::blocks_height_field_test
