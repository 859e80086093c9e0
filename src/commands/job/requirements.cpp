#include "commands/job/requirements.h"

#include <fmt/format.h>

#include <set>
#include <unordered_set>

#include "commands/job/scene_choices.h"
#include "commands/job/stats.h"

namespace rt {

namespace {

std::string light_kind(const Light& light) {
    std::string kind = "point";
    if (light.type == Light::Type::spotlight) kind = "spotlight";
    if (light.type == Light::Type::cylinder) kind = "cylinder";
    if (light.area) kind = kind == "point" ? "area" : "area " + kind;
    if (light.parallel) kind = "parallel " + kind;
    return light.shadowless ? "shadowless " + kind : kind;
}

/// Walks textures once each and collects the names of what they use.
class FeatureCollector {
public:
    FeatureCollector(const Scene& scene, const SceneChoices& choices, std::set<std::string>& features)
        : scene_(scene), general_(choices.shading != ShadingModel::povray), features_(features) {}

    void object(const Object& object) {
        if (object.texture) layers(*object.texture);
        if (object.interior_texture) {
            features_.insert("interior texture");
            layers(*object.interior_texture);
        }
        if (object.shape_textures) {
            features_.insert("textures of parts of shapes");
            for (const TextureLayers& texture : **object.shape_textures) layers(texture);
        }
        if (object.interior) interior(**object.interior);
        if (object.transform) features_.insert("object transforms");
        if (object.no_shadow) features_.insert("no_shadow");
        if (object.no_image) features_.insert("no_image");
        if (object.no_reflection) features_.insert("no_reflection");
        if (object.double_illuminate) features_.insert("double_illuminate");
        if (object.inverse) features_.insert("inverse");
    }

private:
    const Scene& scene_;
    bool general_;
    std::set<std::string>& features_;
    std::unordered_set<const void*> seen_;

    void layers(const TextureLayers& layers) {
        if (seen_.insert(layers.identity()).second) layer_list(*layers);
    }

    void layer_list(const std::vector<Texture>& layers) {
        if (layers.size() > 1) features_.insert("layers");
        for (const Texture& texture : layers) {
            if (const auto* plain = std::get_if<PlainTexture>(&texture.content)) {
                pigment(plain->pigment);
                finish(plain->finish);
                if (plain->normal) features_.insert("normals");
                continue;
            }
            const PatternTexture& patterned = *std::get<Shared<PatternTexture>>(texture.content);
            features_.insert(std::string(name(patterned.pattern.pattern.kind)));
            for (const TextureLayers& entry : patterned.map->textures) layer_list(*entry);
        }
    }

    void pigment(const Pigment& pigment) {
        if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) {
            transparency(*color);
            return;
        }
        const PatternPigment& patterned = *std::get<Shared<PatternPigment>>(pigment.content);
        if (std::holds_alternative<Shared<ImageMap>>(patterned.map)) {
            features_.insert("image_map");
            return;
        }
        features_.insert(std::string(name(patterned.pattern.pattern.kind)));
        if (const auto* colors = std::get_if<Shared<ColorMap>>(&patterned.map))
            for (const PigmentColor& color : (*colors)->colors) transparency(color);
        if (const auto* pigments = std::get_if<Shared<PigmentMap>>(&patterned.map))
            for (const Pigment& entry : (*pigments)->pigments) this->pigment(entry);
    }

    void transparency(const PigmentColor& color) {
        if (color.filter != 0.0 || color.transmit != 0.0) features_.insert("transparency");
    }

    /// By the surroundings that the scene chooses from the catalogue, else by the finish itself.
    bool mirrors(const Finish& finish) const {
        const bool stated = finish.reflection.min != Rgb(0.0) || finish.reflection.max != Rgb(0.0);
        if (!general_ || (scene_.options.empty() && finish.options.empty())) return stated;
        const ModelChoice choice = choice_for(scene_, finish.options, {});
        return choice.model.env == Surroundings::finish ? stated : choice.s.value_or(finish.specular) > 0.0;
    }

    void finish(const Finish& finish) {
        const Reflection& reflection = finish.reflection;
        if (mirrors(finish)) features_.insert("reflection");
        if (reflection.fresnel) features_.insert("fresnel reflection");
        if (finish.specular != 0.0) features_.insert("specular highlights");
        if (finish.phong != 0.0) features_.insert("phong highlights");
        if (finish.emission != Rgb(0.0)) features_.insert("emission");
        if (finish.ior && *finish.ior != 1.0) features_.insert("refraction");
        if (finish.conserve_energy) features_.insert("conserve_energy");
    }

    void interior(const Interior& interior) {
        if (interior.ior && *interior.ior != 1.0) features_.insert("refraction");
        if (interior.fade_power > 0.0 || interior.fade_distance > 0.0) features_.insert("distance fading");
        if (interior.caustics != 0.0) features_.insert("caustics");
    }
};

MissingFeature placed(const Unmodelled& unmodelled, const Sources& sources) {
    const Span& span = unmodelled.span;
    if (span.file >= sources.size()) return {unmodelled.feature, "", 0, 0};
    const LineColumn place = sources.locate(span.file, span.begin);
    return {unmodelled.feature, sources.file(span.file).name, place.line, place.column};
}

}  // namespace

Requirements requirements_of(const Scene& scene) {
    Requirements needs;
    std::set<std::string> features;
    const SceneChoices choices = choices_of(scene);  // a mistake in them is one here too
    if (choices.edges.kind != EdgeOptions::Kind::off) features.insert("edge lines");
    FeatureCollector collector(scene, choices, features);
    needs.objects = scene.objects.size();
    needs.triangles = count_triangles(scene);
    for (const Object& object : scene.objects) {
        ++needs.shapes[name(object.shape)];
        collector.object(object);
    }
    for (const Light& light : scene.lights) {
        ++needs.lights[light_kind(light)];
        if (light.area) features.insert("area lights");
        if (light.fade_power > 0.0 && light.fade_distance > 0.0) features.insert("light fading");
    }
    needs.features.assign(features.begin(), features.end());
    needs.camera = name_of(projection_names, scene.camera.projection);
    needs.gamma = gamma_text(scene.settings.gamma);
    needs.language_version = scene.language_version;
    for (std::uint32_t i = 1; i < scene.sources.size(); ++i) needs.includes.push_back(scene.sources.file(i).name);
    for (const Unmodelled& unmodelled : scene.unmodelled) needs.missing.push_back(placed(unmodelled, scene.sources));
    return needs;
}

}  // namespace rt
