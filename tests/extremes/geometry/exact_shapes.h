// Where rays meet bodies when numbers have digits to spare: no ray meets again what it leaves, but for the far side of what it enters; so
// nothing has to be moved off a surface, and surfaces may be as near each other as their coordinates can say.
#pragma once

#include <optional>

#include "tests/extremes/geometry/body.h"

namespace rt::extremes {

template <typename T>
class ExactShapes {
public:
    /// `extent` is the scene's largest coordinate. What is nearer than this share of it touches and does not count, and of surfaces that
    /// are so near each other the first is met. A negative one turns both round: what touches counts, and the last is met.
    ExactShapes(double extent, double touching) : touching_(T(extent) * T(touching)) {}

    std::optional<Meeting<T>> meet(const Body<T>& body, const BodyRay<T>& ray) const {
        const bool own = ray.from == &body;
        if (own && !ray.into) return std::nullopt;
        switch (body.solid->kind) {
            case Solid::Kind::sphere:
                return sphere(body, ray, own);
            case Solid::Kind::plane:
                return own ? std::nullopt : plane(body, ray);
            case Solid::Kind::box:
                return box(body, ray, own);
            case Solid::Kind::cylinder:
                return cylinder(body, ray, own);
            default:
                return own ? std::nullopt : triangle(body, ray);
        }
    }

    /// Whether a is nearer than b; as near is not.
    bool nearer(T a, T b) const { return a < b - touching_; }

private:
    using V = Vec<T>;
    using Answer = std::optional<Meeting<T>>;
    /// The stretch of a line inside a convex body, with the outward normals at both ends.
    struct Stretch {
        T enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
        V at_enter, at_leave;

        void cut(T t_in, T t_out, const V& n_in, const V& n_out) {
            if (t_in > enter) enter = t_in, at_enter = n_in;
            if (t_out < leave) leave = t_out, at_leave = n_out;
        }
        void nothing() { enter = T(1), leave = T(-1); }
        /// Between the two planes dot(p, n) = low and high.
        void slab(const V& origin, const V& direction, const V& n, T low, T high) {
            const T o = dot(origin, n), d = dot(direction, n);
            if (d == T(0)) {
                if (o < low || o > high) nothing();
            } else if (d > T(0)) {
                cut((low - o) / d, (high - o) / d, -n, n);
            } else {
                cut((high - o) / d, (low - o) / d, n, -n);
            }
        }
    };

    Answer first(const Stretch& s, bool own) const {
        if (!(s.enter <= s.leave)) return std::nullopt;
        if (!own && s.enter > touching_) return Meeting<T>{s.enter, s.at_enter};
        if (s.leave > (own ? T(0) : touching_)) return Meeting<T>{s.leave, s.at_leave};
        return std::nullopt;
    }

    Answer plane(const Body<T>& body, const BodyRay<T>& ray) const {
        const T t = (body.size - dot(ray.origin, body.a)) / dot(ray.direction, body.a);
        if (!(t > touching_ && is_finite(t))) return std::nullopt;
        return Meeting<T>{t, body.a};
    }

    Answer sphere(const Body<T>& body, const BodyRay<T>& ray, bool own) const {
        const V f = ray.origin - body.a;
        const T b = -dot(f, ray.direction);
        const V nearest = f + b * ray.direction;
        const T left = body.size * body.size - dot(nearest, nearest);
        if (!(left >= T(0))) return std::nullopt;
        const T half = sqrt(left);
        Stretch s;
        s.cut(b - half, b + half, nearest - half * ray.direction, nearest + half * ray.direction);
        return first(s, own);
    }

    Answer box(const Body<T>& body, const BodyRay<T>& ray, bool own) const {
        Stretch s;
        s.slab(ray.origin, ray.direction, V(T(1), T(0), T(0)), body.a.x, body.b.x);
        s.slab(ray.origin, ray.direction, V(T(0), T(1), T(0)), body.a.y, body.b.y);
        s.slab(ray.origin, ray.direction, V(T(0), T(0), T(1)), body.a.z, body.b.z);
        return first(s, own);
    }

    Answer cylinder(const Body<T>& body, const BodyRay<T>& ray, bool own) const {
        const V& axis = body.c;
        const V f = ray.origin - body.a, across = ray.direction - dot(ray.direction, axis) * axis, g = f - dot(f, axis) * axis;
        const T a = dot(across, across), b = -dot(g, across), r2 = body.size * body.size;
        Stretch s;
        if (a == T(0)) {
            if (dot(g, g) > r2) return std::nullopt;
        } else {
            const T middle = b / a;
            const V nearest = g + middle * across;
            const T left = r2 - dot(nearest, nearest);
            if (!(left >= T(0))) return std::nullopt;
            const T half = sqrt(left / a);
            s.cut(middle - half, middle + half, nearest - half * across, nearest + half * across);
        }
        s.slab(f, ray.direction, axis, T(0), body.height);
        return first(s, own);
    }

    /// Moeller, Trumbore 1997.
    Answer triangle(const Body<T>& body, const BodyRay<T>& ray) const {
        const V ab = body.b - body.a, ac = body.c - body.a, f = ray.origin - body.a;
        const V p = cross(ray.direction, ac), q = cross(f, ab);
        const T determinant = dot(ab, p);
        if (determinant == T(0)) return std::nullopt;
        const T u = dot(f, p) / determinant, v = dot(ray.direction, q) / determinant, t = dot(ac, q) / determinant;
        if (!(u >= T(0) && v >= T(0) && u + v <= T(1) && t > touching_)) return std::nullopt;
        return Meeting<T>{t, cross(ab, ac)};
    }

    T touching_;
};

}  // namespace rt::extremes
