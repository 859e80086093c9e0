// Textures of the faces of a mesh while it is read.
#pragma once

#include "syntax/parse_shape.h"
#include "syntax/texture_numbers.h"

namespace rt {

class MeshTextures {
public:
    using Corners = MeshData::Face;
    static constexpr Corners none{TextureWeight::of_object, TextureWeight::of_object, TextureWeight::of_object};

    std::uint32_t number_of(const TextureLayers& layers) { return textures_.number_of(layers); }
    /// What face number `face` states for its corners. Faces are told in order; those that are left out have the object's texture.
    void add_face(std::size_t face, const Corners& corners);
    ParsedShape finish(MeshData mesh);

private:
    void state_by_corner();

    FaceTextures faces_;
    TextureNumbers textures_;
};

}  // namespace rt
