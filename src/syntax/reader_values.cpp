// Values as blocks read them: whatever comes out is finite.
#include <fmt/format.h>

#include <cmath>

#include "syntax/expression.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

/// POV-Ray renders something with an infinite radius; nobody wants that picture.
void require_finite(Reader::State& state, const Span& first, double x) {
    if (!std::isfinite(x)) state.reader.fail(state.since(first), fmt::format("Expected 'finite number', {} found instead", x));
}

}  // namespace

double Reader::parse_float() {
    double x;
    if (state_->scan_plain({&x, 1}) != 0) return x;
    const Span first = peek().span;
    x = Expression(*state_).sum_float();
    require_finite(*state_, first, x);
    return x;
}

bool Reader::parse_bool_or(bool when_absent) { return at_expression() ? is_true(parse_float()) : when_absent; }

bool Reader::at_expression() {
    const Token& token = peek();
    switch (token.kind) {
        case Token::Kind::number:
            return true;
        case Token::Kind::identifier: {
            const Value* const value = next_value();
            if (!value) return false;
            const auto* const unmodelled = std::get_if<UnmodelledValue>(value);
            return std::holds_alternative<Number>(*value) || std::holds_alternative<FunctionValue>(*value) ||
                   (unmodelled && unmodelled->word == Word::function);
        }
        case Token::Kind::word: {
            const WordGroup group = group_of(token.word);
            return group == WordGroup::float_function || group == WordGroup::vector_function || token.is(Word::t) || token.is(Word::u) ||
                   token.is(Word::v);
        }
        case Token::Kind::symbol:
            return token.is('<') || token.is('(') || token.is('-') || token.is('+') || token.is('!');
        default:
            return false;
    }
}

Vec3 Reader::parse_vector() {
    Vec3 v;
    if (const std::size_t size = state_->scan_plain({&v.x, 3}); size != 0) return size == 1 ? Vec3(v.x) : v;
    const Span first = peek().span;
    v = Expression(*state_).sum_vector();
    for (int i = 0; i < 3; ++i) require_finite(*state_, first, v[i]);
    return v;
}

Vec2 Reader::parse_vector2() {
    Vec3 v;
    if (const std::size_t size = state_->scan_plain({&v.x, 2}); size != 0) return size == 1 ? Vec2(v.x) : Vec2(v);
    const Span first = peek().span;
    const Number n = Expression(*state_).sum();
    for (int i = 0; i < n.size; ++i) require_finite(*state_, first, n.v[i]);
    if (n.size == 1) return Vec2(n.v[0]);
    if (n.size > 2) fail(state_->since(first), "UV_Vector expected but vector or color expression found.");
    return {n.v[0], n.v[1]};
}

Number Reader::parse_condition() {
    Number n;
    if (const std::size_t size = state_->scan_plain(n.v, true); size != 0) {
        n.size = static_cast<int>(size);
        return n;
    }
    const Span first = peek().span;
    n = Expression(*state_).condition();
    for (int i = 0; i < n.size; ++i) require_finite(*state_, first, n.v[i]);
    return n;
}

void Reader::accept_comma() {
    Lexer& lexer = state_->frames.back().lexer;
    if (cursor_.has_ahead || !lexer.scan_comma())
        accept(',');
    else
        state_->step_over(lexer.position() - 1);
}

std::string Reader::parse_string() { return Expression(*state_).string(); }

/// Scans from the token that was looked at, if any: that is possible where it stands just before the lexer and began a literal.
std::size_t Reader::State::scan_plain(std::span<double> v, bool condition) {
    Lexer& lexer = frames.back().lexer;
    const std::uint32_t position = lexer.position();
    std::uint32_t begin = position;
    if (has_ahead) {
        const bool number = ahead.kind == Token::Kind::number;
        if (!(number || ahead.is('<') || ahead.is('-')) || ahead.span.file != lexer.file() || ahead.span.end != position) return 0;
        begin = ahead.span.begin;
        if (number) {
            if (!std::isfinite(ahead.number) || !lexer.at_expression_end(condition)) return 0;
            v[0] = ahead.number;
            step_over(begin);
            return 1;
        }
        lexer.seek(begin);
    }
    const std::size_t size = lexer.scan_plain_value(v, condition);
    if (size == 0) {
        lexer.seek(position);
        return 0;
    }
    step_over(begin);
    return size;
}

void Reader::State::step_over(std::uint32_t begin) {
    const Lexer& lexer = frames.back().lexer;
    has_ahead = false;
    last = {lexer.file(), begin, lexer.position()};
    last_word = Word::none;
    anything_read = true;
}

}  // namespace rt
