// Names of what a test can come to, as files and reports have them.
#pragma once

#include "core/name_table.h"
#include "grading/result.h"

namespace rt {

inline constexpr NameTable<Outcome, 14> outcome_names{{{"passed", Outcome::passed},
                                                       {"wrong answer", Outcome::wrong_answer},
                                                       {"wrong size", Outcome::wrong_size},
                                                       {"no output", Outcome::no_output},
                                                       {"unreadable output", Outcome::unreadable_output},
                                                       {"non-zero exit", Outcome::non_zero_exit},
                                                       {"signal", Outcome::signal},
                                                       {"time-out", Outcome::time_out},
                                                       {"out of memory", Outcome::out_of_memory},
                                                       {"too much output", Outcome::too_much_output},
                                                       {"not started", Outcome::not_started},
                                                       {"shown", Outcome::shown},
                                                       {"not judged", Outcome::not_judged},
                                                       {"not run", Outcome::not_run}}};
/// Whether a test has nothing against a program: it passed, or only shows.
constexpr bool is_good(Outcome outcome) { return outcome == Outcome::passed || outcome == Outcome::shown; }
inline constexpr NameTable<TestCase::Kind, 3> kind_names{
    {{"text", TestCase::Kind::text}, {"picture", TestCase::Kind::picture}, {"shown", TestCase::Kind::shown}}};
inline constexpr NameTable<Metric, metrics> metric_names{{{"differing", Metric::differing},
                                                          {"differing_1", Metric::differing_1},
                                                          {"rmse", Metric::rmse},
                                                          {"p99", Metric::p99},
                                                          {"flip", Metric::flip},
                                                          {"neighbourhood", Metric::neighbourhood}}};

/// As a sentence about a picture has it.
constexpr std::string_view title_of(Metric metric) {
    constexpr std::array<std::string_view, metrics> titles{"differing pixels", "pixels differing by 1 %",    "RMSE", "99th percentile",
                                                           "mean FLIP",        "difference among neighbours"};
    return titles[static_cast<std::size_t>(metric)];
}

}  // namespace rt
