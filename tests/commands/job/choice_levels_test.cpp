// Which choice wins: file < finish < command line; in each, presets, materials, models, single terms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "commands/job/model_choices.h"
#include "commands/job/render_arguments.h"
#include "commands/job/scene_choices.h"
#include "shading/names.h"
#include "syntax/parser.h"
#include "tests/commands/support.h"

namespace rt::choice_levels_test {
namespace {

/// Choices as "key=value key=value".
using Text = std::string;

Scene scene_of(const Text& file) {
    const test::Workplace here;
    here.write("c.pov", "#version 3.7;\n" + (file.empty() ? "" : "//! raytrace: " + file) + "\n");
    return parse_file("c.pov", {}, [](std::string_view) {});
}

std::vector<ModelOption> options_of(const Text& text) {
    std::vector<ModelOption> options;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size()), equals = text.find('=', begin);
        options.push_back({text.substr(begin, equals - begin), text.substr(equals + 1, end - equals - 1)});
        begin = end + 1;
    }
    return options;
}

std::vector<SceneOption> finish_of(const Text& text) {
    std::vector<SceneOption> options;
    for (const ModelOption& option : options_of(text)) options.push_back({option.key, option.value, {}});
    return options;
}

ModelChoice chosen(const Text& file, const Text& finish, const Text& command_line) {
    return choice_for(scene_of(file), finish_of(finish), options_of(command_line));
}

SurfaceModel model(const Text& file, const Text& finish, const Text& command_line) {
    return fill(chosen(file, finish, command_line), Finish(), 1.5, AlphaMapping::roughness2);
}

void expect_classic(const SurfaceModel& model, const Text& what) {
    EXPECT_EQ(model.specular, SurfaceModel::Specular::microfacet) << what;
    EXPECT_EQ(model.terms.D, Distribution::beckmann) << what;
    EXPECT_EQ(model.terms.G, Masking::cook_torrance) << what;
    EXPECT_EQ(model.terms.F, Fresnel::schlick) << what;
}

TEST(ChoiceLevels, TheMicrofacetModelKeepsTheTermsChosenForIt) {
    const Text terms = "D=beckmann G=cook-torrance", general = "shading=general", by_name = "shading=cook-torrance";
    for (const Text& shading : {general, by_name}) {
        expect_classic(model("", "", "preset=classic " + shading), "one level");
        expect_classic(model(terms, "", shading), "file, command line");
        expect_classic(model(terms, shading, ""), "file, finish");
        expect_classic(model("", terms, shading), "finish, command line");
        expect_classic(model(terms, "shading=phong", shading), "through another model");
    }
    EXPECT_TRUE(model("raw=on half=nv", "", general).terms.without_cosine) << "the variants too";
}

TEST(ChoiceLevels, TermsThatAModelBroughtGoWithIt) {
    for (const char* brought : {"ct-effects", "ct-effects-linear", "lecture"}) {
        const Text stated = fmt::format("shading={}", brought);
        for (const char* between : {"", "shading=phong"}) {
            const MicrofacetTerms terms = model(stated, between, "shading=cook-torrance").terms;
            EXPECT_EQ(terms.D, Distribution::ggx) << brought;
            EXPECT_EQ(terms.G, Masking::ggx) << brought;
            EXPECT_EQ(terms.F, Fresnel::schlick) << brought;
            EXPECT_FALSE(terms.fresnel_at_view) << brought;
        }
        EXPECT_EQ(model("D=ggx", "", stated).terms.D, Distribution::beckmann) << brought << " sets its terms";
        EXPECT_EQ(model("", "", stated + " D=ggx").terms.D, Distribution::ggx) << brought;
    }
}

TEST(ChoiceLevels, APresetLeavesNothingOfAnother) {
    for (const auto& before : preset_names) {
        for (const auto& after : preset_names) {
            const Text first = fmt::format("preset={}", before.name), second = fmt::format("preset={}", after.name);
            const ModelChoice alone = chosen("", "", second);
            for (const ModelChoice& both : {chosen(first, "", second), chosen(first, second, ""), chosen("", "", first + " " + second)}) {
                const Text what = first + " " + second;
                const SurfaceModel &m = both.model, &expected = alone.model;
                EXPECT_EQ(m.specular, expected.specular) << what;
                EXPECT_EQ(m.shares, expected.shares) << what;
                EXPECT_EQ(m.lecture, expected.lecture) << what;
                EXPECT_EQ(m.diffuse, expected.diffuse) << what;
                EXPECT_EQ(m.terms.D, expected.terms.D) << what;
                EXPECT_EQ(m.terms.G, expected.terms.G) << what;
                EXPECT_EQ(m.terms.F, expected.terms.F) << what;
                EXPECT_EQ(m.terms.fresnel_at_view, expected.terms.fresnel_at_view) << what;
                EXPECT_EQ(m.env, expected.env) << what;
                EXPECT_EQ(both.dw, alone.dw) << what;
                EXPECT_EQ(both.lamps.law.kind, alone.lamps.law.kind) << what;
            }
        }
    }
}

TEST(ChoiceLevels, AMaterialLeavesNothingOfAnother) {
    for (const auto& before : material_names) {
        for (const auto& after : material_names) {
            const Text first = fmt::format("material={}", before.name), second = fmt::format("material={}", after.name);
            const ModelChoice alone = chosen("", "", second);
            for (const ModelChoice& both : {chosen(first, "", second), chosen(first, second, ""), chosen("", "", first + " " + second)}) {
                const Text what = first + " " + second;
                EXPECT_EQ(both.eta, alone.eta) << what;
                EXPECT_EQ(both.k, alone.k) << what;
                EXPECT_EQ(both.f0, alone.f0) << what;
                EXPECT_EQ(both.alpha, alone.alpha) << what;
                EXPECT_EQ(both.s, alone.s) << what;
                EXPECT_EQ(both.model.env, alone.model.env) << what;
            }
        }
    }
    EXPECT_EQ(chosen("", "shading=phong exponent=9", "material=mirror").exponent, 9.0) << "what no material sets stays";
}

TEST(ChoiceLevels, ReflectanceAndIndicesReplaceEachOther) {
    const auto f0 = [](const Text& file, const Text& finish, const Text& command_line) {
        return model(file, finish, command_line).interface[0].f0;
    };
    EXPECT_EQ(f0("eta=1.2", "", "f0=0.5"), 0.5);
    EXPECT_EQ(f0("k=3", "f0=0.5", ""), 0.5);
    EXPECT_EQ(f0("", "material=shiny-gold", "f0=0.5"), 0.5);
    EXPECT_EQ(f0("", "", "f0=0.5 material=shiny-gold"), 0.5) << "a single term after the material, in any order";
    EXPECT_EQ(f0("f0=0.5", "", "eta=3"), 0.25);
    EXPECT_EQ(f0("", "f0=0.5", "k=0"), model("", "", "").interface[0].f0) << "the object's own index";
    EXPECT_EQ(f0("", "material=mirror", "eta=3"), 0.25);
    EXPECT_EQ(f0("eta=3", "f0=0.5", "eta=3"), 0.25);
    EXPECT_NEAR(f0("eta=0.143", "k=3.983", ""), 0.967, 5e-4) << "the two indices stay together";
}

TEST(ChoiceLevels, ThePowerOfBlinnIsForBlinn) {
    const auto D = [](const Text& file, const Text& finish, const Text& command_line) { return model(file, finish, command_line).terms.D; };
    for (const char* both : {"D=blinn blinn-power=inverse-roughness", "blinn-power=inverse-roughness D=blinn"}) {
        EXPECT_EQ(D(both, "", ""), Distribution::blinn_inverse_roughness);
        EXPECT_EQ(D("", both, ""), Distribution::blinn_inverse_roughness);
        EXPECT_EQ(D("", "", both), Distribution::blinn_inverse_roughness);
    }
    EXPECT_EQ(D("blinn-power=inverse-roughness", "D=blinn", ""), Distribution::blinn_inverse_roughness);
    EXPECT_EQ(D("blinn-power=inverse-roughness", "D=blinn", "blinn-power=normalised"), Distribution::blinn);
    EXPECT_EQ(D("blinn-power=inverse-roughness preset=course-blinn", "", ""), Distribution::blinn_inverse_roughness);
    for (const char* power : {"blinn-power=normalised", "blinn-power=inverse-roughness"}) {
        EXPECT_EQ(D("", "", fmt::format("D=ggx {}", power)), Distribution::ggx);
        EXPECT_EQ(D("", "", fmt::format("{} D=ggx", power)), Distribution::ggx);
        EXPECT_EQ(D("D=beckmann", power, ""), Distribution::beckmann);
    }
}

TEST(ChoiceLevels, CoefficientsAreThePolynomials) {
    const auto kind = [](const Text& file, const Text& command_line) { return chosen(file, "", command_line).lamps.law.kind; };
    EXPECT_EQ(kind("", "att-coefficients=1,0,1"), Attenuation::polynomial);
    EXPECT_EQ(kind("", "att-coefficients=1,0,1 att=polynomial"), Attenuation::polynomial);
    EXPECT_EQ(kind("att-coefficients=1,0,1", "att=inverse-square"), Attenuation::inverse_square);
    EXPECT_EQ(kind("att=inverse-square", "att-coefficients=1,0,1"), Attenuation::polynomial);
    EXPECT_EQ(kind("", "preset=phong-lights att-coefficients=1,0,1"), Attenuation::polynomial) << "a single term after the preset";
}

const char* const both_f0 = "f0: '{}' is stated as well, and each says what the surface reflects; expected one of them";
const char* const both_att = "att-coefficients: 'att={}' is stated as well, and they are the numbers of att=polynomial";

TEST(ContradictoryChoices, AsOptions) {
    const auto error = [](std::vector<std::string> words) -> std::string {
        std::string help;
        words.insert(words.begin(), "a.pov");
        try {
            parse_render_arguments(words, help);
        } catch (const OptionError& e) {
            return e.what();
        }
        return "accepted";
    };
    EXPECT_EQ(error({"--f0=0.5", "--eta=1.5"}), fmt::format(fmt::runtime(both_f0), "eta"));
    EXPECT_EQ(error({"--k=0.5", "--f0=0.5"}), fmt::format(fmt::runtime(both_f0), "k"));
    EXPECT_EQ(error({"--f0=0.5", "--material=silver"}), "accepted");
    EXPECT_EQ(error({"--att=inverse-square", "--att-coefficients=1,0,1"}), fmt::format(fmt::runtime(both_att), "inverse-square"));
    EXPECT_EQ(error({"--att-coefficients=1,0,1", "--att=none"}), fmt::format(fmt::runtime(both_att), "none"));
    EXPECT_EQ(error({"--att-coefficients=1,0,1", "--att=polynomial"}), "accepted");
}

/// The message of the scene, without the line and the caret.
std::string error_of(const std::string& text) {
    const test::Workplace here;
    here.write("c.pov", text);
    const Scene scene = parse_file("c.pov", {}, [](std::string_view) {});
    try {
        choices_of(scene);
    } catch (const SceneError& error) {
        return std::string(error.what()).substr(0, std::string(error.what()).find('\n'));
    }
    return "accepted";
}

TEST(ContradictoryChoices, InAFile) {
    const std::string place = "File 'c.pov' line 2: Parse Error: ";
    EXPECT_EQ(error_of("//! raytrace: eta=1.5\n//! raytrace: f0=0.5\n"), place + fmt::format(fmt::runtime(both_f0), "eta"));
    EXPECT_EQ(error_of("//! raytrace: k=1.5\n//! raytrace: f0=0.5\n"), place + fmt::format(fmt::runtime(both_f0), "k"));
    EXPECT_EQ(error_of("//! raytrace: att=1+d+d2\n//! raytrace: att-coefficients=1,0,1\n"),
              place + fmt::format(fmt::runtime(both_att), "1+d+d2"));
    EXPECT_EQ(error_of("//! raytrace: att=1+d+d2\n//! raytrace: att=polynomial att-coefficients=1,0,1\n"), "accepted")
        << "the last statement of a key counts";
}

TEST(ContradictoryChoices, InAFinish) {
    EXPECT_EQ(error_of("sphere { 0, 1 finish {\n//! raytrace: f0=0.5 eta=1.5\n} }\n"),
              "File 'c.pov' line 2: Parse Error: " + fmt::format(fmt::runtime(both_f0), "eta"));
    EXPECT_EQ(error_of("//! raytrace: eta=1.5\nsphere { 0, 1 finish {\n//! raytrace: f0=0.5\n} }\n"), "accepted") << "two levels";
}

/// A finish may replace what a declared one says; each block is a level of its own.
TEST(ChoiceLevels, AFinishIsAboveTheOneItComesFrom) {
    const test::Workplace here;
    here.write("c.pov",
               "#version 3.7;\n"
               "#declare Gold = finish { specular 0.9\n//! raytrace: eta=0.2 k=3 D=beckmann alpha=0.2\n}\n"
               "#declare Dull = finish { Gold\n//! raytrace: preset=modern alpha=0.4\n}\n"
               "sphere { 0, 1 finish { Gold\n//! raytrace: f0=0.04\n} }\n"
               "sphere { 3, 1 finish { Dull\n//! raytrace: alpha=0.5\n} }\n");
    const Scene scene = parse_file("c.pov", {}, [](std::string_view) {});
    const auto of = [&](std::size_t i) {
        const auto& texture = std::get<PlainTexture>((*scene.objects[i].texture)->front().content);
        return fill(choice_for(scene, texture.finish.options, {}), texture.finish, 1.5, AlphaMapping::roughness2);
    };
    EXPECT_EQ(of(0).interface[0].f0, 0.04);
    EXPECT_EQ(of(0).interface[0].k, 0.0);
    EXPECT_EQ(of(0).terms.D, Distribution::beckmann);
    EXPECT_EQ(of(0).alpha, 0.2);
    EXPECT_EQ(of(1).terms.D, Distribution::ggx) << "the preset stands above the term that was inherited";
    EXPECT_EQ(of(1).interface[0].k, 3.0);
    EXPECT_EQ(of(1).alpha, 0.5);
    EXPECT_EQ(choices_of(scene).shading, std::nullopt);
}

TEST(ChoiceLevels, APresetOfTheCommandLineIsAShading) {
    std::string help;
    const auto shading = [&](const std::vector<std::string>& words) { return parse_render_arguments(words, help)->shading; };
    EXPECT_EQ(shading({"a.pov", "--preset", "modern"}), ShadingModel::general);
    EXPECT_EQ(shading({"a.pov", "--preset", "modern", "--shading", "povray"}), ShadingModel::povray);
    EXPECT_EQ(shading({"a.pov", "--shading", "povray", "--preset", "modern"}), ShadingModel::povray);
    EXPECT_EQ(shading({"a.pov", "--D", "ggx"}), std::nullopt);
}

}  // namespace
}  // namespace rt::choice_levels_test
