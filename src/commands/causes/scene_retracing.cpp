// Mistakes that send rays on other ways: the scene is traced again with each.
#include <fmt/format.h>

#include "commands/causes/scene_causes.h"

namespace rt {

namespace {

using Stage = SceneSamples::Stage;

struct Variant {
    const char *cause, *words;  ///< the words stand behind "our own picture"
    void (*change)(Stage&);
    bool rebuilds = false;  ///< the scene is compiled anew
};

CourseRules& rules_of(Stage& stage) { return *stage.options.trace.course; }

template <typename Change>
void change_objects(Stage& stage, const Change& change) {
    stage.other_scene = stage.scene;
    for (Object& object : stage.other_scene->objects) change(object);
}

template <typename Change>
void change_ior(Stage& stage, const Change& change) {
    for (CompiledInterior& interior : stage.interiors) interior.ior = change(interior.ior);
}

/// Some colour of the object's pigment lets light pass.
bool transmits(const Object& object) {
    if (!object.texture) return false;
    const PlainTexture* plain = std::get_if<PlainTexture>(&(**object.texture).front().content);
    const PigmentColor* color = plain != nullptr ? std::get_if<PigmentColor>(&plain->pigment.content) : nullptr;
    return color != nullptr && (color->filter > 0.0 || color->transmit > 0.0);
}

const Variant variants[] = {
    {"half-pixel shift", "with rays through the upper left corners of the pixels", [](Stage& s) { s.shift_x = s.shift_y = -0.5; }},
    {"half-pixel shift", "with rays through the lower right corners of the pixels", [](Stage& s) { s.shift_x = s.shift_y = 0.5; }},
    {"half-pixel shift", "with rays through the lower left corners of the pixels", [](Stage& s) { s.shift_x = -0.5, s.shift_y = 0.5; }},
    {"half-pixel shift", "with rays through the upper right corners of the pixels", [](Stage& s) { s.shift_x = 0.5, s.shift_y = -0.5; }},
    {"half-pixel shift", "with rays through the left edges of the pixels", [](Stage& s) { s.shift_x = -0.5; }},
    {"half-pixel shift", "with rays through the right edges of the pixels", [](Stage& s) { s.shift_x = 0.5; }},
    {"half-pixel shift", "with rays through the upper edges of the pixels", [](Stage& s) { s.shift_y = -0.5; }},
    {"half-pixel shift", "with rays through the lower edges of the pixels", [](Stage& s) { s.shift_y = 0.5; }},
    {"missing anti-aliasing", "with one ray a pixel", [](Stage& s) { s.options.sampling.method = Sampling::Method::none; }},
    {"needless anti-aliasing", "with 3 x 3 rays a pixel",
     [](Stage& s) {
         if (s.options.sampling.method == Sampling::Method::none) s.options.sampling = {.method = Sampling::Method::grid, .depth = 3};
     }},
    {"wrong depth", "with 7 further rays on a path", [](Stage& s) { rules_of(s).further_rays = 7; }},
    {"wrong depth", "with 10 further rays on a path", [](Stage& s) { rules_of(s).further_rays = 10; }},
    {"missing Fresnel", "without -fresnel", [](Stage& s) { rules_of(s).fresnel = false; }},
    {"needless Fresnel", "with -fresnel", [](Stage& s) { rules_of(s).fresnel = true; }},
    {"missing absorption", "without -beers", [](Stage& s) { rules_of(s).beers = false; }},
    {"refraction ratio", "with indices of refraction upside down",
     [](Stage& s) { change_ior(s, [](double n) { return n > 0.0 ? 1.0 / n : n; }); }},
    {"refraction ratio", "with transmitted rays that go straight on", [](Stage& s) { change_ior(s, [](double) { return 1.0; }); }},
    {"wrong camera", "with the camera's right vector as long as its up vector",
     [](Stage& s) { s.camera.right *= length(s.camera.up) / length(s.camera.right); }},
    {"wrong camera", "with the view direction not normalised to 1",
     [](Stage& s) {
         if (s.scene.camera.look_at) s.camera.direction = *s.scene.camera.look_at - s.scene.camera.location;
     }},
    {"missing shadows", "with no shadows of transparent objects",
     [](Stage& s) { change_objects(s, [](Object& o) { o.no_shadow = o.no_shadow || transmits(o); }); }, true},
    {"wrong transform", "without any transform", [](Stage& s) { change_objects(s, [](Object& o) { o.transform.reset(); }); }, true},
    {"wrong transform", "with transforms inverted",
     [](Stage& s) {
         change_objects(s, [](Object& o) {
             if (o.transform) o.transform = o.transform->inverse();
         });
     },
     true},
    {"wrong transform", "with transforms without their translations",
     [](Stage& s) {
         change_objects(s, [](Object& o) {
             if (o.transform) o.transform->offset = o.transform->inverse_offset = Vec3(0.0);
         });
     },
     true},
};

Finding finding_of(const SceneSamples& samples, const char* cause, const std::string& words, const std::vector<Rgb>& light) {
    const Misfit left = misfit(samples, light);
    return {cause, what_is_left(samples, words, left), share_left(left, samples.whole())};
}

/// Objects of one shape left out, for each shape of the scene.
void add_missing_shapes(const SceneSamples& samples, std::vector<Finding>& findings) {
    std::vector<std::string> shapes;
    for (const Object& object : samples.scene().objects)
        if (const std::string shape = name(object.shape); std::find(shapes.begin(), shapes.end(), shape) == shapes.end())
            shapes.push_back(shape);
    for (const std::string& shape : shapes) {
        const auto light = samples.traced([&](Stage& stage) {
            stage.other_scene = stage.scene;
            std::erase_if(stage.other_scene->objects, [&](const Object& object) { return name(object.shape) == shape; });
        });
        if (light) findings.push_back(finding_of(samples, "missing objects", fmt::format("without any {}", shape), *light));
    }
}

}  // namespace

std::vector<Finding> retracing_findings(const SceneSamples& samples) {
    std::vector<Finding> findings;
    for (const Variant& variant : variants) {
        if (variant.rebuilds && samples.has_many_objects()) continue;
        if (const auto light = samples.traced(variant.change))
            findings.push_back(finding_of(samples, variant.cause, variant.words, *light));
    }
    if (!samples.has_many_objects()) add_missing_shapes(samples, findings);
    return findings;
}

}  // namespace rt
