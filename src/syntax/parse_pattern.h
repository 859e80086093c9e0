// What pigments, normals and patterns of textures have in common: the pattern's kind and numbers, its modifiers, its map.
#pragma once

#include "scene/object_probe.h"
#include "syntax/blocks.h"

namespace rt {

enum class PatternUse { pigment, normal, texture };

/// A new kind for a pattern that may be a declared one: all stays but its numbers, the frequency of cells and the wave of kinds that have
/// their own.
void become(StatedPattern& stated, PatternKind kind);
/// Takes the pattern that comes next, up to its colours: its kind with its numbers.
bool accept_pattern(Reader& reader, StatedPattern& stated, PatternUse use);
/// Takes a transform, a warp or a number of the pattern.
bool accept_pattern_modifier(Reader& reader, StatedPattern& stated, PatternUse use);
/// `warp { }` after its word.
Warp parse_warp(Reader& reader);
/// One of `turbulence`, `octaves`, `omega`, `lambda`.
bool accept_turbulence_item(Reader& reader, std::optional<Turbulence>& turbulence);

bool takes_map(PatternKind kind);  ///< all but those that list their entries
/// The object of `object { }` after that word, and what moves it; a list follows inside the braces.
Bodies parse_bodies_of_pattern(Reader& reader);
/// The end of such a list: that of `object` ends the braces that the object stands in.
void end_list(Reader& reader, PatternKind kind);

/// What the numbers of a map's entries are.
enum class MapValues : std::uint8_t { places, weights };
inline MapValues map_values(PatternKind kind) { return kind == PatternKind::average ? MapValues::weights : MapValues::places; }

/// color_map { }, pigment_map { }, normal_map { }, texture_map { }, slope_map { } after the word. Weights may be left out.
Shared<ColorMap> parse_color_map(Reader& reader);
Shared<PigmentMap> parse_pigment_map(Reader& reader, MapValues values);
Shared<NormalMap> parse_normal_map(Reader& reader, MapValues values);
Shared<TextureMap> parse_texture_map(Reader& reader, MapValues values);
Shared<SlopeMap> parse_slope_map(Reader& reader);

/// What stands between the braces of pigment { } and normal { }, and in the entries of their maps.
Pigment parse_pigment_body(Reader& reader, Pigment base);
Normal parse_normal_body(Reader& reader, const Normal* base);
/// `normal { }` after its word; edits `base` if there is one.
Shared<Normal> parse_normal(Reader& reader, std::optional<Shared<Normal>> base);

/// `image_map { }` after its word.
Shared<ImageMap> parse_image_map(Reader& reader);
/// `image_pattern { }` and `bump_map { }` after the word; `size` takes `bump_size`, if it may.
ImageNumbers parse_value_image(Reader& reader, float* size);
/// `density_file df3 "name"` after its word.
Shared<ValueGrid> parse_density_file(Reader& reader);

}  // namespace rt
