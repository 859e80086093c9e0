// How messages name a token.
#include <fmt/format.h>

#include <array>

#include "syntax/reader_state.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

struct KindName {
    std::string_view operator()(const Number& n) const {
        if (n.color) return "color identifier";
        constexpr std::array names{"float identifier", "uv vector identifier", "vector identifier", "4d-vector identifier",
                                   "color identifier"};
        return names[static_cast<std::size_t>(n.size - 1)];
    }
    std::string_view operator()(const std::string&) const { return "string identifier"; }
    std::string_view operator()(const Pigment&) const { return "pigment identifier"; }
    std::string_view operator()(const Finish&) const { return "finish identifier"; }
    std::string_view operator()(const TextureLayers&) const { return "texture identifier"; }
    std::string_view operator()(const Shared<Interior>&) const { return "interior identifier"; }
    std::string_view operator()(const MaterialValue&) const { return "material identifier"; }
    std::string_view operator()(const ObjectValue&) const { return "object identifier"; }
    std::string_view operator()(const Camera&) const { return "camera identifier"; }
    std::string_view operator()(const Light&) const { return "object identifier"; }
    std::string_view operator()(const Transform&) const { return "transform identifier"; }
    std::string_view operator()(const MacroValue&) const { return "macro identifier"; }
    std::string_view operator()(const Normal&) const { return "normal identifier"; }
    std::string_view operator()(const Shared<ColorMap>&) const { return "colour map identifier"; }
    std::string_view operator()(const Shared<PigmentMap>&) const { return "pigment_map identifier"; }
    std::string_view operator()(const Shared<NormalMap>&) const { return "normal_map identifier"; }
    std::string_view operator()(const Shared<TextureMap>&) const { return "texture_map identifier"; }
    std::string_view operator()(const Shared<SlopeMap>&) const { return "slope_map identifier"; }
    std::string_view operator()(const SkySphere&) const { return "sky_sphere identifier"; }
    std::string_view operator()(const Fog&) const { return "fog identifier"; }
    std::string_view operator()(const Rainbow&) const { return "rainbow identifier"; }
    std::string_view operator()(const ArrayValue&) const { return "array identifier"; }
    std::string_view operator()(const FunctionValue& f) const {
        return std::holds_alternative<std::shared_ptr<const Spline>>(f) ? "spline identifier" : "function identifier";
    }
    std::string_view operator()(const FileValue&) const { return "file identifier"; }
    std::string_view operator()(const UnmodelledValue& u) const { return text(u.word); }
};

/// Floats and vectors that have names count as functions.
std::string value_name(const Value& value) {
    const auto* const number = std::get_if<Number>(&value);
    if (number && !number->color && number->size == 1) return "float function 'float identifier'";
    if (number && !number->color && number->size == 3) return "vector function 'vector identifier'";
    return std::string(kind_of(value));
}

std::string symbol_name(char symbol) {
    switch (symbol) {
        case 'N':
            return "!=";
        case 'L':
            return "<=";
        case 'G':
            return ">=";
        case '.':
            return ". (period)";
        default:
            return std::string(1, symbol);
    }
}

std::string word_name(Word w) {
    switch (group_of(w)) {
        case WordGroup::float_function:
            return fmt::format("float function '{}'", text(w));
        case WordGroup::vector_function:
            return fmt::format("vector function '{}'", text(w));
        case WordGroup::color_keyword:
            return fmt::format("color keyword '{}'", text(w));
        default:
            return std::string(message_name(w));
    }
}

}  // namespace

std::string_view kind_of(const Value& value) { return std::visit(KindName{}, value); }

std::string Reader::describe(const Token& token) {
    switch (token.kind) {
        case Token::Kind::end:
            return "End of File";
        case Token::Kind::number:
            return "float function 'float constant'";
        case Token::Kind::string:
            return "string literal";
        case Token::Kind::word:
            return word_name(token.word);
        case Token::Kind::symbol:
            return symbol_name(token.symbol);
        case Token::Kind::choice:
            return "directive comment '//! raytrace:'";
        case Token::Kind::identifier:
            break;
    }
    const Value* const value = find(token.text);
    return value ? value_name(*value) : fmt::format("undeclared identifier '{}'", token.text);
}

}  // namespace rt
