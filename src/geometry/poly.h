// Algebraic surfaces of degree 2 to 35: poly, cubic, quartic, polynomial.
#pragma once

#include <vector>

#include "core/shared.h"
#include "geometry/hit_sink.h"

namespace rt {

struct PolyData {
    int degree = 2;
    /// Of x^a y^b z^c with a + b + c <= degree, as a scene lists them: a falls from `degree`, for each a b falls, for each b c falls.
    std::vector<double> coefficients;
    /// About how far from the origin the surface does what it does.
    double scale = 1.0;
    bool operator==(const PolyData&) const = default;
};

/// The surface where the polynomial vanishes, inside where it is negative. Cheap to copy: copies share the data.
struct Poly {
    Shared<PolyData> data;
    static constexpr const char* word = "poly";
    bool operator==(const Poly&) const = default;
};

/// Number of coefficients of a degree.
constexpr std::size_t poly_coefficients(int degree) {
    const auto n = static_cast<std::size_t>(degree);
    return (n + 1) * (n + 2) * (n + 3) / 6;
}
/// Where the coefficient of x^a y^b z^c stands, a + b + c <= degree.
constexpr std::size_t poly_index(int degree, int a, int b, int c) {
    const int rest = degree - a;  // the greatest b + c
    const auto before_a = poly_coefficients(rest) - static_cast<std::size_t>((rest + 1) * (rest + 2) / 2);
    const auto before_b = static_cast<std::size_t>((rest - b) * (rest - b + 1) / 2);
    return before_a + before_b + static_cast<std::size_t>(rest - b - c);
}

/// `coefficients` as in PolyData.
Poly make_poly(int degree, std::vector<double> coefficients);

/// At a hit the polynomial is zero to within some 100 units in the last place of its largest term: divided by the gradient's length that is
/// the distance from the surface, which near singular points exceeds `hit_error`. A ray that only touches has no hit.
void find_hits(const Poly& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const Poly& shape, const Vec3& point, const ShapeHit& hit);
bool contains(const Poly& shape, const Vec3& point);
Bounds bounds(const Poly& shape);

}  // namespace rt
