// From an ending and what was written to a result: every outcome, and which comes first.
#include <gtest/gtest.h>

#include <csignal>

#include "grading/judge.h"
#include "tests/grading/pictures.h"

namespace rt::judge_test {
namespace {

constexpr int side = 40;

StoredImage grey(float value) { return test::picture(side, side, 3, 255, std::vector<float>(3 * side * side, value)); }

Ending ended(Ending::Kind kind, int status = 0, std::string output = "") {
    Ending ending;
    ending.kind = kind, ending.status = status, ending.output = std::move(output);
    return ending;
}

TestCase picture_test() {
    TestCase test;
    test.name = "p1/planes";
    return test;
}

Result judged(const Ending& ending, const StoredImage& actual) {
    return judge_picture(picture_test(), ending, {Written::State::picture, "", actual}, grey(100));
}

TEST(Judge, PassesAtTheLimitAndFailsBeyond) {
    StoredImage actual = grey(100);
    for (std::size_t i = 0; i < 1000; ++i) actual.values[3 * i] = 255.0f;
    const Result at = judged(ended(Ending::Kind::exited), actual);
    EXPECT_EQ(at.outcome, Outcome::passed);
    EXPECT_EQ(at.credit, 1.0);
    EXPECT_EQ((*at.figures)[Metric::differing], 1000.0);
    actual.values[3 * 1000] = 255.0f;
    const Result beyond = judged(ended(Ending::Kind::exited), actual);
    EXPECT_EQ(beyond.outcome, Outcome::wrong_answer);
    EXPECT_EQ(beyond.credit, 0.0);
    EXPECT_EQ(beyond.reason, "differing pixels 1001, at most 1000 allowed");
    ASSERT_TRUE(beyond.region);
    EXPECT_EQ(beyond.region->pixels, 1001u);
}

TEST(Judge, TheEndingComesFirst) {
    Ending file_too_large = ended(Ending::Kind::too_much_output);
    file_too_large.reason = "a file of more than 7 bytes";
    const struct {
        Ending ending;
        Outcome outcome;
        const char* reason;
    } cases[] = {{ended(Ending::Kind::exited, 3), Outcome::non_zero_exit, "exit status 3"},
                 {ended(Ending::Kind::signalled, SIGSEGV), Outcome::signal, "ended by SIGSEGV (Segmentation fault)"},
                 {ended(Ending::Kind::time_out), Outcome::time_out, "not done within 60 s"},
                 {ended(Ending::Kind::out_of_memory), Outcome::out_of_memory, "more than 4096 MiB of memory"},
                 {ended(Ending::Kind::too_much_output), Outcome::too_much_output, "printed more than 1024 KiB"},
                 {file_too_large, Outcome::too_much_output, "a file of more than 7 bytes"}};
    for (const auto& [ending, outcome, reason] : cases) {
        const Result result = judged(ending, grey(100));  // the right picture does not help
        EXPECT_EQ(result.outcome, outcome);
        EXPECT_EQ(result.reason, reason);
        EXPECT_EQ(result.credit, 0.0);
        EXPECT_TRUE(result.figures) << "what was written is compared all the same";
    }
    Ending none = ended(Ending::Kind::not_started);
    none.reason = "no such file";
    EXPECT_EQ(judged(none, grey(100)).reason, "no such file");
}

TEST(Judge, PicturesThatAreNone) {
    const Ending good = ended(Ending::Kind::exited);
    EXPECT_EQ(judge_picture(picture_test(), good, {}, grey(1)).reason, "no output.png");
    EXPECT_EQ(judge_picture(picture_test(), good, {}, grey(1)).outcome, Outcome::no_output);
    const Written broken{Written::State::unreadable, "output.png is a pipe", {}};
    EXPECT_EQ(judge_picture(picture_test(), good, broken, grey(1)).outcome, Outcome::unreadable_output);
    EXPECT_EQ(judge_picture(picture_test(), good, broken, grey(1)).reason, "output.png is a pipe");
    const Written small{Written::State::picture, "", test::picture(1, 2, 3, 255, std::vector<float>(6))};
    EXPECT_EQ(judge_picture(picture_test(), good, small, grey(1)).outcome, Outcome::wrong_size);
    EXPECT_EQ(judge_picture(picture_test(), good, small, grey(1)).reason, "1 x 2 pixels, 40 x 40 expected");
}

TEST(Judge, EqualPicturesHaveFiguresOfNothing) {
    const PictureFigures same = picture_figures(grey(7), grey(7), 5.0);
    StoredImage almost = grey(7);
    almost.values[0] = 8.0f;
    const PictureFigures other = picture_figures(grey(7), almost, 5.0);
    EXPECT_EQ(same.pixels, other.pixels);
    EXPECT_EQ(same.fuzz_percent, other.fuzz_percent);
    for (const double value : same.values) EXPECT_EQ(value, 0.0);
    EXPECT_GT(other[Metric::rmse], 0.0);
    EXPECT_GT(other[Metric::flip], 0.0);
}

TEST(Judge, EveryThresholdMustHold) {
    TestCase test = picture_test();
    test.pass = {{Metric::rmse, 0.1}, {Metric::flip, 0.9}};
    EXPECT_EQ(judge_picture(test, ended(Ending::Kind::exited), {Written::State::picture, "", grey(110)}, grey(100)).outcome,
              Outcome::passed);
    test.pass[1].at_most = 0.0;
    EXPECT_EQ(judge_picture(test, ended(Ending::Kind::exited), {Written::State::picture, "", grey(110)}, grey(100)).outcome,
              Outcome::wrong_answer);
}

TEST(Judge, CreditFollowsItsCurve) {
    const CreditCurve curve{Metric::rmse, {{0.1, 1.0}, {0.2, 0.5}, {0.4, 0.0}}};
    EXPECT_EQ(credit(curve, 0.0), 1.0);
    EXPECT_EQ(credit(curve, 0.1), 1.0);
    EXPECT_NEAR(credit(curve, 0.15), 0.75, 1e-12);
    EXPECT_NEAR(credit(curve, 0.3), 0.25, 1e-12);
    EXPECT_EQ(credit(curve, 0.5), 0.0);
    double before = 2.0;
    for (double figure = 0.0; figure < 0.6; figure += 0.01) {
        EXPECT_LE(credit(curve, figure), before);
        before = credit(curve, figure);
    }
    TestCase test = picture_test();
    test.curve = curve;
    test.pass = {{Metric::differing, 0.0}};
    const Result wrong = judge_picture(test, ended(Ending::Kind::exited), {Written::State::picture, "", grey(151)}, grey(100));
    EXPECT_EQ(wrong.outcome, Outcome::wrong_answer);
    EXPECT_NEAR(wrong.credit, 0.5, 1e-9);
    const Result crashed =
        judge_picture(test, ended(Ending::Kind::signalled, SIGABRT), {Written::State::picture, "", grey(100)}, grey(100));
    EXPECT_EQ(crashed.credit, 0.0);
}

TEST(Judge, Texts) {
    TestCase test;
    test.kind = TestCase::Kind::text;
    EXPECT_EQ(judge_text(test, ended(Ending::Kind::exited, 0, "a  1\n"), "a 1").outcome, Outcome::passed);
    const Result wrong = judge_text(test, ended(Ending::Kind::exited, 0, "a 2\n"), "a 1");
    EXPECT_EQ(wrong.outcome, Outcome::wrong_answer);
    EXPECT_EQ(wrong.reason, "line 1, field 2: '2', '1' expected");
    EXPECT_EQ(judge_text(test, ended(Ending::Kind::exited, 0, " \n"), "a 1").outcome, Outcome::no_output);
    EXPECT_EQ(judge_text(test, ended(Ending::Kind::exited, 1, "a 1"), "a 1").outcome, Outcome::non_zero_exit);
    EXPECT_EQ(judge_text(test, ended(Ending::Kind::exited, 0, "a 1\nmore"), "a 1").reason, "line 2: a line too many");
}

TEST(Judge, ShownPicturesAreNotJudged) {
    TestCase test;
    test.kind = TestCase::Kind::shown;
    EXPECT_EQ(judge_shown(test, ended(Ending::Kind::exited), {Written::State::picture, "", grey(1)}).outcome, Outcome::shown);
    EXPECT_EQ(judge_shown(test, ended(Ending::Kind::exited), {}).outcome, Outcome::no_output);
    EXPECT_EQ(judge_shown(test, ended(Ending::Kind::exited, 1), {Written::State::picture, "", grey(1)}).outcome, Outcome::non_zero_exit);
}

TEST(Judge, WhatIsKeptOfATextEndsWithAWholeCharacter) {
    TestCase test;
    test.kind = TestCase::Kind::text;
    const std::string printed = std::string(16383, 'x') + "\xC3\xA4z";
    EXPECT_EQ(judge_text(test, ended(Ending::Kind::exited, 0, printed), "y").output, std::string(16383, 'x'));
}

TEST(Judge, QuotesNoLongAndNoStrangeFields) {
    TestCase test;
    test.kind = TestCase::Kind::text;
    const std::string field = "\033[2J" + std::string(196, 'x') + std::string(2000, 'z');
    const Result result = judge_text(test, ended(Ending::Kind::exited, 0, "T = " + field), "T = 1");
    EXPECT_EQ(result.reason, "line 1, field 3: '?[2J" + std::string(196, 'x') + "… (2000 bytes more)', '1' expected");
    EXPECT_EQ(result.text->actual, field.substr(0, 200) + "… (2000 bytes more)");
    EXPECT_EQ(result.text->actual_line, ("T = " + field).substr(0, 1900) + "… (304 bytes more)");
}

}  // namespace
}  // namespace rt::judge_test
