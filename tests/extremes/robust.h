// The same terms in forms that lose nothing: the sine of the half angle from a cross product, V = G / (4 n.l n.v) as one term, Fresnel's
// amplitudes from eta^2 - 1. A lamp that is a point has no share of a lobe without width.
#pragma once

#include "tests/extremes/description.h"
#include "tests/extremes/number.h"

namespace rt::extremes {

template <typename T>
struct Robust {
    static T square(T x) { return x * x; }

    /// A direction by its cosine and sine to the normal.
    struct Angle {
        T cos, sin;
    };

    static T D(const Surface& surface, T cos2, T sin2, T alpha) {
        if (alpha == T(0)) return T(0);
        const T pi = pi_of<T>(), a2 = alpha * alpha, t2 = sin2 / cos2;
        switch (surface.D) {
            case Distribution::blinn:  // cos^2 = 1 / (1 + tan^2)
                return exp((T(1) - T(1) / a2) * log1p(t2)) / (pi * a2);
            case Distribution::beckmann:
                return exp(-t2 / a2) / (pi * a2 * cos2 * cos2);
            default:  // ggx
                return square(alpha / (sin2 + a2 * cos2)) / pi;
        }
    }

    static T root(const Angle& x, T alpha) { return sqrt(x.cos * x.cos + square(alpha * x.sin)); }
    /// 2 cos / G1 of Smith's masking for Beckmann.
    static T beckmann(const Angle& x, T alpha) {
        const T spread = alpha * x.sin;
        if (spread == T(0)) return T(2) * x.cos;
        const T a = x.cos / spread;
        return x.cos * (T(1) + erf(a)) + spread * exp(-a * a) / sqrt(pi_of<T>());
    }
    static T rational(const Angle& x, T alpha) {
        const T spread = alpha * x.sin;
        if (x.cos >= T(1.6) * spread) return T(1) / x.cos;
        const T a = x.cos / spread;
        return (T(3.535) + T(2.181) * a) / ((T(1) + T(2.276) * a + T(2.577) * a * a) * spread);
    }

    static T V(const Surface& surface, const Angle& l, const Angle& v, T ss, T alpha) {
        switch (surface.G) {
            case Masking::cook_torrance:
                return std::min(T(1) / (T(4) * l.cos * v.cos), (l.cos + v.cos) / (ss * std::max(l.cos, v.cos)));
            case Masking::ggx:
                return T(1) / ((l.cos + root(l, alpha)) * (v.cos + root(v, alpha)));
            case Masking::ggx_hc:
                return T(0.5) / (l.cos * root(v, alpha) + v.cos * root(l, alpha));
            case Masking::beckmann:
                return T(1) / (beckmann(l, alpha) * beckmann(v, alpha));
            case Masking::beckmann_hc:
                return T(0.5) / (l.cos * beckmann(v, alpha) + v.cos * beckmann(l, alpha) - T(2) * l.cos * v.cos);
            case Masking::beckmann_rational:
                return rational(l, alpha) * rational(v, alpha) / T(4);
            case Masking::none:
                return T(1) / (T(4) * l.cos * v.cos);
        }
        return T(0);
    }

    struct Complex {
        T re, im;
        T size() const { return sqrt(re * re + im * im); }
        friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
        friend Complex operator*(T k, const Complex& a) { return {k * a.re, k * a.im}; }
    };

    /// Of eta + i k; k = 0 is the dielectric.
    static T reflectance(T eta, T k, T c) {
        const Complex e{(eta - T(1)) * (eta + T(1)) - k * k, T(2) * eta * k}, eta2{(eta - k) * (eta + k), e.im};
        if (k == T(0) && e.re == T(0)) return T(0);
        const Complex g2 = e + Complex{c * c, T(0)};
        if (k == T(0) && g2.re <= T(0)) return T(1);
        const T p = sqrt((g2.size() + fabs(g2.re)) / T(2)), q = g2.im / (T(2) * p);
        const Complex g = g2.re >= T(0) ? Complex{p, q} : Complex{q, p};
        const T s = e.size() / square((g + Complex{c, T(0)}).size());
        const Complex above = c * c * eta2 + Complex{-(T(1) - c) * (T(1) + c), T(0)}, below = c * eta2 + g;
        const T parallel = e.size() / below.size() * (above.size() / below.size());
        return std::min(T(1), (s * s + parallel * parallel) / T(2));
    }
    static T reflectance(T eta, T c) { return reflectance(eta, T(0), c); }

    static T schlick(T f0, T c) {
        const T x = T(1) - std::min(T(1), c);
        return f0 + (T(1) - f0) * (x * x * x * x * x);
    }

    static T F(const Surface& surface, T c) {
        const T eta = static_cast<T>(surface.ior), k = static_cast<T>(surface.k);
        const T f0 = (square((eta - T(1))) + k * k) / (square(eta + T(1)) + k * k);
        switch (surface.F) {
            case Fresnel::dielectric:
                return reflectance(eta, c);
            case Fresnel::conductor:
                return reflectance(eta, k, c);
            case Fresnel::schlick_f82: {
                const T at = T(1) / T(7), y = T(1) - at, x = T(1) - std::min(T(1), c);
                const T b = (schlick(f0, at) - reflectance(eta, k, at)) / (at * (y * y * y) * (y * y * y));
                return std::clamp(schlick(f0, c) - b * c * (x * x * x) * (x * x * x), T(0), T(1));
            }
            default:
                return schlick(f0, c);
        }
    }

    static T highlight(const Surface& surface, T alpha, const Vec<T>& n, const Vec<T>& l, const Vec<T>& v) {
        const Angle to_l{dot(n, l), length(cross(n, l))}, to_v{dot(n, v), length(cross(n, v))};
        if (!(to_l.cos > T(0) && to_v.cos > T(0))) return T(0);
        const Vec<T> s = l + v, x = cross(n, s);
        const T ns = to_l.cos + to_v.cos, ss = dot(s, s), sum = ns * ns + dot(x, x);
        const T d = D(surface, ns * ns / sum, dot(x, x) / sum, alpha);
        if (d == T(0)) return T(0);
        return to_l.cos * V(surface, to_l, to_v, ss, alpha) * d * F(surface, sqrt(ss) / T(2));
    }
};

}  // namespace rt::extremes
