// Directional albedo of a lobe as a table: how much of the light from all around a surface sends to a viewer.
#pragma once

#include <array>

#include "shading/models.h"

namespace rt {

/// The integral of D G F / (4 n.l n.v) (n.l) over all l, by the cosine n.v; computed once, in a few milliseconds. For widths up to 1 within
/// 0.002 of the integral where n.v is above 0.05 and within 0.025 nearer to the horizon (V-grooves on rough surfaces are the worst).
class AlbedoTable {
public:
    /// Lobes narrower than this are mirrors: their albedo is F(n.v) itself.
    static constexpr double least_alpha = 1e-6;

    /// Of the terms' D, G and F with an interface for each channel; the terms' variants and factors on the lobe are left out.
    AlbedoTable(const MicrofacetTerms& terms, const Interface (&channels)[3], double alpha);

    /// 0 < n_dot_v <= 1; linear between nodes. `tint` multiplies F0 in the terms that start from F0, in which the albedo is linear.
    double at(int channel, double n_dot_v, double tint) const;

private:
    /// Albedo with F0 as it is and with F0 = 0, per channel.
    struct Node {
        Rgb tinted, untinted;
    };
    static constexpr int intervals = 48;
    Node node(const MicrofacetTerms& terms, const Interface (&channels)[3], double alpha, double n_dot_v) const;

    std::array<Node, intervals + 1> nodes_;  ///< at n.v = (i / intervals)^2, closer towards grazing
};

}  // namespace rt
