// #declare, #local, #undef and #macro.
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

void Reader::State::declare(bool local) {
    const std::optional<Deprecation> deprecation = parse_deprecation();
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier)
        reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
    reader.expect('=');
    // A local name belongs to the file that the directive stands in; the main file's are visible everywhere.
    const std::size_t frame = frames.size() - 1;
    Value value = parse_declared_value();
    end_of_declaration(value);
    ByName<Value>& table = local && frame > 0 && frame < frames.size() ? frames[frame].locals : globals;
    table.insert_or_assign(std::string(name.text), std::move(value));
    if (!deprecation) return;
    Deprecation& kept = deprecated[std::string(name.text)] = *deprecation;
    if (kept.message.empty()) kept.message = fmt::format("Identifier '{}' was declared deprecated.", name.text);
    any_deprecated = true;
}

std::optional<Reader::State::Deprecation> Reader::State::parse_deprecation() {
    names_only = true;
    if (!reader.accept(Word::deprecated)) return std::nullopt;
    Deprecation deprecation;
    deprecation.once = reader.accept(Word::once);
    if (reader.peek().kind == Token::Kind::string) deprecation.message = reader.parse_string();
    return deprecation;
}

Value Reader::State::parse_declared_value() {
    const Token first = reader.peek();
    if (first.kind == Token::Kind::identifier && !reader.find(first.text))
        reader.fail(first.span, "Cannot assign uninitialized identifier.");
    if (at_string(reader)) return reader.parse_string();
    if (const auto number = parse_declared_number()) return *number;
    if (skip_unmodelled_value()) return std::string();
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

/// Values that exist in the language but not here yet: reported, then skipped.
bool Reader::State::skip_unmodelled_value() {
    const Token token = reader.peek();
    if (token.kind != Token::Kind::word) return false;
    switch (token.word) {
        case Word::array:
        case Word::function:
        case Word::spline:
            break;
        default:
            return false;
    }
    reader.unmodelled(token.span, text(token.word));
    while (!reader.peek().is('{') && !reader.peek().is(';') && reader.peek().kind != Token::Kind::end && !reader.peek().is('}'))
        reader.take();
    if (reader.peek().is('{')) reader.skip_block();
    return true;
}

void Reader::State::end_of_declaration(const Value& value) {
    if (!std::holds_alternative<Number>(value)) return accept_semicolon();
    if (reader.accept(';')) return;
    const Span place = reader.peek().span;
    if (version >= 3.5) reader.fail(place, semicolon_required);
    if (version >= 3.1)
        reader.warn_possible(place, "All #version and #declares of float, vector, and color require semi-colon ';' at end.");
}

/// Takes a ';' that comes next without carrying out a directive that comes next: a thousand declarations in a row are no nesting.
void Reader::State::accept_semicolon() {
    if (has_ahead) {
        reader.accept(';');
        return;
    }
    Lexer& lexer = frames.back().lexer;
    const std::uint32_t position = lexer.position();
    Token token;
    lexer.next(token);
    if (!token.is(';')) lexer.seek(position);
}

void Reader::State::undefine(const Span& place) {
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier)
        reader.fail(name.span, fmt::format("Expected 'undeclared identifier', {} found instead", reader.describe(name)));
    for (ByName<Value>* table : {&frames.back().locals, &globals}) {
        const auto found = table->find(name.text);
        if (found == table->end()) continue;
        table->erase(found);
        return;
    }
    reader.warn(place, "Attempt to undef unknown identifier");
}

void Reader::State::declare_macro(const Span& place) {
    const Token name = take_name();
    if (name.kind != Token::Kind::identifier)
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
    if (skip_until(place, true, hash) != Word::end) reader.fail(hash, "Mis-matched '#else'.");
    macro.body = {hash.file, begin, hash.begin};
    globals.insert_or_assign(std::string(name.text), std::move(macro));
    any_macro = true;
}

}  // namespace rt
