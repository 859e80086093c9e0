// union, intersection, difference, merge, clipped_by: what parts have, how they belong together, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "core/source.h"
#include "tests/scene/checkers.h"
#include "tests/syntax/blocks_scene.h"

namespace rt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string error_of(const std::string& text) { return parse_block(text).error; }
std::vector<std::string> warnings_of(const std::string& text) {
    const ParsedScene p = parse_block(text);
    EXPECT_EQ(p.error, "") << text;
    std::vector<std::string> bared;
    for (const std::string& message : p.messages) bared.push_back(bare(message, "Parse Warning: "));
    return bared;
}

/// "(0 & !1 & 2)" of objects 0 to 2; clips are c0, c1 ... behind a bar.
std::string text_of(const Scene& scene, const SetPart& part) {
    const std::string sign = part.complement ? "!" : "";
    if (part.what == SetPart::What::object) return sign + std::to_string(part.index);
    if (part.what == SetPart::What::clip) return sign + "c" + std::to_string(part.index);
    const SetNode& node = scene.sets.at(part.index);
    const char* joint = node.kind == SetKind::intersection ? " & " : node.kind == SetKind::merge ? " ~ " : " + ";
    std::string text;
    for (const SetPart& inner : node.parts) text += (text.empty() ? "" : joint) + text_of(scene, inner);
    if (!node.clips.empty()) text += " |";
    for (const SetPart& clip : node.clips) text += " " + text_of(scene, clip);
    return sign + "(" + text + ")";
}

/// The sets that are no parts of others.
std::string sets_of(const std::string& text) {
    const ParsedScene p = parse_block(text);
    EXPECT_EQ(p.error, "") << text;
    std::vector<bool> inner(p.scene.sets.size());
    for (const SetNode& node : p.scene.sets)
        for (const auto* list : {&node.parts, &node.clips})
            for (const SetPart& part : *list)
                if (part.what == SetPart::What::set) inner.at(part.index) = true;
    std::string all;
    for (std::uint32_t i = 0; i < inner.size(); ++i)
        if (!inner[i]) all += (all.empty() ? "" : " ") + text_of(p.scene, {SetPart::What::set, false, i});
    return all;
}

constexpr const char* two = "sphere { 0, 1 } box { 0, 1 } ";

TEST(Sets, AUnionIsItsObjects) {
    const ParsedScene p = parse_block("union { sphere { x, 1 } union { box { 0, 1 } sphere { y, 2 } translate z } scale 2 }");
    ASSERT_EQ(p.scene.objects.size(), 3u);
    EXPECT_THAT(p.scene.sets, IsEmpty());
    EXPECT_EQ(p.scene.objects[0].transform->point(Vec3(1, 0, 0)), Vec3(2, 0, 0));
    EXPECT_EQ(p.scene.objects[2].transform->point(Vec3(0, 1, 0)), Vec3(0, 2, 2));
}

TEST(Sets, SayHowObjectsBelongTogether) {
    EXPECT_EQ(sets_of("intersection { sphere { 0, 1 } box { 0, 1 } plane { y, 0 } }"), "(0 & 1 & 2)");
    EXPECT_EQ(sets_of("difference { sphere { 0, 1 } box { 0, 1 } plane { y, 0 } }"), "(0 & !1 & !2)");
    EXPECT_EQ(sets_of("merge { sphere { 0, 1 } box { 0, 1 } }"), "(0 ~ 1)");
    EXPECT_EQ(sets_of("sphere { 9, 1 } difference { union { sphere { 0, 1 } box { 0, 1 } } merge { box { 0, 1 } sphere { 0, 1 } } }"),
              "((1 + 2) & !(3 ~ 4))");
    EXPECT_EQ(sets_of("union { difference { sphere { 0, 1 } box { 0, 1 } } sphere { 0, 1 } }"), "((0 & !1) + 2)");
    EXPECT_EQ(sets_of("union { sphere { 0, 1 } box { 0, 1 } inverse }"), "(!(0 + 1))");
    EXPECT_EQ(sets_of("intersection { sphere { 0, 1 } intersection { box { 0, 1 } box { 0, 1 } inverse } }"), "(0 & !(1 & 2))");
}

TEST(Sets, OfTheirOwnKindAreOneSet) {
    EXPECT_EQ(sets_of("difference { difference { sphere { 0, 1 } box { 0, 1 } } plane { y, 0 } }"), "(0 & !1 & !2)");
    EXPECT_EQ(sets_of("intersection { sphere { 0, 1 } intersection { box { 0, 1 } plane { y, 0 } } }"), "(0 & 1 & 2)");
    EXPECT_EQ(sets_of("difference { sphere { 0, 1 } difference { box { 0, 1 } plane { y, 0 } } }"), "(0 & !(1 & !2))");
}

TEST(Sets, ArePlacedAnyNumberOfTimes) {
    EXPECT_EQ(
        sets_of("#declare D = difference { sphere { 0, 1 } box { 0, 1 } } D object { D scale 2 } union { object { D } object { D } }"),
        "(0 & !1) (2 & !3) ((4 & !5) + (6 & !7))");
}

TEST(Sets, PartsWithoutATextureHaveThatOfTheWhole) {
    const ParsedScene p = parse_block(
        "#declare U = union { sphere { 0, 1 pigment { rgb 0.1 } } difference { box { 0, 1 } sphere { 0, 1 pigment { rgb 0.2 } } pigment { "
        "rgb "
        "0.3 } } sphere { 0, 2 } pigment { rgb 0.4 } }\nU object { U pigment { rgb 0.5 } }");
    std::vector<double> reds;
    for (const Object& object : p.scene.objects) reds.push_back(color_of(object).rgb.r);
    EXPECT_THAT(reds, ElementsAre(0.1, 0.3, 0.2, 0.4, 0.1, 0.3, 0.2, 0.5));
}

TEST(Sets, AWholesTextureMovesWithItAndAPartsWithBoth) {
    const ParsedScene p = parse_block(
        "union { sphere { 0, 1 pigment { checker rgb 0 rgb 1 } translate x } sphere { 0, 1 } pigment { checker rgb 0 rgb 1 } translate y "
        "}");
    EXPECT_EQ(moved(layer(p.scene.objects[0]).pigment, Vec3(0.0)), Vec3(1, 1, 0));
    EXPECT_EQ(moved(layer(p.scene.objects[1]).pigment, Vec3(0.0)), Vec3(0, 1, 0));
}

TEST(Sets, PartsHaveTheFlagsOfTheWhole) {
    const ParsedScene p = parse_block("merge { sphere { 0, 1 no_image } box { 0, 1 } no_shadow no_reflection double_illuminate hollow }");
    for (const Object& o : p.scene.objects) EXPECT_TRUE(o.no_shadow && o.no_reflection && o.double_illuminate && o.hollow);
    EXPECT_TRUE(p.scene.objects[0].no_image);
    EXPECT_FALSE(p.scene.objects[1].no_image);
}

TEST(Sets, PartsShareTheInteriorOfTheWhole) {
    const ParsedScene p =
        parse_block("sphere { 5, 1 } union { sphere { 0, 1 } sphere { 0, 1 interior { ior 2 } } box { 0, 1 } interior { ior 1.5 } }");
    ASSERT_EQ(p.scene.objects.size(), 4u);
    EXPECT_FALSE(p.scene.objects[1].shares_interior);
    EXPECT_FALSE(p.scene.objects[2].shares_interior);
    EXPECT_EQ((*p.scene.objects[2].interior)->ior, 2.0);
    EXPECT_EQ(p.scene.objects[3].shares_interior, 1u);
    EXPECT_EQ((*p.scene.objects[3].interior)->ior, 1.5);
}

TEST(Sets, LampsInThemAreTheScenes) {
    const ParsedScene p = parse_block(
        "union { light_source { x, rgb 1 } sphere { 0, 1 } translate y } union { light_source { 0 rgb 1 } light_source { x rgb 1 } }");
    ASSERT_EQ(p.scene.lights.size(), 3u);
    EXPECT_EQ(p.scene.lights[0].location, Vec3(1, 1, 0));
    EXPECT_EQ(p.scene.objects.size(), 1u);
}

TEST(Clips, HaveNoSurface) {
    const ParsedScene p =
        parse_block("sphere { 0, 1 clipped_by { plane { y, 0 } box { 0, 1 inverse } rotate 90*x } clipped_by { sphere { 0, 2 } } }");
    ASSERT_EQ(p.scene.objects.size(), 1u);
    ASSERT_EQ(p.scene.clips.size(), 3u);
    EXPECT_EQ(text_of(p.scene, {SetPart::What::set, false, 0}), "(0 | c0 c1 c2)");
    EXPECT_TRUE(p.scene.clips[0].transform && p.scene.clips[1].transform);
    EXPECT_FALSE(p.scene.clips[2].transform);
    EXPECT_TRUE(p.scene.clips[1].inverse);
}

TEST(Clips, MoveWithWhatTheyClipFromThenOn) {
    const ParsedScene p = parse_block("sphere { 0, 1 translate x clipped_by { plane { y, 0 } } translate z }");
    EXPECT_EQ(p.scene.objects[0].transform->point(Vec3(0.0)), Vec3(1, 0, 1));
    EXPECT_EQ(p.scene.clips[0].transform->point(Vec3(0.0)), Vec3(0, 0, 1));
}

TEST(Clips, MayBeSets) {
    EXPECT_EQ(
        sets_of("#declare C = difference { sphere { 0, 1 } box { 0, 1 } } union { sphere { 0, 1 } box { 0, 1 } clipped_by { C } inverse }"),
        "(!(0 + 1 | (c0 & !c1)))");
}

TEST(Clips, TheClippedObjectsModifiersGoOn) {
    const ParsedScene p = parse_block("sphere { 0, 1 pigment { rgb 0.5 } clipped_by { plane { y, 0 } } finish { phong 1 } no_shadow }");
    EXPECT_EQ(color_of(p.scene.objects[0]).rgb.r, 0.5);
    EXPECT_EQ(layer(p.scene.objects[0]).finish.phong, 1.0);
    EXPECT_TRUE(p.scene.objects[0].no_shadow);
}

TEST(Sets, Warnings) {
    EXPECT_THAT(warnings_of("union { sphere { 0, 1 } }"), ElementsAre("Should have at least 2 objects in csg."));
    EXPECT_THAT(warnings_of("difference { }"), ElementsAre("Should have at least 2 objects in csg."));
    EXPECT_THAT(warnings_of("intersection { sphere { 0, 1 } triangle { 0, x, y } }"),
                ElementsAre("Patch objects not allowed in intersection."));
    EXPECT_THAT(warnings_of("difference { sphere { 0, 1 } light_source { 0, rgb 1 } }"),
                ElementsAre("Patch objects not allowed in intersection."));
    EXPECT_THAT(warnings_of("merge { sphere { 0, 1 } triangle { 0, x, y } }"), IsEmpty());
    EXPECT_THAT(warnings_of("#declare U = union { sphere { 0, 1 } box { 0, 1 } } difference { U pigment { rgb 1 } }"), IsEmpty());
}

TEST(Sets, Mistakes) {
    EXPECT_EQ(error_of("union { sphere { 0, 1 } pigment { rgb 1 } box { 0, 1 } }"), "No matching } in 'union', box found instead");
    EXPECT_EQ(error_of("#declare U = sphere { 0, 1 } difference { U box { 0, 1 } }"), "No matching } in 'difference', box found instead");
    EXPECT_EQ(error_of("union { sphere { 0, 1 } Foo }"), "No matching } in 'union', undeclared identifier 'Foo' found instead");
    EXPECT_EQ(error_of(fmt::format("union {{ {} cutaway_textures }}", two)),
              "cutaway_textures can only be used with intersection and difference.");
    EXPECT_EQ(error_of(fmt::format("difference {{ {} split_union off }}", two)), "split_union found in non-union object.");
    EXPECT_EQ(error_of(fmt::format("union {{ {} split_union off }}", two)), "");
    EXPECT_EQ(error_of(fmt::format("merge {{ {} sturm }}", two)), "Keyword 'sturm' cannot be used with this object.");
    EXPECT_EQ(error_of("sphere { 0, 1 clipped_by { } }"), "Expected 'object', } found instead");
    EXPECT_EQ(error_of("sphere { 0, 1 clipped_by { sphere { 0, 1 pigment { rgb 1 } } } }"),
              "Illegal texture or patch in clip, bound or object pattern.");
    EXPECT_EQ(error_of("sphere { 0, 1 clipped_by { triangle { 0, x, y } } }"),
              "Illegal texture or patch in clip, bound or object pattern.");
    EXPECT_EQ(error_of("sphere { 0, 1 clipped_by { sphere { 0, 1 } inverse } }"), "No matching } in 'clipped_by', inverse found instead");
    EXPECT_EQ(error_of(fmt::format("difference {{ {} cutaway_textures }}", two)), "'cutaway_textures' is not modelled.");
    EXPECT_EQ(error_of("sphere { 0, 1 clipped_by { bounded_by } }"), "'clipped_by { bounded_by }' is not modelled.");
}

TEST(Sets, NestOnlySoDeep) {
    std::string text = "#declare A = sphere { 0, 1 }\n";
    for (int i = 0; i < 501; ++i) text += "#declare A = union { difference { sphere { 0, 1 } object { A } } sphere { 0, 1 } }\n";
    try {
        parse_text({"deep.pov", "#version 3.7;\n" + text}, {}, [](std::string_view) {});
        FAIL() << "no limit";
    } catch (const LimitError& error) {
        EXPECT_EQ(first_line(error.what()), "File 'deep.pov' line 503: Parse Error: Sets are nested more than 1000 deep.");
    }
}

}  // namespace
}  // namespace rt
