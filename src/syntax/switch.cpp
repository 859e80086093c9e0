// #switch, #case, #range: the first case that holds begins what is read, up to a #break or the end.
#include <fmt/format.h>

#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

/// Only directives, and macros of them, may stand before the first case.
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
        if (token.kind == Token::Kind::end && frames.size() > frame_count && leave_frame()) continue;
        ahead = token;
        if (token.kind == Token::Kind::identifier && resolve_name()) continue;
        if (!token.is('#')) reader.fail(token.span, "#switch not followed by #case or #range.");
        const Span hash = token.span;
        const std::uint32_t position = frames.back().lexer.position();
        next_raw(token);
        const bool is_case = token.is(Word::case_) || token.is(Word::range);
        if (is_case && frames.size() == frame_count) return find_case(token.word);
        if (is_case) reader.fail(hash, "Mis-matched '#case' or '#range'.");
        if (token.is(Word::else_) || token.is(Word::end)) reader.fail(hash, fmt::format("Mis-matched '#{}'.", text(token.word)));
        frames.back().lexer.seek(position);
        const std::size_t frames_before = frames.size(), conditionals_before = conditionals.size();
        directive(hash);
        if (frames.size() != frames_before || conditionals.size() != conditionals_before)
            reader.fail(place, "What stands before the first #case must end in the text it begins in.");
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
