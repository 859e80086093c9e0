// What became of one test of one program: plain values, the same for every report.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "grading/regions.h"
#include "grading/suite.h"
#include "grading/text_difference.h"

namespace rt {

enum class Outcome : std::uint8_t {
    passed,
    wrong_answer,
    wrong_size,         ///< of the picture
    no_output,          ///< no picture was written, or nothing was printed
    unreadable_output,  ///< what was written is no picture, or no file of its own
    non_zero_exit,
    signal,
    time_out,
    out_of_memory,
    too_much_output,
    not_started,  ///< there is no program, or it could not be started
    shown,        ///< nothing is expected
    not_judged,   ///< a fault of ours or of the suite's: a broken answer, a full disk
    not_run       ///< the grading ended before
};

struct PictureFigures {
    std::uint64_t pixels = 0;
    double fuzz_percent = 5.0;
    std::array<double, metrics> values{};
    double operator[](Metric m) const { return values[static_cast<std::size_t>(m)]; }
    double& operator[](Metric m) { return values[static_cast<std::size_t>(m)]; }
    bool operator==(const PictureFigures&) const = default;
};

/// Everything but times is the same each time that the same program runs the same test (of a program that does the same each time).
struct Result {
    std::string submission, test;
    TestCase::Kind kind = TestCase::Kind::picture;
    bool required = true;
    double weight = 1.0;
    Outcome outcome = Outcome::not_run;
    double credit = 0.0;  ///< 0..1 of the weight
    int status = 0;       ///< exit status, or the signal
    std::string reason;   ///< one line in words; empty for a pass
    std::optional<PictureFigures> figures;
    std::optional<DifferingRegion> region;
    std::optional<TextDifference> text;  ///< long lines and fields shortened
    std::string cause;                   ///< what a wrong answer looks like, in two or three words; empty if nothing fits
    std::string explanation;             ///< lines: what speaks for the cause, the pixel, the rays
    std::string output;                  ///< the first of what the program printed
    bool left_processes = false;
    std::string picture;  ///< path of the picture that the program wrote, where it is kept; empty if there is none

    // Times: of the last run, for a timed test the median of its runs and how far they are apart.
    bool alone = false;    ///< nothing of ours ran beside it
    int busy_threads = 0;  ///< of a time-out, at its end: see Ending
    double wall_seconds = 0.0, cpu_seconds = 0.0, spread_seconds = 0.0;
    std::uint64_t peak_memory_bytes = 0;
};

}  // namespace rt
