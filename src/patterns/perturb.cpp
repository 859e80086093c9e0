#include "patterns/perturb.h"

#include "patterns/noise_patterns.h"
#include "patterns/plain_patterns.h"

namespace rt {

namespace {

using K = PatternKind;

/// The corners of a tetrahedron around the origin.
const std::array<Vec3, 4> corners{{{0.942809041, -0.333333333, 0.0},
                                   {-0.471404521, -0.333333333, 0.816496581},
                                   {-0.471404521, -0.333333333, -0.816496581},
                                   {0.0, 1.0, 0.0}}};

Vec3 wrinkled(const Vec3& q) {
    Vec3 sum(0.0);
    double scale = 1.0;
    for (int i = 0; i < 10; ++i, scale *= 2.0) sum += glm::abs(vector_noise(scale * q)) / scale;
    return sum;
}

/// ripples (`by_frequency` false) and waves: circles around every source.
Vec3 waved(const Pattern& pattern, const Vec3& q, bool by_frequency) {
    const std::vector<WaveSource>& sources = *std::get<WavesNumbers>(pattern.numbers).sources;
    Vec3 sum(0.0);
    for (const WaveSource& source : sources) {
        const Vec3 d = q - source.center;
        const double distance = length(d);
        const double l = distance == 0.0 ? 1.0 : distance;
        const double f = by_frequency ? source.frequency : 1.0;
        sum += cycle(l * pattern.frequency * f + pattern.phase) / f * d / l;
    }
    return sum / static_cast<double>(sources.size());
}

Vec3 faceted(const FacetsNumbers& numbers, const Vec3& n0, const Vec3& q) {
    if (numbers.size == 0.0F) return n0;
    if (numbers.coords == 0.0) return nearest_features(n0 / static_cast<double>(numbers.size), numbers.metric).nearest;
    const Vec3 e = vector_noise(nearest_features(q / static_cast<double>(numbers.size), numbers.metric).nearest);
    return n0 + static_cast<double>(numbers.coords) * (e - dot(e, n0) * n0);
}

Vec3 quilted_tilt(const QuiltedNumbers& numbers, const Vec3& q) {
    const Vec3 u = q - glm::floor(q) - 0.5;
    return quilt_profile(numbers, length(u)) * 1.154700538 * u;
}

/// The picture as a landscape over the plane whose normal is `n0`; its slope is taken over one texel.
Vec3 bumped(const ImageNumbers& image, double amount, const Vec3& n0, const Vec3& q) {
    const ValueGrid& grid = *image.grid;
    if (grid.values.empty()) return n0;
    const std::optional<Vec2> place = image_place(image.mapping, grid.width, grid.height, q);
    if (!place) return n0;
    const double h1 = image_height(image, *place);
    const double h2 = image_height(image, *place + Vec2(-1.0, 1.0)), h3 = image_height(image, *place + Vec2(1.0, 1.0));
    const Vec3 b = unit(cross(Vec3(2.0, amount * (h3 - h2), 0.0), Vec3(1.0, amount * (h1 - h2), -1.0)));
    Vec3 up = n0, x = cross(n0, Vec3(0.0, 1.0, 0.0));
    if (length(x) < 1e-10) {
        x = Vec3(1.0, 0.0, 0.0);
        up = Vec3(0.0, n0.y < 0.0 ? -1.0 : 1.0, 0.0);
    }
    x = unit(x);
    return b.x * x + b.y * up - b.z * unit(cross(x, up));
}

}  // namespace

bool has_own_normal(PatternKind kind) {
    switch (kind) {
        case K::bump_map:
        case K::bumps:
        case K::dents:
        case K::facets:
        case K::quilted:
        case K::ripples:
        case K::waves:
        case K::wrinkles:
            return true;
        default:
            return false;
    }
}

double slope_height(const std::vector<SlopeEntry>& slopes, double value) {
    if (slopes.empty()) return value;
    if (value >= slopes.back().value) return slopes.back().height;
    if (!(value > slopes.front().value)) return slopes.front().height;
    std::size_t upper = 1;
    while (value > slopes[upper].value) ++upper;
    const auto [v1, h1, s1] = slopes[upper - 1];
    const auto [v2, h2, s2] = slopes[upper];
    const double t = (value - v1) / (v2 - v1);
    return t * t * t * (s1 + s2 + 2.0 * (h1 - h2)) - t * t * (2.0 * s1 + s2 + 3.0 * (h1 - h2)) + t * s1 + h1;
}

std::array<Vec3, 4> difference_points(const Bump& bump, const Vec3& q) {
    const double d = bump.accuracy;
    return {q + d * corners[0], q + d * corners[1], q + d * corners[2], q + d * corners[3]};
}

Vec3 perturbed_by(const Bump& bump, const Vec3& n0, const std::array<double, 4>& values) {
    Vec3 slope(0.0);
    for (std::size_t i = 0; i < 4; ++i) slope += slope_height(bump.slopes, values[i]) * corners[i];
    return n0 - 5.0 * bump.amount * (0.02 / bump.accuracy) * slope;
}

Vec3 perturbed(const Pattern& pattern, const Bump& bump, const Vec3& n0, const Vec3& q, const PatternSurface& surface) {
    const double amount = bump.amount;
    switch (pattern.kind) {
        case K::bump_map:
            return bumped(std::get<ImageNumbers>(pattern.numbers), amount, n0, q);
        case K::bumps:
            return n0 + amount * vector_noise(q);
        case K::dents:
            return n0 + amount * dents(pattern.noise, q) * vector_noise(q);
        case K::facets:
            return faceted(std::get<FacetsNumbers>(pattern.numbers), n0, q);
        case K::quilted:
            return n0 + amount * quilted_tilt(std::get<QuiltedNumbers>(pattern.numbers), q);
        case K::ripples:
            return n0 + amount * waved(pattern, q, false);
        case K::waves:
            return n0 + amount * waved(pattern, q, true);
        case K::wrinkles:
            return n0 + amount * wrinkled(q);
        default:
            break;
    }
    const std::array<Vec3, 4> points = difference_points(bump, q);
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) values[i] = wave_value(pattern, raw_value(pattern, points[i], surface));
    return perturbed_by(bump, n0, values);
}

Vec3 into_pattern(const Pattern& pattern, const Bump& bump, const Vec3& normal) {
    Vec3 n = normal;
    for (std::size_t i = pattern.warps.size(); i-- > 0;)
        if (const auto* transform = std::get_if<Transform>(&pattern.warps[i])) {
            n = n * transform->linear;  // as normals go with the inverse transpose
            if (bump.scale) n = unit(n);
        }
    return n;
}

Vec3 out_of_pattern(const Pattern& pattern, const Bump& bump, const Vec3& normal) {
    Vec3 n = bump.scale ? unit(normal) : normal;
    for (const Warp& warp : pattern.warps)
        if (const auto* transform = std::get_if<Transform>(&warp)) {
            n = transform->normal(n);
            if (bump.scale) n = unit(n);
        }
    return unit(n);
}

}  // namespace rt
