#include "commands/pixel/pixel_page_rays.h"

#include <algorithm>
#include <atomic>
#include <map>

#include "commands/base/json_text.h"
#include "commands/pixel/kept_rays.h"
#include "commands/pixel/ray_tree_values.h"

namespace rt {

namespace {

/// What all samples of one light answered.
struct LightAnswer {
    int samples = 0, hidden = 0;
    Rgb transmitted{0.0};
    std::vector<std::uint32_t> crossed;
};

/// One entry for each light: an area light has hundreds of samples.
Json shadows_by_light(const RayNode& node) {
    std::map<std::uint32_t, LightAnswer> lights;
    for (const ShadowAnswer& shadow : node.shadows) {
        LightAnswer& answer = lights[shadow.light];
        ++answer.samples;
        answer.hidden += shadow.transmitted == Rgb(0.0);
        answer.transmitted += shadow.transmitted;
        for (const std::uint32_t object : shadow.crossed)
            if (std::find(answer.crossed.begin(), answer.crossed.end(), object + 1) == answer.crossed.end())
                answer.crossed.push_back(object + 1);
    }
    Json shadows = Json::array();
    for (const auto& [light, answer] : lights)
        shadows.push_back({{"light", light},
                           {"samples", answer.samples},
                           {"hidden", answer.hidden},
                           {"transmitted", json_of(answer.transmitted / static_cast<double>(answer.samples))},
                           {"crossed", answer.crossed}});
    return shadows;
}

Json ray_of(const Scene& scene, const RayNode& node, const KeptRay& kept) {
    Json ray = json_of(scene, node);
    if (kept.parent != RayNode::none) ray["parent"] = kept.parent;
    if (kept.left_out > 0) ray["left_out"] = kept.left_out;
    if (node.object != RayNode::none) {
        ray["hit"].erase("object_ray");
        ray["hit"]["shadows"] = shadows_by_light(node);
    }
    return ray;
}

}  // namespace

PixelTexts pixel_texts(const World& world, const Scene& scene, const RenderOptions& options, std::span<const PixelPlace> places,
                       std::size_t most_rays, std::size_t most_in_all) {
    PixelTexts texts;
    texts.pixels.resize(places.size());
    std::atomic<std::size_t> rays{0};
    const bool complete = trace_pixels(world, options, places, [&](std::size_t number, const std::vector<RayLog>& samples) {
        PixelText& pixel = texts.pixels[number];
        Json told = Json::array();
        for (const RayLog& log : samples) {
            const std::vector<KeptRay> kept = keep_rays(log, most_rays / samples.size());
            pixel.left_out += log.nodes.size() - kept.size();
            if ((rays += kept.size()) > most_in_all) return false;
            Json list = Json::array();
            for (const KeptRay& ray : kept) list.push_back(ray_of(scene, log.nodes[ray.ray], ray));
            told.push_back(std::move(list));
        }
        pixel.samples = json_line(told);
        return true;
    });
    texts.too_many = rays > most_in_all;
    texts.rays = std::min<std::size_t>(rays, most_in_all);  // how far beyond depends on the threads
    texts.stopped = !complete && !texts.too_many;
    return texts;
}

}  // namespace rt
