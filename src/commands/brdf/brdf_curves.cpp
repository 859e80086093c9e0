#include "commands/brdf/brdf_curves.h"

#include <algorithm>

namespace rt {

namespace {

const Vec3 plane_normal(0, 0, 1);

/// In the plane of incidence; the horizon itself is below the surface.
Vec3 direction(double degrees) { return {std::sin(radians(degrees)), 0.0, std::fabs(degrees) < 90.0 ? std::cos(radians(degrees)) : 0.0}; }

ViewedPoint point_seen_from(double view_degrees) { return viewed_point(plane_normal, direction(-view_degrees), true); }

}  // namespace

double lobe_at(const SurfaceModel& model, double l_degrees, double view_degrees) {
    return grey(highlight(model, point_seen_from(view_degrees), direction(l_degrees), Rgb(1.0)));
}

double masking_at(const SurfaceModel& model, double l_degrees, double view_degrees) {
    const ViewedPoint at = point_seen_from(view_degrees);
    HalfGeometry g;
    if (!half_geometry(at.n, direction(l_degrees), at.v, at.incline_v, g)) return 0.0;
    if (model.terms.half_of_normal_and_view) halve_normal_and_view(at.n, at.v, g);
    return G(model.terms.G, g, model.alpha);
}

double distribution_at(const SurfaceModel& model, double half_degrees) {
    const Vec3 h = direction(half_degrees);
    return D(model.terms.D, h.z * h.z, h.x * h.x, model.alpha);
}

double fresnel_at(const SurfaceModel& model, int channel, double degrees) {
    return F(model.terms.F, model.interface[channel], direction(degrees).z);
}

std::vector<double> angles_around(double peak, double alpha, double least, double most) {
    constexpr int even = 360;
    std::vector<double> angles;
    for (int i = 0; i <= even; ++i) angles.push_back(least + (most - least) * i / even);
    // From a hundredth of the width on, sixteen a decade, to both sides.
    const double width = std::min(alpha, 1.0) * (180.0 / pi);
    for (double away = 0.01 * width; away < most - least; away *= 1.1548)
        for (const double angle : {peak - away, peak + away})
            if (angle > least && angle < most) angles.push_back(angle);
    if (peak >= least && peak <= most) angles.push_back(peak);
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

}  // namespace rt
