// What is said of a wrong answer besides that it is one: the usual cause, what speaks for it, and the rays of one pixel.
#pragma once

#include <functional>

#include "grading/result.h"

namespace rt {

struct StoredImage;

/// Runs the program once more with other words, as contained as before. What it printed; empty if it failed.
using RunAgain = std::function<std::string(const std::vector<std::string>& arguments)>;

/// What the program prints of the rays of the wrong picture's worst pixel; empty if it cannot be asked.
std::string rays_told(const TestCase& test, const Result& result, const RunAgain& run_again);

/// Fills `cause` and `explanation` of a wrong picture; `printed` is what rays_told() says. They depend on nothing else but the answers of
/// the suite's other tests, and its scenes.
void explain_picture(const Suite& suite, const TestCase& test, const StoredImage& expected, const StoredImage& actual,
                     const std::string& printed, Result& result);
/// The same of a wrong text; `actual` is what the program printed.
void explain_text(const std::string& expected, const std::string& actual, Result& result);

}  // namespace rt
