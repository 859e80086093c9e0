#include "commands/job/course_scene.h"

#include <fmt/format.h>

#include <unordered_set>

namespace rt {

namespace {

[[noreturn]] void fail(const Scene& scene, const Span& span, std::string_view what) {
    throw SceneError(
        scene.sources.describe(span, "Parse Error", fmt::format("{} is no part of the course's scenes; --shading povray shows it.", what)));
}

void check_light(const Scene& scene, const Light& light) {
    if (light.type != Light::Type::point) fail(scene, light.span, "A lamp other than a point");
    if (light.parallel) fail(scene, light.span, "A parallel lamp");
    if (light.shadowless) fail(scene, light.span, "A lamp without shadows");
    if (light.area) fail(scene, light.span, "An area light");
    if (light.mask) fail(scene, light.span, "A lamp that is projected through something");
    if (light.group != 0) fail(scene, light.span, "A lamp of a group");
    if (light.fade_power != 0.0 && light.fade_distance != 0.0) fail(scene, light.span, "A lamp that fades");
}

void check_pigment(const Scene& scene, const Object& object, const Pigment& pigment) {
    if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) {
        if (color->transmit != 0.0) fail(scene, object.span, "'transmit'");
        return;
    }
    const PatternPigment& patterned = *std::get<Shared<PatternPigment>>(pigment.content);
    if (std::holds_alternative<Shared<ImageMap>>(patterned.map)) fail(scene, object.span, "'image_map'");
    if (const auto* colors = std::get_if<Shared<ColorMap>>(&patterned.map))
        for (const PigmentColor& color : (*colors)->colors)
            if (color.transmit != 0.0) fail(scene, object.span, "'transmit'");
    if (const auto* pigments = std::get_if<Shared<PigmentMap>>(&patterned.map))
        for (const Pigment& entry : (*pigments)->pigments) check_pigment(scene, object, entry);
}

/// The first word of a finish that has an effect for POV-Ray and none here.
std::string_view unused_word(const Finish& f) {
    const auto coloured = [](const Rgb& c) { return c.r != c.g || c.g != c.b; };
    if (f.phong != 0.0) return "phong";
    if (f.brilliance != 1.0) return "brilliance";
    if (f.metallic != 0.0) return "metallic";
    if (f.emission != Rgb(0.0)) return "emission";
    if (f.diffuse_back != 0.0) return "diffuse of the back";
    if (f.conserve_energy) return "conserve_energy";
    if (coloured(f.ambient)) return "a coloured ambient";
    const Reflection& r = f.reflection;
    if (coloured(r.max) || r.min != r.max || r.exponent != 1.0 || r.metallic != 0.0) return "reflection beyond one number";
    return "";
}

void check_layers(const Scene& scene, const Object& object, const std::vector<Texture>& layers, const MessageSink& warn) {
    if (layers.size() > 1) fail(scene, object.span, "A texture of several layers");
    for (const Texture& texture : layers) {
        const auto* plain = std::get_if<PlainTexture>(&texture.content);
        if (plain == nullptr) {
            const PatternTexture& patterned = *std::get<Shared<PatternTexture>>(texture.content);
            if (!has_cells(patterned.pattern.pattern.kind)) fail(scene, object.span, "A mixture of textures");
            for (const TextureLayers& entry : patterned.map->textures) check_layers(scene, object, *entry, warn);
            continue;
        }
        if (plain->normal) fail(scene, object.span, "'normal'");
        check_pigment(scene, object, plain->pigment);
        if (const std::string_view word = unused_word(plain->finish); !word.empty())
            warn(scene.sources.describe(object.span, "Parse Warning", fmt::format("The course's rules do not use {}.", word)));
    }
}

}  // namespace

void read_as_course(ParseOptions& options) {
    options.rotation = Rotation::csc473;
    options.default_finish.ambient = Rgb(0.0);
    options.default_finish.diffuse = 0.0;
}

void check_course_scene(const Scene& scene, const MessageSink& warn) {
    if (scene.camera.projection != Projection::perspective)
        fail(scene, scene.camera.span, fmt::format("A camera of the type '{}'", name_of(projection_names, scene.camera.projection)));
    for (const Light& light : scene.lights) check_light(scene, light);
    if (scene.sky_sphere) fail(scene, {}, "'sky_sphere'");
    if (!scene.fogs.empty()) fail(scene, {}, "'fog'");
    if (!scene.rainbows.empty()) fail(scene, {}, "'rainbow'");
    std::unordered_set<const void*> seen;  // objects share textures
    for (const Object& object : scene.objects) {
        if (object.interior_texture) fail(scene, object.span, "'interior_texture'");
        if (object.shape_textures) fail(scene, object.span, "A texture of a part of a shape");
        if (object.texture && seen.insert(object.texture->identity()).second) check_layers(scene, object, **object.texture, warn);
    }
}

}  // namespace rt
