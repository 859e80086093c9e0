#include "trace/light_source.h"

#include "shading/povray_finish.h"

namespace rt {
namespace {

Vec3 unit_or_zero(const Vec3& v) {
    const double size = length(v);
    return size > 0.0 && std::isfinite(size) ? v / size : Vec3(0.0);
}

}  // namespace

LightSource::LightSource(const Light& light, const LampRules& rules)
    : light_(&light),
      rules_(rules),
      axis_(unit_or_zero(light.point_at - light.location)),
      cos_radius_(std::cos(radians(light.radius))),
      cos_falloff_(std::cos(radians(light.falloff))),
      fades_(light.fade_power > 0.0 && std::fabs(light.fade_distance) > 1e-10),
      thins_(!light.parallel && (rules.law.kind != Attenuation::none || rules.law.range < AttenuationLaw::infinite)),
      directed_(light.type == Light::Type::cylinder || light.parallel),
      attenuates_(light.type == Light::Type::spotlight || light.type == Light::Type::cylinder || fades_ || thins_) {}

/// A sample of an area shines through point_at from where it stands.
LightRay LightSource::along_axis(const Vec3& location, const Vec3& to_light) const {
    const Vec3 direction = location == light_->location ? -axis_ : unit_or_zero(location - light_->point_at);
    return {direction, dot(to_light, direction)};
}

Vec3 LightSource::direction_beside(const Vec3& beside, const Vec3& point, const LightRay& ray) const {
    if (directed_) return ray.direction;
    return unit_or_zero(point - beside + ray.distance * ray.direction);
}

double LightSource::cone(const Vec3& from_light) const {
    if (rules_.exponent_spots)
        return rules_.clamp_after ? spot_clamped_after(axis_, -from_light, light_->tightness) : spot(axis_, -from_light, light_->tightness);
    const double a = dot(axis_, from_light);
    if (!(a > 0.0)) return 0.0;
    double factor = light_->tightness == 0.0 ? 1.0 : std::pow(std::fmin(a, 1.0), light_->tightness);
    if (cos_radius_ > 0.0 && a < cos_radius_) factor *= cubic_step(cos_falloff_, cos_radius_, a);
    return factor;
}

double LightSource::cylinder(const Vec3& point) const {
    const Vec3 from_light = point - light_->location;
    const double along = dot(from_light, axis_);
    if (!(along > 0.0)) return 0.0;
    const double r = length(from_light - along * axis_);
    if (!(r < light_->falloff)) return 0.0;
    const double q = 1.0 - r / light_->falloff;
    double factor = light_->tightness == 0.0 ? 1.0 : std::pow(q, light_->tightness);
    if (light_->radius > 0.0 && r > light_->radius) factor *= cubic_step(0.0, 1.0 - light_->radius / light_->falloff, q);
    return factor;
}

double LightSource::fade(double distance) const {
    const double factor = 2.0 / (1.0 + std::pow(distance / light_->fade_distance, light_->fade_power));
    return std::isfinite(factor) ? factor : 0.0;
}

double LightSource::attenuated(const Vec3& point, const LightRay& ray) const {
    double factor = 1.0;
    // A parallel spotlight's rays are its axis; what lies behind its plane is behind the cone.
    if (light_->type == Light::Type::spotlight) factor = cone(ray.distance < 0.0 ? ray.direction : -ray.direction);
    if (light_->type == Light::Type::cylinder) factor = cylinder(point);
    if (fades_ && factor != 0.0) factor *= fade(ray.distance);
    if (thins_ && factor != 0.0) factor *= rt::attenuation(rules_.law, ray.distance);
    return factor;
}

AreaGrid::AreaGrid(const Light& light, const Vec3& point)
    : light_(&light), axis1_(light.area->axis1), axis2_(light.area->axis2), circular_(light.area->circular || light.area->orient) {
    if (!light.area->orient) return;
    const Vec3 w = unit_or_zero(light.location - point);
    const Vec3 helper = std::fabs(std::fabs(w.z) - 1.0) < 0.01 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const double size = length(axis1_);
    axis1_ = size * unit_or_zero(cross(w, helper));
    axis2_ = size * unit_or_zero(cross(w, axis1_));
}

Vec3 AreaGrid::position(int i, int j) const {
    const int n1 = light_->area->size1, n2 = light_->area->size2;
    const double middle = circular_ ? 0.499 : 0.5;
    double a = n1 > 1 ? static_cast<double>(i) / (n1 - 1) - middle : 0.0;
    double b = n2 > 1 ? static_cast<double>(j) / (n2 - 1) - middle : 0.0;
    if (circular_ && (a != 0.0 || b != 0.0)) {
        const double m = std::fmax(std::fabs(a), std::fabs(b)) / std::sqrt(a * a + b * b);
        a *= m;
        b *= m;
    }
    return light_->location + a * axis1_ + b * axis2_;
}

}  // namespace rt
