// The fuzzer's dictionary has every reserved word.
#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "syntax/words.h"

namespace rt::fuzz_dictionary_test {
namespace {

std::set<std::string> lines_of(const std::string& command) {
    std::set<std::string> lines;
    std::FILE* const pipe = popen(command.c_str(), "r");
    std::string line;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
        if (c != '\n') {
            line += static_cast<char>(c);
            continue;
        }
        lines.insert(line);
        line.clear();
    }
    EXPECT_EQ(pclose(pipe), 0) << command;
    return lines;
}

#define RT_COUNT(name) +1
constexpr int words = RT_WORDS(RT_COUNT);
#undef RT_COUNT

TEST(FuzzDictionary, HasEveryReservedWord) {
    const std::set<std::string> lines = lines_of(PROJECT_ROOT "/tests/fuzz/dictionary");
    for (int i = 1; i <= words; ++i) {
        const std::string word(text(static_cast<Word>(i)));
        ASSERT_NE(word, "");
        EXPECT_TRUE(lines.contains('"' + word + '"')) << word;
    }
    EXPECT_TRUE(lines.contains("\"#declare A=\"")) << "tokens.dict";
}

}  // namespace
}  // namespace rt::fuzz_dictionary_test
