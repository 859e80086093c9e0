// image_map { }, image_pattern { }, bump_map { } and density_file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "patterns/density.h"
#include "syntax/expression.h"
#include "syntax/parameters.h"
#include "syntax/picture.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

/// What files of a type may be called.
struct PictureType {
    Word word;
    std::array<std::string_view, 4> extensions;  ///< empty ones stand for none
};
constexpr std::array picture_types{PictureType{Word::bmp, {".bmp", ".BMP"}},
                                   PictureType{Word::exr, {".exr", ".EXR"}},
                                   PictureType{Word::gif, {".gif", ".GIF"}},
                                   PictureType{Word::hdr, {".hdr", ".HDR"}},
                                   PictureType{Word::iff, {".iff", ".IFF"}},
                                   PictureType{Word::jpeg, {".jpg", ".JPG", ".jpeg", ".JPEG"}},
                                   PictureType{Word::pgm, {".pgm", ".PGM"}},
                                   PictureType{Word::png, {".png", ".PNG"}},
                                   PictureType{Word::pot, {".pot", ".POT"}},
                                   PictureType{Word::ppm, {".ppm", ".PPM"}},
                                   PictureType{Word::sys, {".bmp", ".BMP"}},
                                   PictureType{Word::tga, {".tga", ".TGA"}},
                                   PictureType{Word::tiff, {".tif", ".TIF", ".tiff", ".TIFF"}}};

/// `filter all f`, `filter index, f`: the latter means entries of a palette, which pictures do not keep.
void parse_share(Reader& reader, double& all) {
    const Token word = reader.take();
    if (reader.accept(Word::all)) {
        all = reader.parse_float();
        return;
    }
    reader.unmodelled(word.span, fmt::format("{} of one palette entry", text(word.word)));
    reader.parse_float();
    reader.accept_comma();
    reader.parse_float();
}

void parse_mapping_number(Reader& reader, const Token& word, ImageMapping& mapping) {
    const int n = parse_int(reader);
    if (word.is(Word::map_type)) {
        if (n != 0 && n != 1 && n != 2 && n != 5) reader.fail(reader.last_place(), "Invalid map_type value.");
        mapping.type = n;
    } else {
        if (n != 0 && n != 2 && n != 3 && n != 4) reader.fail(reader.last_place(), "Invalid interpolate value.");
        mapping.interpolate = n;
    }
}

bool accept_item(Reader& reader, StatedPicture& picture) {
    const Token next = reader.peek();
    if (reader.accept(Word::map_type) || reader.accept(Word::interpolate)) {
        parse_mapping_number(reader, next, picture.mapping);
    } else if (reader.accept(Word::once)) {
        picture.mapping.once = reader.parse_bool_or(true);
    } else if (next.is(Word::filter)) {
        parse_share(reader, picture.filter);
    } else if (next.is(Word::transmit)) {
        parse_share(reader, picture.transmit);
    } else if (reader.accept(Word::offset)) {
        picture.mapping.offset = reader.parse_vector2();
    } else if (reader.accept(Word::repeat)) {
        picture.mapping.repeat = reader.parse_vector2();
    } else if (reader.accept(Word::use_alpha)) {
        picture.use_alpha = true;
    } else if (reader.accept(Word::bump_size)) {
        picture.bump_size = static_cast<float>(reader.parse_float());
    } else if (reader.accept(Word::use_index)) {
        reader.unmodelled(next.span, "use_index");
    } else if (reader.accept(Word::use_color) || reader.accept(Word::use_colour)) {
        return true;  // what is done anyway
    } else {
        return false;
    }
    return true;
}

void parse_gamma(Reader& reader, StatedPicture& picture) {
    if (!reader.accept(Word::gamma)) return;
    picture.srgb = reader.accept(Word::srgb);
    if (!picture.srgb) picture.gamma = reader.parse_float();
}

PictureFile open_picture(Reader& reader, const Token& name, std::span<const std::string_view> extensions) {
    try {
        if (std::optional<PictureFile> file = reader.find_picture(name.text, extensions)) {
            if (file->width > 0 && file->height > 0) return std::move(*file);
            reader.fail(name.span, "The picture has no texels.");
        }
    } catch (const OptionError& problem) {
        reader.fail(name.span, problem.what());
    } catch (const LimitError& problem) {
        reader.fail_limit(name.span, problem.what(), "picture");
    }
    reader.warn_possible(name.span, fmt::format("Cannot find file '{}', even after trying to append file type extension.", name.text));
    reader.fail(name.span, "Cannot find image file.");
}

}  // namespace

void parse_picture_file(Reader& reader, StatedPicture& picture) {
    const Word first = reader.peek().word;
    const bool typed = std::any_of(picture_types.begin(), picture_types.end(), [&](const PictureType& type) { return type.word == first; });
    if (typed) reader.take();
    if (!typed && !at_string(reader)) reader.fail_expected("map file spec");
    std::vector<std::string_view> extensions;
    for (const PictureType& type : picture_types)
        if (!typed || type.word == first)
            std::copy_if(type.extensions.begin(), type.extensions.end(), std::back_inserter(extensions), [](auto e) { return !e.empty(); });
    Token name = reader.peek();
    const std::string text = reader.parse_string();
    name.text = text;
    picture.file = open_picture(reader, name, extensions);
    parse_gamma(reader, picture);
}

StatedPicture parse_picture(Reader& reader, std::string_view word) {
    reader.begin_block(word);
    StatedPicture picture;
    if (reader.peek().is('<')) {
        reader.parse_vector();
        reader.warn(reader.peek().span, "Old style orientation vector or map type not supported. Ignoring value.");
    }
    if (reader.peek().is(Word::function)) {
        reader.unmodelled(reader.take().span, fmt::format("{} {{ function }}", word));
        skip_to_block_end(reader);
        picture.file = {.width = 1, .height = 1, .channels = 1, .values = {0.0f}, .gamma = {}};
    } else {
        parse_picture_file(reader, picture);
    }
    while (accept_item(reader, picture)) continue;
    reader.end_block();
    return picture;
}

Shared<ImageMap> parse_image_map(Reader& reader) {
    const StatedPicture picture = parse_picture(reader, "image_map");
    // Before 3.7 whole numbers of a file that says nothing of its gamma are colours of the working space as they are.
    const bool says_gamma = picture.gamma || picture.file.gamma || picture.file.max_value == 0;
    const bool as_it_is = reader.scene().language_version < 3.7 && !says_gamma;
    const Gamma working = as_it_is ? Gamma{.kind = Gamma::Kind::legacy} : reader.scene().settings.gamma;
    return ImageMap{colors_of(picture, working), picture.mapping, picture.filter, picture.transmit};
}

ImageNumbers parse_value_image(Reader& reader, float* size) {
    const StatedPicture picture = parse_picture(reader, size ? "bump_map" : "image_pattern");
    if (size && picture.bump_size) *size = *picture.bump_size;
    return {values_of(picture), picture.mapping};
}

Shared<ValueGrid> parse_density_file(Reader& reader) {
    reader.accept(Word::df3);
    const Span place = reader.peek().span;
    const std::string name = reader.parse_string();
    const std::optional<std::string> bytes = reader.read_file(name, {""});
    if (!bytes) {
        reader.warn_possible(place, fmt::format("Cannot find file '{}', even after trying to append file type extension.", name));
        reader.fail(place, "Cannot read media density file.");
    }
    std::optional<ValueGrid> grid = read_df3(*bytes);
    if (!grid) reader.fail(place, "Invalid density file size");
    return std::move(*grid);
}

}  // namespace rt
