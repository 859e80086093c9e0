#include "geometry/text.h"

namespace rt {

void find_hits(const Text& shape, const Ray& ray, HitSink& sink) {
    const SweepRay across{Vec2(ray.origin), Vec2(ray.direction), ray.origin.z, ray.direction.z};
    std::uint32_t first = 0;
    for (const Glyph& glyph : *shape.glyphs) {
        find_hits(Sweep{glyph.outline, glyph.low, glyph.high, false, first}, across, sink);
        first += static_cast<std::uint32_t>(glyph.outline.pieces.size());
    }
}

Vec3 normal(const Text& shape, const Vec3&, const ShapeHit& hit) {
    if (hit.part < 2) return {0.0, 0.0, hit.part == 0 ? -1.0 : 1.0};
    std::size_t piece = hit.part - 2;
    for (const Glyph& glyph : *shape.glyphs) {
        if (piece < glyph.outline.pieces.size()) {
            const Vec2 along = glyph.outline.pieces[piece].tangent(hit.u);
            return {along.y, -along.x, 0.0};
        }
        piece -= glyph.outline.pieces.size();
    }
    return {0.0, 0.0, 1.0};
}

bool contains(const Text& shape, const Vec3& point) {
    for (const Glyph& glyph : *shape.glyphs)
        if (point.z > glyph.low && point.z < glyph.high && glyph.outline.contains(Vec2(point))) return true;
    return false;
}

Bounds bounds(const Text& shape) {
    Bounds box;
    for (const Glyph& glyph : *shape.glyphs) {
        if (glyph.outline.pieces.empty()) continue;
        box.extend(Vec3(glyph.outline.min, glyph.low));
        box.extend(Vec3(glyph.outline.max, glyph.high));
    }
    return rounded_outward(box);
}

}  // namespace rt
