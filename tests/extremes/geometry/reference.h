// The reference: brute force, in any precision T, with shapes that are met in one way or another. One ray for each pixel's centre.
#pragma once

#include <limits>
#include <optional>

#include "tests/extremes/eye.h"
#include "tests/extremes/geometry/body.h"
#include "tests/extremes/picture.h"
#include "tests/extremes/robust.h"

namespace rt::extremes {

template <typename T, template <typename> typename Shapes>
class Reference {
public:
    /// `touching`: see ExactShapes.
    explicit Reference(const Solids& solids, double touching = 0x1p-90)
        : scene_(solids), shapes_(solids.extent(), touching), eye_(solids.camera) {
        for (const Solid& solid : solids.solids) bodies_.emplace_back(solid);
        for (const Body<T>& body : bodies_)
            if (body.solid->glass && contains(body, eye_.origin)) around_camera_.push_back(&body);
    }

    /// The camera is moved to the right and upwards by these shares of the scene's largest coordinate.
    Picture picture(int width, int height, double right = 0.0, double up = 0.0) const {
        Picture result{width, height, {}};
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const Color c = light(eye(i, j, width, height, right, up), 0, around_camera_);
                result.pixels.emplace_back(static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z));
            }
        return result;
    }

    /// The number of the object that the camera sees in each pixel, or that of objects.
    std::vector<std::size_t> objects(int width, int height) const {
        std::vector<std::size_t> result;
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const Hit hit = nearest(eye(i, j, width, height, 0.0, 0.0), true);
                result.push_back(hit.body == nullptr ? scene_.objects : hit.body->solid->object);
            }
        return result;
    }

private:
    using V = Vec<T>;
    using Color = Vec<T>;
    using Media = std::vector<const Body<T>*>;
    struct Hit {
        const Body<T>* body = nullptr;
        Meeting<T> at;
    };

    BodyRay<T> eye(int i, int j, int width, int height, double right, double up) const {
        const T extent = static_cast<T>(scene_.extent());
        const V moved = T(right) * extent * unit(eye_.right) + T(up) * extent * unit(eye_.up);
        return {eye_.origin + moved, eye_.towards(i, j, width, height)};
    }

    static bool contains(const Body<T>& body, const V& p) {
        const auto within = [](T x, T low, T high) { return x > low && x < high; };
        const V f = p - body.a;
        switch (body.solid->kind) {
            case Solid::Kind::sphere:
                return dot(f, f) < body.size * body.size;
            case Solid::Kind::box:
                return within(p.x, body.a.x, body.b.x) && within(p.y, body.a.y, body.b.y) && within(p.z, body.a.z, body.b.z);
            default: {
                const T along = dot(f, body.c);
                const V across = f - along * body.c;
                return within(along, T(0), body.height) && dot(across, across) < body.size * body.size;
            }
        }
    }

    Hit nearest(const BodyRay<T>& ray, bool of_camera) const {
        Hit hit;
        for (const Body<T>& body : bodies_) {
            if (of_camera && !body.solid->seen) continue;
            const std::optional<Meeting<T>> at = shapes_.meet(body, ray);
            if (at && (hit.body == nullptr || shapes_.nearer(at->t, hit.at.t))) hit = {&body, *at};
        }
        return hit;
    }

    bool in_shadow(const BodyRay<T>& ray, T distance) const {
        for (const Body<T>& body : bodies_) {
            if (!body.solid->casts_shadow) continue;
            const std::optional<Meeting<T>> at = shapes_.meet(body, ray);
            if (at && shapes_.nearer(at->t, distance)) return true;
        }
        return false;
    }

    Color light(const BodyRay<T>& ray, int level, const Media& media, bool of_camera = true) const {
        if (level >= scene_.max_trace_level) return {};
        const Hit hit = nearest(ray, of_camera);
        if (hit.body == nullptr) return Color(scene_.background);
        const Solid& solid = *hit.body->solid;
        const V point = ray.origin + hit.at.t * ray.direction, outward = unit(hit.at.outward);
        const bool from_within = dot(outward, ray.direction) > T(0);
        const V n = from_within ? -outward : outward;
        if (solid.glass) return glass(ray, *hit.body, point, n, from_within, level + 1, media, of_camera);
        Color sum = matte(*hit.body, point, n, from_within);
        if (solid.mirror != Rgb(0.0)) {
            const V d = ray.direction - T(2) * dot(ray.direction, n) * n;
            sum = sum + Color(solid.mirror) * light({point, d, hit.body, from_within}, level + 1, media, false);
        }
        return sum;
    }

    /// ka + sum lc kd n.l.
    Color matte(const Body<T>& body, const V& point, const V& n, bool from_within) const {
        Color sum(body.solid->ambient);
        for (const Lamp& lamp : scene_.lamps) {
            const V to_lamp = V(lamp.location) - point;
            const T distance = length(to_lamp);
            const V l = T(1) / distance * to_lamp;
            const T cos = dot(n, l);
            if (cos > T(0) && !in_shadow({point, l, &body, from_within}, distance))
                sum = sum + cos * (Color(lamp.color) * Color(body.solid->diffuse));
        }
        return sum;
    }

    /// F of the mirrored ray's light and 1 - F of the bent one's, or all of the mirrored one's where none is bent. Indices are POV-Ray's:
    /// of the medium that was entered last, and none of a change where another than that is left.
    Color glass(const BodyRay<T>& ray, const Body<T>& body, const V& point, const V& n, bool from_within, int level, const Media& media,
                bool of_camera) const {
        const auto index = [&](std::size_t i) { return static_cast<T>(media[i]->solid->ior); };
        const auto place = std::find(media.begin(), media.end(), &body);
        const bool leaves = place != media.end(), last = leaves && place + 1 == media.end();
        const T own = static_cast<T>(body.solid->ior), around = media.empty() ? T(1) : index(media.size() - 1);
        const T behind = !leaves ? own : !last ? own : media.size() > 1 ? index(media.size() - 2) : T(1);
        const T ratio = (leaves ? own : around) / behind;
        const T eta = leaves && media.size() == 1 ? T(1) / own : leaves ? around / own : own / around;

        const V& d = ray.direction;
        const T cos = -dot(d, n), k = T(1) - ratio * ratio * (T(1) - cos * cos);
        const Color mirrored = light({point, d + T(2) * cos * n, &body, from_within}, level, media, false);
        if (k < T(0)) return mirrored;
        const T F = Robust<T>::reflectance(eta, cos);
        Media within = media;
        if (leaves)
            within.erase(within.begin() + (place - media.begin()));
        else
            within.push_back(&body);
        const V bent = ratio * d + (ratio * cos - sqrt(k)) * n;
        return F * mirrored + (T(1) - F) * light({point, bent, &body, !from_within}, level, within, of_camera);
    }

    const Solids& scene_;
    Shapes<T> shapes_;
    Eye<T> eye_;
    std::vector<Body<T>> bodies_;
    Media around_camera_;
};

}  // namespace rt::extremes
