#include "commands/pixel/ray_tree_json.h"

#include <fmt/format.h>

#include "commands/base/json_text.h"
#include "commands/base/names.h"
#include "commands/pixel/ray_tree_names.h"
#include "commands/pixel/ray_tree_values.h"

namespace rt {

namespace {

Json head_of(const TracedPixel& pixel) {
    const Pixel& light = pixel.rays.pixel;
    return {{"format", ray_tree_format},
            {"scene", pixel.scene_name},
            {"width", pixel.width},
            {"height", pixel.height},
            {"profile", name_of(profile_names, pixel.profile)},
            {"shading", pixel.shading},
            {"camera", json_of(pixel.camera)},
            {"pixel",
             {{"x", pixel.name.x},
              {"y", pixel.name.y},
              {"origin", pixel.profile == Profile::csc473 ? "bottom left" : "top left"},
              {"radiance", {json_of(light.r), json_of(light.g), json_of(light.b)}},
              {"color", pixel.name.color}}}};
}

}  // namespace

std::string ray_tree_json(const TracedPixel& pixel) {
    std::string text = "{\n";
    const Json head = head_of(pixel);
    for (const auto& [name, value] : head.items()) text += fmt::format("  {}: {},\n", json_line(name), json_line(value));
    text += "  \"samples\": [";
    for (std::size_t s = 0; s < pixel.rays.samples.size(); ++s) {
        text += s == 0 ? "\n    [" : ",\n    [";
        const std::vector<RayNode>& nodes = pixel.rays.samples[s].nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            text += (i == 0 ? "\n      " : ",\n      ") + json_line(json_of(pixel.scene, nodes[i]));
        text += "\n    ]";
    }
    return text + "\n  ]\n}\n";
}

}  // namespace rt
