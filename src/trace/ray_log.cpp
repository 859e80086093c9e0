#include "trace/ray_log.h"

#include <bit>

#include "shading/povray_finish.h"

namespace rt {

void total(RayLog& log) {
    for (std::size_t i = log.nodes.size(); i-- > 0;) {
        RayNode& node = log.nodes[i];
        const Rgb found = node.ambient + node.diffuse + node.specular + node.reflection + node.refraction + node.background;
        node.radiance = node.veil_light + node.veil_left * found;
        if (node.parent == RayNode::none) continue;
        RayNode& parent = log.nodes[node.parent];
        if (node.kind == RayNode::Kind::reflected) {
            parent.reflection += node.factor * reflected_light(node.radiance, node.exponent);
        } else {
            parent.refraction += node.factor * node.radiance;
        }
    }
}

namespace {

/// FNV-1a over 64-bit words.
class Hash {
public:
    void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3ull; }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    std::uint64_t value() const { return value_ ^ (value_ >> 29); }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// 0 for darkness, 2 for full light, 1 between.
std::uint64_t grade(const Rgb& transmitted) {
    if (transmitted == Rgb(0.0)) return 0;
    return transmitted == Rgb(1.0) ? 2 : 1;
}

void add(Hash& hash, const RayNode& node) {
    hash.add(static_cast<std::uint64_t>(node.kind) << 8 | static_cast<std::uint64_t>(node.end));
    hash.add(static_cast<std::uint64_t>(node.parent) << 32 | node.object);
    hash.add(static_cast<std::uint64_t>(node.part) << 1 | static_cast<std::uint64_t>(node.inside));
    for (const PigmentColor& color : node.layers) {
        for (const double channel : {color.rgb.r, color.rgb.g, color.rgb.b, color.filter, color.transmit}) hash.add(channel);
    }
    for (const ShadowAnswer& answer : node.shadows) {
        hash.add(static_cast<std::uint64_t>(answer.light) << 32 | answer.sample);
        hash.add(grade(answer.transmitted));
        for (const std::uint32_t object : answer.crossed) hash.add(std::uint64_t{object});
    }
}

}  // namespace

std::uint64_t signature(const RayLog& log) {
    Hash hash;
    for (const RayNode& node : log.nodes) add(hash, node);
    return hash.value();
}

}  // namespace rt
