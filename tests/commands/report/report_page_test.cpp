// Pages of reports: which pictures stand in them, what is said of the others, and rows of a grading.
#include "commands/report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/grade/grade_page_row.h"
#include "commands/grade/grade_reports.h"
#include "commands/report/page_pictures.h"
#include "film/png.h"
#include "tests/commands/support.h"

namespace rt::report_page_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// One grey pixel.
StoredImage pixel(float value) { return {1, 1, 1, 255, {value}}; }

ReportRow row(const std::string& name, bool good, const std::vector<std::string>& files) {
    ReportRow row;
    row.data = {{"name", name}, {"good", good}, {"cells", {{"name", name}}}};
    for (const std::string& file : files) row.pictures.push_back({"Picture", file, "there is none"});
    return row;
}

ReportPage page(std::vector<ReportRow> rows) {
    ReportPage page;
    page.title = "</title>\x01\xff", page.columns = {{"name", "Test", CellKind::text, "hint"}};
    page.rows = std::move(rows);
    return page;
}

/// What the page tells of its pictures: names, and why there is none.
std::vector<std::vector<std::string>> pictures(const std::string& html) {
    const std::size_t begin = html.find('>', html.find("id=\"data\"")) + 1;
    const auto data = nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : data["rows"]) {
        rows.emplace_back();
        for (const auto& picture : one.value("pictures", nlohmann::json::array()))
            rows.back().push_back(picture.contains("picture") ? picture["picture"] : picture["missing"]);
    }
    return rows;
}

class Report : public testing::Test {
protected:
    void SetUp() override {
        for (const int value : {1, 2, 3}) place.write(std::to_string(value) + ".png", png_of(pixel(static_cast<float>(value))));
        place.write("one_again.png", place.read("1.png"));
    }
    test::Workplace place;
};

TEST_F(Report, PicturesOfTheSameBytesStandOnce) {
    const std::string html = report_page(page({row("a", true, {"1.png", "one_again.png"}), row("b", true, {"1.png", "2.png"})}), {});
    EXPECT_THAT(pictures(html), ElementsAre(ElementsAre("p0", "p0"), ElementsAre("p0", "p1")));
    EXPECT_THAT(html, HasSubstr("id=\"p1\""));
    EXPECT_THAT(html, Not(HasSubstr("id=\"p2\"")));
}

TEST_F(Report, TheSameRowsGiveTheSameBytes) {
    const auto make = [] { return report_page(page({row("a", false, {"1.png", "2.png"})}), {}); };
    EXPECT_EQ(make(), make());
}

TEST_F(Report, WhatIsNotGoodComesFirstWhereRoomIsShort) {
    const std::uint64_t one = std::filesystem::file_size("1.png");
    const auto rows = [] { return std::vector{row("good", true, {"1.png"}), row("bad", false, {"2.png", "3.png"})}; };
    EXPECT_THAT(pictures(report_page(page(rows()), {2 * one, true, "no room"})),
                ElementsAre(ElementsAre("no room"), ElementsAre("p0", "p1")));
    EXPECT_THAT(pictures(report_page(page(rows()), {one, true, "no room"})),
                ElementsAre(ElementsAre("no room"), ElementsAre("p0", "no room")));
    EXPECT_THAT(pictures(report_page(page(rows()), {1u << 20, false, "it passed"})),
                ElementsAre(ElementsAre("it passed"), ElementsAre("p0", "p1")));
}

TEST_F(Report, SaysWhyAPictureIsNotThere) {
    place.write("text", "no picture");
    const auto told = pictures(report_page(page({row("a", true, {"", "nowhere.png", "text"})}), {}));
    EXPECT_THAT(told,
                ElementsAre(ElementsAre("there is none", HasSubstr("its file is not there"), "its file is no picture that can be read")));
}

TEST_F(Report, NothingInItEndsItsElement) {
    const std::string html = report_page(page({row("</script><!--", true, {"1.png"})}), {});
    EXPECT_THAT(html, Not(HasSubstr("</script><!--")));
    EXPECT_THAT(html, HasSubstr("\\u003c/title>\\u0001\xef\xbf\xbd"));
}

TEST(PagePictures, KnowWhatAPageReads) {
    const std::string plain = png_of({1, 1, 3, 255, {1, 2, 3}});
    EXPECT_TRUE(is_plain_png(plain));
    EXPECT_TRUE(is_plain_png(png_of({1, 1, 4, 65535, {1, 2, 3, 4}})));
    const auto with = [&](std::size_t at, char value) {
        std::string changed = plain;
        changed[at] = value;
        return is_plain_png(changed);
    };
    EXPECT_FALSE(with(19, 0));  // no width
    EXPECT_FALSE(with(23, 0));  // no height
    EXPECT_FALSE(with(24, 4));  // bits
    EXPECT_FALSE(with(25, 3));  // a palette
    EXPECT_FALSE(with(28, 1));  // interlaced
    EXPECT_FALSE(with(1, 'p'));
    std::string transparent = plain;
    transparent.insert(33, std::string("\0\0\0\6tRNS\0\0\0\0\0\0cccc", 18));
    EXPECT_FALSE(is_plain_png(transparent));
    for (std::size_t size = 0; size < 45; ++size) EXPECT_FALSE(is_plain_png(plain.substr(0, size))) << size;
}

TEST(InAddress, EveryByteButPlainOnesIsWritten) { EXPECT_EQ(in_address("a-Z_0.~ /?#%\xff"), "a-Z_0.~%20%2F%3F%23%25%FF"); }

Result failed_text() {
    Result result;
    result.submission = "ada", result.test = "t", result.kind = TestCase::Kind::text, result.outcome = Outcome::wrong_answer;
    result.output = "a 2\nb\n";
    result.text = TextDifference{1, 2, "a 1", "a 2", "1", "2", 1.0};
    return result;
}

TEST(ReportRow, LaysTextsSideBySide) {
    const test::Workplace place;
    place.write("expected", "a 1\nb\n");
    TestCase test;
    test.expected = "expected", test.arguments = {"pixelray", "it's"};
    const auto data = report_row(failed_text(), &test).data;
    EXPECT_EQ(data["lines"].dump(), R"([[1,"a 1",1,"a 2",[2]],[2,"b",2,"b",[]]])");
    EXPECT_EQ(data["command"], R"(ada pixelray 'it'\''s')");
    EXPECT_FALSE(data["good"]);
}

TEST(ReportRow, WithoutTheExpectedTextHasTheFirstDifference) {
    const auto data = report_row(failed_text(), nullptr).data;
    EXPECT_EQ(data["lines"].dump(), R"([[null,"a 1",1,"a 2",[2]]])");
    EXPECT_THAT(data["lines_note"].get<std::string>(), HasSubstr("the expected text is not there"));
    Result missing = failed_text();
    missing.text = TextDifference{3, 0, "c", "", "", "", {}};
    EXPECT_EQ(report_row(missing, nullptr).data["lines"].dump(), R"([[null,"c",0,"",[]]])");
}

TEST(ReportRow, IsGoodAsTheTableIs) {
    Result result;
    for (const auto& [outcome, good] : {std::pair(Outcome::passed, true), std::pair(Outcome::shown, true),
                                        std::pair(Outcome::wrong_answer, false), std::pair(Outcome::not_run, false)}) {
        result.outcome = outcome;
        EXPECT_EQ(report_row(result, nullptr).data["good"], good);
    }
}

TEST(ReportFiles, NamesAreFilesNames) {
    EXPECT_EQ(report_file_name("a_b #2 ü"), "a_b #2 ü");
    EXPECT_THAT(report_file_name("a/b"), testing::StartsWith("a_b-"));
    EXPECT_NE(report_file_name("a/b"), report_file_name("a_b"));
    EXPECT_NE(report_file_name("a/b/c"), report_file_name("a/b_c"));
    const std::string one(250, 'x'), other = one + "y";
    EXPECT_LE(report_file_name(one).size(), 180u);
    EXPECT_NE(report_file_name(one), report_file_name(other));
}

TEST(ReportFiles, LongNamesAreCutBetweenCharacters) {
    const std::string cat = "\xf0\x9f\x90\xb1";
    std::string cats;
    for (int i = 0; i < 60; ++i) cats += cat;
    for (std::size_t before = 0; before < 4; ++before) {
        const std::string name = report_file_name(std::string(before, 'x') + cats);
        EXPECT_LE(name.size(), 180u);
        EXPECT_THAT(name, HasSubstr(cat + "-")) << "the last one is whole";
    }
    EXPECT_LE(report_file_name(std::string(250, '\x80')).size(), 180u);  // no UTF-8 at all
}

TEST(ReportFiles, PicturesAndTestsComeBack) {
    const test::Workplace place;
    const std::string here = std::filesystem::current_path().string();
    TestCase test;
    test.name = "t", test.arguments = {"render", "a b"}, test.expected = "/answers/t.png", test.fuzz_percent = 3.0, test.tolerance = 0.5;
    test.pass = {{Metric::rmse, 0.25}, {Metric::flip, 0.5}};
    Result result;
    result.test = "t", result.picture = here + "/known/k/picture";
    write_reports({"s", {}, {}, {result}, {test}}, here, false);
    EXPECT_THAT(place.read("times.json"), HasSubstr("\"picture\":\"known/k/picture\""));
    const GradeRecord read = read_record(here);
    EXPECT_EQ(read.results[0].picture, result.picture);
    ASSERT_EQ(read.tests.size(), 1u);
    EXPECT_EQ(read.tests[0].arguments, test.arguments);
    EXPECT_EQ(read.tests[0].expected, test.expected);
    EXPECT_EQ(read.tests[0].pass, test.pass);
    EXPECT_EQ(read.tests[0].fuzz_percent, 3.0);
    EXPECT_EQ(read.tests[0].tolerance, 0.5);
}

}  // namespace
}  // namespace rt::report_page_test
