#include "syntax/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "syntax/word_groups.h"

namespace rt {

namespace {

template <typename Operation>
Number combine(const Number& a, const Number& b, Operation operation) {
    Number result;
    result.size = std::max(a.size, b.size);
    result.color = a.color || b.color;
    const auto at = [](const Number& n, int i) { return n.size == 1 ? n.v[0] : i < n.size ? n.v[i] : 0.0; };
    for (int i = 0; i < result.size; ++i) result.v[i] = operation(at(a, i), at(b, i));
    return result;
}

bool is_relation(const Token& t) { return t.is('<') || t.is('>') || t.is('=') || t.is('L') || t.is('G') || t.is('N'); }

/// < and > are exact, the others allow for `epsilon`, as measured on POV-Ray.
bool holds(char relation, double a, double b) {
    switch (relation) {
        case '<':
            return a < b;
        case '>':
            return a > b;
        case 'L':
            return a <= b + epsilon;
        case 'G':
            return a >= b - epsilon;
        case '=':
            return std::fabs(a - b) <= epsilon || a == b;
        default:
            return !(std::fabs(a - b) <= epsilon || a == b);
    }
}

Number number(double x) { return {{x}, 1, false}; }

}  // namespace

std::optional<int> component_index(Word w) {
    switch (w) {
        case Word::x:
        case Word::u:
        case Word::red:
            return 0;
        case Word::y:
        case Word::v:
        case Word::green:
            return 1;
        case Word::z:
        case Word::blue:
            return 2;
        case Word::t:
        case Word::filter:
            return 3;
        case Word::transmit:
            return 4;
        case Word::gray:
            return -1;
        default:
            return std::nullopt;
    }
}

bool is_true(double x) { return !(std::fabs(x) <= epsilon); }

Number Expression::condition() {
    const Span first = reader_.peek().span;
    const Number test = junction();
    if (!reader_.accept('?')) return test;
    const NestingGuard guard(state_, first);
    const bool chosen = is_true(to_float(test, first));
    const Number a = condition();
    reader_.expect(':');
    const Number b = condition();
    return chosen ? a : b;
}

double Expression::condition_float() {
    const Span first = reader_.peek().span;
    return to_float(condition(), first);
}

Number Expression::junction() {
    Number left = relation();
    while (reader_.peek().is('&') || reader_.peek().is('|')) {
        const bool both = reader_.take().is('&');
        left = combine(left, relation(),
                       [both](double a, double b) { return (both ? is_true(a) && is_true(b) : is_true(a) || is_true(b)) ? 1.0 : 0.0; });
    }
    return left;
}

Number Expression::relation() {
    if (at_string(reader_)) return string_relation();
    Number left = sum();
    while (is_relation(reader_.peek())) {
        const char symbol = reader_.take().symbol;
        left = combine(left, sum(), [symbol](double a, double b) { return holds(symbol, a, b) ? 1.0 : 0.0; });
    }
    return left;
}

Number Expression::string_relation() {
    const std::string a = reader_.parse_string();
    if (!is_relation(reader_.peek())) reader_.fail_expected("string comparison operator");
    const char symbol = reader_.take().symbol;
    const int order = a.compare(reader_.parse_string());
    return number(holds(symbol, order, 0.0) ? 1.0 : 0.0);
}

Number Expression::sum() {
    Number left = product();
    while (reader_.peek().is('+') || reader_.peek().is('-')) {
        if (reader_.take().is('+'))
            left = combine(left, product(), [](double a, double b) { return a + b; });
        else
            left = combine(left, product(), [](double a, double b) { return a - b; });
    }
    return left;
}

double Expression::sum_float() {
    const Span first = reader_.peek().span;
    return to_float(sum(), first);
}

Vec3 Expression::sum_vector() {
    const Span first = reader_.peek().span;
    const Number n = sum();
    if (n.size == 1) return Vec3(n.v[0]);
    if (n.size > 3) reader_.fail(state_.since(first), "Vector expected but color expression found.");
    return {n.v[0], n.v[1], n.v[2]};
}

double Expression::to_float(const Number& n, const Span& first) {
    if (n.size != 1) reader_.fail(state_.since(first), "Float expected but vector or color expression found.");
    return n.v[0];
}

Number Expression::product() {
    const Span first = reader_.peek().span;
    Number left = unary();
    while (reader_.peek().is('*') || reader_.peek().is('/')) {
        if (reader_.take().is('*')) {
            left = combine(left, unary(), [](double a, double b) { return a * b; });
        } else {
            const Number right = unary();
            left = divide(left, right, state_.since(first));
        }
    }
    return left;
}

/// Division by zero is a warning; POV-Ray's quotient is plus infinity whatever the numerator.
Number Expression::divide(Number a, const Number& b, const Span& place) {
    return combine(a, b, [&](double numerator, double denominator) {
        if (denominator != 0.0) return numerator / denominator;
        reader_.warn(place, "Divide by zero.");
        return infinity;
    });
}

Number Expression::unary() {
    std::string signs;
    while (reader_.peek().is('-') || reader_.peek().is('+') || reader_.peek().is('!')) signs += reader_.take().symbol;
    const Span first = reader_.peek().span;
    Number n = primary();
    if (reader_.accept('.')) n = component(n, first);
    for (; !signs.empty(); signs.pop_back()) {
        for (int i = 0; i < n.size; ++i) {
            if (signs.back() == '-') n.v[i] = -n.v[i];
            if (signs.back() == '!') n.v[i] = is_true(n.v[i]) ? 0.0 : 1.0;
        }
    }
    return n;
}

Number Expression::component(const Number& whole, const Span& place) {
    const Token& token = reader_.peek();
    const std::optional<int> index = token.kind == Token::Kind::word ? component_index(token.word) : std::nullopt;
    if (!index) reader_.fail_expected("x, y, z or color component");
    reader_.take();
    if (*index >= whole.size || (*index < 0 && whole.size < 3)) reader_.fail(state_.since(place), "Bad operands for period operator.");
    return number(*index < 0 ? grey({whole.v[0], whole.v[1], whole.v[2]}) : whole.v[*index]);
}

Number Expression::primary() {
    const Token& token = reader_.peek();
    if (token.kind == Token::Kind::number) return number(reader_.take().number);
    if (token.kind == Token::Kind::identifier) return identifier();
    if (token.is('<')) return vector_literal();
    if (token.is('(')) {
        const NestingGuard guard(state_, reader_.take().span);
        const Number inner = condition();
        reader_.expect(')');
        return inner;
    }
    if (!reader_.at_expression()) reader_.fail_expected("numeric expression");
    return word(token.word);
}

Number Expression::identifier() {
    if (const Number* declared = reader_.accept_declared<Number>()) return *declared;
    if (reader_.at_expression()) return call();
    reader_.fail_expected("numeric expression");
}

/// Two to five floats; commas are optional, also after the last one.
Number Expression::vector_literal() {
    const NestingGuard guard(state_, reader_.take().span);
    Number result;
    result.v[0] = sum_float();
    reader_.accept_comma();
    result.v[1] = sum_float();
    for (result.size = 2; result.size < 5; ++result.size) {
        reader_.accept_comma();
        if (!reader_.at_expression()) break;
        result.v[result.size] = sum_float();
    }
    if (result.size < 5 || !reader_.peek().is(',')) {
        reader_.expect('>');
        return result;
    }
    reader_.fail_expected(">");
}

}  // namespace rt
