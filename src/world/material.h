// Surfaces, compiled: what the scene's textures and interiors mean to a ray.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "shading/surface_model.h"

namespace rt {

/// A finish with everything derived from it that does not depend on the point.
struct SurfaceFinish {
    Finish finish;                  ///< POV-Ray's coefficients as stated
    double specular_exponent = 20;  ///< POV-Ray's 1/roughness; 0 for roughness 0
    bool reflects = false;          ///< some channel of reflection min or max differs from 0, or the model chose surroundings for it
    // The general form: r = ambient + sum lc [(1-s) diffuse pigment (n.l)^brilliance + s (n.l) D G F / (4 n.l n.v)].
    SurfaceModel model;
};

/// One layer at one point: its colour there and its finish.
struct LayerSample {
    PigmentColor color;
    const SurfaceFinish* finish = nullptr;
};

/// A colour tree: solid, or a pattern over two children. Children are indices into the same vector; the root is element 0.
struct PigmentNode {
    PigmentColor color;
    bool checker = false;
    Transform to_pattern;  ///< surrounding space to pattern space (forward direction)
    std::uint32_t child[2] = {0, 0};
    std::optional<PigmentColor> quick;  ///< stands for the whole tree below where quick colours are asked for
};

/// A texture tree like the colour tree; a leaf is one plain layer, a checker chooses between two lists of layers.
struct LayerNode {
    bool checker = false;
    std::vector<PigmentNode> pigment;
    SurfaceFinish finish;
    Transform to_pattern;
    std::vector<LayerNode> cell[2];
};

struct Material {
    std::vector<LayerNode> layers;           ///< top layer first
    std::vector<LayerNode> interior_layers;  ///< seen from inside; empty: `layers`
    bool can_transmit = false;               ///< some colour in it has |filter| or |transmit| > 1e-10
    bool can_reflect = false;
};

/// Appends the layers that `layers` has at point `p` (world space), top first; with `quick` in their quick colours, where stated.
void sample_layers(const std::vector<LayerNode>& layers, const Vec3& p, std::vector<LayerSample>& out, bool quick = false);

/// Interior of an object with POV-Ray's legacy finish keywords already merged in.
struct CompiledInterior {
    double ior = 1.0;
    double caustics = 0.0;  ///< exponent
    double fade_distance = 0.0;
    double fade_power = 0.0;
    Rgb fade_color{0.0};
    double refraction = 1.0;  ///< legacy factor on all transmitted light
};

}  // namespace rt
