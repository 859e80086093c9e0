// Every value that a choice refuses, in all three places where it can stand: an option, a comment of the file, a comment in a finish.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "commands/job/edge_choices.h"
#include "commands/job/model_choices.h"
#include "commands/job/render_arguments.h"
#include "commands/job/scene_choices.h"
#include "syntax/parser.h"
#include "tests/commands/support.h"
#include "world/compile.h"

namespace rt::choice_values_test {
namespace {

struct Refused {
    const char *key, *value, *message;
};

const Refused refused[] = {
    {"eta", "0", "eta: expected an index of refraction above 0, not '0'"},
    {"eta", "-1.5", "eta: expected an index of refraction above 0, not '-1.5'"},
    {"eta", "1.5,0,1.5", "eta: expected an index of refraction above 0, not '1.5,0,1.5'"},
    {"eta", "nan", "eta: 'nan' is no number"},
    {"eta", "inf", "eta: 'inf' is no number"},
    {"eta", "1e999", "eta: '1e999' is no number"},
    {"eta", "1.5,1.5", "eta: expected one number or three, not '1.5,1.5'"},
    {"k", "-0.1", "k: -0.1 is less than 0"},
    {"k", "1,-2,3", "k: -2 is less than 0"},
    {"k", "nan", "k: 'nan' is no number"},
    {"f0", "-0.1", "f0: -0.1 is outside 0 to 1"},
    {"f0", "1.1", "f0: 1.1 is outside 0 to 1"},
    {"f0", "0.1,0.2,nan", "f0: 'nan' is no number"},
    {"s", "-0.1", "s: -0.1 is outside 0 to 1"},
    {"s", "1.1", "s: 1.1 is outside 0 to 1"},
    {"s", "nan", "s: 'nan' is no number"},
    {"alpha", "-0.1", "alpha: -0.1 is outside 0 to 1000000"},
    {"alpha", "1e7", "alpha: 1e7 is outside 0 to 1000000"},
    {"alpha", "nan", "alpha: 'nan' is unknown; expected roughness2, povray, direct or a number"},
    {"alpha", "0.1x", "alpha: '0.1x' is no number"},
    {"alpha", "roughness", "alpha: 'roughness' is unknown; expected roughness2, povray, direct or a number"},
    {"alpha-floor", "-1e-8", "alpha-floor: -1e-8 is outside 0 to 1000000"},
    {"alpha-floor", "nan", "alpha-floor: 'nan' is no number"},
    {"env", "fresnell", "env: 'fresnell' is unknown; expected one of finish, mirror, fresnel, albedo, ct-effects"},
    {"env-clamp", "-1", "env-clamp: -1 is less than 0"},
    {"env-clamp", "on", "env-clamp: 'on' is no number"},
    {"exponent", "-1", "exponent: -1 is less than 0"},
    {"sigma", "-0.5", "sigma: -0.5 is less than 0"},
    {"dw", "-1e-4", "dw: -1e-4 is less than 0"},
    {"D", "GGX", "D: 'GGX' is unknown; expected one of ggx, beckmann, blinn, gaussian"},
    {"G", "smith", "G: 'smith' is unknown; expected one of ggx, ggx-hc, cook-torrance, beckmann, beckmann-hc, beckmann-rational, none"},
    {"F", "fresnel", "F: 'fresnel' is unknown; expected one of schlick, schlick-linear, schlick-f82, dielectric, conductor, constant, one"},
    {"diffuse", "phong", "diffuse: 'phong' is unknown; expected one of lambert, oren-nayar, gooch, none"},
    {"shading", "blinn",
     "shading: 'blinn' is unknown; expected one of povray, general, cook-torrance, phong, blinn-phong, ct-effects, ct-effects-linear, "
     "lecture, none"},
    {"preset", "best",
     "preset: 'best' is unknown; expected one of modern, classic, course-blinn, reference, effects, lecture, gooch-ct, phong-lights"},
    {"material", "gold", "material: 'gold' is unknown; expected one of shiny-gold, dull-gold, dull-blue, silver, mirror"},
    {"fresnel-arg", "hv", "fresnel-arg: 'hv' is unknown; expected vh or nv"},
    {"half", "vl", "half: 'vl' is unknown; expected lv or nv"},
    {"norm", "ct", "norm: 'ct' is unknown; expected one of normalised, ct4m2, ct1982"},
    {"blinn-power", "roughness", "blinn-power: 'roughness' is unknown; expected normalised or inverse-roughness"},
    {"units", "si", "units: 'si' is unknown; expected printed or physical"},
    {"denominator", "safe", "denominator: 'safe' is unknown; expected exact or clamped"},
    {"raw", "yes", "raw: 'yes' is unknown; expected off or on"},
    {"ambient", "twice", "ambient: 'twice' is unknown; expected once or per-light"},
    {"attenuate-ambient", "1", "attenuate-ambient: '1' is unknown; expected off or on"},
    {"clamp", "never", "clamp: 'never' is unknown; expected before or after"},
    {"phong-gate", "shut", "phong-gate: 'shut' is unknown; expected on or off"},
    {"gooch", "cool", "gooch: 'cool' is unknown; expected warm or as-printed"},
    {"att", "square", "att: 'square' is unknown; expected one of none, 1+d+d2, polynomial, inverse-square"},
    {"att-coefficients", "0,0,0", "att-coefficients: not all of them can be 0"},
    {"att-coefficients", "1,-1,0", "att-coefficients: -1 is less than 0"},
    {"range", "-1", "range: -1 is less than 0"},
    {"spot", "cone", "spot: 'cone' is unknown; expected povray or exponent"},
    {"edges", "on", "edges: 'on' is no kind of edges; expected one of off, silhouette, crease, all"},
    {"edge-width", "0", "edge-width: 0 is outside 0.001 to 1000"},
    {"edge-color", "1,0", "edge-color: expected one number or three, not '1,0'"},
    {"edge-color", "-1", "edge-color: -1 is outside 0 to 1e+30"},
    {"edge-angle", "181", "edge-angle: 181 is outside 0 to 180"},
};

std::string error_of_option(const Refused& row) {
    std::string help;
    try {
        parse_render_arguments({"a.pov", fmt::format("--{}={}", row.key, row.value)}, help);
    } catch (const OptionError& error) {
        return error.what();
    }
    return "accepted";
}

std::string error_of_scene(const std::string& text) {
    const test::Workplace here;
    here.write("c.pov", text);
    const Scene scene = parse_file("c.pov", {}, [](std::string_view) {});
    try {
        choices_of(scene);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "accepted";
}

/// "File ... line N: Parse Error: MESSAGE", the line, the caret under `stated`.
std::string placed(int number, const std::string& line, const std::string& stated, const std::string& message) {
    return fmt::format("File 'c.pov' line {}: Parse Error: {}\n{:>4} | {}\n     | {}{}", number, message, number, line,
                       std::string(line.find(stated), ' '), std::string(stated.size(), '^'));
}

TEST(RefusedChoices, AsOptions) {
    for (const Refused& row : refused) EXPECT_EQ(error_of_option(row), row.message) << row.key;
}

TEST(RefusedChoices, InACommentOfTheFile) {
    for (const Refused& row : refused) {
        const std::string stated = fmt::format("{}={}", row.key, row.value), line = "  //! raytrace: precision=exact " + stated + " F=one";
        EXPECT_EQ(error_of_scene("#version 3.7;\n" + line + "\n"), placed(2, line, stated, row.message));
    }
}

TEST(RefusedChoices, InACommentInAFinish) {
    for (const Refused& row : refused) {
        const std::string stated = fmt::format("{}={}", row.key, row.value), line = "finish { //! raytrace: " + stated;
        std::string message = row.message;
        if (is_lamp_key(row.key) || is_edge_key(row.key))
            message = fmt::format("'{}' is for the whole picture, not for one finish", row.key);
        EXPECT_EQ(error_of_scene("#version 3.7;\nsphere { 0, 1\n" + line + "\n} }\n"), placed(3, line, stated, message));
    }
}

TEST(RefusedChoices, InAFinishThatNothingUses) {
    const std::string message = "D: 'nonsense' is unknown; expected one of ggx, beckmann, blinn, gaussian";
    const std::pair<std::string, std::string> uses[] = {{"#declare F = finish {", "}"},
                                                        {"#declare T = texture { pigment { rgb 1 } finish {", "} }"},
                                                        {"#default { finish {", "} }"},
                                                        {"#declare S = sphere { 0, 1 texture { finish {", "} } }"}};
    for (const auto& [before, after] : uses) {
        const std::string line = before + " //! raytrace: D=nonsense";
        EXPECT_EQ(error_of_scene("#version 3.7;\n" + line + "\n" + after + "\n"), placed(2, line, "D=nonsense", message)) << before;
    }
}

TEST(RefusedChoices, EveryKeyIsAmongThem) {
    const auto listed = [](std::string_view key) {
        return std::any_of(std::begin(refused), std::end(refused), [&](const Refused& row) { return row.key == key; });
    };
    for (const ModelKey& key : model_keys()) EXPECT_TRUE(listed(key.key)) << key.key;
    for (const EdgeKey& key : edge_keys) EXPECT_TRUE(listed(key.key)) << key.key;
}

TEST(RefusedChoices, LimitsThemselvesAreAccepted) {
    for (const auto& [key, value] : {std::pair{"s", "0"},
                                     {"s", "1"},
                                     {"f0", "0,0.5,1"},
                                     {"k", "0"},
                                     {"eta", "1e-300"},
                                     {"eta", "1e300"},
                                     {"alpha", "0"},
                                     {"alpha", "1e6"},
                                     {"alpha-floor", "0"},
                                     {"env-clamp", "0"},
                                     {"edge-angle", "180"}})
        EXPECT_EQ(error_of_option({key, value, ""}), "accepted") << key << " " << value;
}

/// Warnings of compiling the text under the general form.
std::vector<std::string> warnings_of(const std::string& text, const std::vector<ModelOption>& command_line) {
    const test::Workplace here;
    here.write("c.pov", text);
    const Scene scene = parse_file("c.pov", {}, [](std::string_view) {});
    CompileOptions options;
    options.choose = [&](const Finish& finish) { return choice_for(scene, finish.options, command_line); };
    std::vector<std::string> warnings;
    compile(scene, options, [&](std::string_view warning) { warnings.emplace_back(warning); });
    return warnings;
}

const std::string wide_scene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    "sphere { 0, 1 pigment { rgb 1 } finish { specular 0.5 roughness 1.2 } }\n"
    "sphere { 3, 1 pigment { rgb 1 } finish { specular 0.5 roughness 1.3 } }\n";

TEST(WideLobes, WarnOnce) {
    const std::string line = "sphere { 0, 1 pigment { rgb 1 } finish { specular 0.5 roughness 1.2 } }";
    const auto expect_one = [&](const std::vector<std::string>& got, double alpha) {
        ASSERT_EQ(got.size(), 1u);
        EXPECT_EQ(got[0].find(fmt::format("File 'c.pov' line 3: Warning: The microfacet alpha is {:.3g}, wider than 1, here and maybe in "
                                          "further finishes.\n   3 | {}\n     | ^",
                                          alpha, line)),
                  0u)
            << got[0];
    };
    expect_one(warnings_of(wide_scene, {}), 1.44);
    expect_one(warnings_of(wide_scene, {{"alpha", "2"}}), 2.0);
    expect_one(warnings_of(wide_scene, {{"alpha", "0"}, {"alpha-floor", "3"}}), 3.0);
    EXPECT_TRUE(warnings_of(wide_scene, {{"alpha", "1"}}).empty());
    EXPECT_TRUE(warnings_of(wide_scene, {{"alpha", "2"}, {"s", "0"}}).empty()) << "no lobe, no warning";
}

}  // namespace
}  // namespace rt::choice_values_test
