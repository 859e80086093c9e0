// Pictures that a scene names, as values for patterns.
#pragma once

#include "syntax/parse_pattern.h"

namespace rt {

/// What may stand between the braces of image_map, image_pattern and bump_map.
struct StatedPicture {
    PictureFile file;
    std::optional<double> gamma;
    ImageMapping mapping;
    bool use_alpha = false;
    double filter = 0.0;
    double transmit = 0.0;
    std::optional<float> bump_size;
};

/// `{ png "name" ... }`; `word` is the block's.
StatedPicture parse_picture(Reader& reader, std::string_view word);

/// The texels' colours in the working space.
ColorImage colors_of(const StatedPicture& picture, const Gamma& working);
/// The file's numbers as grey, 0..1, or its alpha.
ValueGrid values_of(const StatedPicture& picture);

}  // namespace rt
