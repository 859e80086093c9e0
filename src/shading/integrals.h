// Integrals over the hemisphere that say whether a pair of terms conserves energy.
#pragma once

#include "shading/models.h"

namespace rt {

/// Integral of D(m) (n.m) over the hemisphere of microfacet normals: 1 for a normalised distribution (Walter, Marschner, Li, Torrance 2007,
/// equation 4). To about 1e-12 for widths from 1e-8 to 3.
double normalization(Distribution D, double alpha);

/// Directional albedo, the integral of D G / (4 n.l n.v) (n.l) over all l with F = 1: the share of light from all around that goes to a
/// viewer at cosine `n_dot_v` (0 < n_dot_v <= 1). By strata of GGX's own normals; to about 1e-4 for widths from 1e-3 to 3.
double directional_albedo(Distribution D, Masking G, double alpha, double n_dot_v);
/// The same of the terms' D, G and F, for an interface.
double directional_albedo(const MicrofacetTerms& terms, const Interface& x, double alpha, double n_dot_v);

}  // namespace rt
