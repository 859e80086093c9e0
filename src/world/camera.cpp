// The camera's statements combined into one basis, by the rules of each profile.
#include "world/compile.h"

namespace rt {

namespace {

/// Below this a cross product or a cosine counts as zero when directions are compared.
constexpr double parallel_tolerance = 1e-10;

[[noreturn]] void fail(const Camera& camera, const Sources& sources, std::string_view text) {
    throw SceneError(sources.describe(camera.span, "Parse Error", text));
}

bool is_flat(Projection projection) { return projection == Projection::perspective || projection == Projection::orthographic; }

/// A full turn and half of one for the whole sphere, else 90 degrees; the second angle of a sphere is half of the first.
void apply_wide_angle(const Camera& camera, CameraBasis& basis) {
    const bool sphere = camera.projection == Projection::spherical;
    const double degrees = camera.angle.value_or(sphere ? 360.0 : 90.0);
    basis.angle = radians(degrees);
    basis.vertical_angle = radians(camera.vertical_angle.value_or(0.5 * degrees));
}

void apply_angle(const Camera& camera, const Sources& sources, CameraBasis& basis) {
    const double degrees = camera.angle.value_or(0.0);
    if (degrees < 0.0) fail(camera, sources, "Negative viewing angle.");
    if (degrees >= 180.0) fail(camera, sources, "Viewing angle has to be smaller than 180 degrees.");
    if (degrees > 0.0) basis.direction = unit(basis.direction) * (length(basis.right) / (2.0 * std::tan(radians(degrees) / 2.0)));
}

/// Turns direction, right and up towards the point, keeping their lengths and the handedness they had.
void apply_look_at(const Camera& camera, const Vec3& point, const Sources& sources, const MessageSink& warn, CameraBasis& basis) {
    const double handedness = dot(cross(basis.up, basis.direction), basis.right);
    const double right_length = length(basis.right);
    const Vec3 z = unit(point - basis.origin);
    Vec3 x = cross(camera.sky, z);
    if (length(x) > parallel_tolerance) {
        x = unit(x);
    } else {
        warn(sources.describe(camera.span, "Parse Warning",
                              "Camera location to look_at direction and sky direction should be different. Using default/supplied right "
                              "vector instead."));
        x = unit(basis.right);
    }
    const Vec3 y = cross(z, x);
    basis.direction = length(basis.direction) * z;
    basis.up = length(basis.up) * y;
    basis.right = (handedness > 0.0 ? right_length : -right_length) * x;
}

void warn_if_skewed(const Camera& camera, const Sources& sources, const MessageSink& warn, const CameraBasis& basis) {
    const auto skewed = [](const Vec3& a, const Vec3& b) { return std::fabs(dot(a, b)) > 1e-6 * length(a) * length(b); };
    if (skewed(basis.direction, basis.up) || skewed(basis.direction, basis.right) || skewed(basis.up, basis.right)) {
        warn(sources.describe(camera.span, "Parse Warning",
                              "Camera vectors are not perpendicular. Making look_at the last statement may help."));
    }
}

/// An orthographic camera whose picture plane was not stated sees the plane through look_at as the perspective camera would.
void size_orthographic(const Camera& camera, const Vec3& look_at, CameraBasis& basis) {
    if (camera.up_or_right_stated && !camera.angle) return;
    const double k = length(look_at - basis.origin) / length(basis.direction);
    basis.right *= k;
    basis.up *= k;
}

CameraBasis povray_basis(const Camera& camera, const Sources& sources, const MessageSink& warn) {
    CameraBasis basis{camera.projection, camera.location, camera.direction, camera.right, camera.up};
    if (is_flat(camera.projection))
        apply_angle(camera, sources, basis);
    else
        apply_wide_angle(camera, basis);
    if (camera.look_at) {
        if (*camera.look_at == camera.location) fail(camera, sources, "Camera location and look_at point must be different.");
        apply_look_at(camera, *camera.look_at, sources, warn, basis);
    }
    if (basis.projection == Projection::orthographic) size_orthographic(camera, camera.look_at.value_or(Vec3(0.0, 0.0, 1.0)), basis);
    warn_if_skewed(camera, sources, warn, basis);
    basis.origin = camera.transform.point(basis.origin);
    basis.direction = camera.transform.direction(basis.direction);
    basis.right = camera.transform.direction(basis.right);
    basis.up = camera.transform.direction(basis.up);
    return basis;
}

/// The course's rule: right and up as they are written, a view of length 1 towards look_at.
CameraBasis course_basis(const Camera& camera, const Sources& sources) {
    const Vec3 look_at = camera.look_at.value_or(camera.location + camera.direction);
    if (look_at == camera.location) fail(camera, sources, "Camera location and look_at point must be different.");
    return {Projection::perspective, camera.location, unit(look_at - camera.location), camera.right, camera.up};
}

}  // namespace

CameraBasis camera_basis(const Camera& camera, Profile profile, const Sources& sources, const MessageSink& warn) {
    return profile == Profile::csc473 ? course_basis(camera, sources) : povray_basis(camera, sources, warn);
}

}  // namespace rt
