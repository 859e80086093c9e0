// POV-Ray's average over the samples of an area light: recursive over the corners of rectangles, not a plain mean.
#pragma once

#include "core/vec.h"

namespace rt {

/// Samples with indices in [u1, u2] x [v1, v2].
struct SampleRectangle {
    int u1 = 0, v1 = 0, u2 = 0, v2 = 0;
};

/// Colours whose channels differ by more than 0.1 in sum are worth a closer look.
inline bool differ_visibly(const Rgb& a, const Rgb& b) { return std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b) > 0.1; }

/// Mean of the four corners, each replaced by the average of its quarter of the rectangle while samples lie between and either `level` is
/// below `adaptive` or the corners along an edge differ. `sample(u, v)` is asked repeatedly for the same corner.
template <typename Sample>
Rgb average_corners(const SampleRectangle& r, int level, int adaptive, Sample& sample) {
    Rgb corner[4] = {sample(r.u1, r.v1), sample(r.u2, r.v1), sample(r.u1, r.v2), sample(r.u2, r.v2)};
    if (r.u2 - r.u1 > 1 || r.v2 - r.v1 > 1) {
        if (level < adaptive || differ_visibly(corner[0], corner[1]) || differ_visibly(corner[2], corner[3]) ||
            differ_visibly(corner[0], corner[2]) || differ_visibly(corner[1], corner[3])) {
            const int u_low = (r.u1 + r.u2) / 2, u_high = (r.u1 + r.u2 + 1) / 2;
            const int v_low = (r.v1 + r.v2) / 2, v_high = (r.v1 + r.v2 + 1) / 2;
            corner[0] = average_corners({r.u1, r.v1, u_low, v_low}, level + 1, adaptive, sample);
            corner[1] = average_corners({u_high, r.v1, r.u2, v_low}, level + 1, adaptive, sample);
            corner[2] = average_corners({r.u1, v_high, u_low, r.v2}, level + 1, adaptive, sample);
            corner[3] = average_corners({u_high, v_high, r.u2, r.v2}, level + 1, adaptive, sample);
        }
    }
    return 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
}

}  // namespace rt
