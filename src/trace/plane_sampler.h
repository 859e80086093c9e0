// One worker's view of the picture plane: points to light.
#pragma once

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

/// Without NaN and infinity.
bool finite(const Pixel& pixel);

}  // namespace rt
