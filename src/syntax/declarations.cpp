// #declare, #local and #undef.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/expression.h"
#include "syntax/reader_state.h"

namespace rt {

namespace {

constexpr std::string_view semicolon_required =
    "All #declares of float, vector, and color require semi-colon ';' at end if the language version is set to 3.5 or higher. Either add "
    "the "
    "semi-colon or set the language version to 3.1 or lower.";

/// Colours are kept in single precision, as POV-Ray keeps them.
Number rounded_color(Number color) {
    for (double& channel : color.v) channel = static_cast<double>(static_cast<float>(channel));
    return color;
}

Number from_pigment_color(const PigmentColor& c) { return {{c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit}, 5, true}; }

}  // namespace

/// A name that is known is set where it is known; a new one belongs to the whole scene. A local one belongs to the file or macro that the
/// directive stands in.
void Reader::State::declare(bool local) {
    const std::optional<Deprecation> deprecation = parse_deprecation();
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier)
        reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
    const std::size_t scope = names.depth();
    VariablePtr known = names.find(name.text);
    if (known && local && known != names.find_in(scope, name.text)) {
        const bool element = std::holds_alternative<ArrayValue>(known->value) && raw_next_is('[');
        known = element ? make_variable(copy_of(name.span, known->value)) : nullptr;
        if (element) names.bind(scope, name.text, known);
    }
    if (known) require_redeclarable(name, known->value);
    if (known && std::holds_alternative<ArrayValue>(known->value) && raw_next_is('[')) return declare_element(name, known);
    reader.expect('=');
    const VariablePtr declared = std::make_shared<Variable>();
    parse_declaration(*declared);
    if (!known && !local) known = names.find_from(scope, name.text);  // while the value was read
    if (known)
        *known = std::move(*declared);
    else if (!local || scope <= names.depth())
        names.bind(local ? scope : 0, name.text, declared);
    if (!deprecation) return;
    Deprecation& kept = deprecated[std::string(name.text)] = *deprecation;
    if (kept.message.empty()) kept.message = fmt::format("Identifier '{}' was declared deprecated.", name.text);
    any_deprecated = true;
}

void Reader::State::require_redeclarable(const Token& name, const Value& before) {
    if (std::holds_alternative<MacroValue>(before))
        reader.fail(name.span, "Expected 'undeclared identifier', macro identifier found instead");
    const auto* const function = std::get_if<FunctionValue>(&before);
    const auto* const unmodelled = std::get_if<UnmodelledValue>(&before);
    const bool spline = function && std::holds_alternative<std::shared_ptr<const Spline>>(*function);
    if ((function && !spline) || (unmodelled && unmodelled->word == Word::function))
        reader.fail(name.span, "Redeclaring functions is not allowed - #undef the function first!");
}

void Reader::State::parse_declaration(Variable& into) {
    const std::size_t frame_count = frames.size();
    {
        const Restore<Waiting> wait(waiting, {true, conditionals.size(), depth});
        into.value = parse_declared_value(into.missing);
        end_of_declaration(into.value, frame_count);
    }
    resume_directive();
}

void Reader::State::resume_directive() {
    if (!has_ahead || !ahead.is('#')) return;
    has_ahead = false;
    frames.back().lexer.seek(ahead.span.begin);
}

std::optional<Reader::State::Deprecation> Reader::State::parse_deprecation() {
    names_only = true;
    if (!reader.accept(Word::deprecated)) return std::nullopt;
    Deprecation deprecation;
    names_only = true;
    deprecation.once = reader.accept(Word::once);
    names_only = true;
    if (reader.peek().kind == Token::Kind::string) deprecation.message = reader.parse_string();
    return deprecation;
}

Value Reader::State::parse_declared_value(std::vector<Unmodelled>& lacking) {
    const Restore<std::vector<Unmodelled>*> gather(missing, &lacking);
    const Token first = reader.peek();
    if (first.kind == Token::Kind::identifier && !reader.next_value()) reader.fail(first.span, "Cannot assign uninitialized identifier.");
    if (at_string(reader)) return reader.parse_string();
    if (const auto number = parse_declared_number()) return *number;
    if (reader.accept(Word::array)) return parse_array();
    if (reader.accept(Word::function)) return parse_function(last);
    if (reader.accept(Word::spline)) return FunctionValue(parse_spline());
    if (auto value = parse_declared_block(reader)) return std::move(*value);
    reader.fail(first.span, fmt::format("Expected 'RValue to declare', {} found instead", reader.describe(first)));
}

/// A float, vector or colour, if one comes next. A literal colour can only be the whole value.
std::optional<Number> Reader::State::parse_declared_number() {
    if (reader.peek().kind == Token::Kind::word && at_color(reader)) return rounded_color(from_pigment_color(parse_color(reader)));
    if (!reader.at_expression()) return std::nullopt;
    const Number number = Expression(*this).sum();
    return number.color ? rounded_color(number) : number;
}

void Reader::State::end_of_declaration(const Value& value, std::size_t frame_count) {
    if (!std::holds_alternative<Number>(value)) return accept_semicolon(frame_count);
    if (reader.accept(';')) return;
    const Span place = reader.peek().span;
    if (version >= 3.5) reader.fail(place, semicolon_required);
    if (version >= 3.1)
        reader.warn_possible(place, "All #version and #declares of float, vector, and color require semi-colon ';' at end.");
}

/// Takes a ';' that comes next without carrying out a directive that comes next: a thousand declarations in a row are no nesting. Macros
/// that ended with the value are left: the ';' stands behind their calls.
void Reader::State::accept_semicolon(std::size_t frame_count) {
    if (has_ahead) {
        reader.accept(';');
        return;
    }
    leave_ended_frames(frame_count);
    if (raw_next_is(';')) reader.accept(';');
}

void Reader::State::undefine(const Span& place) {
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier)
        reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
    const VariablePtr variable = names.find(name.text);
    if (variable && std::holds_alternative<ArrayValue>(variable->value) && raw_next_is('[')) {
        VariablePtr array = variable;
        std::get<ArrayValue>(array->value).elements[parse_index(*array)] = nullptr;
        return;
    }
    if (!names.unbind(name.text)) reader.warn(place, "Attempt to undef unknown identifier");
}

}  // namespace rt
