// The curves that `raytrace brdf plot` draws, by the functions that the renderer runs.
#pragma once

#include <vector>

#include "shading/surface_model.h"

namespace rt {

/// A lamp of unit colour in the plane of incidence, at `l_degrees` from the normal, and the viewer at `view_degrees` on the side of
/// negative angles, so that the mirrored direction has the angle `view_degrees`: what the model's highlight returns, luminance of the
/// channels.
double lobe_at(const SurfaceModel& model, double l_degrees, double view_degrees);

/// G at these directions; 0 where one of them is at the horizon.
double masking_at(const SurfaceModel& model, double l_degrees, double view_degrees);

/// D in 1/sr at this half angle.
double distribution_at(const SurfaceModel& model, double half_degrees);

/// F of a channel at this angle of incidence.
double fresnel_at(const SurfaceModel& model, int channel, double degrees);

/// Angles from `least` to `most` degrees, denser and denser around `peak`, where a lobe of width `alpha` is narrow.
std::vector<double> angles_around(double peak, double alpha, double least, double most);

}  // namespace rt
