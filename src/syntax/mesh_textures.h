// Textures of the faces of a mesh while it is read.
#pragma once

#include <unordered_map>
#include <vector>

#include "syntax/parse_shape.h"

namespace rt {

class MeshTextures {
public:
    using Corners = MeshData::Face;
    static constexpr Corners none{TextureWeight::of_object, TextureWeight::of_object, TextureWeight::of_object};

    /// Numbers textures in the order in which they are met. Equal plain colours get one number, so that exporters that write a texture for
    /// every vertex, of a few colours, need not be paid for.
    std::uint32_t number_of(const TextureLayers& layers);
    /// What face number `face` states for its corners. Faces are told in order; those that are left out have the object's texture.
    void add_face(std::size_t face, const Corners& corners);
    ParsedShape finish(MeshData mesh);

private:
    void state_by_corner();

    FaceTextures faces_;
    std::vector<TextureLayers> textures_;
    std::unordered_map<const void*, std::uint32_t> by_identity_;
    std::unordered_map<std::size_t, std::uint32_t> by_color_;  ///< the last one of each hash, of those that are one plain colour
};

}  // namespace rt
