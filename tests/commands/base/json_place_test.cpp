// Where a value of a JSON text stands.
#include "commands/base/json_place.h"

#include <gtest/gtest.h>

#include <vector>

namespace rt::json_place_test {
namespace {

char at(std::string_view json, const std::vector<std::string>& path) { return json[place_in_json(json, path)]; }

TEST(JsonPlace, IsWhereTheValueBegins) {
    const std::string_view json = R"( { "a" : [10, [2, {"b": "}]\"," }], 3 ], "c\\": {}, "d": { "a": [], "e": 4.5 } } )";
    EXPECT_EQ(at(json, {}), '{');
    EXPECT_EQ(at(json, {"a"}), '[');
    EXPECT_EQ(at(json, {"a", "0"}), '1');
    EXPECT_EQ(at(json, {"a", "1", "0"}), '2');
    EXPECT_EQ(at(json, {"a", "1", "1", "b"}), '"');
    EXPECT_EQ(at(json, {"a", "2"}), '3');
    EXPECT_EQ(at(json, {"d", "e"}), '4');
    EXPECT_EQ(place_in_json(json, std::vector<std::string>{"d", "a"}), json.rfind("[]"));
    EXPECT_EQ(place_in_json(json, std::vector<std::string>{"e"}), json.size());
    EXPECT_EQ(place_in_json("{\"a\": 1, \"a\": [2]}", std::vector<std::string>{"a", "0", "b"}), 18u);
    EXPECT_EQ(place_in_json("3", std::vector<std::string>{"a"}), 1u);
}

}  // namespace
}  // namespace rt::json_place_test
