// Colours: keywords, vectors, identifiers and single channels.
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/parameters.h"

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
double decode_srgb(double value, const Gamma& gamma) {
    if (gamma.kind == Gamma::Kind::srgb) return value;
    const double linear = value < 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    return gamma.power == 1.0 ? linear : std::pow(linear, 1.0 / gamma.power);
}

PigmentColor parse_form(Reader& reader, Word word, const Span& place) {
    const Form form = form_of(word);
    const Gamma& gamma = reader.scene().settings.gamma;
    if (form.srgb && gamma.kind == Gamma::Kind::legacy) reader.fail(place, "Cannot parse sRGB colors before assumed_gamma has been set.");
    Number n = reader.parse_number();
    if (n.size == 1)
        for (int i = 1; i < form.size; ++i) n.v[i] = n.v[0];
    if (n.size > form.size && !n.color) reader.warn(reader.peek().span, fmt::format("Suspicious expression after {}.", text(word)));
    if (form.fourth_is_transmit && n.size <= 4) std::swap(n.v[3], n.v[4]);
    PigmentColor color = from_channels(n);
    if (form.srgb)
        for (int i = 0; i < 3; ++i) color.rgb[i] = decode_srgb(color.rgb[i], gamma);
    return color;
}

/// With `pure`, a bare float fills red, green and blue only.
PigmentColor parse_any_color(Reader& reader, bool pure) {
    const Span place = reader.peek().span;
    PigmentColor color;
    while (reader.accept(Word::color) || reader.accept(Word::colour)) continue;
    const Token& next = reader.peek();
    if (next.kind == Token::Kind::word && form_of(next.word).size != 0) {
        const Token form = reader.take();
        color = parse_form(reader, form.word, form.span);
    } else if (next.kind == Token::Kind::word && channel(color, next.word)) {
        // Nothing before the single channels below.
    } else if (reader.at_expression()) {
        Number n = reader.parse_number();
        if (n.size == 1)
            for (int i = 1; i < (pure ? 3 : 5); ++i) n.v[i] = n.v[0];
        color = from_channels(n);
    }
    while (reader.peek().kind == Token::Kind::word) {
        double* const value = channel(color, reader.peek().word);
        if (!value) break;
        reader.take();
        *value = parse_finite(reader);
    }
    require_finite(reader, place, color.rgb);
    require_finite(reader, place, Vec3(color.filter, color.transmit, 0.0));
    return color;
}

}  // namespace

bool at_color(Reader& reader) {
    const Token& next = reader.peek();
    if (next.kind == Token::Kind::word) return is_color_word(next.word);
    if (next.kind != Token::Kind::identifier) return false;
    const Value* const value = reader.find(next.text);
    const Number* const number = value ? std::get_if<Number>(value) : nullptr;
    return number && number->color;
}

PigmentColor parse_color(Reader& reader) { return parse_any_color(reader, false); }

Rgb parse_rgb(Reader& reader) {
    const PigmentColor color = parse_any_color(reader, true);
    const char* extra = nullptr;
    if (color.filter != 0.0) extra = color.transmit != 0.0 ? "filter and transmit components" : "filter component";
    if (!extra && color.transmit != 0.0) extra = "transmit component";
    if (extra)
        reader.warn(reader.peek().span, fmt::format("Expected pure RGB color expression, unexpected {} will have no effect.", extra));
    return color.rgb;
}

}  // namespace rt
