// Prepared inputs for measuring the shading functions: the same numbers on every run.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "shading/surface_model.h"

namespace rt::bench {

inline constexpr std::size_t inputs = 4096;

/// One evaluation: directions above the surface around a highlight, the angles that follow, and a material's numbers.
struct Input {
    ViewedPoint at;
    Vec3 l;
    double n_dot_l;  ///< known before the shadow ray
    HalfGeometry g;
    double alpha;
    Interface dielectric, metal;
    Rgb ka{0.1, 0.1, 0.2}, kd{0.5, 0.3, 0.1}, lc{1.0, 0.9, 0.8}, tint{1.0};
    std::size_t finish;  ///< 0 to 7, in no order
};

class Draw {
public:
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    Vec3 direction() {
        for (;;) {
            const Vec3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            if (dot(v, v) > 0.01 && dot(v, v) < 1.0) return unit(v);
        }
    }
    Vec3 above(const Vec3& n) {
        const Vec3 v = direction();
        return dot(n, v) < 0.0 ? -v : v;
    }

private:
    std::mt19937_64 random_{20};
};

inline std::vector<Input> prepared_inputs() {
    Draw draw;
    std::vector<Input> result;
    while (result.size() < inputs) {
        Input x;
        const Vec3 n = draw.direction(), v = draw.above(n);
        x.at = viewed_point(n, v, true);
        x.alpha = draw.uniform(0.05, 1.0);
        // The mirrored direction of a microfacet that the lobe holds: most evaluations of a picture that matter are such.
        const Vec3 m = unit(n + x.alpha * draw.uniform(0.0, 1.5) * draw.direction());
        x.l = unit(2.0 * dot(m, v) * m - v);
        x.dielectric = interface_of(draw.uniform(1.1, 2.5));
        x.metal = interface_of(draw.uniform(0.1, 2.0), draw.uniform(1.0, 5.0));
        x.n_dot_l = dot(n, x.l);
        x.finish = static_cast<std::size_t>(draw.uniform(0.0, 8.0));
        if (half_geometry(n, x.l, v, x.at.incline_v, x.g)) result.push_back(x);
    }
    return result;
}

/// ka + lc (n.l) (d kd rd + s D G F / (4 n.l n.v)) in three channels, as the model was chosen at run time.
inline Rgb complete_r(const SurfaceModel& model, const Input& x) {
    return x.ka + x.lc * (diffuse_factor(model, x.at, x.l, x.n_dot_l) * x.n_dot_l * x.kd + model.s * highlight(model, x.at, x.l, x.tint));
}

}  // namespace rt::bench
