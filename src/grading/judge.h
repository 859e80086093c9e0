// An ending and what was written -> a result, by the rule of the test.
#pragma once

#include "grading/result.h"

namespace rt {

/// The picture that a program left, or why there is none.
struct Written {
    enum class State : std::uint8_t { missing, unreadable, picture };
    State state = State::missing;
    std::string reason;  ///< of `unreadable`
    StoredImage image;
};

/// What an ending says against a program, in words; empty if it ended by itself with status 0.
std::string ending_reason(const Ending& ending, const Limits& limits);

/// Every figure of difference. Both pictures have the same size.
PictureFigures picture_figures(const StoredImage& expected, const StoredImage& actual, double fuzz_percent);

/// How the run ended decides first (time, memory, output, signal, exit status), then what was written; figures and the place of the
/// difference are there whenever there was something to compare, so that a program that crashes behind its last line shows what it had.
Result judge_picture(const TestCase& test, const Ending& ending, const Written& written, const StoredImage& expected);
Result judge_text(const TestCase& test, const Ending& ending, std::string_view expected);
/// Of a test without an expected picture.
Result judge_shown(const TestCase& test, const Ending& ending, const Written& written);

}  // namespace rt
