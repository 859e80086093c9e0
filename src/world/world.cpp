#include "world/world.h"

#include "world/surface_index.h"
#include "world/uv_mapping.h"

namespace rt {

World::World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

bool World::nearest(const Ray& ray, const Interval& range, RayKind kind, Hit& hit) const {
    return surfaces && surfaces->nearest(ray, range, kind, hit);
}

std::uint32_t World::nearest(std::span<const Ray> rays, const Interval& range, RayKind kind, std::span<Hit> hits) const {
    return surfaces ? surfaces->nearest(rays, range, kind, hits) : 0;
}

bool World::occluded(const Ray& ray, const Interval& range, Blocker& last) const {
    return surfaces && surfaces->occluded(ray, range, last);
}

std::optional<double> World::through(std::uint32_t light, const Ray& ray, const Interval& range) const {
    return surfaces ? surfaces->through(masks[light], ray, range) : std::nullopt;
}

Vec3 World::normal(const Hit& hit, const Vec3& point) const { return surfaces->normal(hit, point); }

Vec3 World::flat_side(const Hit& hit, const Vec3& normal) const { return surfaces->surfaces().flat_side(hit, normal); }

Vec2 World::uv(const Hit& hit, const Vec3& point) const {
    const std::uint32_t face = hit.primitive - surfaces->surfaces().objects[hit.object].first_primitive;
    return uv_of(frames[objects[hit.object].frame], point, face, hit.shape);
}

void World::texture_weights(const Hit& hit, const Vec3& point, double least, std::vector<TextureWeight>& out) const {
    const Surfaces& all = surfaces->surfaces();
    if (all.cut_weights(hit.object, point, least, out)) return;
    const std::uint32_t face = hit.primitive - all.objects[hit.object].first_primitive;
    rt::texture_weights(frames[objects[hit.object].frame], point, face, hit.shape, least, out);
}

bool World::met_from_inside(const Hit& hit, const Vec3& point, const Vec3& direction) const {
    return surfaces->surfaces().met_from_inside(hit, point, direction);
}

}  // namespace rt
