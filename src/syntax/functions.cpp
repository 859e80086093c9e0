// Constants and functions of numeric expressions.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/integer.h"
#include "syntax/expression.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

std::uint32_t bits(double x) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(to_int(x))); }

double from_bits(std::uint32_t b) { return static_cast<std::int32_t>(b); }

/// Rodrigues' formula.
Vec3 rotate_about(const Vec3& p, const Vec3& axis, double degrees) {
    const Vec3 k = unit(axis);
    const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return p * c + cross(k, p) * s + k * (dot(k, p) * (1.0 - c));
}

/// Days since the first of January 2000, UTC.
double days_of_now() {
    using namespace std::chrono;
    constexpr sys_days epoch = year{2000} / January / 1;
    return duration<double, days::period>(system_clock::now() - epoch).count();
}

}  // namespace

/// Reads a word that begins a numeric expression, with its arguments.
Number Expression::word(Word w) {
    const Span place = reader_.take().span;
    if (const auto value = constant(w)) return *value;
    const NestingGuard guard(state_, place);
    if (w == Word::defined) return number(is_defined() ? 1.0 : 0.0);
    reader_.expect('(');
    Number result;
    if (w == Word::select)
        result = select();
    else if (const auto f = function_of_float(w, place))
        result = number(*f);
    else if (const auto ff = function_of_floats(w, place))
        result = number(*ff);
    else if (const auto fs = function_of_strings(w))
        result = number(*fs);
    else if (const auto fv = function_of_vectors(w))
        result = number(*fv);
    else if (const auto v = vector_function(w, place))
        result = vector_of(*v);
    else if (w == Word::dimensions || w == Word::dimension_size)
        result = number(array_function(w));
    else if (const auto about = function_of_object(w, place))
        result = *about;
    else
        return unmodelled_function(w, place);
    reader_.expect(')');
    return result;
}

std::optional<Number> Expression::constant(Word w) {
    switch (w) {
        case Word::true_:
        case Word::yes:
        case Word::on:
            return number(1.0);
        case Word::false_:
        case Word::no:
        case Word::off:
            return number(0.0);
        case Word::clock_on:
            return number(state_.options.frame.clock_on ? 1.0 : 0.0);
        case Word::pi:
            return number(pi);
        case Word::clock:
            return number(state_.options.clock);
        case Word::version:
            return number(state_.version);
        case Word::now:
            return number(days_of_now());
        case Word::x:
            return Number{{1, 0, 0}, 3, false};
        case Word::y:
            return Number{{0, 1, 0}, 3, false};
        case Word::z:
            return Number{{0, 0, 1}, 3, false};
        case Word::t:
            return Number{{0, 0, 0, 1}, 4, false};
        case Word::u:
            return Number{{1, 0}, 2, false};
        case Word::v:
            return Number{{0, 1}, 2, false};
        default:
            return std::nullopt;
    }
}

std::optional<double> Expression::function_of_float(Word w, const Span& place) {
    switch (w) {
        case Word::abs:
        case Word::acos:
        case Word::acosh:
        case Word::asin:
        case Word::asinh:
        case Word::atan:
        case Word::atanh:
        case Word::ceil:
        case Word::cos:
        case Word::cosh:
        case Word::degrees:
        case Word::exp:
        case Word::floor:
        case Word::int_:
        case Word::ln:
        case Word::log:
        case Word::radians:
        case Word::sin:
        case Word::sinh:
        case Word::sqrt:
        case Word::tan:
        case Word::tanh: {
            const double x = condition_float();
            return evaluate(w, x, state_.since(place));
        }
        default:
            return std::nullopt;
    }
}

double Expression::evaluate(Word w, double x, const Span& place) {
    if ((w == Word::acos || w == Word::asin) && std::fabs(x) > 1.0) {
        reader_.warn(place, fmt::format("Domain error in {}.", text(w)));
        x = std::clamp(x, -1.0, 1.0);
    }
    if (((w == Word::ln || w == Word::log) && x <= 0.0) || (w == Word::sqrt && x < 0.0))
        reader_.fail(place, fmt::format("{} of negative number {:f}", text(w), x));
    switch (w) {
        case Word::abs:
            return std::fabs(x);
        case Word::acos:
            return std::acos(x);
        case Word::acosh:
            return std::acosh(x);
        case Word::asin:
            return std::asin(x);
        case Word::asinh:
            return std::asinh(x);
        case Word::atan:
            return std::atan(x);
        case Word::atanh:
            return std::atanh(x);
        case Word::ceil:
            return std::ceil(x);
        case Word::cos:
            return std::cos(x);
        case Word::cosh:
            return std::cosh(x);
        case Word::degrees:
            return x * (180.0 / pi);
        case Word::exp:
            return std::exp(x);
        case Word::floor:
            return std::floor(x);
        case Word::int_:
            return to_int(x);
        case Word::ln:
            return std::log(x);
        case Word::log:
            return std::log10(x);
        case Word::radians:
            return radians(x);
        case Word::sin:
            return std::sin(x);
        case Word::sinh:
            return std::sinh(x);
        case Word::sqrt:
            return std::sqrt(x);
        case Word::tan:
            return std::tan(x);
        default:
            return std::tanh(x);
    }
}

std::optional<double> Expression::function_of_floats(Word w, const Span& place) {
    switch (w) {
        case Word::atan2: {
            const double y = sum_float(), x = next_float();
            if (x == 0.0 && y == 0.0) reader_.fail(state_.since(place), "Domain error in atan2!");
            return std::atan2(y, x);
        }
        case Word::div: {
            const double a = sum_float(), b = next_float();
            return to_int(a / b);
        }
        case Word::mod: {
            const double a = sum_float(), b = next_float();
            return std::fmod(a, b);
        }
        case Word::pow: {
            const double a = sum_float(), b = next_float();
            if (a == 0.0 && b == 0.0) reader_.fail(state_.since(place), "Domain error.");
            return std::pow(a, b);
        }
        case Word::min:
        case Word::max:
        case Word::bitwise_and:
        case Word::bitwise_or:
        case Word::bitwise_xor:
            return extreme(w);
        case Word::seed:
            return new_random_stream();
        case Word::rand:
            return random_number(place);
        default:
            return std::nullopt;
    }
}

/// Functions of any number of floats, which are combined one after the other.
double Expression::extreme(Word w) {
    double result = sum_float();
    while (reader_.accept(',')) {
        const double x = sum_float();
        if (w == Word::min)
            result = std::min(result, x);
        else if (w == Word::max)
            result = std::max(result, x);
        else if (w == Word::bitwise_and)
            result = from_bits(bits(result) & bits(x));
        else if (w == Word::bitwise_or)
            result = from_bits(bits(result) | bits(x));
        else
            result = from_bits(bits(result) ^ bits(x));
    }
    return result;
}

/// select(A, B, C) is A < 0 ? B : C; with a fourth value that one stands for A > 0 and C for A = 0.
Number Expression::select() {
    const double a = sum_float();
    const double b = next_float();
    const double c = next_float();
    reader_.accept_comma();
    const double d = reader_.at_expression() ? sum_float() : c;
    return number(a < 0.0 ? b : a > 0.0 ? d : c);
}

double Expression::new_random_stream() {
    state_.random_streams.push_back(bits(sum_float()));
    return static_cast<double>(state_.random_streams.size() - 1);
}

/// The linear congruential generator of POV-Ray's scenes.
double Expression::random_number(const Span& place) {
    const double stream = sum_float();
    if (!(stream >= 0.0 && stream < static_cast<double>(state_.random_streams.size())))
        reader_.fail(state_.since(place), "Illegal random number generator.");
    std::uint32_t& s = state_.random_streams[static_cast<std::size_t>(stream)];
    s = 1812433253u * s + 12345u;
    return s / 4294967295.0;
}

/// `defined(NAME)`: reserved words and literals are not.
bool Expression::is_defined() {
    reader_.expect('(');
    const Token name = state_.take_name();
    const bool defined = state_.is_declared(name);
    reader_.expect(')');
    return defined;
}

std::optional<double> Expression::function_of_vectors(Word w) {
    switch (w) {
        case Word::vlength:
            return length(sum_vector());
        case Word::vdot: {
            const Vec3 a = sum_vector(), b = next_vector();
            return dot(a, b);
        }
        default:
            return std::nullopt;
    }
}

std::optional<Vec3> Expression::vector_function(Word w, const Span& place) {
    switch (w) {
        case Word::vcross: {
            const Vec3 a = sum_vector(), b = next_vector();
            return cross(a, b);
        }
        case Word::vnormalize: {
            const Vec3 a = sum_vector();
            if (length(a) != 0.0) return unit(a);
            reader_.warn_possible(state_.since(place), "Normalizing zero-length vector.");
            return a;
        }
        case Word::vrotate: {
            const Vec3 a = sum_vector(), degrees = next_vector();
            return Transform::rotate(degrees, Rotation::povray).direction(a);
        }
        case Word::vaxis_rotate: {
            const Vec3 a = sum_vector(), axis = next_vector();
            return rotate_about(a, axis, next_float());
        }
        default:
            return std::nullopt;
    }
}

/// dimensions(Array), dimension_size(Array, dimension from 1).
double Expression::array_function(Word w) {
    const ArrayValue* const array = reader_.accept_declared<ArrayValue>();
    if (!array) reader_.fail_expected("array identifier");
    const std::vector<std::size_t> sizes = array->sizes;
    if (w == Word::dimensions) return static_cast<double>(sizes.size());
    const double dimension = std::trunc(next_float());
    if (!(dimension >= 1.0 && dimension <= static_cast<double>(sizes.size()))) return 0.0;
    return static_cast<double>(sizes[static_cast<std::size_t>(dimension) - 1]);
}

/// A call of a declared function that is not modelled.
Number Expression::unmodelled_call() {
    reader_.accept_declared<UnmodelledValue>();
    reader_.expect('(');
    skip_arguments(reader_);
    return number(0.0);
}

/// Functions of noise, and of objects where nobody answers for them; their '(' is taken.
Number Expression::unmodelled_function(Word w, const Span& place) {
    reader_.unmodelled(place, text(w));
    skip_arguments(reader_);
    return w == Word::vturbulence || w == Word::trace ? vector_of(Vec3(0.0)) : number(0.0);
}

double Expression::next_float() {
    reader_.accept_comma();
    return sum_float();
}

Vec3 Expression::next_vector() {
    reader_.accept_comma();
    return sum_vector();
}

}  // namespace rt
