#include "geometry/outline.h"

#include <algorithm>

#include "geometry/roots.h"

namespace rt {

CurvePiece CurvePiece::line(const Vec2& a, const Vec2& b) { return {{a, a + (b - a) / 3.0, b + (a - b) / 3.0, b}}; }

CurvePiece CurvePiece::quadratic(const Vec2& a, const Vec2& b, const Vec2& c) {
    return {{a, a + 2.0 / 3.0 * (b - a), c + 2.0 / 3.0 * (b - c), c}};
}

Vec2 CurvePiece::at(double u) const {
    std::array<Vec2, 4> mean = points;
    for (std::size_t left = 3; left > 0; --left)
        for (std::size_t j = 0; j < left; ++j) mean[j] += u * (mean[j + 1] - mean[j]);
    return mean[0];
}

Vec2 CurvePiece::tangent(double u) const {
    const Vec2 a = points[1] - points[0], b = points[2] - points[1], c = points[3] - points[2];
    const double v = 1.0 - u;
    const Vec2 derivative = 3.0 * (v * v * a + 2.0 * u * v * b + u * u * c);
    if (derivative != Vec2(0.0)) return derivative;
    // At an end whose neighbouring points coincide with it.
    const Vec2 chord = u < 0.5 ? points[2] - points[0] : points[3] - points[1];
    return chord != Vec2(0.0) ? chord : points[3] - points[0];
}

// A value of exactly zero at an end counts as positive, for both of the pieces that meet there: they share the point, so they agree on it.
Crossings crossings(const CurvePiece& piece, const Vec2& normal, double distance) {
    std::array<double, 4> b;
    for (std::size_t i = 0; i < 4; ++i) b[i] = glm::dot(normal, piece.points[i]) - distance;
    Crossings found;
    const bool above = b[0] >= 0.0 && b[1] >= 0.0 && b[2] >= 0.0 && b[3] >= 0.0;
    const bool below = b[0] < 0.0 && b[1] < 0.0 && b[2] < 0.0 && b[3] < 0.0;
    if (above || below) return found;
    SignChanges changes(b, SignChanges::Basis::bernstein, b[0] == 0.0 ? 1 : 0);
    for (double u = -1.0; found.count + 1 < found.u.size() && changes.next(u, u);) found.u[found.count++] = u;
    if (b[3] == 0.0 && changes.sign() < 0) found.u[found.count++] = 1.0;
    return found;
}

std::vector<CurvePiece> spline_pieces(SplineKind kind, const std::vector<Vec2>& p) {
    std::vector<CurvePiece> pieces;
    switch (kind) {
        case SplineKind::linear:
            for (std::size_t i = 0; i + 1 < p.size(); ++i) pieces.push_back(CurvePiece::line(p[i], p[i + 1]));
            break;
        case SplineKind::quadratic:
            for (std::size_t i = 0; i + 2 < p.size(); ++i)
                pieces.push_back(CurvePiece::quadratic(p[i + 1], p[i + 1] + 0.25 * (p[i + 2] - p[i]), p[i + 2]));
            break;
        case SplineKind::cubic:
            for (std::size_t i = 0; i + 3 < p.size(); ++i)
                pieces.push_back({{p[i + 1], p[i + 1] + (p[i + 2] - p[i]) / 6.0, p[i + 2] - (p[i + 3] - p[i + 1]) / 6.0, p[i + 2]}});
            break;
        case SplineKind::bezier:
            for (std::size_t i = 0; i + 3 < p.size(); i += 4) pieces.push_back({{p[i], p[i + 1], p[i + 2], p[i + 3]}});
            break;
    }
    return pieces;
}

void Outline::add(const CurvePiece& piece) {
    for (const Vec2& p : piece.points) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    pieces.push_back(piece);
}

// By the crossings of a ray from the point in the direction of x.
bool Outline::contains(const Vec2& p) const {
    if (!(p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y)) return false;
    bool inside = false;
    for (const CurvePiece& piece : pieces) {
        const Crossings found = crossings(piece, {0.0, 1.0}, p.y);
        for (std::size_t i = 0; i < found.count; ++i) inside ^= piece.at(found.u[i]).x > p.x;
    }
    return inside;
}

void turn_outwards(Outline& outline) {
    constexpr double aside = 1e-7;
    constexpr std::size_t most_work = 10'000'000;
    const double step = aside * glm::length(outline.max - outline.min);
    std::vector<CurvePiece>& pieces = outline.pieces;
    std::size_t work = 0;
    for (std::size_t first = 0, end = 0; first < pieces.size() && work < most_work; first = end, work += pieces.size()) {
        for (end = first + 1; end < pieces.size() && pieces[end].points[0] == pieces[end - 1].points[3];) ++end;
        const CurvePiece& piece = pieces[first + (end - first) / 2];
        const Vec2 along = piece.tangent(0.5);
        if (along == Vec2(0.0) || !outline.contains(piece.at(0.5) + step * glm::normalize(Vec2(along.y, -along.x)))) continue;
        std::reverse(pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.begin() + static_cast<std::ptrdiff_t>(end));
        for (std::size_t i = first; i < end; ++i) std::reverse(pieces[i].points.begin(), pieces[i].points.end());
    }
}

namespace {

/// Whether the ray's line comes over the box of the outline between the sweep's heights, with some room.
bool passes(const Sweep& sweep, const SweepRay& ray) {
    constexpr double room = 1e-9;
    const Outline& outline = sweep.outline;
    const double far[3] = {ray.origin.x, ray.origin.y, ray.height};
    const double d[3] = {ray.direction.x, ray.direction.y, ray.climb};
    const double low[3] = {outline.min.x, outline.min.y, sweep.low};
    const double high[3] = {outline.max.x, outline.max.y, sweep.high};
    double enter = -infinity, leave = infinity;
    for (int i = 0; i < 3; ++i) {
        const double margin = room * (std::fabs(low[i]) + std::fabs(high[i]) + std::fabs(far[i]));
        if (d[i] == 0.0) {
            if (far[i] < low[i] - margin || far[i] > high[i] + margin) return false;
            continue;
        }
        const double a = (low[i] - margin - far[i]) / d[i], b = (high[i] + margin - far[i]) / d[i];
        enter = std::fmax(enter, std::fmin(a, b));
        leave = std::fmin(leave, std::fmax(a, b));
    }
    return enter <= leave;
}

}  // namespace

void find_hits(const Sweep& sweep, const SweepRay& ray, HitSink& sink) {
    if (!passes(sweep, ray)) return;
    if (!sweep.open && ray.climb != 0.0) {
        for (std::uint32_t end = 0; end < 2; ++end) {
            const double t = ((end == 0 ? sweep.low : sweep.high) - ray.height) / ray.climb;
            if (t > sink.after() && t < sink.before() && sweep.outline.contains(ray.origin + t * ray.direction))
                sink.offer({.t = t, .part = end});
        }
    }
    const Vec2& d = ray.direction;
    const double d2 = glm::dot(d, d);
    if (d2 == 0.0) return;
    // From the point nearest to the middle of the outline on, where numbers are small.
    const Vec2 middle = 0.5 * (sweep.outline.min + sweep.outline.max);
    const double shift = -glm::dot(ray.origin - middle, d) / d2;
    const Vec2 o = ray.origin + shift * d;
    const Vec2 normal(-d.y, d.x);
    const double distance = glm::dot(normal, o);
    for (std::size_t i = 0; i < sweep.outline.pieces.size(); ++i) {
        const CurvePiece& piece = sweep.outline.pieces[i];
        const Crossings found = crossings(piece, normal, distance);
        for (std::size_t k = 0; k < found.count; ++k) {
            const double t = shift + glm::dot(piece.at(found.u[k]) - o, d) / d2;
            const double height = ray.height + t * ray.climb;
            if (height >= sweep.low && height <= sweep.high)
                sink.offer({.t = t, .part = 2 + sweep.first_piece + static_cast<std::uint32_t>(i), .u = found.u[k]});
        }
    }
}

}  // namespace rt
