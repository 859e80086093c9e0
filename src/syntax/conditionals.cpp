// #if, #ifdef, #ifndef, #elseif, #else, #end.
#include <fmt/format.h>

#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

bool opens_level(Word w) {
    return w == Word::if_ || w == Word::ifdef || w == Word::ifndef || w == Word::while_ || w == Word::for_ || w == Word::switch_ ||
           w == Word::macro;
}

}  // namespace

void Reader::State::begin_conditional(const Span& place, Word w) {
    const bool taken = condition(w);
    conditionals.push_back({.place = place, .taken = taken});
    if (!taken) skip_branches();
}

/// What stands in parentheses after `#if`, `#elseif`, `#while`, `#ifdef` or `#ifndef`. Nothing beyond the ')' is read.
bool Reader::State::condition(Word w) {
    const std::size_t frame_count = frames.size();
    reader.expect('(');
    const NestingGuard guard(*this, last);
    bool holds;
    if (w == Word::ifdef || w == Word::ifndef) {
        holds = is_declared(take_name()) == (w == Word::ifdef);
    } else {
        holds = is_true(Expression(*this).condition_float());
    }
    reader.expect(')');
    require_same_text(last, frame_count, conditionals.size());
    return holds;
}

/// Whether `name`, which was just taken, stands for something; so does an array's element that was set.
bool Reader::State::is_declared(const Token& name) {
    if (name.kind != Token::Kind::identifier) return false;
    VariablePtr variable = names.find(name.text);
    if (variable && std::holds_alternative<ArrayValue>(variable->value)) variable = parse_subscripts(std::move(variable));
    return variable != nullptr;
}

void Reader::State::else_branch(Word w, const Span& place) {
    using Kind = Conditional::Kind;
    if (!may_close() || conditionals.back().else_seen) reader.fail(place, fmt::format("Mis-matched '#{}'.", text(w)));
    if (conditionals.back().kind == Kind::branch) return skip_branches();
    if (conditionals.back().kind != Kind::choice || w != Word::else_) reader.fail(place, fmt::format("Mis-matched '#{}'.", text(w)));
    conditionals.back().else_seen = true;
}

void Reader::State::end_conditional(const Span& place) {
    if (!may_close()) reader.fail(place, "Mis-matched '#end'.");
    switch (conditionals.back().kind) {
        case Conditional::Kind::while_loop:
            return repeat_while();
        case Conditional::Kind::for_loop:
            return repeat_for();
        case Conditional::Kind::branch:
        case Conditional::Kind::choice:
            return conditionals.pop_back();
    }
}

/// Skips the branch that begins here, and the next ones up to one that is to be read or the end.
void Reader::State::skip_branches() {
    const std::size_t open = conditionals.size();
    for (;;) {
        Span hash;
        const Word stop = skip_until(conditionals.back().place, Stops::branches, hash);
        if (stop == Word::end) return conditionals.pop_back();
        if (conditionals.back().taken) continue;
        const bool taken = stop == Word::else_ || condition(stop);
        if (conditionals.size() != open) reader.fail(hash, "Mis-matched '#end'.");  // opened or closed inside the condition
        conditionals.back().else_seen = stop == Word::else_;
        conditionals.back().taken = taken;
        if (taken) return;
    }
}

Word Reader::State::skip_until(const Span& open, Stops stops, Span& hash) {
    const auto is_stop = [stops](const Token& token) {
        switch (token.word) {
            case Word::end:
                return true;
            case Word::else_:
                return stops != Stops::end_only;
            case Word::elseif:
                return stops == Stops::branches;
            case Word::case_:
            case Word::range:
                return stops == Stops::cases;
            default:
                return false;
        }
    };
    Token token;
    for (std::size_t depth = 0;;) {
        next_raw(token);
        if (token.kind == Token::Kind::end) reader.fail(open, "End of file reached but #end expected.");
        if (!token.is('#')) continue;
        while (token.is('#')) {
            hash = token.span;
            next_raw(token);
        }
        if (token.kind != Token::Kind::word) continue;
        if (opens_level(token.word))
            ++depth;
        else if (depth == 0 && is_stop(token))
            return token.word;
        else if (token.is(Word::end))
            --depth;
    }
}

}  // namespace rt
