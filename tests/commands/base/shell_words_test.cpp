#include "commands/base/shell_words.h"

#include <gtest/gtest.h>

namespace rt::shell_words_test {
namespace {

TEST(ShellWords, AreQuotedWhereTheyMustBe) {
    EXPECT_EQ(shell_word("pov/a_b-1.pov"), "pov/a_b-1.pov");
    EXPECT_EQ(shell_word("--D=ggx,1"), "--D=ggx,1");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("a b"), "'a b'");
    EXPECT_EQ(shell_word("$(x);`y`"), "'$(x);`y`'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word("~x"), "'~x'");
    EXPECT_EQ(shell_word("\xc3\xa9.pov"), "'\xc3\xa9.pov'");
}

TEST(ShellWords, HoldAnyByte) {
    EXPECT_EQ(shell_word("\xe9"
                         "1'\\"),
              "$'\\3511\\'\\\\'");
    EXPECT_EQ(shell_word("a\nb"), "$'a\\012b'");
}

}  // namespace
}  // namespace rt::shell_words_test
