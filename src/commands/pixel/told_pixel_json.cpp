// Our JSON of a pixel's rays, back to numbers. Every mistake has its place.
#include <fmt/format.h>

#include "commands/base/json_value.h"
#include "commands/pixel/ray_tree_names.h"
#include "commands/pixel/told_pixel_file.h"

namespace rt {

namespace {

using nlohmann::json;

Ray ray_of(const JsonValue& value) { return {value["origin"].vector(), value["direction"].vector()}; }

ToldHit hit_of(const JsonValue& value) {
    ToldHit hit;
    hit.object = value["object"].count();
    hit.type = value["type"].word();
    hit.t = value["t"].number();
    hit.point = value["point"].vector();
    if (value.has("normal")) hit.normal = value["normal"].vector();
    if (value.has("object_ray")) hit.object_ray = ray_of(value["object_ray"]);
    if (value.has("inside")) hit.inside = value["inside"].truth();
    if (value.has("layers")) {
        const JsonValue layers = value["layers"];
        for (std::size_t i = 0; i < layers.size(); ++i)
            hit.layers.push_back({layers.item(i)["rgb"].vector(), layers.item(i)["filter"].number(), layers.item(i)["transmit"].number()});
    }
    if (value.has("shadows")) {
        const JsonValue shadows = value["shadows"];
        hit.shadows.emplace();
        for (std::size_t i = 0; i < shadows.size(); ++i)
            hit.shadows->push_back({shadows.item(i)["light"].count(), shadows.item(i)["sample"].count(),
                                    shadows.item(i)["transmitted"].vector(),
                                    shadows.item(i).has("crossed") && shadows.item(i)["crossed"].size() > 0, true});
    }
    return hit;
}

ToldRay::Kind kind_of(RayNode::Kind kind) {
    if (kind == RayNode::Kind::camera) return ToldRay::Kind::camera;
    const bool mirrored = kind == RayNode::Kind::reflected || kind == RayNode::Kind::total;
    return mirrored ? ToldRay::Kind::reflection : ToldRay::Kind::refraction;
}

ToldRay::End end_of(RayNode::End end) {
    switch (end) {
        case RayNode::End::surface:
            return ToldRay::End::surface;
        case RayNode::End::background:
            return ToldRay::End::background;
        case RayNode::End::level:
            return ToldRay::End::level;
        case RayNode::End::weight:
            return ToldRay::End::weight;
    }
    return ToldRay::End::background;
}

/// A ray behind those of its sample that are already known.
ToldRay told_ray(const JsonValue& value, const std::vector<ToldRay>& before) {
    ToldRay ray;
    const JsonValue parent = value["parent"], kind = value["kind"], end = value["end"];
    const RayNode::Kind told_kind = kind.name(ray_kind_names, "kind of ray");
    ray.kind = kind_of(told_kind);
    ray.total = told_kind == RayNode::Kind::total;
    ray.end = end_of(end.name(ray_end_names, "kind of end"));
    if ((ray.kind == ToldRay::Kind::camera) != before.empty()) kind.fail("the camera ray first and no other one");
    if (parent.is_null() != before.empty()) parent.fail(before.empty() ? "null" : "the place of the ray that causes this one");
    if (!parent.is_null()) {
        ray.parent = parent.count();
        if (ray.parent >= before.size() || !before[ray.parent].hit) parent.fail("the place of a ray before that meets a surface");
    }
    ray.ray = ray_of(value);
    if (ray.end == ToldRay::End::surface) ray.hit = hit_of(value["hit"]);
    if (value.has("factor")) ray.factor = value["factor"].vector();
    constexpr std::pair<const char*, LightPart> parts[] = {{"ambient", LightPart::ambient},       {"diffuse", LightPart::diffuse},
                                                           {"specular", LightPart::specular},     {"reflection", LightPart::reflection},
                                                           {"refraction", LightPart::refraction}, {"background", LightPart::background},
                                                           {"radiance", LightPart::radiance}};
    for (const auto& [name, part] : parts)
        if (value.has(name)) ray.part(part) = value[name].vector();
    if (value.has("shares")) {
        const JsonValue shares = value["shares"];
        ray.shares = {shares["local"].number(), shares["reflection"].number(), shares["transmission"].number()};
    }
    return ray;
}

ToldPixel told_pixel(const JsonValue& value) {
    ToldPixel told;
    if (value["format"].word() != ray_tree_format) value["format"].fail(fmt::format("\"{}\"", ray_tree_format));
    const JsonValue pixel = value["pixel"];
    told.x = static_cast<int>(pixel["x"].count());
    told.y = static_cast<int>(pixel["y"].count());
    constexpr NameTable<bool, 2> origins{{{"top left", true}, {"bottom left", false}}};
    told.from_top = pixel["origin"].name(origins, "corner, \"top left\" or \"bottom left\"");
    const JsonValue color = pixel["color"];
    if (color.size() != 3) color.fail("a list of three bytes");
    for (std::size_t c = 0; c < 3; ++c) told.color[c] = static_cast<int>(color.item(c).count());
    if (value.has("camera") && value["camera"]["projection"].word() == "perspective") {
        const JsonValue camera = value["camera"];
        told.camera = {camera["direction"].vector(), camera["right"].vector(), camera["up"].vector(),
                       static_cast<int>(value["width"].count()), static_cast<int>(value["height"].count())};
    }
    const JsonValue samples = value["samples"];
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const JsonValue rays = samples.item(s);
        std::vector<ToldRay>& sample = told.samples.emplace_back();
        for (std::size_t i = 0; i < rays.size(); ++i) sample.push_back(told_ray(rays.item(i), sample));
        if (sample.empty()) rays.fail("a camera ray");
    }
    if (told.samples.empty()) samples.fail("the rays of a sample");
    return told;
}

}  // namespace

ToldPixel told_pixel_of_json(const Sources& sources) {
    const json content = parse_json(sources);
    return told_pixel(JsonValue(sources, content));
}

}  // namespace rt
