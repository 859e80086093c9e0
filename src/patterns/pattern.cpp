#include "patterns/pattern.h"

#include "patterns/cell_patterns.h"
#include "patterns/density.h"
#include "patterns/fractal_patterns.h"
#include "patterns/noise_patterns.h"
#include "patterns/plain_patterns.h"

namespace rt {

namespace {

using K = PatternKind;

template <typename Numbers>
const Numbers& numbers(const Pattern& pattern) {
    return std::get<Numbers>(pattern.numbers);
}

double image_value(const ImageNumbers& image, const Vec3& q) {
    const ValueGrid& grid = *image.grid;
    if (grid.values.empty()) return 0.0;
    const std::optional<Vec2> place = image_place(image.mapping, grid.width, grid.height, q);
    return place ? image_height(image, *place) : 0.0;
}

/// The point of a spiral: turbulence, which has moved it already, shifts it along the axis as well.
Vec3 spiral_point(const Pattern& pattern, const Vec3& q) {
    if (!pattern.turbulence || pattern.turbulence->amount.x == 0.0) return q;
    return q + Vec3(0.0, 0.0, pattern.turbulence->amount.x * scalar_turbulence(pattern.noise, *pattern.turbulence, q));
}

/// The kinds that are made of noise, and cells.
double noise_value(const Pattern& pattern, const Vec3& q) {
    switch (pattern.kind) {
        case K::agate:
            return agate(pattern, q);
        case K::bozo:
        case K::bumps:
        case K::spotted:
            return noise(pattern.noise, q);
        case K::cells:
            return cells(q);
        case K::crackle:
            return crackle(numbers<CrackleNumbers>(pattern), pattern.noise, q);
        case K::dents:
            return dents(pattern.noise, q);
        case K::granite:
            return granite(pattern.noise, q);
        case K::marble:
            return marble(pattern, q);
        case K::ripples:
            return ripples(pattern, q);
        case K::waves:
            return waves(pattern, q);
        case K::wood:
            return wood(pattern, q);
        case K::wrinkles:
            return wrinkles(pattern.noise, q);
        default:
            return raw_cell(pattern, q);
    }
}

}  // namespace

double image_height(const ImageNumbers& image, const Vec2& place) {
    const ValueGrid& grid = *image.grid;
    double sum = 0.0;
    for (const auto& tap : image_taps(image.mapping, grid.width, grid.height, place))
        sum += tap.weight *
               static_cast<double>(
                   grid.values[static_cast<std::size_t>(tap.y) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(tap.x)]);
    return std::fmax(0.0, sum);  // cubics undershoot
}

void append(Pattern& pattern, const Transform& transform) {
    auto* last = pattern.warps.empty() ? nullptr : std::get_if<Transform>(&pattern.warps.back());
    if (last != nullptr)
        *last = last->then(transform);
    else
        pattern.warps.emplace_back(transform);
}

Vec3 pattern_point(const Pattern& pattern, const Vec3& p) {
    Vec3 q = p;
    for (std::size_t i = pattern.warps.size(); i-- > 0;) q = warped(pattern.warps[i], q);
    if (!pattern.turbulence || pattern.turbulence->amount == Vec3(0.0)) return q;
    if (pattern.kind == K::marble || pattern.kind == K::wood) return q;
    return warped(*pattern.turbulence, q);
}

double raw_value(const Pattern& pattern, const Vec3& q, const PatternSurface& surface) {
    switch (pattern.kind) {
        case K::aoi:
            return angle_of_incidence(surface);
        case K::boxed:
            return boxed(q);
        case K::cylindrical:
            return cylindrical(q);
        case K::density_file:
            return density(numbers<DensityNumbers>(pattern), q);
        case K::gradient:
            return gradient(numbers<GradientNumbers>(pattern), q);
        case K::image_pattern:
            return image_value(numbers<ImageNumbers>(pattern), q);
        case K::julia:
            return julia(numbers<FractalNumbers>(pattern), q);
        case K::leopard:
            return leopard(q);
        case K::magnet:
            return magnet(numbers<FractalNumbers>(pattern), q);
        case K::mandel:
            return mandel(numbers<FractalNumbers>(pattern), q);
        case K::onion:
            return onion(q);
        case K::planar:
            return planar(q);
        case K::quilted:
            return quilted(numbers<QuiltedNumbers>(pattern), q);
        case K::radial:
            return radial(q);
        case K::slope:
            return slope(numbers<SlopeNumbers>(pattern), q, surface);
        case K::spherical:
            return spherical(q);
        case K::spiral1:
            return spiral1(numbers<SpiralNumbers>(pattern), spiral_point(pattern, q));
        case K::spiral2:
            return spiral2(numbers<SpiralNumbers>(pattern), spiral_point(pattern, q));
        default:
            return noise_value(pattern, q);
    }
}

double wave_value(const Pattern& pattern, double raw) {
    double v = raw;
    if (pattern.frequency != 0.0) v = std::fmod(v * pattern.frequency + pattern.phase, 1.00001);
    if (v < 0.0) v -= std::floor(v);
    switch (pattern.wave) {
        case WaveType::ramp:
            return v;
        case WaveType::triangle:
            return triangle_wave(v);
        case WaveType::sine:
            return 0.5 * (1.0 + cycle(v));
        case WaveType::scallop:
            return std::fabs(cycle(0.5 * v));
        case WaveType::cubic:
            return v * v * (3.0 - 2.0 * v);
        case WaveType::poly:
            break;
    }
    return std::pow(v, pattern.wave_exponent);
}

double pattern_value(const Pattern& pattern, const Vec3& p, const PatternSurface& surface) {
    return wave_value(pattern, raw_value(pattern, pattern_point(pattern, p), surface));
}

int raw_cell(const Pattern& pattern, const Vec3& q) {
    switch (pattern.kind) {
        case K::brick:
            return brick(numbers<BrickNumbers>(pattern), q);
        case K::checker:
            return checker(q);
        case K::cubic:
            return cubic(q);
        case K::hexagon:
            return hexagon(q);
        case K::square:
            return square(q);
        case K::triangular:
            return triangular(q);
        default:
            return 0;
    }
}

int pattern_cell(const Pattern& pattern, const Vec3& p) { return raw_cell(pattern, pattern_point(pattern, p)); }

}  // namespace rt
