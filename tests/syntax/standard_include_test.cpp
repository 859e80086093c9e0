// Every include file that is installed with POV-Ray can be read.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/syntax/read_scene.h"

namespace rt::standard_include_test {
namespace {

const std::filesystem::path folder = "/usr/share/povray-3.7/include";

std::vector<std::string> installed() {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
        if (entry.path().extension() == ".inc") names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string error_of(const std::string& scene) {
    try {
        parse_text({"t.pov", scene}, {}, [](std::string_view) {});
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

TEST(StandardInclude, EachCanBeRead) {
    const std::vector<std::string> names = installed();
    if (names.empty()) GTEST_SKIP() << "no include files in " << folder;
    EXPECT_GE(names.size(), 30u);
    for (const std::string& name : names) {
        // shapes2.inc is made of what shapes.inc declares.
        const std::string scene =
            "#version 3.7; global_settings { assumed_gamma 1 } #include \"colors.inc\" #include \"shapes.inc\" #include \"" + name + "\"";
        EXPECT_EQ(error_of(scene), "") << name;
    }
}

TEST(StandardInclude, AllTogetherCanBeRead) {
    std::string scene = "#version 3.7; global_settings { assumed_gamma 1 } #include \"colors.inc\"";
    if (installed().empty()) GTEST_SKIP() << "no include files in " << folder;
    for (const std::string& name : installed()) scene += " #include \"" + name + "\"";
    EXPECT_EQ(error_of(scene), "");
}

}  // namespace
}  // namespace rt::standard_include_test
