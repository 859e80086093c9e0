#include "core/function.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/integer.h"

namespace rt {

namespace {

using Op = Function::Op;

bool holds(double x) { return x != 0.0; }

double binary(Op op, double a, double b) {
    switch (op) {
        case Op::add:
            return a + b;
        case Op::subtract:
            return a - b;
        case Op::multiply:
            return a * b;
        case Op::divide:
            return a / b;
        case Op::less:
            return a < b ? 1.0 : 0.0;
        case Op::greater:
            return a > b ? 1.0 : 0.0;
        case Op::not_greater:
            return a <= b ? 1.0 : 0.0;
        case Op::not_less:
            return a >= b ? 1.0 : 0.0;
        case Op::equal:
            return a == b ? 1.0 : 0.0;
        case Op::unequal:
            return a != b ? 1.0 : 0.0;
        case Op::both:
            return holds(a) && holds(b) ? 1.0 : 0.0;
        case Op::either:
            return holds(a) || holds(b) ? 1.0 : 0.0;
        case Op::atan2:
            return std::atan2(a, b);
        case Op::div:
            return to_int(a / b);
        case Op::mod:
            return std::fmod(a, b);
        case Op::pow:
            return std::pow(a, b);
        case Op::min:
            return std::min(a, b);
        default:
            return std::max(a, b);
    }
}

double unary(Op op, double x) {
    switch (op) {
        case Op::negate:
            return -x;
        case Op::abs:
            return std::fabs(x);
        case Op::acos:
            return std::acos(x);
        case Op::acosh:
            return std::acosh(x);
        case Op::asin:
            return std::asin(x);
        case Op::asinh:
            return std::asinh(x);
        case Op::atan:
            return std::atan(x);
        case Op::atanh:
            return std::atanh(x);
        case Op::ceil:
            return std::ceil(x);
        case Op::cos:
            return std::cos(x);
        case Op::cosh:
            return std::cosh(x);
        case Op::degrees:
            return x * (180.0 / std::numbers::pi);
        case Op::exp:
            return std::exp(x);
        case Op::floor:
            return std::floor(x);
        case Op::integer:
            return to_int(x);
        case Op::ln:
            return std::log(x);
        case Op::log:
            return std::log10(x);
        case Op::radians:
            return x * (std::numbers::pi / 180.0);
        case Op::sin:
            return std::sin(x);
        case Op::sinh:
            return std::sinh(x);
        case Op::sqrt:
            return std::sqrt(x);
        case Op::tan:
            return std::tan(x);
        default:
            return std::tanh(x);
    }
}

struct BuiltIn {
    int number;
    std::size_t parameters;
    double (*value)(std::span<const double> a);
};

double torus_distance(std::span<const double> a) { return std::hypot(std::hypot(a[0], a[2]) - a[3], a[1]) - a[4]; }

/// A box of half the size (b, c, d) less its radius; the outside of a ball of that radius moved in it.
double rounded_box(std::span<const double> a) {
    const double radius = a[3];
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double beyond = std::max(std::fabs(a[i]) - (a[4 + i] - radius), 0.0);
        squares += beyond * beyond;
    }
    return std::sqrt(squares) - radius - 1e-6;
}

double superellipsoid(std::span<const double> a) {
    const double east = a[3], north = a[4];
    const double round = std::pow(std::pow(std::fabs(a[0]), 2.0 / east) + std::pow(std::fabs(a[1]), 2.0 / east), east / north);
    return 1.0 - std::pow(round + std::pow(std::fabs(a[2]), 2.0 / north), north / 2.0);
}

constexpr BuiltIn built_ins[] = {
    {17, 6, [](std::span<const double> a) { return std::hypot(a[3] * a[0], a[4] * a[1], a[5] * a[2]); }},
    {45, 4, [](std::span<const double> a) { return std::clamp(-a[3] * (a[0] * a[0] - a[1] + a[2] * a[2]), -10.0, 10.0); }},
    {47, 3, [](std::span<const double> a) { return std::atan2(std::hypot(a[0], a[2]), a[1]); }},
    {57, 3, [](std::span<const double> a) { return std::hypot(a[0], a[1], a[2]); }},
    {60, 7, rounded_box},
    {61, 4, [](std::span<const double> a) { return std::hypot(a[0], a[1], a[2]) - a[3]; }},
    {68, 5, superellipsoid},
    {69, 3, [](std::span<const double> a) { return std::atan2(a[0], a[2]); }},
    {70, 5, torus_distance},
};

const BuiltIn* find_built_in(int number) {
    const auto found = std::find_if(std::begin(built_ins), std::end(built_ins), [number](const BuiltIn& b) { return b.number == number; });
    return found == std::end(built_ins) ? nullptr : found;
}

/// One call of one function.
class Run {
public:
    Run(const Function& function, std::span<const double> arguments, std::uint64_t& steps_left)
        : function_(function), values_(arguments.begin(), arguments.end()), steps_left_(steps_left) {
        values_.resize(function.parameters + function.counters);
        stack_.reserve(function.stack);
    }

    /// Takes the steps [begin, end) and leaves their value on the stack; false if there were too many.
    bool steps(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (steps_left_ == 0) return false;
            --steps_left_;
            const Function::Step& step = function_.steps[i];
            if (step.op == Op::sum || step.op == Op::product) {
                if (!loop(step, i)) return false;
                i = step.index - 1;
            } else if (step.op == Op::call) {
                if (!call(*function_.called[step.index])) return false;
            } else if (step.op == Op::source) {
                ask(step);
            } else {
                simple(step);
            }
        }
        return true;
    }

    double pop() {
        const double top = stack_.back();
        stack_.pop_back();
        return top;
    }

private:
    void simple(const Function::Step& step) {
        if (step.op == Op::constant) {
            stack_.push_back(step.value);
        } else if (step.op == Op::argument) {
            stack_.push_back(values_[step.index]);
        } else if (step.op == Op::built_in) {
            stack_.push_back(find_built_in(static_cast<int>(step.index))->value(values_));
        } else if (step.op >= Op::select3) {
            const double d = step.op == Op::select4 ? pop() : 0.0;
            const double c = pop(), b = pop(), a = pop();
            stack_.push_back(a < 0.0 ? b : step.op == Op::select3 || a == 0.0 ? c : d);
        } else if (step.op >= Op::negate) {
            stack_.back() = unary(step.op, stack_.back());
        } else {
            const double b = pop();
            stack_.back() = binary(step.op, stack_.back(), b);
        }
    }

    bool call(const Function& called) {
        const std::size_t first = stack_.size() - called.parameters;
        const std::optional<double> value = evaluate(called, std::span(stack_).subspan(first), steps_left_);
        stack_.resize(first);
        stack_.push_back(value.value_or(0.0));
        return value.has_value();
    }

    void ask(const Function::Step& step) {
        const double z = pop(), y = pop(), x = pop();
        stack_.push_back(function_.sources[step.index]->values({x, y, z})[step.count]);
    }

    bool loop(const Function::Step& step, std::size_t at) {
        const double last = pop(), first = pop();
        double result = step.op == Op::sum ? 0.0 : 1.0;
        for (double counter = first; counter <= last; ++counter) {
            if (steps_left_ == 0) return false;
            --steps_left_;
            values_[step.count] = counter;
            if (!steps(at + 1, step.index)) return false;
            result = step.op == Op::sum ? result + pop() : result * pop();
        }
        stack_.push_back(result);
        return true;
    }

    const Function& function_;
    std::vector<double> values_;  ///< arguments, then counters
    std::vector<double> stack_;
    std::uint64_t& steps_left_;
};

}  // namespace

std::optional<double> evaluate(const Function& function, std::span<const double> arguments, std::uint64_t& steps_left) {
    Run run(function, arguments, steps_left);
    if (!run.steps(0, function.steps.size())) return std::nullopt;
    return run.pop();
}

std::size_t built_in_parameters(int number) {
    const BuiltIn* const found = find_built_in(number);
    return found ? found->parameters : 0;
}

}  // namespace rt
