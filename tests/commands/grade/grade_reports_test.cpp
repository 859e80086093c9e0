// Reports of a grading: their fields, what a hostile name or text may do to them, and the way there and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/grade/grade_page_row.h"
#include "commands/grade/grade_reports.h"
#include "commands/report/result_json.h"
#include "tests/commands/support.h"

namespace rt::grade_reports_test {
namespace {

using testing::HasSubstr;

Result passed() {
    Result result;
    result.submission = "ada", result.test = "p1/planes", result.outcome = Outcome::passed, result.credit = 1.0;
    result.figures.emplace();
    result.figures->pixels = 307200;
    (*result.figures)[Metric::differing] = 12, (*result.figures)[Metric::rmse] = 0.1234567890123;
    result.wall_seconds = 1.5, result.cpu_seconds = 1.25, result.spread_seconds = 0.125, result.peak_memory_bytes = 1u << 20,
    result.alone = true;
    return result;
}

Result wrong() {
    Result result;
    result.submission = "ada", result.test = "p1/test<1>", result.kind = TestCase::Kind::text, result.outcome = Outcome::wrong_answer;
    result.weight = 2.0, result.reason = "line 1, field 2: '2', '1' expected", result.cause = "wrong depth",
    result.explanation = "first\nsecond";
    result.text = TextDifference{1, 2, "a 1", "a 2", "1", "2", 1.0};
    result.region = DifferingRegion{7, 1, 2, 3, 4, 2, 3};
    result.output = "=1+1,\"x\"\x01\xff</testcase>";
    result.required = false, result.left_processes = true;
    return result;
}

Result crashed() {
    Result result;
    result.submission = "bob", result.test = "p1/planes", result.outcome = Outcome::signal, result.status = 11,
    result.reason = "ended by SIGSEGV";
    return result;
}

GradeRecord record() { return {"Winter & more", {"no network is kept out"}, {1, 4}, {passed(), wrong(), crashed()}, {}}; }

TEST(GradeReports, ResultsComeBackAsTheyWere) {
    const test::Workplace place;
    write_reports(record(), ".", false);
    const GradeRecord read = read_record(".");
    EXPECT_EQ(results_text(read), results_text(record()));
    EXPECT_EQ(times_text(read, "."), times_text(record(), "."));
    EXPECT_EQ(read.shard.index, 1u);
    EXPECT_EQ(read.shard.of, 4u);
    EXPECT_EQ((*read.results[0].figures)[Metric::rmse], 0.1234567890123);
    EXPECT_EQ(read.results[1].text->expected, "1");
    EXPECT_EQ(read.results[1].region->y, 3);
}

TEST(GradeReports, TimesAreInAFileOfTheirOwn) {
    GradeRecord other = record();
    other.results[0].wall_seconds = 99.0, other.results[0].peak_memory_bytes = 1;
    EXPECT_EQ(results_text(other), results_text(record()));
    EXPECT_NE(times_text(other, "."), times_text(record(), "."));
}

TEST(GradeReports, CsvQuotesAndDisarmsFields) {
    const std::string text = csv_text(record());
    EXPECT_THAT(
        text,
        HasSubstr(
            "submission,test,kind,required,outcome,credit,weight,status,differing,differing_1,rmse,p99,flip,neighbourhood,cause,reason,"));
    EXPECT_THAT(text, HasSubstr("ada,p1/planes,picture,yes,passed,1,1,0,12,0,0.123456789,0,0,0,,,1.500,1.250,0.125,1048576\n"));
    EXPECT_THAT(text, HasSubstr("\"line 1, field 2: '2', '1' expected\""));
    GradeRecord formula = record();
    formula.results[0].submission = "=HYPERLINK(\"x\")";
    EXPECT_THAT(csv_text(formula), HasSubstr("\"'=HYPERLINK(\"\"x\"\")\""));
}

TEST(GradeReports, JunitCountsAndEscapes) {
    const std::string text = junit_text(record());
    EXPECT_THAT(text,
                HasSubstr("<testsuites name=\"Winter &amp; more\" tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\" time=\"1.500\">"));
    EXPECT_THAT(text, HasSubstr("<testsuite name=\"ada\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\" time=\"1.500\">"));
    EXPECT_THAT(text, HasSubstr("name=\"p1/test&lt;1&gt;\""));
    EXPECT_THAT(
        text,
        HasSubstr(
            "<failure type=\"wrong answer\" message=\"line 1, field 2: '2', '1' expected (wrong depth)\">first&#10;second</failure>"));
    EXPECT_THAT(text, HasSubstr("<error type=\"signal\" message=\"ended by SIGSEGV\">"));
    EXPECT_EQ(text.find('\x01'), std::string::npos);
    EXPECT_EQ(text.find('\xff'), std::string::npos);
}

TEST(GradeReports, JunitHoldsNoCharacterThatXmlHasNot) {
    GradeRecord odd = record();
    odd.results[1].output = "a\xEF\xBF\xBE\xEF\xBF\xBF\xEF\xBF\xBD\xED\xA0\x80z\v";
    const std::string text = junit_text(odd);
    EXPECT_THAT(text, HasSubstr("a??\xEF\xBF\xBD"));
    for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF", "\xED\xA0", "\v"}) EXPECT_EQ(text.find(none), std::string::npos);
    const test::Workplace place;
    place.write("junit.xml", text);
    EXPECT_EQ(std::system("python3 -c 'import xml.parsers.expat as e; e.ParserCreate().ParseFile(open(\"junit.xml\", \"rb\"))'"), 0);
}

TEST(GradeReports, GradescopeHasScoresOfEachTest) {
    const auto json = nlohmann::json::parse(gradescope_text({passed(), wrong()}));
    EXPECT_EQ(json["score"], 1.0);
    EXPECT_EQ(json["execution_time"], 2);
    ASSERT_EQ(json["tests"].size(), 2u);
    EXPECT_EQ(json["tests"][0]["status"], "passed");
    EXPECT_EQ(json["tests"][1]["max_score"], 2.0);
    EXPECT_EQ(json["tests"][1]["score"], 0.0);
    EXPECT_EQ(json["tests"][1]["output"], "wrong answer: line 1, field 2: '2', '1' expected\nlikely cause: wrong depth\nfirst\nsecond");
}

TEST(GradeReports, ManyProgramsHaveAFileEach) {
    const test::Workplace place;
    write_reports(record(), ".", false);
    EXPECT_TRUE(place.has("gradescope/ada.json"));
    EXPECT_TRUE(place.has("gradescope/bob.json"));
}

TEST(GradeReports, TheTableNamesOutcomeAndCause) {
    const std::string one = table_text({"s", {}, {}, {passed(), wrong()}, {}});
    EXPECT_THAT(one, HasSubstr("ok   p1/planes"));
    EXPECT_THAT(one, HasSubstr("FAIL p1/test<1>"));
    EXPECT_THAT(one, HasSubstr("wrong answer: wrong depth"));
    EXPECT_THAT(one, HasSubstr("1 of 2 passed, 1 of 1 required; 1 of 3 points; 1.5 s\n"));
    EXPECT_THAT(table_text(record()), HasSubstr("bob               0/1        0/1              0/1"));
}

TEST(GradeReports, TheTableHasNoControlBytesOfNames) {
    GradeRecord odd = record();
    odd.results[0].submission = odd.results[1].submission = "a\033[31mb\nc", odd.results[0].test = "p1/\033[2Jx";
    EXPECT_THAT(table_text(odd), HasSubstr("\na?[31mb?c         1/2"));
    odd.results.pop_back();
    EXPECT_THAT(table_text(odd), HasSubstr("ok   p1/?[2Jx   "));
}

TEST(GradeReports, TheTableAndThePagesCutNoCharacterInTwo) {
    GradeRecord odd = record();
    odd.results.erase(odd.results.begin() + 2);
    odd.results[0].test = odd.results[0].cause = std::string(199, 'x') + "\xC3\xA4";
    odd.results[1].reason = std::string(1999, 'y') + "\xC3\xA4";
    EXPECT_THAT(table_text(odd), HasSubstr("ok   " + std::string(199, 'x') + "... "));
    EXPECT_THAT(table_text(odd), HasSubstr(": " + std::string(199, 'x') + "...\n"));
    const ReportRow row = report_row(odd.results[1], nullptr);
    EXPECT_EQ(row.data["reason"], std::string(1999, 'y') + "… (2 bytes more)");
}

TEST(GradeReports, CsvHasNoBytesOfOtherEncodingsAndNoControlCharacters) {
    GradeRecord odd = record();
    odd.results[0].reason = std::string("a\0\033\x7F\xFFz", 6);
    EXPECT_THAT(csv_text(odd), HasSubstr(",a???\xEF\xBF\xBDz,"));
}

TEST(GradeReports, JunitKeepsEndsOfLines) {
    GradeRecord odd = record();
    odd.results[1].output = "a\r\nb";
    EXPECT_THAT(junit_text(odd), HasSubstr("a&#13;&#10;b"));
}

}  // namespace
}  // namespace rt::grade_reports_test
