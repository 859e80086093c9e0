// #while, #for, #break: a loop is a jump back in the text it stands in.
#include <fmt/format.h>

#include "syntax/expression.h"
#include "syntax/memory.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::size_t round_bytes = 64;  ///< what a round costs besides its text
constexpr std::uint32_t rounds_between_looks = 256;

bool goes_on(double value, double last, double step) { return step > 0.0 ? value <= last + epsilon : value >= last - epsilon; }

}  // namespace

void Reader::State::require_same_text(const Span& place, std::size_t frame_count, std::size_t conditional_count) {
    if (frames.size() != frame_count || conditionals.size() != conditional_count)
        reader.fail(place, "What stands in parentheses must end in the text it begins in.");
}

void Reader::State::begin_while(const Span& place) {
    const std::uint32_t again = frames.back().lexer.position();
    const std::size_t frame_count = frames.size(), conditional_count = conditionals.size();
    const bool holds = condition(Word::while_);
    require_same_text(place, frame_count, conditional_count);
    if (holds) {
        conditionals.push_back({.place = place, .kind = Conditional::Kind::while_loop, .again = again});
        return;
    }
    Span hash;
    skip_until(place, Stops::end_only, hash);
}

void Reader::State::repeat_while() {
    const Conditional loop = conditionals.back();
    const std::uint32_t behind = frames.back().lexer.position();
    const std::size_t frame_count = frames.size(), conditional_count = conditionals.size();
    count_replay(loop.place, behind - loop.again);
    frames.back().lexer.seek(loop.again);
    const bool holds = condition(Word::while_);
    require_same_text(loop.place, frame_count, conditional_count);
    if (holds) return;
    conditionals.pop_back();
    frames.back().lexer.seek(behind);
}

/// #for(Counter, first, last [, step]): the counter is a local name and keeps the first value beyond the last.
void Reader::State::begin_for(const Span& place) {
    const std::size_t frame_count = frames.size(), conditional_count = conditionals.size();
    reader.expect('(');
    const Token counter = take_name();
    if (counter.kind != Token::Kind::identifier)
        reader.fail(counter.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(counter)));
    Conditional loop{.place = place, .kind = Conditional::Kind::for_loop, .counter = counter.text, .scope = names.depth()};
    reader.accept_comma();
    const double first = Expression(*this).sum_float();
    reader.accept_comma();
    loop.last = Expression(*this).sum_float();
    reader.accept_comma();
    loop.step = reader.at_expression() ? Expression(*this).sum_float() : 1.0;
    reader.expect(')');
    require_same_text(place, frame_count, conditional_count);
    if (!(std::fabs(loop.step) >= epsilon)) reader.fail(since(place), "#for loop increment must be non-zero.");
    names.bind(loop.scope, loop.counter, make_variable(Number{{first}, 1, false}));
    if (goes_on(first, loop.last, loop.step)) {
        loop.again = frames.back().lexer.position();
        conditionals.push_back(loop);
        return;
    }
    Span hash;
    skip_until(place, Stops::end_only, hash);
}

void Reader::State::repeat_for() {
    const Conditional& loop = conditionals.back();
    count_replay(loop.place, frames.back().lexer.position() - loop.again);
    const VariablePtr& counter = names.find_in(loop.scope, loop.counter);
    Number* const number = counter ? std::get_if<Number>(&counter->value) : nullptr;
    if (!number || number->size != 1) reader.fail(loop.place, "The #for loop's counter is no float any more.");
    number->v[0] += loop.step;
    if (goes_on(number->v[0], loop.last, loop.step))
        frames.back().lexer.seek(loop.again);
    else
        conditionals.pop_back();
}

/// In a macro, outside of its loops, `#break` leaves the macro.
void Reader::State::leave_loop(const Span& place) {
    std::size_t inner = 0;
    for (;; ++inner) {
        if (conditionals.size() - inner == frames.back().conditionals) {
            if (!frames.back().macro) reader.fail(place, "Invalid context for #break");
            conditionals.resize(frames.back().conditionals);
            leave_frame();
            return;
        }
        if (conditionals[conditionals.size() - inner - 1].kind != Conditional::Kind::branch) break;
    }
    Span hash;
    for (std::size_t i = 0; i <= inner; ++i) {
        skip_until(conditionals.back().place, Stops::end_only, hash);
        conditionals.pop_back();
    }
}

void Reader::State::count_replay(const Span& place, std::size_t bytes) {
    replayed += bytes + round_bytes;
    if (replayed > options.max_replayed_bytes)
        reader.fail_limit(place, fmt::format("Loops and macros have read more than {} bytes of text again.", options.max_replayed_bytes),
                          "reread");
    if (++replays % rounds_between_looks == 0) check_memory(place);
}

void Reader::State::check_memory(const Span& place) {
    if (memory_in_use() > options.max_memory_bytes) fail_memory(place);
}

void Reader::State::fail_memory(const Span& place) {
    reader.fail_limit(place,
                      fmt::format("The scene takes more than {:.1f} GB of memory.", static_cast<double>(options.max_memory_bytes) * 1e-9),
                      "memory");
}

}  // namespace rt
