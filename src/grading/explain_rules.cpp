#include "grading/explain_rules.h"

#include <algorithm>
#include <cstdlib>

namespace rt::rules {

namespace {

const Rgb dark(0.0);

/// The factor k of b = k a, if there is one; empty also for vectors that are almost zero.
std::optional<double> ratio(const Vec3& a, const Vec3& b, double tolerance) {
    const double aa = dot(a, a);
    if (!(aa > sqr(tolerance))) return std::nullopt;
    const double k = dot(a, b) / aa;
    if (!same(k * a, b, 2.0 * tolerance * std::max(1.0, std::fabs(k)))) return std::nullopt;
    return k;
}

bool is_grey(const Rgb& c, double tolerance) { return same(c.r, c.g, tolerance) && same(c.g, c.b, tolerance); }

Rgb part_or_dark(const ToldRay& ray, LightPart part) { return ray.part(part).value_or(dark); }

/// Vectors of different length that point the same way.
bool is_scaled(const Vec3& a, const Vec3& b, double tolerance) {
    if (length(a) == 0.0 || length(b) == 0.0) return false;
    return same(unit(a), unit(b), tolerance) && !same(length(a), length(b), tolerance);
}

/// One coordinate has the other sign, the other two agree.
bool is_flipped(const Vec3& a, const Vec3& b, int axis, double tolerance) {
    Vec3 flipped = a;
    flipped[axis] = -flipped[axis];
    return same(flipped, b, tolerance);
}

/// Sine of the refracted over sine of the incident angle; empty at normal incidence, or outside the plane of incidence.
std::optional<double> bending(const Vec3& incident, const Vec3& normal, const Vec3& direction, double tolerance) {
    const Vec3 across = cross(unit(normal), unit(incident));
    const double sine = length(across);
    if (!(sine > 100.0 * tolerance)) return std::nullopt;
    if (std::fabs(dot(across, unit(direction))) > 10.0 * tolerance) return std::nullopt;
    return dot(cross(unit(normal), unit(direction)), across) / (sine * sine);
}

/// How much longer than in the world distances are in the space of the object that is met.
double stretch(const ToldHit& hit) { return hit.object_ray ? length(hit.object_ray->direction) : 1.0; }

/// Whether distances of the objects' own spaces explain what B meets: the same object just there, or another one that only they bring to
/// the front.
bool in_object_space(const ToldHit& a, const ToldHit& b, double tolerance) {
    const double of_a = stretch(a), of_b = stretch(b);
    if (same(of_a, 1.0, tolerance) && same(of_b, 1.0, tolerance)) return false;
    if (a.object == b.object) return same(a.t * of_a, b.t, tolerance);
    return a.t * of_a > b.t && b.t / of_b > a.t;
}

bool tells_lamps(const ToldRay& ray) { return ray.hit && ray.hit->shadows.has_value(); }

/// Both tell of their lamps, which had been compared before, and no light of them was coloured on its way where one tells only whether it
/// arrives.
bool shadows_agree(const ToldRay& a, const ToldRay& b) {
    if (!tells_lamps(a) || !tells_lamps(b)) return false;
    const auto told = [](const ToldShadow& s, const ToldShadow& other) {
        return s.exact || other.transmitted == dark || other.transmitted == Rgb(1.0);
    };
    const std::vector<ToldShadow>&of_a = *a.hit->shadows, &of_b = *b.hit->shadows;
    for (std::size_t k = 0; k < std::min(of_a.size(), of_b.size()); ++k)
        if (!told(of_a[k], of_b[k]) || !told(of_b[k], of_a[k])) return false;
    return true;
}

/// Diffuse light where B does not tell which lamps arrive. What A tells of its own bounds what B can have: no shadow is missing where A has
/// none, and no lamp where one alone arrives.
Cause diffuse_of_unknown_shadows(const ToldRay& a, const ToldRay& b, bool proportional, double tolerance) {
    const Rgb light_a = part_or_dark(a, LightPart::diffuse), light_b = part_or_dark(b, LightPart::diffuse);
    const Rgb gloss_a = part_or_dark(a, LightPart::specular), gloss_b = part_or_dark(b, LightPart::specular);
    bool may_be_hidden = true, may_be_several = true;
    if (tells_lamps(a)) {
        const std::vector<ToldShadow>& lamps = *a.hit->shadows;
        may_be_hidden = std::any_of(lamps.begin(), lamps.end(), [](const ToldShadow& s) { return s.transmitted != Rgb(1.0); });
        may_be_several = std::count_if(lamps.begin(), lamps.end(), [](const ToldShadow& s) { return s.transmitted != dark; }) > 1;
    }
    const bool gloss_agrees = same(gloss_a, gloss_b, tolerance);
    if (light_a == dark) return may_be_hidden ? Cause::missing_shadow : Cause::wrong_diffuse;
    if (light_b == dark) return gloss_agrees && gloss_a != dark ? Cause::wrong_diffuse : Cause::false_shadow;
    // Where the ambient light agrees, so does the pigment.
    if (!gloss_agrees || (!proportional && part_or_dark(a, LightPart::ambient) != dark)) {
        if (max_component(light_b) > max_component(light_a)) return may_be_hidden ? Cause::missing_shadow : Cause::wrong_diffuse;
        return may_be_several ? Cause::missing_light : Cause::wrong_diffuse;
    }
    return proportional ? Cause::wrong_diffuse : Cause::wrong_pigment;
}

}  // namespace

bool same(double a, double b, double tolerance) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return true;
    // Two numbers rounded to the tolerance may differ by one step of it, and by the rounding of that difference.
    constexpr double slack = 1.0 + 1e-6;
    return std::isfinite(a) && std::isfinite(b) && std::fabs(a - b) <= slack * tolerance * std::max({1.0, std::fabs(a), std::fabs(b)});
}

bool same(const Vec3& a, const Vec3& b, double tolerance) {
    return same(a.x, b.x, tolerance) && same(a.y, b.y, tolerance) && same(a.z, b.z, tolerance);
}

Cause camera_direction(const Vec3& a, const Vec3& b, const ToldCamera* camera, double grid, double tolerance) {
    if (is_scaled(a, b, tolerance)) return Cause::missing_normalisation;
    if (camera == nullptr) {
        if (is_flipped(a, b, 1, tolerance)) return Cause::upside_down;
        return is_flipped(a, b, 0, tolerance) || is_flipped(a, b, 2, tolerance) ? Cause::mirrored : Cause::camera;
    }
    const Mat3 frame(camera->right, camera->up, camera->direction);
    if (glm::determinant(frame) == 0.0) return Cause::camera;
    const Mat3 inverse = glm::inverse(frame);
    const auto place = [&](const Vec3& d) {
        const Vec3 c = inverse * d;
        return Vec2(c.x, c.y) / c.z;
    };
    const Vec2 at = place(a), other = place(b);
    const double near = 10.0 * tolerance;
    if (same(-at.x, other.x, near) && same(at.y, other.y, near)) return Cause::mirrored;
    if (same(at.x, other.x, near) && same(-at.y, other.y, near)) return Cause::upside_down;
    const Vec2 pixels((other.x - at.x) * camera->width, (other.y - at.y) * camera->height);
    // Of the pixel, or of the part of it that is the ray's own.
    const auto is_half = [&](double p) { return std::fabs(std::fabs(p) - 0.5) < 0.03 || std::fabs(std::fabs(p) * grid - 0.5) < 0.03; };
    const auto is_none = [](double p) { return std::fabs(p) < 0.03; };
    const bool halves = (is_half(pixels.x) || is_none(pixels.x)) && (is_half(pixels.y) || is_none(pixels.y));
    return halves && !(is_none(pixels.x) && is_none(pixels.y)) ? Cause::half_pixel : Cause::camera;
}

Cause origin(const Vec3& a, const Vec3& b, const Vec3& point) {
    constexpr double far = 0.1;  // of the distance to the origin: more is no offset
    return length(a - b) <= far * std::max(1.0, length(point)) ? Cause::offset : Cause::other;
}

Cause direction(ToldRay::Kind kind, const Vec3& a, const Vec3& b, const Vec3& incident, const Vec3& normal, double tolerance) {
    if (is_scaled(a, b, tolerance)) return Cause::missing_normalisation;
    if (kind == ToldRay::Kind::reflection) return Cause::wrong_mirror_direction;
    const std::optional<double> bent_a = bending(incident, normal, a, tolerance), bent_b = bending(incident, normal, b, tolerance);
    return bent_a && bent_b ? Cause::wrong_refraction_ratio : Cause::other;
}

Cause hit(const ToldRay& a, const ToldRay& b, const ToldRay* parent, double tolerance) {
    constexpr double touching = 0.01;  // so near to where it began that the ray meets the surface that it comes from
    if (a.end == ToldRay::End::level || b.end == ToldRay::End::level || a.end == ToldRay::End::weight || b.end == ToldRay::End::weight)
        return Cause::depth;
    if (!b.hit) return Cause::missed_object;
    const bool own = parent != nullptr && parent->hit && parent->hit->object == b.hit->object;
    if (own && b.hit->t < touching) return Cause::offset;
    if (!a.hit) return Cause::wrong_object;
    if (in_object_space(*a.hit, *b.hit, tolerance)) return Cause::object_space_distance;
    if (a.hit->object != b.hit->object) return Cause::wrong_object;
    if (same(a.hit->point, b.hit->point, tolerance)) return Cause::object_space_distance;
    return b.hit->t > a.hit->t && a.hit->normal && b.hit->normal &&
                   dot(*a.hit->normal, a.ray.direction) * dot(*b.hit->normal, b.ray.direction) < 0.0
               ? Cause::far_hit
               : Cause::placement;
}

Cause normal(const Vec3& a, const Vec3& b, double tolerance) {
    if (is_scaled(a, b, tolerance)) return Cause::missing_normalisation;
    if (length(a) > 0.0 && length(b) > 0.0 && same(-unit(a), unit(b), tolerance)) return Cause::wrong_normal_side;
    return Cause::wrong_normal;
}

Cause shares(const ToldRay::Shares& a, const ToldRay::Shares& b, double tolerance) {
    const bool same_local = same(a.local, b.local, tolerance);
    if (same_local && same(a.transmission + a.reflection, b.transmission + b.reflection, tolerance)) {
        // Nothing else moves light between the mirror and what passes.
        const bool total = (a.transmission == 0.0) != (b.transmission == 0.0);
        return total ? Cause::total_reflection : Cause::missing_fresnel;
    }
    if (a.transmission > 0.0 && b.transmission == 0.0) return Cause::missing_filter;
    if (a.reflection > 0.0 && b.reflection == 0.0) return Cause::missing_reflection;
    return Cause::wrong_share;
}

bool inverse_ratio_is_total(const ToldRay& incident, const ToldRay& passing, double tolerance) {
    if (!incident.hit || !incident.hit->normal) return true;
    const std::optional<double> bent = bending(incident.ray.direction, *incident.hit->normal, passing.ray.direction, tolerance);
    if (!bent) return true;
    const double sine = length(cross(unit(*incident.hit->normal), unit(incident.ray.direction)));
    return sine > std::fabs(*bent);
}

Cause layers(const ToldLayer& a, const ToldLayer& b, double tolerance) {
    const bool through = same(a.filter, b.filter, tolerance) && same(a.transmit, b.transmit, tolerance);
    return through ? Cause::wrong_pigment : Cause::missing_filter;
}

Cause shadow(const ToldShadow& a, const ToldShadow& b) {
    if (a.transmitted == dark || b.transmitted == Rgb(1.0)) return Cause::missing_shadow;
    return b.transmitted != dark || a.through ? Cause::missing_filter : Cause::false_shadow;
}

bool hides_all(const std::vector<ToldShadow>& a, const std::vector<ToldShadow>& b) {
    std::optional<std::uint32_t> first;
    bool several = false;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (a[k].transmitted == dark) continue;
        if (b[k].transmitted != dark) return false;
        several |= first && *first != a[k].light;
        first = a[k].light;
    }
    return several;
}

Cause local_light(LightPart part, const ToldRay& a, const ToldRay& b, bool rounded, double tolerance) {
    const Rgb all_a = part_or_dark(a, LightPart::ambient) + part_or_dark(a, LightPart::diffuse) + part_or_dark(a, LightPart::specular);
    const Rgb all_b = part_or_dark(b, LightPart::ambient) + part_or_dark(b, LightPart::diffuse) + part_or_dark(b, LightPart::specular);
    const Rgb light_a = part_or_dark(a, part), light_b = part_or_dark(b, part);
    const std::optional<double> k = ratio(light_a, light_b, tolerance);
    if (part == LightPart::ambient) {
        const std::optional<double> of_all = ratio(all_a, all_b, tolerance);
        const bool lit = part_or_dark(a, LightPart::diffuse) != dark;
        if (lit && k && of_all && *k != 0.0 && std::fabs(*k - *of_all) < 0.01 * std::fabs(*k)) return Cause::wrong_share;
        const bool same_pigment = a.hit && b.hit && !a.hit->layers.empty() && !b.hit->layers.empty();  // or it had been found before
        return k || light_a == dark || same_pigment ? Cause::missing_ambient : Cause::wrong_pigment;
    }
    if (part == LightPart::specular) {
        constexpr double plain = 0.01;  // less may be the foot of another lobe
        const bool one_has_none = light_a == dark || light_b == dark;
        return one_has_none && (!rounded || max_component(light_a + light_b) > plain) ? Cause::missing_highlight : Cause::wrong_exponent;
    }
    if (shadows_agree(a, b)) return k || light_a == dark || !a.hit->layers.empty() ? Cause::wrong_diffuse : Cause::wrong_pigment;
    return diffuse_of_unknown_shadows(a, b, k.has_value(), tolerance);
}

Cause factor(ToldRay::Kind kind, const Rgb& a, const Rgb& b, double tolerance) {
    const bool colour = is_grey(a, tolerance) != is_grey(b, tolerance);
    if (kind == ToldRay::Kind::refraction)
        return colour || b == dark || !ratio(a, b, tolerance) ? Cause::missing_filter : Cause::wrong_share;
    if (b == dark) return Cause::missing_reflection;
    return colour ? Cause::wrong_pigment : Cause::wrong_share;
}

Cause sum(const ToldRay& a, const ToldRay& b, double tolerance) {
    const Rgb light_a = part_or_dark(a, LightPart::radiance), light_b = part_or_dark(b, LightPart::radiance);
    if (same(glm::clamp(light_a, 0.0, 1.0), light_b, tolerance) || same(glm::clamp(light_b, 0.0, 1.0), light_a, tolerance))
        return Cause::clamp;
    for (std::size_t i = 0; i + 1 < light_parts; ++i) {
        const Rgb part = part_or_dark(a, static_cast<LightPart>(i));
        if (same(light_a - part, light_b, 2.0 * tolerance) || same(light_a + part, light_b, 2.0 * tolerance)) return Cause::missing_part;
    }
    return Cause::other;
}

Cause further_ray(ToldRay::Kind kind, bool a_has, bool beyond_deepest) {
    if (beyond_deepest) return Cause::depth;
    if (kind == ToldRay::Kind::refraction) return Cause::missing_filter;
    return a_has ? Cause::missing_reflection : Cause::wrong_share;
}

Cause color(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    if (largest <= 1) return Cause::rounding;
    // One power maps all channels: that of gamma is about 2.2 or its inverse. Black and white are their own powers.
    bool brighter = true, darker = true;
    for (std::size_t c = 0; c < 3; ++c) {
        const double from = a[c] / 255.0, to = b[c] / 255.0;
        const auto near = [&](double power) { return std::fabs(std::pow(from, power) - to) < 0.03; };
        brighter = brighter && near(1.0 / 2.2);
        darker = darker && near(2.2);
    }
    return brighter || darker ? Cause::gamma : Cause::other;
}

}  // namespace rt::rules
