#include "geometry/sphere_sweep.h"

#include <algorithm>

#include "geometry/bernstein.h"
#include "geometry/roots.h"

namespace rt {

namespace {

using Cubic = std::array<double, 4>;

SweptSphere mix(std::initializer_list<std::pair<double, SweptSphere>> parts) {
    SweptSphere sum;
    for (const auto& [weight, sphere] : parts) {
        sum.center += weight * sphere.center;
        sum.radius += weight * sphere.radius;
    }
    return sum;
}

SweepPiece piece_of(const SweptSphere& a, const SweptSphere& b, const SweptSphere& c, const SweptSphere& d) {
    return {{a.center, b.center, c.center, d.center}, {a.radius, b.radius, c.radius, d.radius}};
}

double largest_radius(const SweepPiece& piece) {
    double largest = 0.0;
    for (const double r : piece.radius) largest = std::fmax(largest, std::fabs(r));
    return largest;
}

template <std::size_t size>
std::array<double, size - 1> derivative(const std::array<double, size>& p) {
    std::array<double, size - 1> slopes;
    for (std::size_t i = 0; i + 1 < size; ++i) slopes[i] = static_cast<double>(size - 1) * (p[i + 1] - p[i]);
    return slopes;
}

/// Where the polynomial changes its sign on [0, 1].
template <std::size_t size>
void add_changes(const std::array<double, size>& p, std::vector<double>& places) {
    SignChanges changes(p, SignChanges::Basis::bernstein);
    for (double u = -1.0; changes.next(u, u);) places.push_back(u);
}

/// A piece as a ray sees it: its line meets the sphere of u between along(u) - sqrt(room(u)) and along(u) + sqrt(room(u)).
struct SeenPiece {
    Cubic along, aside, above, radius;
    std::array<double, 7> room;

    SeenPiece(const SweepPiece& piece, const Ray& line, const Vec3& e, const Vec3& f) : radius(piece.radius) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 c = piece.center[i] - line.origin;
            along[i] = dot(c, line.direction);
            aside[i] = dot(c, e);
            above[i] = dot(c, f);
        }
        room = product(radius, radius);
        const auto aside2 = product(aside, aside), above2 = product(above, above);
        for (std::size_t i = 0; i < room.size(); ++i) room[i] -= aside2[i] + above2[i];
    }

    /// Half of the sphere's part of the line; 0 where it is missed.
    double half(double u) const {
        return std::sqrt(std::fmax(0.0, sqr(value_at(radius, u)) - (sqr(value_at(aside, u)) + sqr(value_at(above, u)))));
    }
    double end(double u, double side) const { return value_at(along, u) + side * half(u); }
};

/// Part of a line that a piece covers, and where on the piece it begins and ends.
struct Cover {
    double first, last;
    double first_u, last_u;
    std::uint32_t first_part, last_part;
};

class CoverFinder {
public:
    CoverFinder(const SeenPiece& piece, std::uint32_t part, std::vector<Cover>& out) : piece_(piece), part_(part), out_(out) {}

    /// Spheres next to each other cover one stretch together: from where the first begins to where the last ends.
    void find() {
        edges_.assign(1, 0.0);
        SignChanges changes(piece_.room, SignChanges::Basis::bernstein);
        for (double u = -1.0; changes.next(u, u);) edges_.push_back(u);
        edges_.push_back(1.0);
        bool is_met = (changes.sign() > 0) == (edges_.size() % 2 == 0);
        for (std::size_t i = 0; i + 1 < edges_.size(); ++i, is_met = !is_met)
            if (is_met) add(edges_[i], edges_[i + 1]);
    }

private:
    /// The sphere's end is extreme where d/du (along -+ sqrt(room)) = 0, so 4 along'^2 room - room'^2 = 0. Where that only touches 0,
    /// along' or room' change their signs.
    void add(double from, double to) {
        if (places_.empty()) {
            const auto climb = derivative(piece_.along);
            const auto slope = derivative(piece_.room);
            std::array<double, 11> extreme = product(product(climb, climb), piece_.room);
            const auto slope2 = product(slope, slope);
            for (std::size_t i = 0; i < extreme.size(); ++i) extreme[i] = 4.0 * extreme[i] - slope2[i];
            add_changes(extreme, places_);
            add_changes(climb, places_);
            add_changes(slope, places_);
            places_.push_back(0.0);
        }
        Cover s{infinity, -infinity, 0.0, 0.0, part_, part_};
        const auto consider = [&](double u) {
            if (const double t = piece_.end(u, -1.0); t < s.first) s.first = t, s.first_u = u;
            if (const double t = piece_.end(u, 1.0); t > s.last) s.last = t, s.last_u = u;
        };
        consider(from);
        consider(to);
        for (const double u : places_)
            if (u > from && u < to) consider(u);
        if (s.first < s.last) out_.push_back(s);
    }

    const SeenPiece& piece_;
    std::uint32_t part_;
    std::vector<Cover>& out_;
    std::vector<double> edges_, places_;
};

/// Stretches that overlap become one.
void join(std::vector<Cover>& stretches) {
    std::stable_sort(stretches.begin(), stretches.end(), [](const Cover& a, const Cover& b) { return a.first < b.first; });
    std::size_t count = 0;
    for (const Cover& s : stretches) {
        if (count > 0 && s.first <= stretches[count - 1].last) {
            Cover& before = stretches[count - 1];
            if (s.last > before.last) before.last = s.last, before.last_u = s.last_u, before.last_part = s.last_part;
        } else {
            stretches[count++] = s;
        }
    }
    stretches.resize(count);
}

/// Whether the line comes near enough to the piece to meet it: no sphere reaches out of the ball around the corners' balls.
bool is_near(const SweepPiece& piece, const Ray& line) {
    const Vec3 middle = 0.25 * (piece.center[0] + piece.center[1] + piece.center[2] + piece.center[3]);
    double reach = 0.0;
    for (const Vec3& c : piece.center) reach = std::fmax(reach, length(c - middle));
    reach += largest_radius(piece);
    constexpr double room = 1.0 + 1e-9;
    return length(cross(middle - line.origin, line.direction)) <= room * reach;
}

}  // namespace

SweepPiece sweep_line(const SweptSphere& a, const SweptSphere& b) {
    return piece_of(a, mix({{2.0 / 3.0, a}, {1.0 / 3.0, b}}), mix({{1.0 / 3.0, a}, {2.0 / 3.0, b}}), b);
}

SweepPiece sweep_cubic(const SweptSphere& a, const SweptSphere& b, const SweptSphere& c, const SweptSphere& d) {
    constexpr double sixth = 1.0 / 6.0;
    return piece_of(b, mix({{1.0, b}, {sixth, c}, {-sixth, a}}), mix({{1.0, c}, {sixth, b}, {-sixth, d}}), c);
}

SweepPiece sweep_b_spline(const SweptSphere& a, const SweptSphere& b, const SweptSphere& c, const SweptSphere& d) {
    constexpr double sixth = 1.0 / 6.0, third = 1.0 / 3.0;
    return piece_of(mix({{sixth, a}, {4.0 * sixth, b}, {sixth, c}}), mix({{2.0 * third, b}, {third, c}}),
                    mix({{third, b}, {2.0 * third, c}}), mix({{sixth, b}, {4.0 * sixth, c}, {sixth, d}}));
}

void find_hits(const SphereSweep& shape, const Ray& ray, HitSink& sink) {
    const std::vector<SweepPiece>& pieces = *shape.pieces;
    const double speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const double shift = dot(pieces.front().center[0] - ray.origin, d);
    const Ray line{ray.origin + shift * d, d};
    const Vec3 e = unit(cross(d, std::fabs(d.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0))), f = cross(d, e);
    std::vector<Cover> stretches;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        if (!is_near(pieces[i], line)) continue;
        const SeenPiece seen(pieces[i], line, e, f);
        CoverFinder(seen, i, stretches).find();
    }
    join(stretches);
    for (const Cover& s : stretches) {
        sink.offer({.t = (s.first + shift) / speed, .part = s.first_part, .u = s.first_u});
        sink.offer({.t = (s.last + shift) / speed, .part = s.last_part, .u = s.last_u});
    }
}

Vec3 normal(const SphereSweep& shape, const Vec3& point, const ShapeHit& hit) {
    const SweepPiece& piece = (*shape.pieces)[hit.part];
    Vec3 center;
    for (int axis = 0; axis < 3; ++axis)
        center[axis] = value_at(Cubic{piece.center[0][axis], piece.center[1][axis], piece.center[2][axis], piece.center[3][axis]}, hit.u);
    return point - center;
}

/// In some sphere, where (p - center)^2 - radius^2 < 0.
bool contains(const SphereSweep& shape, const Vec3& point) {
    return std::any_of(shape.pieces->begin(), shape.pieces->end(), [&](const SweepPiece& piece) {
        std::array<double, 7> outside = product(piece.radius, piece.radius);
        for (double& c : outside) c = -c;
        for (int axis = 0; axis < 3; ++axis) {
            const Cubic away{piece.center[0][axis] - point[axis], piece.center[1][axis] - point[axis], piece.center[2][axis] - point[axis],
                             piece.center[3][axis] - point[axis]};
            const auto square = product(away, away);
            for (std::size_t i = 0; i < square.size(); ++i) outside[i] += square[i];
        }
        SignChanges changes(outside, SignChanges::Basis::bernstein);
        double u = -1.0;
        return changes.next(u, u) || changes.sign() < 0;
    });
}

Bounds bounds(const SphereSweep& shape) {
    Bounds all;
    for (const SweepPiece& piece : *shape.pieces) {
        const Vec3 r(largest_radius(piece));
        for (const Vec3& c : piece.center) {
            all.extend(c - r);
            all.extend(c + r);
        }
    }
    return rounded_outward(all);
}

}  // namespace rt
