// One light as a surface point sees it: direction, distance, attenuation, and the grid of an area light.
#pragma once

#include "world/world.h"

namespace rt {

/// Towards a light: unit direction, and the length along it at which shadows end (negative behind a parallel light's plane).
struct LightRay {
    Vec3 direction{0.0};
    double distance = 0.0;
};

/// A light with everything derived from it that does not depend on the point.
class LightSource {
public:
    LightSource(const Light& light, const LampRules& rules);

    const Light& light() const { return *light_; }
    const AreaLight* area() const { return light_->area ? &*light_->area : nullptr; }

    /// From `point` to the light when it stands at `location` (its own, or a sample's of its area). The zero direction where there is none:
    /// the light is at the point, or a directed light has no direction.
    LightRay towards(const Vec3& location, const Vec3& point) const {
        const Vec3 to_light = location - point;
        if (directed_) return along_axis(location, to_light);
        const double distance = length(to_light);
        if (!(distance > 0.0) || !std::isfinite(distance)) return {};
        return {to_light / distance, distance};
    }

    /// The direction at `beside`, not far from `point`, towards where `ray` leads from `point`.
    Vec3 direction_beside(const Vec3& beside, const Vec3& point, const LightRay& ray) const;

    /// Factor on the light's colour at `point` along `ray`, which may lead to a sample: spot cone, cylinder (always the central one),
    /// fading with distance, the law of all lamps. Not NaN.
    double attenuation(const Vec3& point, const LightRay& ray) const { return attenuates_ ? attenuated(point, ray) : 1.0; }

private:
    LightRay along_axis(const Vec3& location, const Vec3& to_light) const;
    double attenuated(const Vec3& point, const LightRay& ray) const;
    double cone(const Vec3& from_light) const;
    double cylinder(const Vec3& point) const;
    double fade(double distance) const;

    const Light* light_;
    LampRules rules_;
    Vec3 axis_{0.0};  ///< unit, the way the light shines; zero if location and point_at are one
    double cos_radius_ = 0.0, cos_falloff_ = 0.0;
    bool fades_ = false;
    bool thins_ = false;  ///< by the rules' law
    // A lamp that is neither shines everywhere, with all of its light.
    bool directed_ = false;  ///< all of its rays are parallel
    bool attenuates_ = false;
};

/// The grid of an area light, turned towards a point where it says `orient`.
class AreaGrid {
public:
    AreaGrid(const Light& light, const Vec3& point);
    /// Location of sample (i, j), 0 <= i < size1, 0 <= j < size2.
    Vec3 position(int i, int j) const;

private:
    const Light* light_;
    Vec3 axis1_, axis2_;
    bool circular_;
};

}  // namespace rt
