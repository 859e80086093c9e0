// One worker's view of the picture plane: points to light.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "trace/edges.h"
#include "trace/render.h"
#include "trace/tracer.h"

namespace rt {

/// The picture as a function of the plane, see Samples. Holds scratch memory, so use one per thread; the world and options outlive it.
class PlaneSampler {
public:
    PlaneSampler(const World& world, const RenderOptions& options);
    PlaneSampler(const PlaneSampler&) = delete;
    PlaneSampler& operator=(const PlaneSampler&) = delete;

    void operator()(std::span<const Vec2> points, int scale, std::span<Pixel> pixels);
    /// Rays cast so far.
    RayCounts counts() const;

private:
    const World& world_;
    const RenderOptions& options_;
    Tracer tracer_;
    std::optional<EdgeLines> edges_;
    std::vector<Ray> rays_;
    std::vector<Radiance> light_;
};

/// Without NaN and infinity. Asked for every pixel, so it is inline: 1 to 3 % of a small picture's instructions otherwise.
inline bool finite(const Pixel& p) {
    return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b) && std::isfinite(p.transmittance);
}

}  // namespace rt
