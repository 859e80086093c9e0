// Bumps, compiled.
#pragma once

#include "world/pattern_node.h"

namespace rt {

/// A pattern that turns normals itself, or chooses and mixes the normals that its children make.
struct NormalNode {
    PatternNode pattern;
    Bump bump;
    std::vector<NormalNode> children;
};

/// `normal`, unit and of the space around `node`, as it is turned at the point that `p` is there; unit.
Vec3 turned(const NormalNode& node, const Vec3& normal, const Vec3& p, const TexturePoint& seen);

}  // namespace rt
