// Shapes: the parameters between a shape's '{' and its modifiers.
#pragma once

#include <concepts>

#include "syntax/reader.h"

namespace rt {

/// What was read: no shape if it can never be hit (a degenerate triangle, ...), for which POV-Ray's warning was given.
struct ParsedShape {
    ParsedShape(std::nullopt_t) {}  // NOLINT: implicit, as that of an optional
    template <std::convertible_to<Shape> S>
    ParsedShape(S read, std::vector<TextureLayers> stated = {}) : shape(std::move(read)), textures(std::move(stated)) {}  // NOLINT

    std::optional<Shape> shape;
    std::vector<TextureLayers> textures;  ///< of its parts, by their numbers
};

/// How a shape is read; `word` is none if it is no shape's word.
struct ShapeSyntax {
    Word word = Word::none;
    ParsedShape (*parse)(Reader& reader) = nullptr;
    bool takes_sturm = false;
    bool takes_hierarchy = false;
};
const ShapeSyntax* find_shape(Word w);

ParsedShape parse_mesh(Reader& reader);
ParsedShape parse_mesh2(Reader& reader);
ParsedShape parse_polygon(Reader& reader);
ParsedShape parse_quadric(Reader& reader);
ParsedShape parse_cubic(Reader& reader);
ParsedShape parse_quartic(Reader& reader);
ParsedShape parse_poly(Reader& reader);
ParsedShape parse_polynomial(Reader& reader);
ParsedShape parse_prism(Reader& reader);
ParsedShape parse_lathe(Reader& reader);
ParsedShape parse_sor(Reader& reader);
ParsedShape parse_blob(Reader& reader);
ParsedShape parse_text(Reader& reader);
ParsedShape parse_bicubic_patch(Reader& reader);
ParsedShape parse_height_field(Reader& reader);
ParsedShape parse_sphere_sweep(Reader& reader);
ParsedShape parse_isosurface(Reader& reader);

}  // namespace rt
