// #switch, #case, #range: the first case that holds begins what is read, up to a #break or the end.
#include <fmt/format.h>

#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

/// Only directives may stand before the first case.
void Reader::State::begin_switch(const Span& place) {
    const std::size_t frame_count = frames.size(), conditional_count = conditionals.size();
    reader.expect('(');
    const double value = Expression(*this).condition_float();
    reader.expect(')');
    require_same_text(place, frame_count, conditional_count);
    conditionals.push_back({.place = place, .kind = Conditional::Kind::choice, .value = value});
    Token token;
    for (;;) {
        next_raw(token);
        if (!token.is('#')) reader.fail(token.span, "#switch not followed by #case or #range.");
        const Span hash = token.span;
        const std::uint32_t position = frames.back().lexer.position();
        next_raw(token);
        if (token.is(Word::case_) || token.is(Word::range)) return find_case(token.word);
        if (token.is(Word::else_) || token.is(Word::end)) reader.fail(hash, fmt::format("Mis-matched '#{}'.", text(token.word)));
        frames.back().lexer.seek(position);
        directive(hash);
        require_same_text(place, frame_count, conditional_count + 1);
        if (has_ahead) reader.fail(ahead.span, "#switch not followed by #case or #range.");
    }
}

/// Goes on from the case whose word was just read to the first that holds.
void Reader::State::find_case(Word w) {
    const std::size_t frame_count = frames.size(), conditional_count = conditionals.size();
    for (;;) {
        const Span place = conditionals.back().place;
        if (w == Word::end) return conditionals.pop_back();
        if (w == Word::else_) {
            conditionals.back().else_seen = true;
            return;
        }
        const bool holds = case_holds(w);
        require_same_text(place, frame_count, conditional_count);
        if (holds) return;
        Span hash;
        w = skip_until(place, Stops::cases, hash);
    }
}

/// Reads `(value)` of `#case`, equal within the tolerance of all equalities, or `(from, to)` of `#range`, which is exact.
bool Reader::State::case_holds(Word w) {
    const double value = conditionals.back().value;
    reader.expect('(');
    const double first = Expression(*this).condition_float();
    bool holds = std::fabs(value - first) < epsilon;
    if (w == Word::range) {
        reader.accept_comma();
        const double last = Expression(*this).condition_float();
        holds = value >= first && value <= last;
    }
    reader.expect(')');
    return holds;
}

/// A case that is come upon while another is read is only read over.
void Reader::State::pass_case(Word w, const Span& place) {
    if (!may_close() || conditionals.back().kind != Conditional::Kind::choice || conditionals.back().else_seen)
        reader.fail(place, "Mis-matched '#case' or '#range'.");
    case_holds(w);
}

}  // namespace rt
