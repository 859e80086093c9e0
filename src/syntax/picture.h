// Pictures that a scene names, as values for patterns.
#pragma once

#include "geometry/height_field.h"
#include "syntax/parse_pattern.h"

namespace rt {

/// What may stand between the braces of image_map, image_pattern and bump_map.
struct StatedPicture {
    PictureFile file;
    std::optional<double> gamma;
    bool srgb = false;  ///< `gamma srgb`
    ImageMapping mapping;
    bool use_alpha = false;
    double filter = 0.0;
    double transmit = 0.0;
    std::optional<float> bump_size;
};

/// `{ png "name" ... }`; `word` is the block's.
StatedPicture parse_picture(Reader& reader, std::string_view word);

/// The file's type and name and how it is decoded: what comes first in all blocks that show pictures.
void parse_picture_file(Reader& reader, StatedPicture& picture);

/// The texels' colours in the working space.
ColorImage colors_of(const StatedPicture& picture, const Gamma& working);
/// The file's numbers as grey, 0..1, or its alpha.
ValueGrid values_of(const StatedPicture& picture);
/// The same as heights, the bottom row first: 65535 times the grey value, or 256 times the entry's number where there is a palette. Of
/// colours of eight bits red and green count as the high and the low byte. No float pictures.
HeightFieldData heights_of(const StatedPicture& picture);

}  // namespace rt
