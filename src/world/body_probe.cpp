#include "world/body_probe.h"

#include <algorithm>
#include <unordered_set>

#include "world/compile_pigment.h"
#include "world/surface_index.h"

namespace rt {

namespace {

// POV-Ray's, as measured.
constexpr Interval traced{1e-4, 1e7};

Surfaces surfaces_of(const Bodies& bodies) {
    Surfaces surfaces;
    for (const Object& object : bodies.objects) surfaces.add(object, seen_by::image);
    for (const ObjectSet& set : bodies.sets) surfaces.add_set(set);
    for (Placed<FurtherShape>& placed : surfaces.further) compile_functions(placed.shape, {});
    return surfaces;
}

class BodyProbe final : public ObjectProbe {
public:
    explicit BodyProbe(const Bodies& bodies) : index_(surfaces_of(bodies), {}) {
        const Surfaces& surfaces = index_.surfaces();
        std::unordered_set<std::uint32_t> sets;
        for (std::uint32_t object = 0; object < bodies.objects.size(); ++object) {
            const std::uint32_t set = surfaces.set_of(object);
            if (set == Body::none || sets.insert(set).second) wholes_.push_back(object);
        }
    }

    std::optional<Met> trace(const Vec3& from, const Vec3& direction) const override {
        if (!(length(direction) > 0.0)) return std::nullopt;
        const Ray ray{from, unit(direction)};
        Hit hit;
        if (!index_.nearest(ray, traced, RayKind::image, hit)) return std::nullopt;
        const Vec3 point = ray.at(hit.shape.t);
        return Met{point, index_.normal(hit, point)};
    }

    bool contains(const Vec3& point) const override {
        return std::any_of(wholes_.begin(), wholes_.end(), [&](std::uint32_t object) { return index_.surfaces().contains(object, point); });
    }

private:
    SurfaceIndex index_;
    std::vector<std::uint32_t> wholes_;  ///< objects that are no parts, and the first part of each set
};

}  // namespace

std::shared_ptr<const ObjectProbe> make_body_probe(const Bodies& bodies) {
    try {
        return std::make_shared<const BodyProbe>(bodies);
    } catch (const std::bad_alloc&) {
        throw LimitError("not enough memory for the surfaces of an object");
    }
}

}  // namespace rt
