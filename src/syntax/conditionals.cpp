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
    conditionals.push_back({place, taken, false});
    if (!taken) skip_branches();
}

/// What stands in parentheses after `#if`, `#elseif`, `#ifdef` or `#ifndef`. Nothing beyond the ')' is read.
bool Reader::State::condition(Word w) {
    reader.expect('(');
    bool holds;
    if (w == Word::if_ || w == Word::elseif) {
        holds = is_true(Expression(*this).condition_float());
    } else {
        const Token name = take_name();
        const bool defined = name.kind == Token::Kind::identifier && reader.find(name.text);
        holds = defined == (w == Word::ifdef);
    }
    reader.expect(')');
    return holds;
}

void Reader::State::else_branch(Word w, const Span& place) {
    if (conditionals.size() == frames.back().conditionals || conditionals.back().else_seen)
        reader.fail(place, fmt::format("Mis-matched '#{}'.", text(w)));
    skip_branches();
}

void Reader::State::end_conditional(const Span& place) {
    if (conditionals.size() == frames.back().conditionals) reader.fail(place, "Mis-matched '#end'.");
    conditionals.pop_back();
}

/// Skips the branch that begins here, and the next ones up to one that is to be read or the end.
void Reader::State::skip_branches() {
    const std::size_t open = conditionals.size();
    for (;;) {
        Span hash;
        const Word stop = skip_until(conditionals.back().place, true, hash);
        if (stop == Word::end) return conditionals.pop_back();
        if (conditionals.back().taken) continue;
        const bool taken = stop == Word::else_ || condition(stop);
        if (conditionals.size() != open) reader.fail(hash, "Mis-matched '#end'.");  // opened or closed inside the condition
        conditionals.back().else_seen = stop == Word::else_;
        conditionals.back().taken = taken;
        if (taken) return;
    }
}

Word Reader::State::skip_until(const Span& open, bool stop_at_else, Span& hash) {
    Token token;
    for (std::size_t depth = 0;;) {
        next_raw(token);
        if (token.kind == Token::Kind::end) reader.fail(open, "End of file reached but #end expected.");
        if (!token.is('#')) continue;
        hash = token.span;
        next_raw(token);
        if (token.kind != Token::Kind::word) continue;
        if (opens_level(token.word)) {
            ++depth;
        } else if (token.is(Word::end)) {
            if (depth == 0) return Word::end;
            --depth;
        } else if (depth == 0 && stop_at_else && (token.is(Word::else_) || token.is(Word::elseif))) {
            return token.word;
        }
    }
}

}  // namespace rt
