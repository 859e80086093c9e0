// Where rays meet bodies as texts print it and as one types it: the quadratic formula, Moeller and Trumbore with their epsilon, and nothing
// counts that is nearer than 1e-4.
#pragma once

#include <optional>

#include "tests/extremes/geometry/body.h"

namespace rt::extremes {

template <typename T>
class TextbookShapes {
public:
    TextbookShapes(double, double) {}

    std::optional<Meeting<T>> meet(const Body<T>& body, const BodyRay<T>& ray) const {
        switch (body.solid->kind) {
            case Solid::Kind::sphere:
                return sphere(body, ray);
            case Solid::Kind::plane:
                return at((body.size - dot(ray.origin, body.a)) / dot(ray.direction, body.a), body.a);
            case Solid::Kind::box:
                return box(body, ray);
            case Solid::Kind::cylinder:
                return cylinder(body, ray);
            default:
                return triangle(body, ray);
        }
    }

    bool nearer(T a, T b) const { return a < b; }

private:
    using V = Vec<T>;
    using Answer = std::optional<Meeting<T>>;
    static constexpr double nearest = 1e-4, parallel = 1e-6;

    static Answer at(T t, const V& outward) {
        if (!(t > T(nearest) && is_finite(t))) return std::nullopt;
        return Meeting<T>{t, outward};
    }

    Answer sphere(const Body<T>& body, const BodyRay<T>& ray) const {
        const V f = ray.origin - body.a;
        const T b = T(2) * dot(f, ray.direction), c = dot(f, f) - body.size * body.size, discriminant = b * b - T(4) * c;
        if (!(discriminant >= T(0))) return std::nullopt;
        for (const T sign : {T(-1), T(1)}) {
            const T t = (-b + sign * sqrt(discriminant)) / T(2);
            if (t > T(nearest)) return Meeting<T>{t, ray.origin + t * ray.direction - body.a};
        }
        return std::nullopt;
    }

    Answer box(const Body<T>& body, const BodyRay<T>& ray) const {
        T enter = -std::numeric_limits<T>::infinity(), leave = std::numeric_limits<T>::infinity();
        V at_enter, at_leave;
        for (const auto part : {&V::x, &V::y, &V::z}) {
            T t_in = (body.a.*part - ray.origin.*part) / ray.direction.*part,
              t_out = (body.b.*part - ray.origin.*part) / ray.direction.*part;
            V outward;
            outward.*part = ray.direction.*part > T(0) ? T(1) : T(-1);
            if (t_in > t_out) std::swap(t_in, t_out);
            if (t_in > enter) enter = t_in, at_enter = -outward;
            if (t_out < leave) leave = t_out, at_leave = outward;
        }
        if (!(enter <= leave)) return std::nullopt;
        return enter > T(nearest) ? at(enter, at_enter) : at(leave, at_leave);
    }

    Answer cylinder(const Body<T>& body, const BodyRay<T>& ray) const {
        const V f = ray.origin - body.a, across = ray.direction - dot(ray.direction, body.c) * body.c, g = f - dot(f, body.c) * body.c;
        const T a = dot(across, across), b = T(2) * dot(g, across), c = dot(g, g) - body.size * body.size;
        const T discriminant = b * b - T(4) * a * c;
        Answer best;
        const auto offer = [&](const Answer& answer) {
            if (answer && (!best || answer->t < best->t)) best = answer;
        };
        for (const T sign : {T(-1), T(1)}) {
            const T t = (-b + sign * sqrt(discriminant)) / (T(2) * a), height = dot(f + t * ray.direction, body.c);
            if (discriminant >= T(0) && height > T(0) && height < body.height) offer(at(t, g + t * across));
        }
        for (const T end : {T(0), body.height}) {
            const T t = (end - dot(f, body.c)) / dot(ray.direction, body.c);
            const V from_axis = g + t * across;
            if (dot(from_axis, from_axis) <= body.size * body.size) offer(at(t, end == T(0) ? -body.c : body.c));
        }
        return best;
    }

    Answer triangle(const Body<T>& body, const BodyRay<T>& ray) const {
        const V ab = body.b - body.a, ac = body.c - body.a, f = ray.origin - body.a;
        const V p = cross(ray.direction, ac), q = cross(f, ab);
        const T determinant = dot(ab, p);
        if (determinant > T(-parallel) && determinant < T(parallel)) return std::nullopt;
        const T u = dot(f, p) / determinant, v = dot(ray.direction, q) / determinant;
        if (u < T(0) || u > T(1) || v < T(0) || u + v > T(1)) return std::nullopt;
        return at(dot(ac, q) / determinant, cross(ab, ac));
    }
};

}  // namespace rt::extremes
