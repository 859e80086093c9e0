#include "trace/edges.h"

namespace rt {
namespace {

/// Of the way between two rays, until a step or crease is told from a bend: to a thousandth of the line's width.
constexpr int halvings = 10;

/// Stands for all triangles that are objects of their own: scenes without meshes build one surface of them.
constexpr std::uint32_t loose_triangles = 0xffffffffu;

/// Along ray `b`, how far what it meets is from the plane that touches the surface where `a` meets it.
double off_plane(const Ray& b, double t, const Vec3& point, const Vec3& side) {
    return std::fabs(t - dot(point - b.origin, side) / dot(b.direction, side));
}

}  // namespace

EdgeLines::EdgeLines(const World& world, const EdgeOptions& options, Distances distances, int width, int height)
    : world_(world),
      options_(options),
      range_(DistanceRules(distances, world.scene_extent, world.scene_size).traced()),
      width_(width),
      height_(height),
      cos_crease_(std::cos(radians(options.crease_angle))) {}

EdgeLines::Seen EdgeLines::seen(const Vec2& place, const Ray& ray, const Hit* hit) const {
    Seen result{.place = place, .ray = ray};
    if (hit == nullptr) return result;
    result.hit = true;
    result.object = world_.objects[hit->object].loose_triangle ? loose_triangles : hit->object;
    result.t = hit->shape.t;
    result.point = ray.at(result.t);
    result.normal = world_.normal(*hit, result.point);
    result.side = world_.flat_side(*hit, result.normal);
    if (dot(result.normal, ray.direction) > 0.0) result.normal = -result.normal;
    return result;
}

EdgeLines::Seen EdgeLines::look(const Vec2& place) {
    ++rays;
    const Ray ray = camera_ray(world_.camera, place.x, place.y, width_, height_);
    Hit hit;
    return seen(place, ray, world_.nearest(ray, range_, RayKind::image, hit) ? &hit : nullptr);
}

bool EdgeLines::covers(const Vec2& point, int scale) {
    constexpr double d = 0.70710678118654752;
    constexpr std::array<std::array<double, 2>, packet_size> circle{{{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}}};
    std::array<Vec2, packet_size> places;
    std::array<Ray, packet_size> around;
    std::array<Hit, packet_size> hits;
    for (std::size_t i = 0; i < packet_size; ++i) {
        places[i] = point / static_cast<double>(scale) + 0.5 * options_.width * Vec2(circle[i][0], circle[i][1]);
        around[i] = camera_ray(world_.camera, places[i].x, places[i].y, width_, height_);
    }
    const std::uint32_t found = world_.nearest(around, range_, RayKind::image, hits);
    rays += packet_size;
    const auto at = [&](std::size_t i) { return seen(places[i], around[i], (found >> i & 1u) != 0 ? &hits[i] : nullptr); };
    for (std::size_t i = 0; i < packet_size / 2; ++i)
        if (line_between(at(i), at(i + packet_size / 2))) return true;
    return false;
}

bool EdgeLines::line_between(const Seen& a, const Seen& b) {
    const bool outlines = options_.kind != EdgeOptions::Kind::crease, creases = options_.kind != EdgeOptions::Kind::silhouette;
    if (a.hit != b.hit || (a.hit && a.object != b.object)) return outlines;
    if (!a.hit) return false;
    const double near = std::fmin(a.t, b.t);
    const double limit = length(a.ray.at(near) - b.ray.at(near));  // the line's width there
    const auto step = [&](const Seen& x, const Seen& y) { return is_step(x, y, limit); };
    const auto turn = [&](const Seen& x, const Seen& y) { return is_turn(x, y); };
    const bool turned = is_turn(a, b);
    if (!turned && !step(a, b)) return false;
    if (remains(a, b, true, step)) return outlines;
    return creases && turned && remains(a, b, false, turn);
}

/// Neither surface continues to where the other is.
bool EdgeLines::is_step(const Seen& a, const Seen& b, double limit) const {
    return !(std::fmin(off_plane(b.ray, b.t, a.point, a.side), off_plane(a.ray, a.t, b.point, b.side)) <= limit);
}

/// Whether `test` holds for two rays between a and b however near they are to each other; `if_parted` where something else is seen between
/// them.
template <typename Test>
bool EdgeLines::remains(Seen a, Seen b, bool if_parted, const Test& test) {
    for (int i = 0; i < halvings; ++i) {
        const Seen middle = look(0.5 * (a.place + b.place));
        if (!middle.hit || middle.object != a.object) return if_parted;
        if (test(a, middle)) {
            b = middle;
        } else if (test(middle, b)) {
            a = middle;
        } else {
            return false;
        }
    }
    return true;
}

}  // namespace rt
