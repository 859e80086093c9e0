#include "syntax/texture_numbers.h"

#include <bit>

namespace rt {

namespace {

/// The colour of a texture that is one plain layer of it, else null.
const PigmentColor* plain_color(const std::vector<Texture>& layers) {
    if (layers.size() != 1) return nullptr;
    const auto* plain = std::get_if<PlainTexture>(&layers.front().content);
    return plain && !plain->normal ? std::get_if<PigmentColor>(&plain->pigment.content) : nullptr;
}

std::size_t hash_of(const PigmentColor& color) {
    std::uint64_t hash = 0x243f6a8885a308d3u;
    for (const double x : {color.rgb.r, color.rgb.g, color.rgb.b, color.filter, color.transmit}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return hash;
}

}  // namespace

std::uint32_t TextureNumbers::number_of(const TextureLayers& layers) {
    const auto next = static_cast<std::uint32_t>(textures_.size());
    if (const PigmentColor* color = plain_color(*layers)) {
        std::uint32_t& known = by_color_.try_emplace(hash_of(*color), next).first->second;
        if (known != next && *textures_[known] == *layers) return known;
        known = next;
    } else if (const auto [known, is_new] = by_identity_.try_emplace(layers.identity(), next); !is_new) {
        return known->second;
    }
    textures_.push_back(layers);
    return next;
}

}  // namespace rt
