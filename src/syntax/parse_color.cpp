// Colours: keywords, vectors, identifiers and single channels.
#include <fmt/format.h>

#include "core/srgb.h"
#include "syntax/blocks.h"

namespace rt {

namespace {

/// `rgb`, `srgbft` ...: which channels the vector after it fills, in its order.
struct Form {
    int size = 0;  ///< 0: not such a word
    bool fourth_is_transmit = false;
    bool srgb = false;
};

Form form_of(Word w) {
    switch (w) {
        case Word::rgb:
            return {3, false, false};
        case Word::rgbf:
            return {4, false, false};
        case Word::rgbt:
            return {4, true, false};
        case Word::rgbft:
            return {5, false, false};
        case Word::srgb:
            return {3, false, true};
        case Word::srgbf:
            return {4, false, true};
        case Word::srgbt:
            return {4, true, true};
        case Word::srgbft:
            return {5, false, true};
        default:
            return {};
    }
}

/// Where a channel keyword writes, null for any other word.
double* channel(PigmentColor& color, Word w) {
    switch (w) {
        case Word::red:
            return &color.rgb.r;
        case Word::green:
            return &color.rgb.g;
        case Word::blue:
            return &color.rgb.b;
        case Word::filter:
            return &color.filter;
        case Word::transmit:
            return &color.transmit;
        default:
            return nullptr;
    }
}

bool is_color_word(Word w) {
    PigmentColor unused;
    return w == Word::color || w == Word::colour || form_of(w).size != 0 || channel(unused, w) != nullptr;
}

PigmentColor from_channels(const Number& n) { return {Rgb(n.v[0], n.v[1], n.v[2]), n.v[3], n.v[4]}; }

/// sRGB's transfer function, then into the working space of `gamma`.
double from_srgb(double value, const Gamma& gamma) {
    if (gamma.kind == Gamma::Kind::srgb) return value;
    const double linear = decode_srgb(value);
    return gamma.power == 1.0 ? linear : std::pow(linear, 1.0 / gamma.power);
}

/// Where only red, green and blue count, POV-Ray remarks on what else was stated, form by form.
void remark(Reader& reader, bool pure, bool stated, std::string_view extra) {
    if (pure && stated)
        reader.warn(reader.peek().span, fmt::format("Expected pure RGB color expression, unexpected {} will have no effect.", extra));
}

PigmentColor parse_form(Reader& reader, bool pure) {
    const Token word = reader.take();
    const Form form = form_of(word.word);
    const Gamma& gamma = reader.scene().settings.gamma;
    if (form.srgb && gamma.kind == Gamma::Kind::legacy)
        reader.fail(word.span, "Cannot parse sRGB colors before assumed_gamma has been set.");
    Number n = reader.parse_condition();
    if (n.size == 1)
        for (int i = 1; i < form.size; ++i) n.v[i] = n.v[0];
    if (n.size > form.size) reader.warn(reader.peek().span, fmt::format("Suspicious expression after {}.", text(word.word)));
    if (form.fourth_is_transmit && n.size <= 4) std::swap(n.v[3], n.v[4]);
    PigmentColor color = from_channels(n);
    if (form.srgb)
        for (int i = 0; i < 3; ++i) color.rgb[i] = from_srgb(color.rgb[i], gamma);
    if (form.size == 5) {
        remark(reader, pure, color.filter != 0.0 || color.transmit != 0.0, "filter and transmit components");
    } else if (form.size == 4) {
        remark(reader, pure, !form.fourth_is_transmit && color.filter != 0.0, "filter component");
        remark(reader, pure, form.fourth_is_transmit && color.transmit != 0.0, "transmit component");
    }
    return color;
}

PigmentColor parse_bare(Reader& reader, bool pure) {
    Number n = reader.parse_condition();
    if (n.size == 1)
        for (int i = 1; i < (pure ? 3 : 5); ++i) n.v[i] = n.v[0];
    remark(reader, pure, n.v[3] != 0.0 || n.v[4] != 0.0, "filter and transmit components");
    return from_channels(n);
}

/// `pure`: only red, green and blue count. A bare float then fills these three, otherwise all five.
PigmentColor parse_any_color(Reader& reader, bool pure) {
    PigmentColor color;
    while (reader.accept(Word::color) || reader.accept(Word::colour)) continue;
    const Token& next = reader.peek();
    if (next.kind == Token::Kind::word && form_of(next.word).size != 0)
        color = parse_form(reader, pure);
    else if (reader.at_expression())
        color = parse_bare(reader, pure);
    while (reader.peek().kind == Token::Kind::word) {
        const Word word = reader.peek().word;
        double* const value = channel(color, word);
        if (!value) break;
        reader.take();
        *value = reader.parse_float();
        remark(reader, pure, word == Word::filter && *value != 0.0, "filter component");
        remark(reader, pure, word == Word::transmit && *value != 0.0, "transmit component");
    }
    return color;
}

}  // namespace

bool at_color(Reader& reader) {
    const Token& next = reader.peek();
    if (next.kind == Token::Kind::word) return is_color_word(next.word);
    if (next.kind != Token::Kind::identifier) return false;
    const Value* const value = reader.next_value();
    const Number* const number = value ? std::get_if<Number>(value) : nullptr;
    return number && (number->color || number->size == 5);
}

PigmentColor parse_color(Reader& reader) { return parse_any_color(reader, false); }

Rgb parse_rgb(Reader& reader) { return parse_any_color(reader, true).rgb; }

}  // namespace rt
