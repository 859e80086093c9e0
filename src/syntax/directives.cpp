// Directives, carried out as soon as they are met between two tokens.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr double newest_version = 3.7;
constexpr double version_tolerance = 1e-6;

}  // namespace

void Reader::State::directive(const Span& hash) {
    const DirectiveGuard guard(*this, hash);
    Token name;
    next_raw(name);
    if (name.kind == Token::Kind::end) return;  // a lone '#' at the very end is nothing
    Span place = hash;
    place.end = name.span.end;
    if (!name.is(Word::version)) anything_read = true;
    switch (name.word) {
        case Word::if_:
        case Word::ifdef:
        case Word::ifndef:
            return begin_conditional(place, name.word);
        case Word::else_:
        case Word::elseif:
            return else_branch(name.word, place);
        case Word::end:
            return end_conditional(place);
        case Word::declare:
        case Word::local:
            return declare(name.word == Word::local);
        case Word::undef:
            return undefine(place);
        case Word::macro:
            return declare_macro(place);
        case Word::include:
            return include_directive(place);
        case Word::default_:
            return parse_default(reader);
        case Word::version:
            return set_version(place);
        case Word::debug:
        case Word::warning:
        case Word::error:
        case Word::render:
        case Word::statistics:
            return message_directive(name.word, place);
        case Word::while_:
            return begin_while(place);
        case Word::for_:
            return begin_for(place);
        case Word::switch_:
            return begin_switch(place);
        case Word::break_:
            return leave_loop(place);
        case Word::case_:
        case Word::range:
            return pass_case(name.word, place);
        case Word::fopen:
        case Word::fclose:
        case Word::read:
        case Word::write:
            return file_directive(name.word, place);
        default:
            if (name.kind == Token::Kind::number || name.kind == Token::Kind::string)
                reader.fail(name.span, fmt::format("Expected 'object or directive', {} found instead", reader.describe(name)));
            frames.back().lexer.seek(name.span.begin);  // '#' before anything else says nothing
    }
}

void Reader::State::include_directive(const Span& place) {
    const Span first = reader.peek().span;
    if (reader.peek().kind == Token::Kind::end) reader.fail(place, "Expecting a string after INCLUDE.");
    const std::string name = reader.parse_string();
    include(since(first), name);
}

void Reader::State::message_directive(Word w, const Span& place) {
    const std::string message = reader.parse_string();
    if (w == Word::error) reader.fail(place, fmt::format("Parse halted by #error directive: {}", message));
    if (w == Word::warning) return reader.warn(place, message);
    if (w != Word::debug)
        reader.warn(place, "#render and #statistics streams are no longer available. Redirecting output to #debug stream.");
    messages(message);
}

/// Restoring a saved version sets it too: the scene then counts as one that states its version.
void Reader::State::set_version(const Span& place) {
    if (!version_stated && anything_read) version_late = true;
    // A contextual word, whatever was declared under its name: patched versions of POV-Ray accept their own scenes by it.
    if (reader.peek().kind == Token::Kind::identifier && reader.peek().text == "unofficial") reader.take();
    const Restore<Waiting> wait(waiting, {true, conditionals.size(), depth});
    const double stated = reader.parse_float();
    if (stated > newest_version + version_tolerance)
        reader.fail(place, fmt::format("Your scene file requires POV-Ray version {:g} or later!", stated));
    version = stated;
    version_stated = true;
    scene.language_version = stated;
    if (!reader.accept(';'))
        reader.warn_possible(reader.peek().span, "All #version and #declares of float, vector, and color require semi-colon ';' at end.");
    resume_directive();
}

}  // namespace rt
