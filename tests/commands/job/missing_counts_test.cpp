// What is missing in many scenes, by gain.
#include "commands/job/missing_counts.h"

#include <gtest/gtest.h>

namespace rt::missing_counts_test {
namespace {

std::vector<MissingFeature> missing(const std::vector<std::string>& names) {
    std::vector<MissingFeature> features;
    for (const std::string& name : names) features.push_back({name, "s.pov", 1, 1});
    return features;
}

std::string counts_of(const MissingOfScenes& scenes) {
    std::string text;
    for (const MissingCount& count : missing_counts(scenes))
        text += count.name + " " + std::to_string(count.scenes) + " " + std::to_string(count.only_this) + "; ";
    return text;
}

std::string order_of(const MissingOfScenes& scenes) {
    std::string text;
    for (const MissingStep& step : missing_order(scenes)) text += step.name + " " + std::to_string(step.completes) + "; ";
    return text;
}

TEST(MissingFeatures, CountOnceForEachScene) {
    EXPECT_EQ(counts_of({}), "");
    EXPECT_EQ(counts_of({missing({}), missing({"fog", "fog", "fog"})}), "fog 1 1; ");
    EXPECT_EQ(counts_of({missing({"blob"}), missing({"fog", "media"}), missing({"fog", "media"}), missing({"media", "blob", "ant"})}),
              "blob 2 1; media 3 0; fog 2 0; ant 1 0; ");
}

TEST(MissingFeatures, TheNextCompletesMostScenes) {
    EXPECT_EQ(order_of({missing({})}), "");
    // Alone, blob completes one scene and photons none; behind media, photons complete two.
    const MissingOfScenes scenes = {missing({"media"}), missing({"media"}), missing({"blob"}), missing({"media", "photons"}),
                                    missing({"photons", "media", "photons"})};
    EXPECT_EQ(order_of(scenes), "media 2; photons 2; blob 1; ");
}

TEST(MissingFeatures, WhereNoneCompletesASceneTheNearestIsNext) {
    EXPECT_EQ(order_of({missing({"a", "b", "c"}), missing({"a", "d", "e"}), missing({"f", "g"})}), "a 0; b 0; c 1; d 0; e 1; f 0; g 1; ");
    EXPECT_EQ(order_of({missing({"z", "y"})}), "y 0; z 1; ") << "then by name";
}

}  // namespace
}  // namespace rt::missing_counts_test
