// What is said of a wrong answer besides that it is one: the usual cause, what speaks for it, and the rays of one pixel.
#pragma once

#include <functional>

#include "grading/result.h"

namespace rt {

struct StoredImage;

/// Runs the program once more with other words, as contained as before. What it printed; empty if it failed.
using RunAgain = std::function<std::string(const std::vector<std::string>& arguments)>;

/// Fills `cause` and `explanation` of a wrong picture.
void explain_picture(const Suite& suite, const TestCase& test, const StoredImage& expected, const StoredImage& actual,
                     const RunAgain& run_again, Result& result);
/// The same of a wrong text; `actual` is what the program printed.
void explain_text(const std::string& expected, const std::string& actual, Result& result);

}  // namespace rt
