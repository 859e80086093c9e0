// The highlight of each combination of terms, compiled with the combination fixed: nothing is asked again at each evaluation.
#pragma once

#include "shading/surface_model.h"

namespace rt {

/// Fills what follows from the choices and numbers in `model`, once all of them are made: the share of the diffuse term, whether the sine
/// of the view is asked for, and the kernel. That is one of those for each D, G and F, of bit for bit the values of
/// highlight_by_switches(), as long as none of the variants that texts print is among the choices.
void prepare(SurfaceModel& model);

}  // namespace rt
