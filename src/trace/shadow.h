// How much of a light arrives: shadow rays, opaque or tinted by what they cross.
#pragma once

#include <span>
#include <vector>

#include "trace/atmosphere.h"
#include "trace/distances.h"
#include "trace/light_source.h"
#include "trace/ray_log.h"
#include "trace/surface_layers.h"

namespace rt {

class Shadows {
public:
    Shadows(const World& world, const DistanceRules& rules, const TraceOptions& options);

    /// Whether `ray` leads to the world's light of that index through its mask, and now only as far as that.
    bool comes_through(std::uint32_t light, const SurfacePoint& at, LightRay& ray) const;

    /// Share of the world's light of that index that reaches `at` along `ray`, per channel. `inside` lists the interiors that the ray which
    /// found `at` was in. `answer`, if given, receives what was crossed.
    Rgb transmitted(std::uint32_t light, const SurfacePoint& at, const LightRay& ray, std::span<const std::uint32_t> inside,
                    ShadowAnswer* answer);

    /// Light of colour `color` from all samples of an area light, shadowed and averaged. `log`, if given, receives every answer.
    Rgb area(const LightSource& source, std::uint32_t index, const Rgb& color, const SurfacePoint& at,
             std::span<const std::uint32_t> inside, RayNode* log);

    std::uint64_t rays = 0;  ///< cast so far

private:
    Rgb through_transparent(const SurfacePoint& at, const LightRay& ray, bool fogged, std::span<const std::uint32_t> inside,
                            ShadowAnswer* answer);
    Rgb filtered(const Hit& hit, const Vec3& point, const Vec3& direction, const Vec3& normal);
    void fade(std::uint32_t interior, double segment, Rgb& light);

    struct Cached {
        Rgb light;
        std::uint32_t stamp = 0;
    };

    const World& world_;
    DistanceRules rules_;
    bool tinted_;        ///< some surfaces let light pass, and are asked how much of it
    bool opaque_first_;  ///< opaque blockers are asked for before the transparent ones are counted
    SurfaceLayers layers_;
    Atmosphere atmosphere_;
    std::vector<std::uint32_t> inside_;
    std::vector<Cached> samples_;
    std::uint32_t stamp_ = 0;
    std::vector<Blocker> blockers_;  ///< by light
};

}  // namespace rt
