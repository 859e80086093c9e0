// #macro and its calls: the body is read where the call stands, in a scope of its own.
#include <fmt/format.h>

#include "syntax/reader_state.h"

namespace rt {

void Reader::State::declare_macro(const Span& place) {
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier || is_no_macro(name))
        reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
    reader.expect('(');
    MacroValue macro;
    for (;;) {
        const Token parameter = take_name();
        if (parameter.is(')')) break;
        if (parameter.kind != Token::Kind::identifier)
            reader.fail(parameter.span, fmt::format("Expected 'identifier or expression.', {} found instead", reader.describe(parameter)));
        macro.parameters.emplace_back(parameter.text);
        names_only = true;
        reader.accept_comma();
    }
    Span hash;
    const std::uint32_t begin = frames.back().lexer.position();
    if (skip_until(place, Stops::branches, hash) != Word::end) reader.fail(hash, "Mis-matched '#else'.");
    macro.body = {hash.file, begin, hash.begin};
    names.bind(0, name.text, make_variable(std::move(macro)));
}

/// Does the name stand for something else?
bool Reader::State::is_no_macro(const Token& name) const {
    const VariablePtr& variable = names.find(name.text);
    return variable && !std::holds_alternative<MacroValue>(variable->value);
}

/// The macro's name was read; its body is what comes next. `called` is kept while the arguments are read, whatever becomes of the name;
/// nothing gives a variable that is a macro another value.
void Reader::State::call_macro(const VariablePtr& called) {
    const auto& macro = std::get<MacroValue>(called->value);
    const Span place = ahead.span, before = last;
    const Word word_before = last_word;
    const std::vector<VariablePtr> arguments = parse_arguments(macro, place);
    if (macros == options.max_macro_depth)
        reader.fail_limit(place, fmt::format("Macros call each other more than {} deep.", options.max_macro_depth), "macro-depth");
    count_replay(place, macro.body.end - macro.body.begin);
    push_frame(Lexer(scene.sources, macro.body.file, macro.body.begin, macro.body.end, &near_choice), true);
    for (std::size_t i = 0; i < arguments.size(); ++i) names.bind(names.depth(), macro.parameters[i], arguments[i]);
    last = before;
    last_word = word_before;
}

std::vector<VariablePtr> Reader::State::parse_arguments(const MacroValue& macro, const Span& place) {
    const NestingGuard guard(*this, place);
    std::vector<VariablePtr> arguments;
    reader.expect('(');
    const std::size_t frame_count = frames.size();
    for (const std::size_t count = macro.parameters.size(); arguments.size() < count;) {
        if (reader.peek().is(')'))
            reader.fail(reader.peek().span, fmt::format("Expected {} parameters but only {} found.", count, arguments.size()));
        arguments.push_back(parse_argument(frame_count));
        reader.accept_comma();
    }
    reader.expect(')');
    return arguments;
}

/// A name alone, or an array's element, is passed as the variable itself, which the macro can set; anything else as its value.
VariablePtr Reader::State::parse_argument(std::size_t frame_count) {
    const Token next = reader.peek();
    if (next.kind == Token::Kind::identifier) {
        if (!ahead_variable)
            reader.fail(next.span, "Cannot pass uninitialized identifier as macro parameter. Initialize identifier first.");
        leave_ended_frames(frame_count);  // of macros whose last word it was
        if (raw_next_is(',') || raw_next_is(')')) {
            step();
            return ahead_variable;
        }
    }
    const auto variable = std::make_shared<Variable>();
    variable->value = parse_declared_value(variable->missing);
    return variable;
}

}  // namespace rt
