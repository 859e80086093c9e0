// Surfaces, compiled: what the scene's textures and interiors mean to a ray.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "shading/surface_model.h"
#include "world/normal_node.h"

namespace rt {

/// A finish with everything derived from it that does not depend on the point.
struct SurfaceFinish {
    Finish finish;                  ///< POV-Ray's coefficients as stated
    double specular_exponent = 20;  ///< POV-Ray's 1/roughness; 0 for roughness 0
    bool reflects = false;          ///< some channel of reflection min or max differs from 0, or the model chose surroundings for it
    // The general form: r = ambient + sum lc [(1-s) diffuse pigment (n.l)^brilliance + s (n.l) D G F / (4 n.l n.v)].
    SurfaceModel model;
};

/// One layer at one point: its colour there, its finish, and its own normal if it is bumped.
struct LayerSample {
    PigmentColor color;
    const SurfaceFinish* finish = nullptr;
    bool bumped = false;
    Vec3 normal{0.0};  ///< unit; of a bumped layer
};

struct TextureNode;

/// One layer, or a pattern of textures instead.
struct LayerNode {
    PigmentTree pigment;
    SurfaceFinish finish;
    std::shared_ptr<const NormalNode> normal;
    std::shared_ptr<const TextureNode> textures;
};

/// A pattern that chooses or mixes textures, each a list of layers, the top one first.
struct TextureNode {
    PatternNode pattern;
    std::vector<std::vector<LayerNode>> entries;
};

/// Calls `visit` for every plain layer in the list and in the textures below it.
template <typename Visit>
void for_each_layer(const std::vector<LayerNode>& layers, const Visit& visit) {
    for (const LayerNode& layer : layers) {
        if (!layer.textures) {
            visit(layer);
            continue;
        }
        for (const std::vector<LayerNode>& entry : layer.textures->entries) for_each_layer(entry, visit);
    }
}

struct Material {
    std::vector<LayerNode> layers;           ///< top layer first; none where the shape states textures
    std::vector<LayerNode> interior_layers;  ///< seen from inside; empty: `layers`
    /// Of the textures that the shape states, and last of the object's own, their materials; empty: it states none. All count below.
    std::vector<std::uint32_t> shape_textures;
    bool can_transmit = false;  ///< some colour in it has |filter| or |transmit| > 1e-10
    bool can_reflect = false;
    bool uses_uv = false;
};

/// Layers of one of the textures that are mixed at a point: those from the end of the part before up to `end`.
struct TextureShare {
    double weight = 1.0;
    std::size_t end = 0;
};

/// What a texture is at a point. Without shares all layers are of one texture.
struct SampledTexture {
    std::vector<LayerSample> layers;  ///< of each texture the top one first
    std::vector<TextureShare> shares;

    /// Whether there is more to show than all layers with their whole light.
    bool is_mixture() const { return !shares.empty() && (shares.size() > 1 || shares.front().weight != 1.0); }
};

/// What is asked of textures.
struct TextureQuestion {
    bool quick_colors = false;  ///< where stated
    bool normals = true;
    double least_weight = 0.0;  ///< textures of a shape's parts that have less than this in a mixture do not show
};

/// Appends what `layers` is at a point.
void sample(const std::vector<LayerNode>& layers, const TexturePoint& seen, const TextureQuestion& question, SampledTexture& out);
/// The same as one of several textures in a mixture, of this weight.
void sample_share(const std::vector<LayerNode>& layers, double weight, const TexturePoint& seen, const TextureQuestion& question,
                  SampledTexture& out);
/// The top layer at a point, without bumps; of a mixture of textures the first one's.
LayerSample top_layer(const std::vector<LayerNode>& layers, const Vec3& point);

/// Interior of an object with POV-Ray's legacy finish keywords already merged in.
struct CompiledInterior {
    double ior = 1.0;
    double caustics = 0.0;  ///< exponent
    double fade_distance = 0.0;
    double fade_power = 0.0;
    Rgb fade_color{0.0};
    double refraction = 1.0;  ///< legacy factor on all transmitted light
    bool hollow = false;      ///< fog and rainbows go on inside
};

}  // namespace rt
