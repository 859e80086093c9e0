#include "grading/text_causes.h"

#include <gtest/gtest.h>

namespace rt::text_causes_test {
namespace {

const char* const expected = "Pixel: [1, 2]\nRay: {0.0000 0.0000 14.0000} -> {0.1234 -0.5000 0.8575}\nT = 9.3750\nColor: (12, 30, 255)\n";

std::string cause(std::string_view actual) { return text_cause(expected, actual).cause; }

TEST(TextCause, Rounding) {
    const TextCause found =
        text_cause(expected, "Pixel: [1, 2]\nRay: {0.0000 0.0000 14.0000} -> {0.1235 -0.5000 0.8574}\nT = 9.3750\nColor: (12, 30, 254)\n");
    EXPECT_EQ(found.cause, "rounding");
    EXPECT_EQ(found.evidence, "3 of 12 numbers differ, all by at most two units of the last place");
}

TEST(TextCause, Sign) {
    EXPECT_EQ(cause("Pixel: [1, 2]\nRay: {0.0000 0.0000 -14.0000} -> {0.1234 0.5000 0.8575}\nT = 9.3750\nColor: (12, 30, 255)\n"), "sign");
}

TEST(TextCause, OtherNumbers) {
    EXPECT_EQ(cause("Pixel: [1, 2]\nRay: {0.0000 0.0000 14.0000} -> {0.1234 -0.5000 0.8575}\nT = 8.1000\nColor: (12, 30, 255)\n"),
              "other numbers");
}

TEST(TextCause, LinesAndTheirOrder) {
    EXPECT_EQ(cause("Pixel: [1, 2]\nT = 9.3750\nColor: (12, 30, 255)\n"), "missing lines");
    EXPECT_EQ(cause(std::string(expected) + "done\n"), "lines too many");
    EXPECT_EQ(cause("T = 9.3750\nPixel: [1, 2]\nRay: {0.0000 0.0000 14.0000} -> {0.1234 -0.5000 0.8575}\nColor: (12, 30, 255)\n"),
              "another order");
}

TEST(TextCause, Format) {
    EXPECT_EQ(cause("Pixel: [1, 2]\nRay: <0.0000, 0.0000, 14.0000> -> <0.1234, -0.5000, 0.8575>\nT = 9.3750\nColor: (12, 30, 255)\n"),
              "another format");
    EXPECT_EQ(cause("Pixel: [1, 2]\nRay: {0 0 14} -> {0.1234 -0.5 0.8575}\nT = 9.375\nColor: (12, 30, 255)\n"), "another format");
}

TEST(TextCause, Words) {
    EXPECT_EQ(cause("Pixel: [1, 2]\nRay: {0.0000 0.0000 14.0000} -> {0.1234 -0.5000 0.8575}\nNo Hit\nColor: (12, 30, 255)\n"),
              "other words");
}

TEST(TextCause, DigitsOfNamesAreNoNumbers) { EXPECT_EQ(text_cause("light1 2.0\n", "light2 2.0\n").cause, "other words"); }

}  // namespace
}  // namespace rt::text_causes_test
