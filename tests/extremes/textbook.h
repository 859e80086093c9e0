// The terms as papers and texts print them, and as one types them: half vector normalised, tan^2 = (1 - c^2) / c^2, and D G F / (4 n.l
// n.v).
#pragma once

#include "tests/extremes/description.h"
#include "tests/extremes/number.h"

namespace rt::extremes {

template <typename T>
struct Textbook {
    static T square(T x) { return x * x; }
    static T tan2(T cos) { return (T(1) - cos * cos) / (cos * cos); }

    static T D(const Surface& surface, T nh, T alpha) {
        const T pi = pi_of<T>(), a2 = alpha * alpha, t2 = tan2(nh);
        switch (surface.D) {
            case Distribution::blinn:
                return pow(nh, T(2) / a2 - T(2)) / (pi * a2);
            case Distribution::beckmann:
                return exp(-t2 / a2) / (pi * a2 * square(nh * nh));
            default:  // ggx
                return a2 / (pi * square(nh * nh * (a2 + t2)));
        }
    }

    static T beckmann_G1(T cos, T alpha) {
        const T a = T(1) / (alpha * sqrt(tan2(cos)));
        return T(2) / (T(1) + erf(a) + exp(-a * a) / (a * sqrt(pi_of<T>())));
    }
    static T rational_G1(T cos, T alpha) {
        const T a = T(1) / (alpha * sqrt(tan2(cos)));
        return a < T(1.6) ? (T(3.535) * a + T(2.181) * a * a) / (T(1) + T(2.276) * a + T(2.577) * a * a) : T(1);
    }
    static T ggx_root(T cos, T alpha) { return sqrt(T(1) + alpha * alpha * tan2(cos)); }

    static T G(const Surface& surface, T nl, T nv, T nh, T vh, T alpha) {
        switch (surface.G) {
            case Masking::cook_torrance:
                return std::min(T(1), std::min(T(2) * nh * nv / vh, T(2) * nh * nl / vh));
            case Masking::ggx:
                return T(2) / (T(1) + ggx_root(nl, alpha)) * (T(2) / (T(1) + ggx_root(nv, alpha)));
            case Masking::ggx_hc:
                return T(1) / (T(1) + (ggx_root(nl, alpha) - T(1)) / T(2) + (ggx_root(nv, alpha) - T(1)) / T(2));
            case Masking::beckmann:
                return beckmann_G1(nl, alpha) * beckmann_G1(nv, alpha);
            case Masking::beckmann_hc:  // 1 + Lambda = 1 / G1
                return T(1) / (T(1) / beckmann_G1(nl, alpha) + T(1) / beckmann_G1(nv, alpha) - T(1));
            case Masking::beckmann_rational:
                return rational_G1(nl, alpha) * rational_G1(nv, alpha);
            case Masking::none:
                return T(1);
        }
        return T(0);
    }

    static T F0(T eta, T k) { return (square(eta - T(1)) + k * k) / (square(eta + T(1)) + k * k); }
    static T schlick(T f0, T c) { return f0 + (T(1) - f0) * pow(T(1) - c, T(5)); }

    /// Cook, Torrance 1982.
    static T dielectric(T eta, T c) {
        const T g = sqrt(eta * eta + c * c - T(1));
        return T(0.5) * square((g - c) / (g + c)) * (T(1) + square((c * (g + c) - T(1)) / (c * (g - c) + T(1))));
    }
    /// The real form of the equations for eta + i k.
    static T conductor(T eta, T k, T c) {
        const T cos2 = c * c, sin2 = T(1) - cos2, difference = eta * eta - k * k - sin2;
        const T sum = sqrt(difference * difference + T(4) * eta * eta * k * k);
        const T a = sqrt(T(0.5) * (sum + difference));
        const T s = (sum + cos2 - T(2) * a * c) / (sum + cos2 + T(2) * a * c);
        const T p = s * (cos2 * sum + sin2 * sin2 - T(2) * a * c * sin2) / (cos2 * sum + sin2 * sin2 + T(2) * a * c * sin2);
        return T(0.5) * (s + p);
    }

    /// 1 where light is reflected totally, in all precisions but single, which shows what the formula does by itself.
    static T reflectance(T eta, T c) { return sizeof(T) > 4 && eta * eta + c * c - T(1) <= T(0) ? T(1) : dielectric(eta, c); }

    static T F(const Surface& surface, T c) {
        const T eta = static_cast<T>(surface.ior), k = static_cast<T>(surface.k);
        switch (surface.F) {
            case Fresnel::dielectric:
                return reflectance(eta, c);
            case Fresnel::conductor:
                return conductor(eta, k, c);
            case Fresnel::schlick_f82: {
                const T at = T(1) / T(7), exact = reflectance(eta, at);
                const T b = (schlick(F0(eta, k), at) - exact) / (at * pow(T(1) - at, T(6)));
                return std::clamp(schlick(F0(eta, k), c) - b * c * pow(T(1) - c, T(6)), T(0), T(1));
            }
            default:
                return schlick(F0(eta, k), c);
        }
    }

    /// (n.l) D G F / (4 n.l n.v).
    static T highlight(const Surface& surface, T alpha, const Vec<T>& n, const Vec<T>& l, const Vec<T>& v) {
        const T nl = dot(n, l), nv = dot(n, v);
        if (!(nl > T(0) && nv > T(0))) return T(0);
        const Vec<T> h = unit(l + v);
        const T nh = dot(n, h), vh = dot(v, h);
        return nl * (D(surface, nh, alpha) * G(surface, nl, nv, nh, vh, alpha) * F(surface, vh) / (T(4) * nl * nv));
    }
};

}  // namespace rt::extremes
