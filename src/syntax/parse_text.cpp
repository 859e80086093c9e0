// text { }
#include <array>
#include <stdexcept>

#include "core/utf8.h"
#include "syntax/font_file.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

constexpr std::size_t most_pieces = 1'000'000;  ///< of all outlines of one text: some 20,000 letters

/// The fonts that POV-Ray has built in are those it also installs as files; of any other number it takes the last.
std::string internal_font(int number) {
    constexpr std::array names{"timrom.ttf", "cyrvetic.ttf", "crystal.ttf", "povlogo.ttf"};
    return names[number >= 1 && number <= 3 ? static_cast<std::size_t>(number - 1) : 3];
}

std::string parse_font_name(Reader& reader) {
    if (reader.accept(Word::ttf)) return reader.parse_string();
    if (reader.accept(Word::internal)) return internal_font(parse_int(reader));
    reader.fail_expected("ttf or internal");
}

/// The characters of a string: UTF-8 where it is that, else one a byte.
std::u32string characters(const std::string& text) {
    std::u32string out;
    const bool utf8 = is_utf8(text);
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t size = utf8 ? utf8_character(std::string_view(text).substr(i)) : 1;
        char32_t c = size == 1 ? byte : byte & (0x7Fu >> size);
        for (std::size_t k = 1; k < size; ++k) c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
        out.push_back(c);
        i += size;
    }
    return out;
}

/// The first letter begins exactly at x = 0; each pen position after it is an advance further, kerned by the font's table. Like
/// POV-Ray's, letters do not move along z.
std::vector<Glyph> set_line(Reader& reader, const FontFile& font, const std::u32string& line, double thickness, const Vec2& offset) {
    std::vector<Glyph> glyphs;
    Vec2 pen(0.0);
    unsigned before = 0;
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const unsigned number = font.glyph(line[i]);
        const FontFile::Shape shape = font.shape(number);
        const double kern = i == 0 ? -shape.left : font.kerning(before, number);
        const Vec2 place(pen.x + kern, pen.y);
        Glyph glyph{{}, std::fmin(thickness, 0.0), std::fmax(thickness, 0.0)};
        for (CurvePiece piece : shape.outline) {
            for (Vec2& p : piece.points) p += place;
            glyph.outline.add(piece);
        }
        if ((pieces += shape.outline.size()) > most_pieces)
            reader.fail(reader.peek().span, "The outlines of this text have too many pieces.");
        turn_outwards(glyph.outline);
        if (!glyph.outline.pieces.empty()) glyphs.push_back(std::move(glyph));
        pen += Vec2(shape.advance + kern, 0.0) + offset;
        before = number;
    }
    return glyphs;
}

}  // namespace

ParsedShape parse_text(Reader& reader) {
    const Span place = reader.peek().span;
    const std::string font_name = parse_font_name(reader);
    reader.accept_comma();
    const std::u32string line = characters(reader.parse_string());
    reader.accept_comma();
    const double thickness = reader.parse_float();
    reader.accept_comma();
    const Vec3 offset = reader.parse_vector();
    std::optional<std::string> bytes = reader.read_file(font_name, {"", ".ttf", ".TTF"});
    if (!bytes) {
        reader.warn_possible(place, "Cannot find file '" + font_name + "', even after trying to append file type extension.");
        reader.fail(place, "Cannot open font file.");
    }
    std::optional<FontFile> font;
    try {
        font.emplace(std::move(*bytes));
    } catch (const std::invalid_argument&) {
        reader.fail(place, "Cannot read the font file '" + font_name + "'.");
    }
    std::vector<Glyph> glyphs = set_line(reader, *font, line, thickness, Vec2(offset));
    if (glyphs.empty()) return std::nullopt;
    return Text{std::move(glyphs)};
}

}  // namespace rt
