// height_field { }
#include <fmt/format.h>

#include <algorithm>

#include "core/function.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"
#include "syntax/picture.h"

namespace rt {

namespace {

/// POV-Ray draws nothing of fewer than two columns or rows.
bool has_cells(Reader& reader, const Span& place, double columns, double rows) {
    if (columns * rows > static_cast<double>(most_height_samples))
        reader.fail(place, fmt::format("A height field has at most {} samples.", most_height_samples));
    if (columns >= 2.0 && rows >= 2.0) return true;
    reader.warn(place, "A height field of less than two columns or rows is not visible.");
    return false;
}

/// POV-Ray keeps the lower 16 bits of the whole number, so that what is too high begins again from below.
std::uint16_t sample_of(double value) {
    const double number = std::trunc(65535.0 * value);
    return std::fabs(number) < 0x1p62 ? static_cast<std::uint16_t>(static_cast<std::int64_t>(number)) : std::uint16_t{0};
}

/// `function columns, rows { ... }` after its word: its value at x from 0 to 1 and y from 1, at the bottom row, to 0. Nothing where it is
/// not modelled.
std::optional<HeightFieldData> parse_samples(Reader& reader) {
    const Span place = reader.peek().span;
    const int columns = parse_int(reader);
    reader.accept_comma();
    const int rows = parse_int(reader);
    if (columns < 0 || rows < 0) reader.fail(place, "The number of a height field's columns or rows is below 0.");
    const bool visible = has_cells(reader, place, columns, rows);
    const std::shared_ptr<const Function> function = reader.parse_pattern_function();
    if (!function || !visible) return std::nullopt;
    std::vector<std::uint16_t> heights;
    heights.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = rows - 1; j >= 0; --j) {
        for (int i = 0; i < columns; ++i) {
            const double at[] = {static_cast<double>(i) / (columns - 1), static_cast<double>(j) / (rows - 1), 0.0};
            heights.push_back(sample_of(reader.evaluate(function, at, place)));
        }
    }
    return HeightFieldData(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), std::move(heights));
}

std::optional<HeightFieldData> parse_heights(Reader& reader) {
    if (reader.accept(Word::function)) return parse_samples(reader);
    StatedPicture picture;
    const Span place = reader.peek().span;
    parse_picture_file(reader, picture);
    const PictureFile& file = picture.file;
    if (file.kind == PictureFile::Kind::gif || file.max_value == 0) {
        reader.unmodelled(place, file.max_value == 0 ? "height_field of a picture of floats" : "height_field of a GIF's palette");
        return std::nullopt;
    }
    if (!has_cells(reader, place, file.width, file.height)) return std::nullopt;
    return heights_of(picture);
}

}  // namespace

ParsedShape parse_height_field(Reader& reader) {
    const std::optional<HeightFieldData> heights = parse_heights(reader);
    bool smooth = false;
    HeightField field;
    for (;;) {
        if (reader.accept(Word::smooth))
            smooth = true;
        else if (reader.accept(Word::water_level))
            field.lowest = reader.parse_float();
        else
            break;
    }
    if (!heights) return std::nullopt;
    field.data = *heights;
    if (smooth) field.normals = sample_normals(*field.data);
    return field;
}

}  // namespace rt
