#include "core/function.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rt::function_test {
namespace {

using Op = Function::Op;

double value_of(const Function& f, std::vector<double> arguments) {
    std::uint64_t steps = 1000;
    return evaluate(f, arguments, steps).value();
}

/// x * x + 1
Function square_and_one() {
    Function f;
    f.parameters = 1;
    f.steps = {{.op = Op::argument}, {.op = Op::argument}, {.op = Op::multiply}, {.op = Op::constant, .value = 1.0}, {.op = Op::add}};
    f.stack = 2;
    return f;
}

TEST(Function, TakesItsStepsOnAStack) {
    EXPECT_EQ(value_of(square_and_one(), {3.0}), 10.0);
    Function caller;
    caller.parameters = 1;
    caller.called = {std::make_shared<const Function>(square_and_one())};
    caller.steps = {{.op = Op::constant, .value = 2.0}, {.op = Op::argument}, {.op = Op::call}, {.op = Op::subtract}};
    EXPECT_EQ(value_of(caller, {4.0}), 2.0 - 17.0);
}

TEST(Function, SumsOverItsCounter) {
    // sum(i, 1, x, i * i)
    Function f;
    f.parameters = 1;
    f.counters = 1;
    f.steps = {{.op = Op::constant, .value = 1.0},      {.op = Op::argument},
               {.op = Op::sum, .count = 1, .index = 6}, {.op = Op::argument, .index = 1},
               {.op = Op::argument, .index = 1},        {.op = Op::multiply}};
    EXPECT_EQ(value_of(f, {4.0}), 30.0);
    EXPECT_EQ(value_of(f, {0.0}), 0.0);
    f.steps[2].op = Op::product;
    EXPECT_EQ(value_of(f, {3.0}), 36.0);
    EXPECT_EQ(value_of(f, {0.0}), 1.0);
    std::uint64_t steps = 1'000'000;
    EXPECT_FALSE(evaluate(f, std::vector{1e300}, steps));
    EXPECT_EQ(steps, 0u);
}

/// The values of POV-Ray's built-in functions at P = <.37, -.81, 1.23>, by their formulas.
TEST(Function, BuiltInOnesAreTheirFormulas) {
    const double x = 0.37, y = -0.81, z = 1.23;
    const auto built_in = [&](int number, std::vector<double> more) {
        Function f;
        f.parameters = built_in_parameters(number);
        f.steps = {{.op = Op::built_in, .index = static_cast<std::uint32_t>(number)}};
        more.insert(more.begin(), {x, y, z});
        EXPECT_EQ(f.parameters, more.size());
        return value_of(f, more);
    };
    const double r = std::sqrt(x * x + y * y + z * z), flat = std::sqrt(x * x + z * z);
    EXPECT_DOUBLE_EQ(built_in(61, {1}), r - 1);
    EXPECT_DOUBLE_EQ(built_in(57, {}), r);
    EXPECT_DOUBLE_EQ(built_in(69, {}), std::atan2(x, z));
    EXPECT_DOUBLE_EQ(built_in(47, {}), std::atan2(flat, y));
    EXPECT_DOUBLE_EQ(built_in(17, {2, 3, 4}), std::sqrt(4 * x * x + 9 * y * y + 16 * z * z));
    EXPECT_DOUBLE_EQ(built_in(70, {1, 0.25}), std::sqrt((flat - 1) * (flat - 1) + y * y) - 0.25);
    EXPECT_DOUBLE_EQ(built_in(60, {0.1, 0.5, 0.5, 0.5}), std::sqrt((0.81 - 0.4) * (0.81 - 0.4) + (1.23 - 0.4) * (1.23 - 0.4)) - 0.1 - 1e-6);
    EXPECT_DOUBLE_EQ(built_in(68, {1, 1}), 1 - r);
    EXPECT_DOUBLE_EQ(built_in(45, {2}), -2 * (x * x - y + z * z));
    EXPECT_EQ(built_in(45, {-100}), 10.0);
    EXPECT_EQ(built_in_parameters(0), 0u);
    EXPECT_EQ(built_in_parameters(-1), 0u);
}

}  // namespace
}  // namespace rt::function_test
