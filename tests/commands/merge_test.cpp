// Shards that are read and joined: what is not all of one grading is refused and named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "commands/grade_reports.h"
#include "commands/json_value.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt {
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

}  // namespace
}  // namespace rt
