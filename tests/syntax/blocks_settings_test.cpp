#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/syntax/blocks_scene.h"

namespace rt::blocks_settings_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ParsedScene with_settings(const std::string& body) { return parse_block("global_settings { " + body + " }"); }
ParsedScene raw(const std::string& text, ParseOptions options = {}) { return parse_block(text, std::move(options), ""); }
Gamma gamma_of(const std::string& text, ParseOptions options = {}) { return raw(text, std::move(options)).scene.settings.gamma; }

constexpr Gamma legacy{Gamma::Kind::legacy, 1.0};
constexpr Gamma power(double p) { return {Gamma::Kind::power, p}; }

TEST(GlobalSettings, Defaults) {
    const GlobalSettings s = with_settings("").scene.settings;
    EXPECT_EQ(s.ambient_light, Rgb(1.0));
    EXPECT_EQ(s.max_trace_level, 5);
    EXPECT_EQ(s.adc_bailout, 1.0 / 255.0);
}

TEST(GlobalSettings, WhatIsModelled) {
    const GlobalSettings s = with_settings("ambient_light rgb <2,1,0.5> max_trace_level 20 adc_bailout 0.5").scene.settings;
    EXPECT_EQ(s.ambient_light, Rgb(2, 1, 0.5));
    EXPECT_EQ(s.max_trace_level, 20);
    EXPECT_EQ(s.adc_bailout, 0.5);
    EXPECT_EQ(with_settings("ambient_light").scene.settings.ambient_light, Rgb(0.0));
}

TEST(GlobalSettings, TraceLevelIsKeptInRange) {
    EXPECT_EQ(with_settings("max_trace_level 2.7").scene.settings.max_trace_level, 2);
    EXPECT_EQ(with_settings("max_trace_level -3").scene.settings.max_trace_level, 1);
    const ParsedScene p = with_settings("max_trace_level 300");
    EXPECT_EQ(p.scene.settings.max_trace_level, 256);
    EXPECT_THAT(p.messages,
                ElementsAre(HasSubstr("Maximum max_trace_level is 256 but 300 was specified. Going to use max_trace_level 256.")));
    EXPECT_THAT(with_settings("max_trace_level 256").messages, IsEmpty());
    EXPECT_EQ(with_settings("max_trace_level 1e300").scene.settings.max_trace_level, 256);
}

TEST(GlobalSettings, WhatHasNoEffectIsReadWithItsRemarks) {
    EXPECT_THAT(with_settings("number_of_waves 3 noise_generator 2 irid_wavelength rgb 1 charset utf8 mm_per_unit 3").messages, IsEmpty());
    EXPECT_THAT(with_settings("number_of_waves 0").messages, ElementsAre(HasSubstr("number_of_waves must be greater than 0.")));
    EXPECT_THAT(with_settings("max_intersections 64").messages, ElementsAre(HasSubstr("'max_intersections' is no longer needed")));
    EXPECT_THAT(with_settings("hf_gray_16 on").messages,
                ElementsAre(HasSubstr("Possible Parse Error: In POV-Ray 3.7 and later 'hf_gray_16'")));
    EXPECT_EQ(with_settings("noise_generator 7").error, "Value for noise_generator in global_settings must be 1, 2, or 3.");
    EXPECT_EQ(with_settings("charset foo").error, "Expected 'charset type', undeclared identifier 'foo' found instead");
    EXPECT_EQ(with_settings("foo").error, "No matching } in 'global_settings', undeclared identifier 'foo' found instead");
    EXPECT_EQ(with_settings("radiosity { count 100 }").error, "'radiosity' is not modelled.");
}

TEST(AssumedGamma, StatedOnes) {
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma 2.2 }"), power(2.2));
    EXPECT_EQ(gamma_of("#version 3.6; global_settings { assumed_gamma 1 }"), power(1.0));
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma srgb }").kind, Gamma::Kind::srgb);
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma 1.009 }"), power(1.0));
    EXPECT_EQ(gamma_of("global_settings { assumed_gamma 1.02 }"), power(1.02));
}

TEST(AssumedGamma, TheFirstOneCounts) {
    const ParsedScene p = with_settings("assumed_gamma 2.2");
    EXPECT_EQ(p.scene.settings.gamma, power(1.0));
    EXPECT_THAT(p.messages, ElementsAre(HasSubstr("New instance of assumed_gamma ignored")));
}

TEST(AssumedGamma, MustBePositive) {
    EXPECT_EQ(raw("global_settings { assumed_gamma 0 }").error, "gamma value must be positive.");
    EXPECT_EQ(raw("global_settings { assumed_gamma off }").error, "gamma value must be positive.");
    EXPECT_THAT(raw("#version 3.7; global_settings { assumed_gamma 0.5 }").messages,
                ElementsAre(HasSubstr("Possible Parse Error: Suspicious value 0.5 specified for gamma. Did you mean 2?")));
}

TEST(AssumedGamma, IsDecidedByTheVersionWhereItIsNotStated) {
    EXPECT_EQ(gamma_of("sphere { 0, 1 }"), legacy);
    EXPECT_EQ(gamma_of("#version 3.6; sphere { 0, 1 }"), legacy);
    EXPECT_EQ(gamma_of("#version 3.7; sphere { 0, 1 }"), power(1.0));
    EXPECT_EQ(gamma_of("#version 3.7; #version 3.6; sphere { 0, 1 }"), legacy);
    EXPECT_EQ(gamma_of("sphere { 0, 1 } #version 3.7;"), power(1.0));
    EXPECT_EQ(gamma_of("#declare V = version; #version 3.5; #version V;"), power(1.0));
    ParseOptions on_the_command_line;
    on_the_command_line.version = 3.7;
    EXPECT_EQ(gamma_of("sphere { 0, 1 }", on_the_command_line), power(1.0));
}

TEST(AssumedGamma, WarnsWhereItIsNotStated) {
    EXPECT_THAT(raw("#version 3.7; sphere { 0, 1 }").messages, ElementsAre(HasSubstr("Possible Parse Error: assumed_gamma not specified")));
    EXPECT_THAT(raw("#version 3.6; sphere { 0, 1 }").messages, ElementsAre(HasSubstr("so gamma_correction is turned off")));
    EXPECT_THAT(raw("sphere { 0, 1 }").messages,
                ElementsAre(HasSubstr("so gamma_correction is turned off"), HasSubstr("did not contain a #version directive")));
}

TEST(Statements, OnlyObjectsAndDirectivesStandAtTheTop) {
    for (const auto& [text, found] : std::initializer_list<std::pair<const char*, const char*>>{{";", ";"},
                                                                                                {"}", "}"},
                                                                                                {"foo", "undeclared identifier 'foo'"},
                                                                                                {"pigment { rgb 1 }", "pigment"},
                                                                                                {"3", "float function 'float constant'"},
                                                                                                {"rgb 1", "color keyword 'rgb'"},
                                                                                                {"\"a\"", "string literal"}})
        EXPECT_EQ(parse_block(text).error, std::string("Expected 'object or directive', ") + found + " found instead");
    EXPECT_EQ(parse_block("sphere { 0, 1 };").error, "Expected 'object or directive', ; found instead");
}

TEST(Statements, AnEmptySceneIsOneWithAWarning) {
    std::vector<std::string> messages;
    const MessageSink sink = [&](std::string_view m) { messages.push_back(first_line(m)); };
    EXPECT_TRUE(parse_text({"t.pov", "#version 3.7; global_settings { assumed_gamma 1 } camera { }"}, {}, sink).objects.empty());
    EXPECT_THAT(messages, ElementsAre(HasSubstr("No objects in scene.")));
    messages.clear();
    parse_text({"t.pov", "#version 3.7; global_settings { assumed_gamma 1 } light_source { 0 rgb 1 }"}, {}, sink);
    EXPECT_THAT(messages, IsEmpty());
}

}  // namespace
}  // namespace rt::blocks_settings_test
