#include "geometry/isosurface.h"

namespace rt {

namespace {

/// Steps of the function for one ray: where they are not enough nothing more is found.
constexpr std::uint64_t most_steps = 10'000'000;
/// What begins nearer to the ray's origin than POV-Ray sees a surface begins there.
constexpr double at_origin = 1e-4;
/// A search goes on so many accuracies behind what it found, or behind an origin that is inside.
constexpr double skipped = 5.0;

struct Passage {
    double enter = 0.0, leave = 0.0;
    std::uint32_t enter_part = 1, leave_part = 1;
};

bool pass(const Box& box, const Ray& ray, Passage& passage) {
    Slabs slabs;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        if (!slabs.clip(box.min[i], box.max[i], ray.origin[i], ray.direction[i], axis)) return false;
    }
    passage = {slabs.enter, slabs.leave, 1 + slabs.enter_face, 1 + slabs.leave_face};
    return true;
}

bool pass(const Sphere& sphere, const Ray& ray, Passage& passage) {
    ShapeHit near, far;
    if (!intersect(sphere, ray, {-infinity, infinity}, near)) return false;
    passage.enter = passage.leave = near.t;
    if (intersect(sphere, ray, {near.t, infinity}, far)) passage.leave = far.t;
    return true;
}

/// The function along a ray, less the threshold.
class Search {
public:
    Search(const Isosurface& shape, const Ray& ray, double end)
        : shape_(shape), ray_(ray), end_(end), slope_(shape.max_gradient * length(ray.direction)) {}

    double value(double t) {
        const Vec3 p = ray_.at(t);
        const std::array<double, 3> arguments{p.x, p.y, p.z};
        return evaluate(*shape_.function, arguments, steps_).value_or(shape_.threshold) - shape_.threshold;
    }

    /// The end of the first piece, shorter than the accuracy, in which the function changes its sign; infinity if there is none.
    double first(double from, double to) {
        sign_ = value(from) < 0.0 ? -1.0 : 1.0;
        return first_between({from, sign_ * value(from)}, {to, sign_ * value(to)});
    }

private:
    struct Place {
        double t, value;
    };

    double first_between(const Place& a, const Place& b) {
        if (!(a.t < end_) || steps_ == 0) return infinity;
        if (a.value + b.value >= slope_ * (b.t - a.t)) return infinity;  // too far from 0 at both ends
        if (b.t - a.t < shape_.accuracy) return b.value < 0.0 ? b.t : infinity;
        const double middle = 0.5 * (a.t + b.t);
        if (!(a.t < middle && middle < b.t)) return infinity;
        const Place m{middle, sign_ * value(middle)};
        const double t = first_between(a, m);
        return t < infinity ? t : first_between(m, b);
    }

    const Isosurface& shape_;
    const Ray& ray_;
    double end_;  ///< nobody asks what lies farther
    double slope_;
    double sign_ = 1.0;
    std::uint64_t steps_ = most_steps;
};

double field_at(const Isosurface& shape, const Vec3& p) {
    const std::array<double, 3> arguments{p.x, p.y, p.z};
    std::uint64_t steps = most_steps;
    return evaluate(*shape.function, arguments, steps).value_or(shape.threshold) - shape.threshold;
}

}  // namespace

void find_hits(const Isosurface& shape, const Ray& ray, HitSink& sink) {
    Passage passage;
    if (!std::visit([&](const auto& container) { return pass(container, ray, passage); }, shape.container)) return;
    if (!(passage.leave > 0.0) || passage.enter >= sink.before()) return;
    Search search(shape, ray, sink.before());
    int left = shape.max_trace;  // of those that the sink asks for: what transmits a shadow ray is asked for the hits behind it
    const auto offer = [&](const ShapeHit& hit) {
        sink.offer(hit);
        if (hit.t > sink.after()) --left;
    };
    double from = std::fmax(passage.enter, 0.0);
    const bool begins_inside = search.value(from) < 0.0;
    if (begins_inside && passage.enter > at_origin && !shape.open) {
        offer({.t = passage.enter, .part = passage.enter_part});
    } else if (begins_inside && passage.enter <= at_origin) {
        from += skipped * shape.accuracy;
    }
    while (left > 0 && from < passage.leave) {
        const double t = search.first(from, passage.leave);
        if (t == infinity) break;
        offer({.t = t});
        from = t + skipped * shape.accuracy;
    }
    if (left > 0 && !shape.open && search.value(passage.leave) < 0.0) sink.offer({.t = passage.leave, .part = passage.leave_part});
}

/// Differences over one accuracy, forward.
Vec3 normal(const Isosurface& shape, const Vec3& point, const ShapeHit& hit) {
    if (hit.part > 0)
        return std::visit([&](const auto& container) { return normal(container, point, ShapeHit{.part = hit.part - 1}); }, shape.container);
    const double here = field_at(shape, point), step = shape.accuracy;
    const Vec3 slope(field_at(shape, point + Vec3(step, 0.0, 0.0)) - here, field_at(shape, point + Vec3(0.0, step, 0.0)) - here,
                     field_at(shape, point + Vec3(0.0, 0.0, step)) - here);
    return length(slope) > 0.0 && is_finite(slope) ? slope : Vec3(1.0, 0.0, 0.0);
}

bool contains(const Isosurface& shape, const Vec3& point) {
    return std::visit([&](const auto& container) { return contains(container, point); }, shape.container) && field_at(shape, point) < 0.0;
}

Bounds bounds(const Isosurface& shape) {
    return std::visit([](const auto& container) { return bounds(container); }, shape.container);
}

}  // namespace rt
