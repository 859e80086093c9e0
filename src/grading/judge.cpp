#include "grading/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>

#include "core/utf8.h"
#include "grading/difference.h"
#include "grading/neighbourhood.h"
#include "grading/result_names.h"

namespace rt {

namespace {

constexpr std::size_t shown_output = 16384;                      ///< as the course's graders keep
constexpr std::size_t longest_field = 200, longest_line = 1900;  ///< of what a program printed, where a result quotes it

std::string signal_text(int signal) {
    const char* name = sigabbrev_np(signal);
    const char* meaning = strsignal(signal);
    return name ? fmt::format("ended by SIG{} ({})", name, meaning) : fmt::format("ended by signal {}", signal);
}

Outcome outcome_of(const Ending& ending) {
    switch (ending.kind) {
        case Ending::Kind::exited:
            return ending.status == 0 ? Outcome::passed : Outcome::non_zero_exit;
        case Ending::Kind::signalled:
            return Outcome::signal;
        case Ending::Kind::time_out:
            return Outcome::time_out;
        case Ending::Kind::out_of_memory:
            return Outcome::out_of_memory;
        case Ending::Kind::too_much_output:
            return Outcome::too_much_output;
        case Ending::Kind::not_started:
            break;
    }
    return Outcome::not_started;
}

/// What the ending says; `passed` if it says nothing against the program.
Result of_ending(const TestCase& test, const Ending& ending) {
    Result result;
    result.test = test.name, result.kind = test.kind, result.required = test.required, result.weight = test.weight;
    result.status = ending.status, result.output = whole_characters(ending.output, shown_output);
    result.left_processes = ending.left_processes, result.busy_threads = ending.busy_threads;
    result.wall_seconds = ending.wall_seconds, result.cpu_seconds = ending.cpu_seconds;
    result.peak_memory_bytes = ending.peak_memory_bytes;
    result.outcome = outcome_of(ending), result.reason = ending_reason(ending, test.limits);
    return result;
}

/// A finding about the answer: counts only where the ending was good.
void find(Result& result, Outcome outcome, const std::string& reason) {
    if (result.outcome != Outcome::passed) return;
    result.outcome = outcome;
    result.reason = reason;
}

std::string quoted(const std::string& field) { return one_line(shortened(field, longest_field)); }

void shorten(TextDifference& text) {
    for (std::string* line : {&text.expected_line, &text.actual_line}) *line = shortened(*line, longest_line);
    for (std::string* field : {&text.expected, &text.actual}) *field = shortened(*field, longest_field);
}

void compare_pictures(const TestCase& test, const StoredImage& expected, const StoredImage& actual, Result& result) {
    result.figures = picture_figures(expected, actual, test.fuzz_percent);
    std::string beyond;
    for (const Threshold& threshold : test.pass) {
        const double figure = (*result.figures)[threshold.metric];
        if (figure <= threshold.at_most) continue;
        beyond += fmt::format("{}{} {:.6g}, at most {:.6g} allowed", beyond.empty() ? "" : "; ", title_of(threshold.metric), figure,
                              threshold.at_most);
    }
    if (!beyond.empty()) find(result, Outcome::wrong_answer, beyond);
    if (result.outcome != Outcome::passed) result.region = largest_region(expected, actual, test.fuzz_percent);
    if (result.outcome == Outcome::passed || result.outcome == Outcome::wrong_answer)
        result.credit = test.curve.points.empty() ? (result.outcome == Outcome::passed ? 1.0 : 0.0)
                                                  : credit(test.curve, (*result.figures)[test.curve.metric]);
}

}  // namespace

std::string ending_reason(const Ending& ending, const Limits& limits) {
    switch (ending.kind) {
        case Ending::Kind::exited:
            return ending.status == 0 ? "" : fmt::format("exit status {}", ending.status);
        case Ending::Kind::signalled:
            return signal_text(ending.status);
        case Ending::Kind::time_out:
            return fmt::format("not done within {} s", limits.wall_seconds);
        case Ending::Kind::out_of_memory:
            return fmt::format("more than {} MiB of memory", limits.memory_bytes >> 20);
        case Ending::Kind::too_much_output:
            return ending.reason.empty() ? fmt::format("printed more than {} KiB", limits.output_bytes >> 10) : ending.reason;
        case Ending::Kind::not_started:
            break;
    }
    return ending.reason;
}

PictureFigures picture_figures(const StoredImage& expected, const StoredImage& actual, double fuzz_percent) {
    PictureFigures figures;
    figures.pixels = static_cast<std::uint64_t>(expected.width) * static_cast<std::uint64_t>(expected.height);
    figures.fuzz_percent = fuzz_percent;
    const bool same = expected.channels == actual.channels && expected.max_value == actual.max_value && expected.values == actual.values;
    if (same) return figures;  // all of them 0, in no time
    const Difference d = compare(expected, actual, {fuzz_percent});
    figures[Metric::differing] = static_cast<double>(d.differing);
    figures[Metric::differing_1] = static_cast<double>(d.differing_1);
    figures[Metric::rmse] = d.rmse;
    figures[Metric::p99] = d.p99;
    figures[Metric::flip] = d.flip_mean;
    figures[Metric::neighbourhood] = neighbourhood_difference(expected, actual);
    return figures;
}

Result judge_picture(const TestCase& test, const Ending& ending, const Written& written, const StoredImage& expected) {
    Result result = of_ending(test, ending);
    const StoredImage& actual = written.image;
    if (written.state == Written::State::missing)
        find(result, Outcome::no_output, fmt::format("no {}", test.output));
    else if (written.state == Written::State::unreadable)
        find(result, Outcome::unreadable_output, written.reason);
    else if (actual.width != expected.width || actual.height != expected.height)
        find(result, Outcome::wrong_size,
             fmt::format("{} x {} pixels, {} x {} expected", actual.width, actual.height, expected.width, expected.height));
    else
        compare_pictures(test, expected, actual, result);
    return result;
}

Result judge_text(const TestCase& test, const Ending& ending, std::string_view expected) {
    Result result = of_ending(test, ending);
    result.text = first_difference(expected, ending.output, test.tolerance);
    if (result.text && compared_lines(ending.output).empty())
        find(result, Outcome::no_output, "nothing printed");
    else if (const std::optional<TextDifference>& d = result.text; d && d->field == 0)
        find(result, Outcome::wrong_answer,
             fmt::format("line {}: {}", d->line, d->actual_line.empty() ? "a line is missing" : "a line too many"));
    else if (d)
        find(result, Outcome::wrong_answer,
             fmt::format("line {}, field {}: '{}', '{}' expected", d->line, d->field, quoted(d->actual), quoted(d->expected)));
    if (result.text) shorten(*result.text);
    if (result.outcome == Outcome::passed) result.credit = 1.0;
    return result;
}

Result judge_shown(const TestCase& test, const Ending& ending, const Written& written) {
    Result result = of_ending(test, ending);
    if (written.state == Written::State::missing) find(result, Outcome::no_output, fmt::format("no {}", test.output));
    if (written.state == Written::State::unreadable) find(result, Outcome::unreadable_output, written.reason);
    find(result, Outcome::shown, "");
    return result;
}

}  // namespace rt
