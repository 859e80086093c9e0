// From the first field that differs to its usual cause: one rule for each field. In all of them the second argument of a pair is the
// suspect.
#pragma once

#include "grading/causes.h"
#include "grading/told_pixel.h"

namespace rt::rules {

/// Both of these are relative above 1 and absolute below; equal infinities and two NaNs are the same.
bool same(double a, double b, double tolerance);
bool same(const Vec3& a, const Vec3& b, double tolerance);

/// The camera ray's direction. `camera` of either record, or null; a pixel has `grid` x `grid` rays.
Cause camera_direction(const Vec3& a, const Vec3& b, const ToldCamera* camera, double grid, double tolerance);
/// Where a further ray begins; `point` is where its parent ends.
Cause origin(const Vec3& a, const Vec3& b, const Vec3& point);
/// A further ray's direction, caused by `incident` at a surface with `normal`.
Cause direction(ToldRay::Kind kind, const Vec3& a, const Vec3& b, const Vec3& incident, const Vec3& normal, double tolerance);
/// What the ray meets, or where on it. `parent` of B's ray is null for a camera ray.
Cause hit(const ToldRay& a, const ToldRay& b, const ToldRay* parent, double tolerance);
Cause normal(const Vec3& a, const Vec3& b, double tolerance);
Cause shares(const ToldRay::Shares& a, const ToldRay::Shares& b, double tolerance);
/// Whether light that passes a surface as `passing` would be totally reflected by the inverse ratio of the indices; true if that cannot be
/// told.
bool inverse_ratio_is_total(const ToldRay& incident, const ToldRay& passing, double tolerance);
Cause layers(const ToldLayer& a, const ToldLayer& b, double tolerance);
Cause shadow(const ToldShadow& a, const ToldShadow& b);
/// Of shadow rays to the lamps in `a`, does every one of several lamps that arrive fail to do so in `b`? A surface that shadows itself does
/// that.
bool hides_all(const std::vector<ToldShadow>& a, const std::vector<ToldShadow>& b);
/// Light of the surface itself, where `part` is the first of ambient, diffuse and specular that differs. `rounded`: a part that is 0 in one
/// of them may be a small one.
Cause local_light(LightPart part, const ToldRay& a, const ToldRay& b, bool rounded, double tolerance);
/// The factor of a further ray's light.
Cause factor(ToldRay::Kind kind, const Rgb& a, const Rgb& b, double tolerance);
/// All parts are the same, their sum is not.
Cause sum(const ToldRay& a, const ToldRay& b, double tolerance);
/// B's ray has no further ray of this kind, or A's has none (`a_has` false).
Cause further_ray(ToldRay::Kind kind, bool a_has, bool beyond_deepest);
/// The bytes of the picture, all rays being the same.
Cause color(const std::array<int, 3>& a, const std::array<int, 3>& b);

}  // namespace rt::rules
