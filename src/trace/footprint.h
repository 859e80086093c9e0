// How much of a surface one sample of the camera covers, and highlights that are at least as wide. A highlight narrower than a sample is
// met or missed by chance; the widened one brings about as much light as the mean over the sample.
#pragma once

#include <span>

#include "trace/light_source.h"
#include "trace/lighting.h"

namespace rt {

/// A camera's ray and two beside it, one to the right and one upwards, on the same face of an object.
struct Footprint {
    struct Beside {
        Vec3 point{0.0}, normal{0.0}, to_viewer{0.0};
        double samples = 0.0;  ///< between both rays; 0 if it met something else
    };
    Beside across, upwards;
};

class Footprints {
public:
    /// `grid`: the samples of the whole picture.
    Footprints(const World& world, const DistanceRules& rules, const SampleGrid& grid);

    /// Around the camera's `ray` that met `hit`, seen as `at`; null if no layer has a microfacet highlight. Valid until the next call.
    const Footprint* around(const Ray& ray, const Hit& hit, const SurfacePoint& at, std::span<const ActiveLayer> layers);

private:
    Footprint::Beside beside(const Ray& ray, const Vec3& step, const Hit& hit, const SurfacePoint& at) const;

    const World& world_;
    DistanceRules rules_;
    Vec3 right_, up_;  ///< from a sample to the next in units of the camera's vectors
    Vec3 across_;      ///< to both
    Footprint last_;
};

/// The width of a lobe that `ray` lights, averaged over the sample at `at`, whose footprint is known. With D_x and D_y the
/// changes of the half vector's slope m from one sample to the next,
///     alpha'^2 = alpha^2 + min(w (|D_x|^2 + |D_y|^2) / 12, 0.18),    w = min(1, (alpha^2 + |D_x|^2 + |D_y|^2) / |m|^2)
/// since a square sample has a variance of 1/12 on each side. Variances of slopes are added as in Kaplanyan, Hill, Patney, Lefohn 2016,
/// Filtering Distributions of Normals for Shading Antialiasing; the limit 0.18 is that of Tokuyoshi, Kaplanyan 2019, Improved Geometric
/// Specular Antialiasing. w is our own: a mean over a sample leaves the far tail of a lobe as it is, but a wider lobe raises it.
double widened_alpha(double alpha, const SurfacePoint& at, const LightSource& source, const LightRay& ray);

}  // namespace rt
