// How a world's rays are answered: an Embree index over the bounded surfaces and a list of the rest, or one list of everything.
#pragma once

#include <memory>
#include <vector>

#include "world/compile.h"
#include "world/surfaces.h"

namespace rt {

class EmbreeIndex;

class SurfaceIndex {
public:
    SurfaceIndex(Surfaces surfaces, const CompileOptions& options);
    ~SurfaceIndex();

    bool nearest(const Ray& ray, const Interval& range, RayKind kind, Hit& hit) const;
    std::uint32_t nearest(std::span<const Ray> rays, const Interval& range, RayKind kind, std::span<Hit> hits) const;
    bool occluded(const Ray& ray, const Interval& range, Blocker& last) const;
    std::optional<double> through(const MaskRange& masks, const Ray& ray, const Interval& range) const;
    Vec3 normal(const Hit& hit, const Vec3& point) const { return surfaces_.normal(hit, point); }
    const Surfaces& surfaces() const { return surfaces_; }
    /// Objects that are tested one by one for every ray.
    const std::vector<std::uint32_t>& listed() const { return listed_; }
    /// Whether an Embree index is in use.
    bool indexed() const { return embree_ != nullptr; }

private:
    void ask_listed(Query& query) const {
        if (!embree_)
            for (const IndexedSphere& sphere : listed_spheres_) sphere.test(query);
        for (const std::uint32_t object : listed_others_) surfaces_.test(object, query);
    }

    void ask_late(Query& query) const;
    bool late_occluded(Query& query) const;

    Surfaces surfaces_;
    std::vector<std::uint32_t> listed_;
    // The same once more, as they are asked: beside no index, spheres without a detour over their kind.
    std::vector<IndexedSphere> listed_spheres_;
    std::vector<std::uint32_t> listed_others_;
    std::unique_ptr<EmbreeIndex> embree_;
    bool exact_;  ///< every test is in doubles, so one surface answers as all of them would
};

}  // namespace rt
