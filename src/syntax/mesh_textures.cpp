#include "syntax/mesh_textures.h"

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

std::uint32_t MeshTextures::number_of(const TextureLayers& layers) {
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

/// One number a face -> three.
void MeshTextures::state_by_corner() {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(3 * faces_.numbers.size());
    for (const std::uint32_t number : faces_.numbers) numbers.insert(numbers.end(), 3, number);
    faces_ = {true, std::move(numbers)};
}

void MeshTextures::add_face(std::size_t face, const Corners& corners) {
    if (faces_.numbers.empty() && corners == none) return;
    const bool one = corners[0] == corners[1] && corners[0] == corners[2];
    if (!one && !faces_.by_corner) state_by_corner();
    const std::size_t each = faces_.by_corner ? 3 : 1;
    faces_.numbers.resize(face * each, TextureWeight::of_object);
    faces_.numbers.insert(faces_.numbers.end(), corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(each));
}

ParsedShape MeshTextures::finish(MeshData mesh) {
    if (faces_.numbers.empty()) return Mesh{std::move(mesh)};
    faces_.numbers.resize(mesh.faces.size() * (faces_.by_corner ? 3 : 1), TextureWeight::of_object);
    faces_.numbers.shrink_to_fit();
    return {Mesh{std::move(mesh), Shared<FaceTextures>(std::move(faces_))}, std::move(textures_)};
}

}  // namespace rt
