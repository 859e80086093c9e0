// normal { }: patterns that turn the surface's normal.
#pragma once

#include <optional>
#include <vector>

#include "patterns/perturb.h"
#include "scene/pattern.h"

namespace rt {

struct NormalMap;

struct Normal {
    StatedPattern pattern;
    Bump bump;
    std::optional<Shared<NormalMap>> map;  ///< of normal_map, average and cells
    bool operator==(const Normal&) const;
};

/// Entries as those of a `ColorMap`.
struct NormalMap {
    std::vector<double> values;
    std::vector<Normal> normals;
    bool operator==(const NormalMap&) const;
};

}  // namespace rt
