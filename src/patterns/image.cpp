#include "patterns/image.h"

#include <algorithm>

#include "patterns/warp.h"

namespace rt {

namespace {

constexpr double edge_offset = 1e-10;  ///< decides for points on the edge of a texel

/// x modulo n in [0, n).
double modulo(double x, double n) {
    const double rest = x - n * std::floor(x / n);
    return rest >= 0.0 && rest < n ? rest : 0.0;
}

/// The place in pictures, before offset: once around or once up is 1.
std::optional<Vec2> unrolled(const ImageMapping& mapping, const Vec3& p) {
    const double r = length(p);
    switch (mapping.type) {
        case 1:
            return Vec2(turn_about_y(p), r == 0.0 ? 0.5 : 0.5 + std::asin(std::clamp(p.y / r, -1.0, 1.0)) / pi);
        case 2:
            if (mapping.once && !(p.y >= 0.0 && p.y <= 1.0)) return std::nullopt;
            return Vec2(turn_about_y(p), p.y);
        case 5: {
            const double out = std::sqrt(p.x * p.x + p.z * p.z) - 1.0, w = std::sqrt(out * out + p.y * p.y);
            const double turn = w == 0.0 ? 0.0 : std::acos(std::clamp(-out / w, -1.0, 1.0)) / (2.0 * pi);
            return Vec2(turn_about_y(p), p.y > 0.0 ? 1.0 - turn : turn);
        }
        default:
            break;
    }
    if (mapping.once && !(p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0)) return std::nullopt;
    return Vec2(p.x, p.y);
}

int texel(int i, int size, bool once) { return once ? std::clamp(i, 0, size - 1) : (i % size + size) % size; }

/// The weights of the texels i-2..i+1 at fraction `p`.
std::array<double, 4> cubic_weights(double p) {
    const double q = 1.0 - p;
    return {-p * q * q / 2.0, q * (q * (3.0 * p + 1.0) + 1.0) / 2.0, p * (p * (4.0 - 3.0 * p) + 1.0) / 2.0, -q * p * p / 2.0};
}

/// Of the four texels around (p, q), the two of the upper row first.
std::array<double, 4> bilinear_weights(double p, double q) { return {(1.0 - p) * (1.0 - q), p * (1.0 - q), (1.0 - p) * q, p * q}; }

/// The same, as the inverse squares of the distances.
std::array<double, 4> distance_weights(double p, double q) {
    const double left = p * p, right = (1.0 - p) * (1.0 - p), up = q * q, down = (1.0 - q) * (1.0 - q);
    const std::array<double, 4> squared{left + up, right + up, left + down, right + down};
    std::array<double, 4> weight{};
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        weight[i] = 1.0 / std::fmax(squared[i], 1e-30);  // on a texel's middle: that texel alone
        sum += weight[i];
    }
    for (double& w : weight) w /= sum;
    return weight;
}

}  // namespace

std::optional<Vec2> image_place(const ImageMapping& mapping, int width, int height, const Vec3& p) {
    const std::optional<Vec2> at = unrolled(mapping, p);
    if (!at) return std::nullopt;
    const double u = (at->x * mapping.repeat.x - mapping.offset.x) * width + edge_offset;
    const double v = (at->y * mapping.repeat.y - mapping.offset.y) * height + edge_offset;
    return Vec2(modulo(u, width), modulo(-v, height));
}

ImageTaps image_taps(const ImageMapping& mapping, int width, int height, const Vec2& place) {
    ImageTaps taps;
    const auto add = [&](int x, int y, double weight) {
        taps.tap[static_cast<std::size_t>(taps.count++)] = {texel(x, width, mapping.once), texel(y, height, mapping.once), weight};
    };
    if (mapping.interpolate == 0) {
        add(static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y)), 1.0);
        return taps;
    }
    const double u = place.x + 0.5, v = place.y + 0.5;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    const double p = u - i, q = v - j;
    if (mapping.interpolate == 3) {
        const auto across = cubic_weights(p), down = cubic_weights(q);
        for (int b = 0; b < 4; ++b)
            for (int a = 0; a < 4; ++a) add(i - 2 + a, j - 2 + b, across[static_cast<std::size_t>(a)] * down[static_cast<std::size_t>(b)]);
        return taps;
    }
    const std::array<double, 4> weight = mapping.interpolate == 4 ? distance_weights(p, q) : bilinear_weights(p, q);
    add(i - 1, j - 1, weight[0]);
    add(i, j - 1, weight[1]);
    add(i - 1, j, weight[2]);
    add(i, j, weight[3]);
    return taps;
}

}  // namespace rt
