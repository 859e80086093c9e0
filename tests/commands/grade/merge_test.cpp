// Shards that are read and joined: what is not all of one grading is refused and named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/base/json_value.h"
#include "commands/grade/grade_reports.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::merge_test {
namespace {

using testing::HasSubstr;

constexpr const char* no_times = R"({"format": "raytrace times 1", "suite": "s", "times": []})";

std::string mistake_in(const std::string& shard) {
    const test::Workplace place;
    place.write("results.json", R"({"format": "raytrace results 1", "suite": "s", "holes": [], "results": [], "shard": )" + shard + "}");
    place.write("times.json", no_times);
    try {
        read_record(".");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "none";
}

TEST(Merge, AShardIsANumberOfSoMany) {
    EXPECT_EQ(mistake_in("[2, 3]"), "none");
    EXPECT_THAT(mistake_in("[]"), HasSubstr("line 1: Parse Error: Expected a shard's number and how many there are, [] found instead."));
    EXPECT_THAT(mistake_in("[1, 2, 3]"), HasSubstr("Expected a shard's number and how many there are, [1,2,3] found instead."));
    for (const char* shard : {"[1, 0]", "[0, 1]", "[3, 2]"})
        EXPECT_THAT(mistake_in(shard), HasSubstr("Expected a shard's number, from 1 to how many there are")) << shard;
}

TEST(Merge, AListHasNoMoreThanItHolds) {
    Sources sources;
    sources.add({"a.json", "[7]"});
    const nlohmann::json content = parse_json(sources);
    const JsonValue list(sources, content);
    EXPECT_EQ(list.item(0).count(), 7u);
    try {
        list.item(1);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Expected a list of 2 or more values, [7] found instead."));
    }
}

class MergedShards : public testing::Test {
protected:
    MergedShards() {
        for (const char* program : {"ada", "bob", "eve"})
            for (const TestCase& test : tests_) deal(program, test.name);
    }
    void deal(const std::string& program, const std::string& test) {
        Result result;
        result.submission = program, result.test = test, result.outcome = Outcome::wrong_answer;
        (dealt_++ % 2 == 0 ? first_ : second_).results.push_back(result);
    }
    test::Outcome merge() const {
        for (const auto& [folder, record] : {std::pair("a", &first_), std::pair("b", &second_)}) {
            std::filesystem::create_directories(folder);
            write_reports(*record, folder, false);
        }
        return test::run({"merge", "-q", "a", "b", "-o", "whole"});
    }
    static TestCase asked(const std::string& name, TestCase::Kind kind) {
        TestCase test;
        test.name = name, test.kind = kind, test.arguments = {"render", name};
        if (kind != TestCase::Kind::shown) test.expected = name + ".png";
        return test;
    }

    test::Workplace place_;
    std::vector<TestCase> tests_{asked("x", TestCase::Kind::picture), asked("y", TestCase::Kind::picture),
                                 asked("own", TestCase::Kind::shown)};
    GradeRecord first_{"s", {}, {0, 2}, {}, tests_}, second_{"s", {}, {1, 2}, {}, tests_};
    std::size_t dealt_ = 0;
};

TEST_F(MergedShards, AreTheListAgain) {
    EXPECT_EQ(merge().status, 0);
    std::string order;
    for (const Result& result : read_record("whole").results) order += result.submission + " " + result.test + "; ";
    EXPECT_EQ(order, "ada x; ada y; ada own; bob x; bob y; bob own; eve x; eve y; eve own; ");
}

TEST_F(MergedShards, OfOtherSizesThanOneListGivesAreRefused) {
    first_.results.resize(1);
    const test::Outcome told = merge();
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(told.err, HasSubstr("merge: of the 5 results of these 2 shards, shard 1/2 should hold 3, and holds 1"));
    EXPECT_FALSE(place_.has("whole/results.json"));
}

TEST_F(MergedShards, OfOtherProgramsAreRefused) {
    first_.results.pop_back(), second_.results.pop_back();
    const test::Outcome told = merge();
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(told.err, HasSubstr("merge: 'eve' has no result of test 'y'"));
    EXPECT_FALSE(place_.has("whole/results.json"));
}

TEST_F(MergedShards, WithAResultTwiceAreRefused) {
    second_.results[0] = first_.results[0];
    const test::Outcome told = merge();
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(told.err, HasSubstr("merge: 'ada' has no result of test 'y' in its place"));
}

TEST_F(MergedShards, ByOtherRulesAreRefused) {
    second_.tests[1].pass[0].at_most = 5.0;
    const test::Outcome told = merge();
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(told.err, HasSubstr("merge: shards 1/2 and 2/2 have other tests: number 2 is 'y' and 'y'"));
    second_.tests.pop_back(), second_.tests[1] = first_.tests[1];
    EXPECT_THAT(merge().err, HasSubstr("merge: shards 1/2 and 2/2 have other tests: 3 and 2"));
}

TEST_F(MergedShards, MayLieInOtherFolders) {
    for (TestCase& test : second_.tests) test.expected.insert(0, test.expected.empty() ? "" : "/elsewhere/");
    EXPECT_EQ(merge().status, 0);
}

TEST_F(MergedShards, OfAProgramWithoutItsOwnSceneAreComplete) {
    first_.results.clear(), second_.results.clear(), dealt_ = 0;
    for (const char* test : {"x", "y"}) deal("ada", test);
    for (const char* test : {"x", "y", "own"}) deal("bob", test);
    EXPECT_EQ(merge().status, 0);
}

TEST_F(MergedShards, WithTestsThatWereNotRunAreNotComplete) {
    second_.results[2].outcome = Outcome::not_run;
    EXPECT_EQ(merge().status, 2);
    EXPECT_TRUE(place_.has("whole/results.json"));
}

}  // namespace
}  // namespace rt::merge_test
