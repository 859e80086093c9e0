// Letters: the areas of glyphs in the xy plane, each swept along z.
#pragma once

#include "core/shared.h"
#include "geometry/outline.h"

namespace rt {

struct Glyph {
    Outline outline;               ///< in (x, y), where it stands in the text
    double low = 0.0, high = 1.0;  ///< along z
    bool operator==(const Glyph&) const = default;
};

/// All letters of one `text`, each a solid of its own: where two overlap, the walls inside are there.
struct Text {
    Shared<std::vector<Glyph>> glyphs;
    static constexpr const char* word = "text";
    bool operator==(const Text&) const = default;
};

/// Parts: 0 the front, 1 the back, 2 + i the wall over piece i of all glyphs counted in a row.
void find_hits(const Text& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Text& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Text& shape, const Vec3& point);
Bounds bounds(const Text& shape);

}  // namespace rt
