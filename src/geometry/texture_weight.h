// Of a shape whose parts have textures of their own: what of them shows at a point.
#pragma once

#include <cstdint>

namespace rt {

/// One of the textures that show at a point. Numbers count the textures that the shape states, from 0.
struct TextureWeight {
    static constexpr std::uint32_t of_object = 0xffffffffu;  ///< the texture of the object as a whole
    std::uint32_t texture = of_object;
    double weight = 1.0;  ///< its share of the light
    bool operator==(const TextureWeight&) const = default;
};

}  // namespace rt
