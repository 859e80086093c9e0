#include "core/spline.h"

#include <algorithm>

namespace rt {

namespace {

using Points = std::vector<Spline::Point>;
using Value = std::array<double, 5>;

template <typename Component>
Value each(const Component& component) {
    Value result{};
    for (std::size_t c = 0; c < result.size(); ++c) result[c] = component(c);
    return result;
}

Value line(const Points& p, std::size_t i, double t) {
    const double part = (t - p[i].t) / (p[i + 1].t - p[i].t);
    return each([&](std::size_t c) { return p[i].value[c] + (p[i + 1].value[c] - p[i].value[c]) * part; });
}

/// The parabola through the points i - 1, i, i + 1 in Lagrange's form.
Value parabola(const Points& p, std::size_t i, double t) {
    const double a = p[i - 1].t, b = p[i].t, d = p[i + 1].t;
    const double wa = (t - b) * (t - d) / ((a - b) * (a - d)), wb = (t - a) * (t - d) / ((b - a) * (b - d)),
                 wd = (t - a) * (t - b) / ((d - a) * (d - b));
    return each([&](std::size_t c) { return wa * p[i - 1].value[c] + wb * p[i].value[c] + wd * p[i + 1].value[c]; });
}

/// Hermite's cubic between the points i and i + 1.
Value hermite(const Points& p, std::size_t i, double t) {
    const double h = p[i + 1].t - p[i].t, s = (t - p[i].t) / h;
    const auto slope = [&](std::size_t k, std::size_t c) { return (p[k + 1].value[c] - p[k].value[c]) / (p[k + 1].t - p[k].t); };
    return each([&](std::size_t c) {
        const double m0 = 0.5 * (slope(i - 1, c) + slope(i, c)), m1 = 0.5 * (slope(i, c) + slope(i + 1, c));
        return (2 * s * s * s - 3 * s * s + 1) * p[i].value[c] + (s * s * s - 2 * s * s + s) * h * m0 +
               (3 * s * s - 2 * s * s * s) * p[i + 1].value[c] + (s * s * s - s * s) * h * m1;
    });
}

/// Second derivatives of the natural cubic spline at its points: Thomas' algorithm for the tridiagonal system of its knots.
std::vector<double> second_derivatives(const Points& p, std::size_t c) {
    const std::size_t n = p.size();
    std::vector<double> m(n, 0.0), upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double before = p[i].t - p[i - 1].t, after = p[i + 1].t - p[i].t;
        const double change = (p[i + 1].value[c] - p[i].value[c]) / after - (p[i].value[c] - p[i - 1].value[c]) / before;
        const double pivot = 2 * (before + after) - before * upper[i - 1];
        upper[i] = after / pivot;
        m[i] = (6 * change - before * m[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
    return m;
}

Value natural(const Points& p, std::size_t i, double t, int size) {
    const double h = p[i + 1].t - p[i].t, a = (p[i + 1].t - t) / h, b = (t - p[i].t) / h;
    return each([&](std::size_t c) {
        if (c >= static_cast<std::size_t>(size)) return 0.0;
        const std::vector<double> m = second_derivatives(p, c);
        return a * p[i].value[c] + b * p[i + 1].value[c] + ((a * a * a - a) * m[i] + (b * b * b - b) * m[i + 1]) * h * h / 6;
    });
}

}  // namespace

void Spline::arrange() {
    std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.t < b.t; });
    const auto first = std::unique(points.rbegin(), points.rend(), [](const Point& a, const Point& b) { return a.t == b.t; });
    points.erase(points.begin(), first.base());
}

std::array<double, 5> evaluate(const Spline& spline, double t, Spline::Kind kind) {
    const Points& p = spline.points;
    const std::size_t n = p.size();
    if (kind == Spline::Kind::cubic && n == 2) return each([&](std::size_t c) { return 0.5 * (p[0].value[c] + p[1].value[c]); });
    const bool inner = kind == Spline::Kind::cubic && n > 2;
    if (!(t > p[inner ? 1 : 0].t)) return p[inner ? 1 : 0].value;
    if (!(t < p[n - (inner ? 2 : 1)].t)) return p[n - (inner ? 2 : 1)].value;
    const auto after = std::lower_bound(p.begin(), p.end(), t, [](const Spline::Point& q, double x) { return q.t < x; });
    const auto i = static_cast<std::size_t>(after - p.begin()) - 1;  // t is in (t_i, t_{i+1}]
    if (kind == Spline::Kind::cubic) return hermite(p, i, t);
    if (kind == Spline::Kind::natural) return natural(p, i, t, spline.size);
    if (kind == Spline::Kind::quadratic && n >= 3) return parabola(p, std::max<std::size_t>(i, 1), t);
    return line(p, i, t);
}

}  // namespace rt
