// A function of floats that a scene declares: its expression as steps of a stack machine.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/vec.h"

namespace rt {

/// What functions ask that is no arithmetic: a pigment's colour or a pattern's value at a point.
class FunctionSource {
public:
    virtual ~FunctionSource() = default;
    /// Red, green, blue, filter, transmit and grey; of a pattern its value comes first.
    virtual std::array<double, 6> values(const Vec3& point) const = 0;
};

struct Function {
    enum class Op : std::uint8_t {
        constant,  ///< pushes `value`
        argument,  ///< pushes the argument `index`, or a counter of sum or product, which come behind the arguments
        call,      ///< of `called[index]`, with as many arguments as it has
        sum,       ///< over the steps up to `index`, for counters between two bounds, both included; `count` is the counter's place
        product,   ///< likewise
        built_in,  ///< one that POV-Ray has by its number `index`; all arguments
        source,    ///< takes x, y and z; pushes value `count` of `sources[index]`
        // of two operands
        add,
        subtract,
        multiply,
        divide,
        less,
        greater,
        not_greater,
        not_less,
        equal,
        unequal,
        both,
        either,
        atan2,
        div,
        mod,
        pow,
        min,
        max,
        // of one operand
        negate,
        abs,
        acos,
        acosh,
        asin,
        asinh,
        atan,
        atanh,
        ceil,
        cos,
        cosh,
        degrees,
        exp,
        floor,
        integer,
        ln,
        log,
        radians,
        sin,
        sinh,
        sqrt,
        tan,
        tanh,
        // of more
        select3,  ///< of a, b, c: a < 0 ? b : c
        select4,  ///< of a, b, c, d: a < 0 ? b : a = 0 ? c : d
    };
    struct Step {
        Op op = Op::constant;
        std::uint32_t count = 0;
        std::uint32_t index = 0;
        double value = 0.0;
    };

    std::vector<Step> steps;
    std::size_t parameters = 0;
    std::size_t counters = 0;  ///< of sums and products
    std::size_t stack = 0;     ///< the most values that its steps hold at once
    std::size_t depth = 1;     ///< of functions that call functions
    std::vector<std::shared_ptr<const Function>> called;
    std::vector<std::shared_ptr<const FunctionSource>> sources;
    /// Of the pigments and patterns that it asks, those that they and functions that it calls ask included: as TreeSize has them.
    std::size_t source_nodes = 0, source_depth = 0;
};

/// The value at `arguments`, as many as there are parameters. Domain errors make infinities and NaN. Each step is taken off `steps_left`;
/// empty when there are no more.
std::optional<double> evaluate(const Function& function, std::span<const double> arguments, std::uint64_t& steps_left);

/// How many arguments the built-in function of that number takes, 0 if there is no such or it is not modelled.
std::size_t built_in_parameters(int number);

}  // namespace rt
