// What a suite asks of a program: plain values, whatever file they were read from.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grading/sandbox.h"

namespace rt {

/// Figures by which a picture is judged. Pixels are counted as ImageMagick 6 does; the others are shares of full scale.
enum class Metric : std::uint8_t { differing, differing_1, rmse, p99, flip, neighbourhood };
inline constexpr std::size_t metrics = 6;

/// Passed if the figure is at most that.
struct Threshold {
    Metric metric = Metric::differing;
    double at_most = 1000.0;
    bool operator==(const Threshold&) const = default;
};

/// Credit for a figure: 0..1, linear between points of growing figure, constant beyond both ends.
struct CreditCurve {
    Metric metric = Metric::rmse;
    std::vector<std::pair<double, double>> points;  ///< (figure, credit); empty: all for a pass, else nothing
    bool operator==(const CreditCurve&) const = default;
};
double credit(const CreditCurve& curve, double figure);

struct TestCase {
    enum class Kind : std::uint8_t {
        text,     ///< what is printed is compared
        picture,  ///< a file is
        shown     ///< a picture is made and shown, and not judged
    };

    std::string name;  ///< unique in its suite, e.g. "p3/simple_refract"
    Kind kind = Kind::picture;
    std::vector<std::string> arguments;
    std::string expected;              ///< path of the expected text or picture; empty for `shown`
    std::string output{"output.png"};  ///< what the program writes, in its working folder
    bool required = true;
    bool listed = true;  ///< false: has files, but the suite's list does not name it
    double weight = 1.0;
    bool timed = false;  ///< run with nothing beside it, and its time reported as a result
    int repeats = 1;     ///< of a timed one; the median counts
    Limits limits;
    double fuzz_percent = 5.0;
    std::vector<Threshold> pass{Threshold{}};  ///< all of them; of a picture
    CreditCurve curve;
    double tolerance = 0.0;  ///< numbers of a text may differ so much, relative above 1
};

struct Suite {
    std::string name;
    std::string folder;  ///< never shown to a program
    std::string inputs;  ///< folder that programs find as ../resources
    std::vector<TestCase> tests;
};

}  // namespace rt
