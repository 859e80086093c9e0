// The program's pictures against POV-Ray's, pixel by pixel, with POV-Ray's own switches as recipes.json states them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "film/image_file.h"

namespace reference_test {
namespace {

constexpr float step = 2.0f;          // of 65535: the rounding of two programs
constexpr double edge_share = 0.005;  // pixels in which silhouettes, shadow edges and texture edges may fall to the other side

struct Recipe {
    std::string name;
    std::vector<std::string> command;
};

std::vector<Recipe> recipes() {
    std::ifstream file(std::string(PROJECT_ROOT) + "/reference/recipes.json");
    const nlohmann::json pictures = nlohmann::json::parse(file).at("pictures");
    std::vector<Recipe> all;
    for (const auto& [name, recipe] : pictures.items()) all.push_back({name, recipe.at("command").get<std::vector<std::string>>()});
    return all;
}

class Reference : public testing::TestWithParam<Recipe> {};

TEST_P(Reference, PixelsAreThoseOfPovray) {
    const std::string picture = testing::TempDir() + "reference_" + GetParam().name + ".png";
    std::string command = "cd '" + std::string(PROJECT_ROOT) + "/pov' && '" + PROGRAM + "' --shading povray";
    for (std::size_t i = 1; i < GetParam().command.size(); ++i) {
        const std::string& word = GetParam().command[i];
        command += word.starts_with("+O") ? " '+O" + picture + "'" : " '" + word + "'";
    }
    ASSERT_EQ(std::system((command + " >/dev/null 2>&1").c_str()), 0) << command;
    const rt::StoredImage ours = rt::read_image(picture);
    const rt::StoredImage theirs = rt::read_image(std::string(PROJECT_ROOT) + "/reference/" + GetParam().name + ".png");
    std::remove(picture.c_str());
    ASSERT_EQ(ours.width, theirs.width);
    ASSERT_EQ(ours.height, theirs.height);
    ASSERT_EQ(ours.max_value, theirs.max_value);
    int beyond = 0;
    const int pixels = ours.width * ours.height;
    for (int i = 0; i < pixels; ++i) {
        bool differs = false;
        for (int k = 0; k < 3; ++k)
            differs |= std::fabs(ours.values[static_cast<std::size_t>(i * ours.channels + k)] -
                                 theirs.values[static_cast<std::size_t>(i * theirs.channels + k)]) > step;
        beyond += differs;
    }
    EXPECT_LE(beyond, edge_share * pixels);
    RecordProperty("pixels_beyond", beyond);
}

INSTANTIATE_TEST_SUITE_P(Pictures, Reference, testing::ValuesIn(recipes()), [](const auto& info) {
    std::string name = info.param.name;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

}  // namespace
}  // namespace reference_test
