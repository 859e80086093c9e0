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

PigmentColor parse_color(Reader& reader);  ///< every form of a colour, with or without `color`; a bare float fills all five channels
Rgb parse_rgb(
    Reader& reader);  ///< where only red, green and blue count: filter and transmit are dropped with a warning; black if none is there
bool at_color(Reader& reader);  ///< does a colour keyword or a colour identifier come next?
/// With the vectors as stated: what `angle` and `look_at` make of them depends on the profile.
Camera parse_camera(Reader& reader);
/// Moves everything of the light that has a place or a direction, what it shines through included.
void transform_light(Reader& reader, const Span& place, Light& light, const Transform& t);
/// The modifiers of a declared light: any that an object takes, of which only transforms mean anything.
void modify_light(Reader& reader, const Span& place, Light& light);
/// Into the reader's scene.
void parse_global_settings(Reader& reader);
// Each of these starts from `base` unless the block begins with a declared name.
Pigment parse_pigment(Reader& reader, Pigment base);
Finish parse_finish(Reader& reader, Finish base);
Shared<Interior> parse_interior(Reader& reader, Shared<Interior> base);
MaterialValue parse_material(Reader& reader, MaterialValue base);
/// `texture { }`: appends its layers to `layers`; an empty optional means that there is no texture yet.
void parse_texture(Reader& reader, std::optional<TextureLayers>& layers);
/// What stands between its braces, and in the entries of a texture_map.
void parse_texture_body(Reader& reader, std::optional<TextureLayers>& layers);
// What surrounds the objects, after the word.
SkySphere parse_sky_sphere(Reader& reader);
Fog parse_fog(Reader& reader);
Rainbow parse_rainbow(Reader& reader);
/// Any of translate, rotate, scale, matrix, transform at the next token; empty if none is there.
std::optional<Transform> accept_transform(Reader& reader);
/// What an object statement places.
using Placeable = std::variant<ObjectValue, Light>;
/// An object statement whose word is next (sphere ... mesh2, object, light_source, or a declared object's or light's name); empty if
/// there is none.
std::optional<Placeable> accept_object(Reader& reader);
/// `{ OBJECT MODIFIERS }`; `word` is the block's. The object is moved to `location` before it is modified.
Placeable parse_object_block(Reader& reader, std::string_view word, const Vec3& location = Vec3(0.0));
/// Of a light that shows an object: a set of both.
Placeable parse_light(Reader& reader);
/// A set of the group's objects with lights that shine on them alone.
ObjectValue parse_light_group(Reader& reader);

}  // namespace rt
