#include "commands/pixel/ray_tree_values.h"

#include <cmath>

#include "commands/pixel/course_text.h"
#include "commands/pixel/ray_tree_names.h"

namespace rt {

Json json_of(double x) {
    if (std::isnan(x)) return "NaN";
    if (std::isinf(x)) return x > 0.0 ? "Infinity" : "-Infinity";
    return x;
}

Json json_of(const Vec3& v) { return {json_of(v.x), json_of(v.y), json_of(v.z)}; }

Json json_of(const Ray& ray) { return {{"origin", json_of(ray.origin)}, {"direction", json_of(ray.direction)}}; }

Json json_of(const CameraBasis& camera) {
    return {{"projection", name_of(projection_names, camera.projection)},
            {"location", json_of(camera.origin)},
            {"direction", json_of(camera.direction)},
            {"right", json_of(camera.right)},
            {"up", json_of(camera.up)}};
}

namespace {

Json layers_of(const RayNode& node) {
    Json layers = Json::array();
    for (const PigmentColor& color : node.layers)
        layers.push_back({{"rgb", json_of(color.rgb)}, {"filter", json_of(color.filter)}, {"transmit", json_of(color.transmit)}});
    return layers;
}

Json shadows_of(const RayNode& node) {
    Json shadows = Json::array();
    for (const ShadowAnswer& shadow : node.shadows) {
        Json crossed = Json::array();
        for (const std::uint32_t object : shadow.crossed) crossed.push_back(object + 1);
        shadows.push_back(
            {{"light", shadow.light}, {"sample", shadow.sample}, {"transmitted", json_of(shadow.transmitted)}, {"crossed", crossed}});
    }
    return shadows;
}

Json hit_of(const Scene& scene, const RayNode& node) {
    const Object& object = scene.objects[node.object];
    Json hit = {{"object", node.object + 1}, {"type", type_text(object)},    {"part", node.part},
                {"t", json_of(node.t)},      {"point", json_of(node.point)}, {"normal", json_of(node.normal)},
                {"inside", node.inside},     {"layers", layers_of(node)},    {"shadows", shadows_of(node)}};
    if (object.transform && !object.transform->is_identity()) hit["object_ray"] = json_of(object.transform->inverse_ray(node.ray));
    return hit;
}

}  // namespace

Json json_of(const Scene& scene, const RayNode& node) {
    Json ray = {{"parent", nullptr},
                {"kind", name_of(ray_kind_names, node.kind)},
                {"level", node.level},
                {"weight", json_of(node.weight)},
                {"origin", json_of(node.ray.origin)},
                {"direction", json_of(node.ray.direction)},
                {"factor", json_of(node.factor)},
                {"exponent", json_of(node.exponent)},
                {"end", name_of(ray_end_names, node.end)}};
    if (node.parent != RayNode::none) ray["parent"] = node.parent;
    if (node.object != RayNode::none) ray["hit"] = hit_of(scene, node);
    ray["ambient"] = json_of(node.ambient);
    ray["diffuse"] = json_of(node.diffuse);
    ray["specular"] = json_of(node.specular);
    ray["reflection"] = json_of(node.reflection);
    ray["refraction"] = json_of(node.refraction);
    ray["background"] = json_of(node.background);
    ray["radiance"] = json_of(node.radiance);
    if (node.shares)
        ray["shares"] = {{"local", json_of(node.shares->local)},
                         {"reflection", json_of(node.shares->reflection)},
                         {"transmission", json_of(node.shares->transmission)}};
    return ray;
}

}  // namespace rt
