// Names of the catalogue become models.
#include "commands/job/model_choices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "commands/job/edge_choices.h"
#include "core/source.h"
#include "shading/names.h"
#include "syntax/choices.h"

namespace rt::model_choices_test {
namespace {

ModelChoice chosen(const std::vector<ModelOption>& options) { return choice_for(Scene(), {}, options); }

std::string refusal(const std::string& key, const std::string& value) {
    try {
        chosen({{key, value}});
    } catch (const OptionError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ModelChoices, TheSceneKnowsEveryKeyOfTheCatalogue) {
    for (const ModelKey& key : model_keys())
        EXPECT_NE(std::find(choice_keys.begin(), choice_keys.end(), key.key), choice_keys.end()) << key.key;
    for (const std::string_view key : choice_keys)
        EXPECT_TRUE(is_model_key(key) || is_edge_key(key) || key == "distances" || key == "precision") << key;
}

TEST(ModelChoices, NothingChosenIsTheGeneralForm) {
    const ModelChoice choice = chosen({});
    EXPECT_EQ(choice.model.specular, SurfaceModel::Specular::microfacet);
    EXPECT_TRUE(choice.model.shares);
    EXPECT_EQ(choice.model.terms.D, Distribution::ggx);
    EXPECT_EQ(choice.model.terms.G, Masking::ggx);
    EXPECT_EQ(choice.model.terms.F, Fresnel::schlick);
    EXPECT_FALSE(choice.alpha);
}

TEST(ModelChoices, EveryNameIsAccepted) {
    const auto all = [](const std::string& key, const auto& table) {
        for (const auto& entry : table) EXPECT_EQ(refusal(key, std::string(entry.name)), "accepted") << key << "=" << entry.name;
    };
    all("shading", model_names);
    all("diffuse", diffuse_names);
    all("D", distribution_names);
    all("G", masking_names);
    all("F", fresnel_names);
    all("env", surroundings_names);
    all("preset", preset_names);
    all("material", material_names);
}

TEST(ModelChoices, SingleTermsWinOverPresetsInAnyOrder) {
    for (const bool preset_last : {false, true}) {
        std::vector<ModelOption> options{{"preset", "classic"}, {"G", "ggx-hc"}};
        if (preset_last) std::swap(options[0], options[1]);
        const MicrofacetTerms terms = chosen(options).model.terms;
        EXPECT_EQ(terms.D, Distribution::beckmann);
        EXPECT_EQ(terms.G, Masking::ggx_hc);
    }
}

TEST(ModelChoices, MaterialsAreConstants) {
    const ModelChoice gold = chosen({{"material", "shiny-gold"}});
    EXPECT_EQ(gold.eta, Rgb(0.143, 0.375, 1.442));
    EXPECT_EQ(gold.k, Rgb(3.983, 2.386, 1.603));
    EXPECT_EQ(gold.alpha, 0.04);
    EXPECT_EQ(gold.s, 0.9);
    const SurfaceModel filled = fill(gold, Finish(), 1.5, AlphaMapping::roughness2);
    EXPECT_NEAR(filled.interface[0].f0, 0.967, 5e-4);
    EXPECT_NEAR(filled.interface[1].f0, 0.802, 5e-4);
    EXPECT_FALSE(filled.colorless);
}

TEST(ModelChoices, MaterialsAndPresetsSayWhatTheyMirror) {
    const auto env = [](const std::vector<ModelOption>& options) { return chosen(options).model.env; };
    EXPECT_EQ(env({}), Surroundings::finish);
    EXPECT_EQ(env({{"material", "shiny-gold"}}), Surroundings::albedo);
    EXPECT_EQ(env({{"material", "silver"}}), Surroundings::albedo);
    EXPECT_EQ(env({{"material", "mirror"}}), Surroundings::fresnel);
    EXPECT_EQ(env({{"material", "dull-gold"}}), Surroundings::finish) << "a sharp picture on a dull surface would be wrong";
    EXPECT_EQ(env({{"preset", "effects"}}), Surroundings::ct_effects);
    EXPECT_EQ(env({{"env", "finish"}, {"preset", "effects"}}), Surroundings::finish);
    EXPECT_EQ(fill(chosen({{"preset", "effects"}}), Finish(), 1.5, AlphaMapping::roughness2).env_dw, 1e-4);
    EXPECT_EQ(chosen({{"env-clamp", "1"}}).model.env_limit, 1.0);
}

TEST(ModelChoices, NoAlphaIsBelowItsFloor) {
    Finish finish;
    const auto alpha = [&](const std::vector<ModelOption>& options) {
        return fill(chosen(options), finish, 1.5, AlphaMapping::roughness2).alpha;
    };
    finish.roughness = 1e-6;
    EXPECT_EQ(alpha({}), 1e-6 * 1e-6);
    EXPECT_EQ(alpha({{"alpha-floor", "1e-8"}}), 1e-8);
    EXPECT_EQ(alpha({{"alpha-floor", "0.2"}, {"alpha", "0"}}), 0.2);
    EXPECT_EQ(alpha({{"alpha-floor", "0.2"}, {"alpha", "0.3"}}), 0.3);
}

TEST(ModelChoices, ClampIsForHighlightsAndLamps) {
    const ModelChoice after = chosen({{"clamp", "after"}, {"spot", "exponent"}});
    EXPECT_TRUE(after.model.clamp_after && after.lamps.clamp_after && after.lamps.exponent_spots);
    EXPECT_FALSE(chosen({{"clamp", "before"}}).lamps.clamp_after);
}

TEST(ModelChoices, FactorsMultiply) {
    const auto factor = [](const std::vector<ModelOption>& options) {
        return fill(chosen(options), Finish(), 1.5, AlphaMapping::roughness2).terms.factor;
    };
    EXPECT_EQ(factor({}), 1.0);
    EXPECT_EQ(factor({{"norm", "ct4m2"}}), 1.0);
    EXPECT_EQ(factor({{"norm", "ct1982"}}), 4.0);
    EXPECT_EQ(factor({{"units", "physical"}, {"norm", "ct1982"}}), 4.0 * pi);
    EXPECT_EQ(factor({{"preset", "effects"}}), 1e-4);
    EXPECT_EQ(factor({{"preset", "effects"}, {"dw", "2"}}), 2.0);
}

TEST(ModelChoices, WrongValuesNameWhatIsExpected) {
    EXPECT_EQ(refusal("D", "GGX"), "D: 'GGX' is unknown; expected one of ggx, beckmann, blinn, gaussian");
    EXPECT_EQ(refusal("clamp", "never"), "clamp: 'never' is unknown; expected before or after");
    EXPECT_EQ(refusal("norm", "1982"), "norm: '1982' is unknown; expected one of normalised, ct4m2, ct1982");
    EXPECT_EQ(refusal("alpha", "-0.1"), "alpha: -0.1 is outside 0 to 1000000");
    EXPECT_EQ(refusal("f0", "0.5,2,0.1"), "f0: 2 is outside 0 to 1");
    EXPECT_EQ(refusal("dw", "much"), "dw: 'much' is no number");
}

}  // namespace
}  // namespace rt::model_choices_test
