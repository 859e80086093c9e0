#include "geometry/blob.h"

#include <algorithm>

#include "geometry/bernstein.h"
#include "geometry/roots.h"

namespace rt {

namespace {

/// Stretch of a line on which the field of a component is strength * (a s^2 + 2 b s + c)^2.
struct FieldStretch {
    double from, to;
    double a, b, c;
    double strength;
};

struct OwnLine {
    Vec3 o, d;
};

OwnLine own_line(const BlobComponent& component, const Vec3& o, const Vec3& d) {
    if (!component.moved) return {o, d};
    return {component.to_own * o + component.own_offset, component.to_own * d};
}

/// The stretch on which the line is nearer than the radius, to a point or, with `axis`, to the infinite line through it; cut to from..to.
void add_stretch(const BlobComponent& component, const OwnLine& line, const Vec3& point, const Vec3& axis, double from, double to,
                 std::vector<FieldStretch>& out) {
    const Vec3 f = line.o - point;
    const Vec3 across_f = f - dot(f, axis) * axis, across_d = line.d - dot(line.d, axis) * axis;
    const double r2 = sqr(component.radius);
    const double a = dot(across_d, across_d), b = dot(across_f, across_d);
    // The part of f across the line, whose square does not cancel.
    const Vec3 nearest = a > 0.0 ? across_f - (b / a) * across_d : across_f;
    const double left = r2 - dot(nearest, nearest);
    if (!(left > 0.0)) return;
    if (a > 0.0) {
        const double half = std::sqrt(left / a);
        from = std::fmax(from, -b / a - half);
        to = std::fmin(to, -b / a + half);
    }
    if (from < to) out.push_back({from, to, -a / r2, -b / r2, (r2 - dot(across_f, across_f)) / r2, component.strength});
}

void add_stretches(const BlobComponent& component, const Vec3& o, const Vec3& d, std::vector<FieldStretch>& out) {
    const OwnLine line = own_line(component, o, d);
    const Vec3 axis = component.cap - component.base;
    const double axis2 = dot(axis, axis);
    if (axis2 == 0.0) {
        add_stretch(component, line, component.base, Vec3(0.0), -infinity, infinity, out);
        return;
    }
    // Before the base's end plane, between both, beyond the cap's.
    const double height = dot(line.o - component.base, axis) / axis2, climb = dot(line.d, axis) / axis2;
    const Vec3 along = axis / std::sqrt(axis2);
    if (climb == 0.0) {
        if (height < 0.0)
            add_stretch(component, line, component.base, Vec3(0.0), -infinity, infinity, out);
        else if (height > 1.0)
            add_stretch(component, line, component.cap, Vec3(0.0), -infinity, infinity, out);
        else
            add_stretch(component, line, component.base, along, -infinity, infinity, out);
        return;
    }
    const double at_base = -height / climb, at_cap = (1.0 - height) / climb;
    const bool upward = climb > 0.0;
    add_stretch(component, line, component.base, Vec3(0.0), upward ? -infinity : at_base, upward ? at_base : infinity, out);
    add_stretch(component, line, component.base, along, upward ? at_base : at_cap, upward ? at_cap : at_base, out);
    add_stretch(component, line, component.cap, Vec3(0.0), upward ? at_cap : -infinity, upward ? infinity : at_cap, out);
}

/// The field minus the threshold on from..to as a polynomial of degree 4 in [0, 1].
std::array<double, 5> sum_on(const std::vector<FieldStretch>& stretches, double from, double to, double threshold) {
    std::array<double, 5> sum;
    sum.fill(-threshold);
    for (const FieldStretch& s : stretches) {
        if (!(s.from < to && s.to > from)) continue;
        const std::array<double, 3> q{s.c + (2.0 * s.b + s.a * from) * from, s.c + s.b * (from + to) + s.a * from * to,
                                      s.c + (2.0 * s.b + s.a * to) * to};
        const std::array<double, 5> squared = product(q, q);
        for (std::size_t i = 0; i < 5; ++i) sum[i] += s.strength * squared[i];
    }
    return sum;
}

struct Near {
    double closeness;  ///< 1 - (rho / radius)^2, at most 0 out of reach
    Vec3 away;         ///< from the segment, in the component's space
};

Near near(const BlobComponent& component, const Vec3& point) {
    const Vec3 p = component.moved ? component.to_own * point + component.own_offset : point;
    const Vec3 axis = component.cap - component.base;
    const double axis2 = dot(axis, axis);
    const double height = axis2 > 0.0 ? std::fmin(std::fmax(dot(p - component.base, axis) / axis2, 0.0), 1.0) : 0.0;
    const Vec3 away = p - component.base - height * axis;
    return {1.0 - dot(away, away) / sqr(component.radius), away};
}

}  // namespace

bool BlobComponent::operator==(const BlobComponent& other) const {
    return base == other.base && cap == other.cap && radius == other.radius && strength == other.strength && to_own == other.to_own &&
           own_offset == other.own_offset && texture == other.texture;
}

void find_hits(const Blob& shape, const Ray& ray, HitSink& sink) {
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const Bounds box = bounds(shape);
    const double shift = -dot(ray.origin - 0.5 * (box.min + box.max), d);
    const Vec3 o = ray.origin + shift * d;
    std::vector<FieldStretch> stretches;
    for (const BlobComponent& component : shape.data->components) add_stretches(component, o, d, stretches);
    std::vector<double> borders;
    for (const FieldStretch& s : stretches) {
        borders.push_back(s.from);
        borders.push_back(s.to);
    }
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    const double threshold = shape.data->threshold;
    const auto offer = [&](double s) { sink.offer({.t = (s + shift) / speed}); };
    int sign = sign_of(-threshold);
    for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
        const double from = borders[i], to = borders[i + 1];
        if ((from + shift) / speed >= sink.before()) return;
        const std::array<double, 5> sum = sum_on(stretches, from, to, threshold);
        SignChanges changes(sum, SignChanges::Basis::bernstein, sign);
        for (double u = -1.0; changes.next(u, u);) offer((1.0 - u) * from + u * to);
        sign = changes.sign();
    }
    if (!borders.empty() && sign * sign_of(-threshold) < 0) offer(borders.back());
}

Vec3 normal(const Blob& shape, const Vec3& point, const ShapeHit&) {
    Vec3 sum(0.0);
    for (const BlobComponent& component : shape.data->components) {
        const Near at = near(component, point);
        if (!(at.closeness > 0.0)) continue;
        const Vec3 slope = (component.strength * at.closeness / sqr(component.radius)) * at.away;
        sum += component.moved ? glm::transpose(component.to_own) * slope : slope;
    }
    return sum;
}

bool contains(const Blob& shape, const Vec3& point) {
    double sum = 0.0;
    for (const BlobComponent& component : shape.data->components) {
        const Near at = near(component, point);
        if (at.closeness > 0.0) sum += component.strength * sqr(at.closeness);
    }
    return sum > shape.data->threshold;
}

Bounds bounds(const Blob& shape) {
    Bounds box;
    for (const BlobComponent& component : shape.data->components) box.extend(component.box);
    return box;
}

void texture_weights(const Blob& shape, const Vec3& point, double least, std::vector<TextureWeight>& out) {
    const std::size_t first = out.size();
    double sum = 0.0;
    for (const BlobComponent& component : shape.data->components) {
        const Near at = near(component, point);
        if (!(at.closeness > 0.0)) continue;
        out.push_back({component.texture, std::fabs(component.strength) * sqr(at.closeness)});
        sum += out.back().weight;
    }
    const auto fields = out.begin() + static_cast<std::ptrdiff_t>(first);
    out.erase(std::remove_if(fields, out.end(), [&](const TextureWeight& field) { return field.weight / sum < least; }), out.end());
    join_textures(out, first);
    // Divided last: a texture that is alone there has all of the light.
    for (std::size_t i = first; i < out.size(); ++i) out[i].weight /= sum;
}

}  // namespace rt
