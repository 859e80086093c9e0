#include "geometry/texture_weight.h"

#include <algorithm>

namespace rt {

void join_textures(std::vector<TextureWeight>& weights, std::size_t first) {
    const auto begin = weights.begin() + static_cast<std::ptrdiff_t>(first);
    auto end = begin;
    for (auto next = begin; next != weights.end(); ++next) {
        const auto known = std::find_if(begin, end, [&](const TextureWeight& other) { return other.texture == next->texture; });
        if (known == end)
            *end++ = *next;
        else
            known->weight += next->weight;
    }
    weights.erase(end, weights.end());
}

}  // namespace rt
