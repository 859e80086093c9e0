#include "geometry/poly.h"

#include <array>

#include "geometry/roots.h"

namespace rt {

namespace {

using Coefficients = std::array<double, highest_degree + 1>;  // of the powers of one variable, the constant first

/// p(s) (o + s d) + constant, of degree n + 1.
void times_linear(Coefficients& p, std::size_t n, double o, double d, double constant) {
    p[n + 1] = p[n] * d;
    for (std::size_t i = n; i > 0; --i) p[i] = p[i] * o + p[i - 1] * d;
    p[0] = p[0] * o + constant;
}

/// The polynomial along o + s d, by Horner's rule in x, y and z.
Coefficients along(const PolyData& poly, const Vec3& o, const Vec3& d) {
    const auto n = static_cast<std::size_t>(poly.degree);
    const double* next = poly.coefficients.data();
    Coefficients in_x{};
    for (std::size_t x = 0; x <= n; ++x) {
        Coefficients in_y{};
        for (std::size_t y = 0; y <= x; ++y) {
            Coefficients in_z{};
            in_z[0] = *next++;
            for (std::size_t z = 1; z <= y; ++z) times_linear(in_z, z - 1, o.z, d.z, *next++);
            if (y > 0) times_linear(in_y, y - 1, o.y, d.y, 0.0);
            for (std::size_t i = 0; i <= y; ++i) in_y[i] += in_z[i];
        }
        if (x > 0) times_linear(in_x, x - 1, o.x, d.x, 0.0);
        for (std::size_t i = 0; i <= x; ++i) in_x[i] += in_y[i];
    }
    return in_x;
}

/// Visits the changes of sign of `c` on [0, 1] that lie between `from` and `to`, and maybe some near them. The sign before 1.
template <typename Visit>
int visit_changes(std::span<const double> c, double from, double to, Visit visit) {
    constexpr double margin = 1e-14;
    SignChanges changes(c);
    double after = from - margin * std::fabs(from);
    for (double u = 0.0; changes.next(after, u);) {
        if (u > to * (1.0 + margin))
            after = 1.0;  // only the sign is wanted
        else
            visit(u);
    }
    return changes.sign();
}

/// The changes of sign of a polynomial of degree n on s > 0, those at least that lie between `from` and `to`.
template <typename Visit>
void find_half(const Coefficients& c, std::size_t n, double from, double to, Visit visit) {
    if (!(to > 0.0)) return;
    Coefficients reversed;
    for (std::size_t i = 0; i <= n; ++i) reversed[i] = c[n - i];
    const int inner = visit_changes(std::span(c).first(n + 1), from, to, visit);
    const int outer =
        visit_changes(std::span(reversed).first(n + 1), 1.0 / to, from > 0.0 ? 1.0 / from : infinity, [&](double u) { visit(1.0 / u); });
    if (inner * outer < 0) visit(1.0);
}

/// Whether the sign is another just after 0 than just before.
bool changes_at_zero(std::span<const double> c) {
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c[i] != 0.0) return i % 2 == 1;
    return false;
}

struct ValueAndGradient {
    double value;
    Vec3 gradient;
};

constexpr double largest_step = 1e-6;  ///< relative; beyond that the gradient says nothing

ValueAndGradient evaluate(const PolyData& poly, const Vec3& p) {
    const auto n = static_cast<std::size_t>(poly.degree);
    const double* next = poly.coefficients.data();
    double fx = 0.0, fx_x = 0.0, fx_y = 0.0, fx_z = 0.0;
    for (std::size_t x = 0; x <= n; ++x) {
        double fy = 0.0, fy_y = 0.0, fy_z = 0.0;
        for (std::size_t y = 0; y <= x; ++y) {
            double fz = 0.0, fz_z = 0.0;
            for (std::size_t z = 0; z <= y; ++z) {
                fz_z = fz_z * p.z + fz;
                fz = fz * p.z + *next++;
            }
            fy_y = fy_y * p.y + fy;
            fy = fy * p.y + fz;
            fy_z = fy_z * p.y + fz_z;
        }
        fx_x = fx_x * p.x + fx;
        fx = fx * p.x + fy;
        fx_y = fx_y * p.x + fy_y;
        fx_z = fx_z * p.x + fy_z;
    }
    return {fx, {fx_x, fx_y, fx_z}};
}

}  // namespace

Poly make_poly(int degree, std::vector<double> coefficients) {
    // Largest coefficient of each degree; the surface turns where terms of different degrees are of one size.
    std::array<double, highest_degree + 1> largest{};
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
            for (int c = 0; a + b + c <= degree; ++c) {
                double& most = largest[static_cast<std::size_t>(a + b + c)];
                most = std::fmax(most, std::fabs(coefficients[poly_index(degree, a, b, c)]));
            }
    std::size_t top = static_cast<std::size_t>(degree);
    while (top > 0 && largest[top] == 0.0) --top;
    double scale = 0.0;
    for (std::size_t k = 0; k < top; ++k) scale = std::fmax(scale, std::pow(largest[k] / largest[top], 1.0 / static_cast<double>(top - k)));
    if (!(scale > 1e-150 && scale < 1e150)) scale = 1.0;
    return {Shared<PolyData>(PolyData{degree, std::move(coefficients), scale})};
}

// The line is cut at its point nearest to the origin, s = 0, and at one reach on either side of it. Beyond that 1 / |s| is the variable, so
// that the polynomial is asked for on [0, 1] in all four pieces.
void find_hits(const Poly& shape, const Ray& ray, HitSink& sink) {
    const PolyData& poly = *shape.data;
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const double shift = -dot(ray.origin, d);
    const Vec3 o = ray.origin + shift * d;
    const double reach = std::fmax(poly.scale, length(o));
    const auto n = static_cast<std::size_t>(poly.degree);
    Coefficients c = along(poly, o, reach * d);
    // One step of Newton's on the surface itself: the coefficients along the line, and the brackets they gave, are rounded ones.
    const auto offer = [&](double s) {
        double r = reach * s;
        const ValueAndGradient at = evaluate(poly, o + r * d);
        const double step = at.value / dot(at.gradient, d);
        if (std::fabs(step) <= largest_step * (std::fabs(r) + poly.scale)) r -= step;
        sink.offer({.t = (r + shift) / speed});
    };
    const auto s_of = [&](double t) { return (t * speed - shift) / reach; };

    if (changes_at_zero(std::span(c).first(n + 1))) offer(0.0);
    for (std::size_t i = 1; i <= n; i += 2) c[i] = -c[i];
    find_half(c, n, -s_of(sink.before()), -s_of(sink.after()), [&](double s) { offer(-s); });
    for (std::size_t i = 1; i <= n; i += 2) c[i] = -c[i];
    find_half(c, n, s_of(sink.after()), s_of(sink.before()), offer);
}

Vec3 normal(const Poly& shape, const Vec3& point, const ShapeHit&) { return evaluate(*shape.data, point).gradient; }

bool contains(const Poly& shape, const Vec3& point) { return evaluate(*shape.data, point).value < 0.0; }

Bounds bounds(const Poly&) { return Bounds::everything(); }

}  // namespace rt
