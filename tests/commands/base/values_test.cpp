// Numbers on the command line.
#include "commands/base/values.h"

#include <gtest/gtest.h>

#include <string>

#include "core/source.h"

namespace rt::values_test {
namespace {

std::string mistake(std::string_view text) {
    try {
        real_number("max-error", text, 0.0, 1.0);
    } catch (const OptionError& error) {
        return error.what();
    }
    return "";
}

TEST(RealNumber, IsANumberOrAQuotientOfTwo) {
    EXPECT_EQ(real_number("x", "0.25", 0.0, 1.0), 0.25);
    EXPECT_EQ(real_number("x", "+2.5e-1", 0.0, 1.0), 0.25);
    EXPECT_EQ(real_number("x", "1/255", 0.0, 1.0), 1.0 / 255.0);
    EXPECT_EQ(real_number("x", "1e1/+40", 0.0, 1.0), 0.25);
    EXPECT_EQ(mistake("1/0"), "max-error: '1/0' is no number");
    EXPECT_EQ(mistake("0/0"), "max-error: '0/0' is no number");
    EXPECT_EQ(mistake("1/"), "max-error: '1/' is no number");
    EXPECT_EQ(mistake("/2"), "max-error: '/2' is no number");
    EXPECT_EQ(mistake("1/2/3"), "max-error: '1/2/3' is no number");
    EXPECT_EQ(mistake("1x"), "max-error: '1x' is no number");
    EXPECT_EQ(mistake("nan"), "max-error: 'nan' is no number");
    EXPECT_EQ(mistake("3/2"), "max-error: 3/2 is outside 0 to 1");
}

}  // namespace
}  // namespace rt::values_test
