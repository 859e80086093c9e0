// A second renderer for the extreme scenes: rays in any precision T, the terms in either form and in any precision S, which receive the
// directions rounded to it. One ray for each pixel's centre.
#pragma once

#include <limits>

#include "tests/extremes/description.h"
#include "tests/extremes/eye.h"
#include "tests/extremes/picture.h"

namespace rt::extremes {

template <typename T, template <typename> typename Terms, typename S = T>
class Renderer {
public:
    /// `least_alpha` stands in for 0 where a form has no value there.
    Renderer(const Description& description, double least_alpha)
        : scene_(description), least_alpha_(static_cast<S>(least_alpha)), eye_(description.camera) {}

    Picture picture(int width, int height) const {
        Picture result{width, height, {}};
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const Color c = light({eye_.origin, eye_.towards(i, j, width, height)}, 0);
                result.pixels.emplace_back(static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z));
            }
        return result;
    }

private:
    using V = Vec<T>;
    using Color = Vec<T>;
    struct Ray {
        V origin, direction;
        const Surface* from = nullptr;  ///< where it starts
        bool inside = false;            ///< of that sphere
    };
    struct Hit {
        const Surface* surface = nullptr;
        T t{};
    };

    /// Nothing convex meets what leaves it; what goes on inside meets its other side.
    static bool meet(const Surface& surface, const Ray& ray, T& t) {
        const V center(surface.center);
        const T size = static_cast<T>(surface.radius);
        const bool own = ray.from == &surface;
        if (surface.plane) {
            t = (size - dot(ray.origin, center)) / dot(ray.direction, center);
            return !own && t > T(0) && is_finite(t);
        }
        const V f = ray.origin - center;
        const T b = -dot(f, ray.direction);
        if (own) {
            t = T(2) * b;
            return ray.inside;
        }
        const V nearest = f + b * ray.direction;
        const T left = size * size - dot(nearest, nearest);
        if (!(left >= T(0) && b > T(0))) return false;
        t = (dot(f, f) - size * size) / (b + sqrt(left));
        return t > T(0);
    }

    Hit nearest(const Ray& ray) const {
        Hit hit;
        for (const Surface& surface : scene_.surfaces) {
            T t{};
            if (meet(surface, ray, t) && (hit.surface == nullptr || t < hit.t)) hit = {&surface, t};
        }
        return hit;
    }

    bool in_shadow(const Ray& ray, T distance) const {
        for (const Surface& surface : scene_.surfaces) {
            T t{};
            if (surface.casts_shadow && meet(surface, ray, t) && t < distance) return true;
        }
        return false;
    }

    Color light(const Ray& ray, int level) const {
        if (level >= scene_.max_trace_level) return {};
        const Hit hit = nearest(ray);
        if (hit.surface == nullptr) return Color(scene_.background);
        const V point = ray.origin + hit.t * ray.direction;
        const V outward = hit.surface->plane ? V(hit.surface->center) : unit(point - V(hit.surface->center));
        const V n = dot(outward, ray.direction) > T(0) ? -outward : outward;
        return hit.surface->glass ? glass(ray, *hit.surface, point, n, level + 1) : lit(ray, *hit.surface, point, n);
    }

    S alpha(const Surface& surface) const {
        const S r = static_cast<S>(surface.roughness);
        return std::max(surface.direct ? r : r * r, least_alpha_);
    }

    T lobe(const Surface& surface, const V& n, const V& l, const V& v) const {
        return static_cast<T>(Terms<S>::highlight(surface, alpha(surface), Vec<S>(n), Vec<S>(l), Vec<S>(v)));
    }

    /// ka + sum lc ((1 - s) kd n.l + s n.l rs).
    Color lit(const Ray& ray, const Surface& surface, const V& point, const V& n) const {
        const Color pigment(surface.pigment);
        const T s = static_cast<T>(surface.s), diffuse = (T(1) - s) * static_cast<T>(surface.diffuse);
        Color sum = pigment * Color(surface.ambient);
        for (const Lamp& lamp : scene_.lamps) {
            const V to_lamp = V(lamp.location) - point;
            const T distance = length(to_lamp);
            const V l = T(1) / distance * to_lamp;
            const T nl = dot(n, l);
            if (!(nl > T(0)) || in_shadow({point, l, &surface}, distance)) continue;
            const T highlight = s == T(0) ? T(0) : s * lobe(surface, n, l, -ray.direction);
            sum = sum + Color(lamp.color) * (diffuse * nl * pigment + highlight * Color(T(1), T(1), T(1)));
        }
        return sum;
    }

    /// F of the mirrored ray's light and 1 - F of the refracted one's, or all of the mirrored one's where none is refracted.
    Color glass(const Ray& ray, const Surface& surface, const V& point, const V& n, int level) const {
        const bool leaves = ray.inside && ray.from == &surface;
        const T ior = static_cast<T>(surface.ior), ratio = leaves ? ior : T(1) / ior;
        const V& d = ray.direction;
        const T cos = -dot(d, n), k = T(1) - ratio * ratio * (T(1) - cos * cos);
        const Color mirrored = light({point, d + T(2) * cos * n, &surface, leaves}, level);
        if (k < T(0)) return mirrored;
        const T F = static_cast<T>(Terms<S>::reflectance(static_cast<S>(T(1) / ratio), static_cast<S>(cos)));
        const V bent = ratio * d + (ratio * cos - sqrt(k)) * n;
        return F * mirrored + (T(1) - F) * light({point, bent, &surface, !leaves}, level);
    }

    const Description& scene_;
    S least_alpha_;
    Eye<T> eye_;
};

}  // namespace rt::extremes
