#include "syntax/mesh_textures.h"

namespace rt {

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
    return {Mesh{std::move(mesh), Shared<FaceTextures>(std::move(faces_))}, textures_.take()};
}

}  // namespace rt
