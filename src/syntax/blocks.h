// One function per block of the language. Each is called after its word was taken and reads from '{' to '}'.
#pragma once

#include "syntax/reader.h"

namespace rt {

/// The whole file: top-level statements until the end.
void parse_scene(Reader& reader);

/// The value of `#declare NAME =` where it is no numeric expression and no string: the next token begins a block or names a declared value.
/// Empty if it begins nothing that can be declared.
std::optional<Value> parse_declared_block(Reader& reader);
/// `#default { ... }`; the next token is '{'.
void parse_default(Reader& reader);

PigmentColor parse_color(Reader& reader);  ///< every form of a colour, with or without `color`
bool at_color(Reader& reader);             ///< does a colour keyword or a colour identifier come next?
Camera parse_camera(Reader& reader);
Light parse_light(Reader& reader);
void parse_global_settings(Reader& reader);
Pigment parse_pigment(Reader& reader);
Finish parse_finish(Reader& reader, Finish base);
TextureLayers parse_texture(Reader& reader);
Shared<Interior> parse_interior(Reader& reader, Shared<Interior> base);
MaterialValue parse_material(Reader& reader);
/// Any of translate, rotate, scale, matrix, transform at the next token; empty if none is there.
std::optional<Transform> accept_transform(Reader& reader);
/// An object statement whose word is next (sphere ... mesh2, object, or a declared object's name); empty if there is none.
std::optional<ObjectValue> accept_object(Reader& reader);

}  // namespace rt
