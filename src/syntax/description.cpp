// How messages name a token.
#include <fmt/format.h>

#include "syntax/reader_state.h"
#include "syntax/word_groups.h"

namespace rt {

namespace {

struct ValueName {
    std::string operator()(const Number& n) const {
        if (n.color) return "color identifier";
        switch (n.size) {
            case 1:
                return "float function 'float identifier'";
            case 2:
                return "uv vector identifier";
            case 3:
                return "vector function 'vector identifier'";
            case 4:
                return "4d-vector identifier";
            default:
                return "color identifier";
        }
    }
    std::string operator()(const std::string&) const { return "string identifier"; }
    std::string operator()(const Pigment&) const { return "pigment identifier"; }
    std::string operator()(const Finish&) const { return "finish identifier"; }
    std::string operator()(const TextureLayers&) const { return "texture identifier"; }
    std::string operator()(const Shared<Interior>&) const { return "interior identifier"; }
    std::string operator()(const MaterialValue&) const { return "material identifier"; }
    std::string operator()(const ObjectValue&) const { return "object identifier"; }
    std::string operator()(const Camera&) const { return "camera identifier"; }
    std::string operator()(const Light&) const { return "object identifier"; }
    std::string operator()(const Transform&) const { return "transform identifier"; }
    std::string operator()(const MacroValue&) const { return "macro identifier"; }
};

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
    return value ? std::visit(ValueName{}, *value) : fmt::format("undeclared identifier '{}'", token.text);
}

}  // namespace rt
