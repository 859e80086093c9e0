// Textures of the parts of a shape while it is read.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/texture.h"

namespace rt {

class TextureNumbers {
public:
    /// Numbers textures in the order in which they are met. Equal plain colours get one number, so that exporters that write a texture for
    /// every vertex, of a few colours, need not be paid for.
    std::uint32_t number_of(const TextureLayers& layers);
    /// All of them, by their numbers.
    std::vector<TextureLayers> take() { return std::move(textures_); }

private:
    std::vector<TextureLayers> textures_;
    std::unordered_map<const void*, std::uint32_t> by_identity_;
    std::unordered_map<std::size_t, std::uint32_t> by_color_;  ///< the last one of each hash, of those that are one plain colour
};

}  // namespace rt
