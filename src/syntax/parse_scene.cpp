// The statements of a file, and what is decided when it ends.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

#include "geometry/bezier_patch.h"
#include "syntax/blocks.h"
#include "syntax/choices.h"
#include "syntax/set_value.h"
#include "syntax/texture_layers.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

constexpr std::uint32_t statements_between_looks = 1024;

/// What the statements so far have placed.
struct Placed {
    bool camera = false;
    bool anything = false;  ///< an object, even one that can never be hit, or a light
};

/// What objects share counts once.
void count_texture(Reader& reader, const Span& place, const TextureLayers& layers) {
    if (layers->size() <= 1 && !has_any_pattern(layers)) return;
    if (reader.is_first_use(layers)) reader.count_scene_nodes(place, tree_size(*layers).nodes - 1);
}

bool same_bits(const Rgb& a, const Rgb& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Equal, and zeros have the same signs where a texture's numbers are printed.
bool prints_the_same(const Texture& a, const Texture& b) {
    if (!(a == b)) return false;
    const auto &p = std::get<PlainTexture>(a.content), &q = std::get<PlainTexture>(b.content);
    return same_bits(std::get<PigmentColor>(p.pigment.content).rgb, std::get<PigmentColor>(q.pigment.content).rgb) &&
           same_bits(p.finish.ambient, q.finish.ambient) && std::signbit(p.finish.diffuse) == std::signbit(q.finish.diffuse);
}

/// Gives an object the texture of the one before it if the two are the same: many files repeat one texture in every object. What patterns
/// and layers add up to is counted for each, so those stay as they are.
void share_texture(const std::vector<Object>& placed, TextureLayers& layers) {
    if (placed.empty() || layers->size() > 1 || has_any_pattern(layers)) return;
    const std::optional<TextureLayers>& last = placed.back().texture;
    if (!last || (*last)->size() > 1 || has_any_pattern(*last) || last->identity() == layers.identity()) return;
    if (prints_the_same((*last)->front(), layers->front())) layers = *last;
}

bool states_interior(const TextureLayers& layers) {
    const auto* top = std::get_if<PlainTexture>(&layers->back().content);
    return top && (top->finish.ior || top->finish.refraction || top->finish.caustics);
}

/// A mesh of which all faces show one texture is an object with that texture: some exporters write a mesh for every triangle.
void take_only_texture(Object& object) {
    auto* const mesh = std::get_if<Mesh>(&object.shape);
    if (!mesh || !mesh->textures || (*mesh->textures)->by_corner) return;
    const std::vector<std::uint32_t>& numbers = (*mesh->textures)->numbers;
    if (std::any_of(numbers.begin(), numbers.end(), [&](std::uint32_t number) { return number != numbers.front(); })) return;
    if (numbers.front() != TextureWeight::of_object) {
        const TextureLayers only = (**object.shape_textures)[numbers.front()];
        if (states_interior(*object.texture) || states_interior(only)) return;
        object.texture = only;
    }
    mesh->textures.reset();
    object.shape_textures.reset();
}

/// Likewise for a few textures of a shape: those of neighbours on one surface are mostly the same.
void share_shape_textures(const std::vector<Object>& placed, Object& object) {
    constexpr std::size_t few = 3;
    if (!object.shape_textures || placed.empty() || !placed.back().shape_textures) return;
    const std::vector<TextureLayers>& last = **placed.back().shape_textures;
    if (last.size() > few || (*object.shape_textures)->size() > few) return;
    std::vector<TextureLayers> own = **object.shape_textures;
    bool any = false;
    for (TextureLayers& layers : own) {
        const auto known = std::find(last.begin(), last.end(), layers);
        if (known == last.end() || known->identity() == layers.identity() || has_any_pattern(layers)) continue;
        layers = *known;
        any = true;
    }
    if (any) object.shape_textures = std::move(own);
}

/// Makes room for as many objects as the rest of the file would hold at the rate so far: what moves when the list grows has to be paid
/// for in pages, which cost as much as reading.
void make_room(Reader& reader) {
    Scene& scene = reader.scene();
    const std::size_t size = scene.objects.size();
    const Span last = reader.last_place();
    if (size < 128 || size < scene.objects.capacity() || last.file == Span::none || reader.has_replayed()) return;
    const std::size_t expected = size * (scene.sources.file(last.file).text.size() / std::max<std::size_t>(last.end, 1) + 1);
    scene.objects.reserve(std::clamp(expected, 2 * size, 64 * size));
}

/// A patch is halved until it is flat where it stands.
void refine(Object& object) {
    auto* mesh = std::get_if<Mesh>(&object.shape);
    if (!mesh || !mesh->patch || !object.transform) return;
    mesh->data = triangles_of(**mesh->patch, *object.transform);
    mesh->patch.reset();
}

void place_object(Reader& reader, Object object) {
    refine(object);
    if (!object.texture) object.texture = reader.default_texture();
    take_only_texture(object);
    count_texture(reader, object.span, *object.texture);
    if (object.interior_texture) count_texture(reader, object.span, *object.interior_texture);
    if (object.shape_textures)
        for (const TextureLayers& layers : **object.shape_textures) count_texture(reader, object.span, layers);
    share_texture(reader.scene().objects, *object.texture);
    share_shape_textures(reader.scene().objects, object);
    make_room(reader);
    reader.scene().objects.push_back(std::move(object));
}

void place_set(Reader& reader, ObjectValue value) {
    Scene& scene = reader.scene();
    const Span place = reader.last_place();
    Parts parts = resolved(std::move(value));
    reader.count_parts(place, size_of(parts));
    cut_textures(parts, reader.default_texture());
    shift_light_groups(parts, scene.light_groups);
    parts.set.first_object = static_cast<std::uint32_t>(scene.objects.size());
    for (SetNode& node : parts.set.nodes)
        if (node.medium != 0) node.medium += reader.placed_media();
    for (ObjectSet& set : separate_sets(parts.set)) scene.sets.push_back(std::move(set));
    for (Object& object : parts.objects) {
        if (object.medium != 0) object.medium += reader.placed_media();
        place_object(reader, std::move(object));
    }
    reader.placed_media() += parts.media;
    scene.light_groups += parts.light_groups;
    std::move(parts.lights.begin(), parts.lights.end(), std::back_inserter(scene.lights));
}

void place(Reader& reader, ObjectValue value) {
    for (Object& object : value.objects) place_object(reader, std::move(object));
    if (value.set) place_set(reader, std::move(value));
}

void place_camera(Reader& reader, const Span& word, Placed& placed) {
    if (placed.camera) reader.warn(word, "More than one camera in scene. Ignoring previous camera(s).");
    placed.camera = true;
    reader.scene().camera = parse_camera(reader);
}

void parse_background(Reader& reader) {
    reader.begin_block("background");
    PigmentColor color;
    if (at_color(reader) || reader.at_expression()) color = parse_color(reader);
    reader.end_block();
    reader.scene().background = color;
}

bool accept_surroundings(Reader& reader) {
    Scene& scene = reader.scene();
    if (reader.accept(Word::sky_sphere)) {
        const bool another = scene.sky_sphere.has_value();
        scene.sky_sphere = parse_sky_sphere(reader);
        if (another) reader.warn(reader.last_place(), "Only one sky-sphere allowed (last one will be used).");
    } else if (reader.accept(Word::fog)) {
        scene.fogs.push_back(parse_fog(reader));
    } else if (reader.accept(Word::rainbow)) {
        scene.rainbows.push_back(parse_rainbow(reader));
    } else {
        return false;
    }
    return true;
}

void parse_statement(Reader& reader, Placed& placed) {
    Scene& scene = reader.scene();
    if (accept_choices(reader, scene.options)) return;
    if (std::optional<Placeable> object = accept_object(reader)) {
        placed.anything = true;
        if (Light* light = std::get_if<Light>(&*object))
            scene.lights.push_back(std::move(*light));
        else
            place(reader, std::get<ObjectValue>(std::move(*object)));
        return;
    }
    const Token next = reader.peek();
    if (reader.accept(Word::camera)) {
        place_camera(reader, next.span, placed);
    } else if (reader.accept(Word::background)) {
        parse_background(reader);
    } else if (reader.accept(Word::default_)) {
        parse_default(reader);
    } else if (reader.accept(Word::global_settings)) {
        parse_global_settings(reader);
    } else if (accept_surroundings(reader)) {
        return;
    } else if (next.kind == Token::Kind::word && is_unmodelled_item(next.word)) {
        reader.take();
        skip_unmodelled_block(reader, next);
    } else {
        reader.fail_expected("object or directive");
    }
}

/// What the file stated decides; else the language version that is in force at its end, if one was ever set.
void decide_gamma(Reader& reader) {
    Gamma& gamma = reader.scene().settings.gamma;
    if (gamma.kind != Gamma::Kind::legacy) return;
    if (reader.scene().language_version >= 3.7) {
        gamma = {Gamma::Kind::power, 1.0};
        reader.warn_possible(
            Span{},
            "assumed_gamma not specified in this POV-Ray 3.7 or later scene. Future versions of POV-Ray may consider this a "
            "fatal error. To avoid this warning, explicitly specify 'assumed_gamma 1.0' in the global_settings section. See "
            "the documentation for more details.");
    } else {
        reader.warn(Span{},
                    "assumed_gamma not specified, so gamma_correction is turned off for compatibility with this pre POV-Ray 3.7 scene. See "
                    "the documentation for more details.");
    }
}

}  // namespace

void parse_scene(Reader& reader) {
    Placed placed;
    for (std::uint32_t count = 1; reader.peek().kind != Token::Kind::end; ++count) {
        parse_statement(reader, placed);
        if (count % statements_between_looks == 0) reader.check_memory();
    }
    if (!placed.anything) reader.warn(reader.peek().span, "No objects in scene.");
    decide_gamma(reader);
}

}  // namespace rt
