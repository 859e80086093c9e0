// Patterns whose value is a function of what other patterns show.
#include <gtest/gtest.h>

#include "core/function.h"
#include "scene/function_source.h"
#include "tests/scene/checkers.h"
#include "world/compile_pigment.h"
#include "world/normal_node.h"

namespace rt::pattern_node_test {
namespace {

/// Value `count` of a source at (x, y, z).
Function asking(std::variant<Pigment, StatedPattern> what, std::uint32_t count) {
    Function function;
    function.parameters = 3;
    for (std::uint32_t i = 0; i < 3; ++i) function.steps.push_back({.op = Function::Op::argument, .index = i});
    function.steps.push_back({.op = Function::Op::source, .count = count});
    function.stack = 3, function.source_nodes = 1;
    function.sources.push_back(std::make_shared<const StatedSource>(std::move(what)));
    return function;
}

double value(const Function& stated, const Vec3& at) {
    const auto function = compile_function(std::make_shared<const Function>(stated), {});
    std::uint64_t steps = 100;
    const std::array<double, 3> arguments{at.x, at.y, at.z};
    return evaluate(*function, arguments, steps).value();
}

TEST(ObjectPatterns, ShareWhatAnswersForTheirBodies) {
    StatedPattern stated;
    stated.pattern = make_pattern(PatternKind::object);
    stated.source = Shared<Bodies>(Bodies{});
    StatedPattern other = stated;
    other.source = Shared<Bodies>(Bodies{});
    const PatternDefaults defaults;
    const auto first = compile_pattern(stated, defaults, false).bodies;
    EXPECT_EQ(compile_pattern(stated, defaults, false).bodies, first);
    EXPECT_NE(compile_pattern(other, defaults, false).bodies, first);
}

TEST(FunctionSources, APigmentTellsEachPartOfItsColour) {
    Pigment a, b;
    a.content = PigmentColor{Rgb(0.125, 0.25, 0.5), 0.75, 0.0625};
    b.content = PigmentColor{Rgb(1.0), 0.0, 0.0};
    const Pigment cells = checker_of(a, b);
    const double expected[] = {0.125, 0.25, 0.5, 0.75, 0.0625, 0.297 * 0.125 + 0.589 * 0.25 + 0.114 * 0.5};
    for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(value(asking(cells, i), {0.5, 0.5, 0.5}), expected[i]) << i;
    EXPECT_EQ(value(asking(cells, 0), {1.5, 0.5, 0.5}), 1.0);
}

TEST(FunctionSources, APatternTellsItsValue) {
    StatedPattern gradient;
    gradient.pattern = make_pattern(PatternKind::gradient);
    gradient.pattern.warps.emplace_back(Transform::scale(Vec3(4.0)));
    EXPECT_NEAR(value(asking(gradient, 0), {1.0, 0.0, 0.0}), 0.25, 1e-12);
}

/// Cells 1 and 2 of `square` meet at x = 1 above z = 1; as waves the two numbers would be one.
TEST(CellNormals, StepFromNumberToNumber) {
    NormalNode node;
    node.pattern.pattern = make_pattern(PatternKind::square);
    node.bump.amount = 1.0F;
    const Vec3 up(0.0, 1.0, 0.0);
    EXPECT_GT(length(turned(node, up, {1.0, 0.0, 1.5}, {}) - up), 0.5);
    EXPECT_LT(length(turned(node, up, {1.5, 0.0, 1.5}, {}) - up), 1e-7);
}

TEST(FunctionSources, WhatIsCalledTwiceIsCompiledOnce) {
    const auto inner = std::make_shared<const Function>(asking(Pigment{}, 0));
    Function outer;
    outer.called = {inner, inner};
    outer.source_nodes = 2;
    const auto compiled = compile_function(std::make_shared<const Function>(outer), {});
    EXPECT_EQ(compiled->called[0], compiled->called[1]);
    EXPECT_NE(compiled->called[0], inner);
    const auto plain = std::make_shared<const Function>();
    EXPECT_EQ(compile_function(plain, {}), plain) << "nothing to do";
}

TEST(ObjectPattern, IsOneInsideAndZeroOutside) {
    Object ball;
    ball.shape = Sphere{Vec3(0.0), 1.0};
    StatedPattern pattern;
    pattern.pattern = make_pattern(PatternKind::object);
    pattern.pattern.warps.emplace_back(Transform::scale(Vec3(2.0)));
    pattern.source = Shared<Bodies>(Bodies{{ball}, {}});
    EXPECT_EQ(value(asking(pattern, 0), {1.5, 0.0, 0.0}), 1.0);
    EXPECT_EQ(value(asking(pattern, 0), {2.5, 0.0, 0.0}), 0.0);
    pattern.pattern.frequency = 0.75F;
    EXPECT_EQ(value(asking(pattern, 0), {1.5, 0.0, 0.0}), 0.75) << "a value as others are";
}

}  // namespace
}  // namespace rt::pattern_node_test
