// Of a shape whose parts have textures of their own: what of them shows at a point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// One of the textures that show at a point. Numbers count the textures that the shape states, from 0.
struct TextureWeight {
    static constexpr std::uint32_t of_object = 0xffffffffu;  ///< the texture of the object as a whole
    std::uint32_t texture = of_object;
    double weight = 1.0;  ///< its share of the light
    bool operator==(const TextureWeight&) const = default;
};

/// Makes one of those from number `first` on that are of the same texture.
void join_textures(std::vector<TextureWeight>& weights, std::size_t first);

}  // namespace rt
