// Every case of tests/errors: the scene's complete messages, warnings and error, against the text beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "syntax/parser.h"

namespace rt::errors_test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(PROJECT_ROOT) / "tests" / "errors";

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".pov") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// What a user would see on stderr.
std::string messages_of(const std::string& file) {
    std::string all;
    const MessageSink sink = [&](std::string_view text) { all.append(text).append("\n"); };
    try {
        parse_file(file, {}, sink);
    } catch (const SceneError& error) {
        all.append(error.what()).append("\n");
    } catch (const LimitError& error) {
        all.append(error.what()).append("\n");
    }
    return all;
}

class BadInput : public testing::TestWithParam<std::string> {
protected:
    // The names in messages are as the user wrote them, relative to where he is.
    void SetUp() override {
        before_ = fs::current_path();
        fs::current_path(folder);
    }
    void TearDown() override { fs::current_path(before_); }

private:
    fs::path before_;
};

TEST_P(BadInput, HasItsFullMessage) {
    const fs::path expected = GetParam() + ".txt";
    ASSERT_TRUE(fs::exists(expected));
    EXPECT_EQ(messages_of(GetParam() + ".pov"), read(expected));
}

/// Warnings are for what is rendered all the same, everything else is refused.
TEST_P(BadInput, IsRefusedUnlessItIsAWarning) {
    const std::string text = read(GetParam() + ".txt");
    const bool refused = text.find(": Parse Error: ") != std::string::npos;
    EXPECT_EQ(refused, GetParam().rfind("warn_", 0) != 0);
    EXPECT_FALSE(text.empty());
}

INSTANTIATE_TEST_SUITE_P(Cases, BadInput, testing::ValuesIn(case_names()), [](const auto& info) { return info.param; });

TEST(BadInputFolder, HasAtLeastSixtyRefusals) {
    const std::vector<std::string> names = case_names();
    EXPECT_GE(std::count_if(names.begin(), names.end(), [](const std::string& n) { return n.rfind("warn_", 0) != 0; }), 60);
}

}  // namespace
}  // namespace rt::errors_test
