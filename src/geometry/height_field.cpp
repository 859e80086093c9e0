#include "geometry/height_field.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace rt {

namespace {

using Range = HeightFieldData::Range;

void extend(Range& range, const Range& other) {
    range.low = std::min(range.low, other.low);
    range.high = std::max(range.high, other.high);
}

std::uint32_t half(std::uint32_t n) { return (n + 1) / 2; }

/// The level whose squares are made of 2 x 2 of what is below, of which `below(i, j)` tells the range.
template <typename Below>
HeightFieldData::Level make_level(std::uint32_t columns, std::uint32_t rows, Below below) {
    HeightFieldData::Level level{half(columns), half(rows), {}};
    level.ranges.resize(std::size_t{level.columns} * level.rows);
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) extend(level.ranges[std::size_t{j / 2} * level.columns + i / 2], below(i, j));
    return level;
}

/// One ray on its way down the levels, nearest squares first.
class Walk {
public:
    Walk(const HeightField& shape, const Ray& ray, HitSink& sink)
        : field_(*shape.data),
          lowest_(shape.lowest),
          ray_(ray),
          sheared_(ray),
          inverse_(1.0 / ray.direction),
          room_(0x1p-48 * (1.0 + max_abs(ray.origin))),
          backwards_{ray.direction.x < 0.0 ? 1u : 0u, ray.direction.z < 0.0 ? 1u : 0u},
          sink_(sink) {}

    void visit_all() { visit(field_.levels.size() - 1, 0, 0); }

private:
    /// Square (i, j) of a level.
    void visit(std::size_t level, std::uint32_t i, std::uint32_t j) {
        const HeightFieldData::Level& squares = field_.levels[level];
        if (!passes(std::size_t{2} << level, i, j, squares.ranges[std::size_t{j} * squares.columns + i])) return;
        const std::uint32_t columns = level == 0 ? field_.columns - 1 : field_.levels[level - 1].columns;
        const std::uint32_t rows = level == 0 ? field_.rows - 1 : field_.levels[level - 1].rows;
        for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t x = 2 * i + ((k & 1) ^ backwards_[0]), z = 2 * j + ((k >> 1) ^ backwards_[1]);
            if (x >= columns || z >= rows) continue;
            if (level == 0)
                visit_cell(x, z);
            else
                visit(level - 1, x, z);
        }
    }

    void visit_cell(std::uint32_t i, std::uint32_t j) {
        if (!passes(1, i, j, field_.cell(i, j))) return;
        const Vec3 beside = field_.point(i + 1, j), behind = field_.point(i, j + 1);
        const std::uint32_t part = 2 * (j * (field_.columns - 1) + i);
        offer(part, field_.point(i, j), beside, behind);
        offer(part + 1, field_.point(i + 1, j + 1), behind, beside);
    }

    void offer(std::uint32_t part, const Vec3& a, const Vec3& b, const Vec3& c) {
        ShapeHit hit;
        if (!intersect(a, b, c, sheared_, {sink_.after(), sink_.before()}, hit)) return;
        if (lowest_ > 0.0 && a.y + hit.u * (b.y - a.y) + hit.v * (c.y - a.y) <= lowest_) return;
        sink_.offer({.t = hit.t, .part = part});
    }

    /// Whether the ray comes through the box over `size` x `size` cells at a distance that counts, or so near to it that rounding might
    /// give it to one of its triangles.
    bool passes(std::size_t size, std::uint32_t i, std::uint32_t j, const Range& heights) const {
        double enter = sink_.after(), leave = sink_.before();
        const auto side = [&](double low, double high, int axis) {
            const double a = (low - room_ - ray_.origin[axis]) * inverse_[axis], b = (high + room_ - ray_.origin[axis]) * inverse_[axis];
            const double first = a < b ? a : b, last = a < b ? b : a;
            if (first > enter) enter = first;
            if (last < leave) leave = last;
        };
        const auto at = [size](std::uint32_t place, std::uint32_t samples) {
            return static_cast<double>(std::min<std::size_t>(place * size, samples - 1)) / (samples - 1);
        };
        side(at(i, field_.columns), at(i + 1, field_.columns), 0);
        side(at(j, field_.rows), at(j + 1, field_.rows), 2);
        side(0x1p-16 * heights.low, 0x1p-16 * heights.high, 1);
        return !(enter > leave);
    }

    const HeightFieldData& field_;
    double lowest_;
    const Ray& ray_;
    TriangleRay sheared_;
    Vec3 inverse_;
    double room_;
    std::array<std::uint32_t, 2> backwards_;
    HitSink& sink_;
};

/// Where a number in [0, 1] is among samples: the one before it and how far it is to the next.
struct Place {
    Place(double x, std::uint32_t samples) {
        const double at = x * (samples - 1);
        index = static_cast<std::uint32_t>(std::clamp(std::floor(at), 0.0, samples - 2.0));
        fraction = at - index;
    }
    std::uint32_t index;
    double fraction;
};

/// Over a point of the triangle on its side of the diagonal; `lowest` for samples below it.
double height_over(const HeightField& shape, const Place& x, const Place& z) {
    const auto height = [&](std::uint32_t to_x, std::uint32_t to_z) {
        return std::max(0x1p-16 * shape.data->height(x.index + to_x, z.index + to_z), shape.lowest);
    };
    const double beside = height(1, 0), behind = height(0, 1);
    if (x.fraction + z.fraction <= 1.0) {
        const double corner = height(0, 0);
        return corner + x.fraction * (beside - corner) + z.fraction * (behind - corner);
    }
    const double corner = height(1, 1);
    return corner + (1.0 - x.fraction) * (behind - corner) + (1.0 - z.fraction) * (beside - corner);
}

Vec3 flat_normal(const HeightFieldData& field, std::uint32_t part) {
    const std::uint32_t cell = part / 2, i = cell % (field.columns - 1), j = cell / (field.columns - 1);
    const Vec3 beside = field.point(i + 1, j), behind = field.point(i, j + 1);
    if (part % 2 == 0) return cross(behind - field.point(i, j), beside - field.point(i, j));
    return cross(beside - field.point(i + 1, j + 1), behind - field.point(i + 1, j + 1));
}

}  // namespace

HeightFieldData::HeightFieldData(std::uint32_t columns_, std::uint32_t rows_, std::vector<std::uint16_t> heights_)
    : columns(columns_), rows(rows_), heights(std::move(heights_)) {
    levels.push_back(make_level(columns - 1, rows - 1, [&](std::uint32_t i, std::uint32_t j) { return cell(i, j); }));
    while (levels.back().ranges.size() > 1) {
        const Level& below = levels.back();
        levels.push_back(make_level(below.columns, below.rows,
                                    [&](std::uint32_t i, std::uint32_t j) { return below.ranges[std::size_t{j} * below.columns + i]; }));
    }
}

Range HeightFieldData::cell(std::uint32_t i, std::uint32_t j) const {
    const auto [low, high] = std::minmax({height(i, j), height(i + 1, j), height(i, j + 1), height(i + 1, j + 1)});
    return {low, high};
}

std::vector<HeightField::SampleNormal> sample_normals(const HeightFieldData& data) {
    std::vector<HeightField::SampleNormal> normals;
    normals.reserve(data.heights.size());
    for (std::uint32_t j = 0; j < data.rows; ++j) {
        for (std::uint32_t i = 0; i < data.columns; ++i) {
            const double h = data.height(i, j);
            Vec3 sum(0.0);
            // The triangle's legs go to the neighbours on one side in x and on one in z.
            for (const auto& [to_x, to_z] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
                const std::uint32_t x = i + static_cast<std::uint32_t>(to_x), z = j + static_cast<std::uint32_t>(to_z);
                if (x >= data.columns || z >= data.rows) continue;
                sum += unit(Vec3(-to_x * (data.height(x, j) - h), 1.0, -to_z * (data.height(i, z) - h)));
            }
            const Vec3 n = 32767.0 * unit(sum);
            normals.push_back({static_cast<std::int16_t>(n.x), static_cast<std::int16_t>(n.y), static_cast<std::int16_t>(n.z)});
        }
    }
    return normals;
}

void find_hits(const HeightField& shape, const Ray& ray, HitSink& sink) { Walk(shape, ray, sink).visit_all(); }

Vec3 normal(const HeightField& shape, const Vec3& point, const ShapeHit& hit) { return moved_normal(shape, Transform{}, point, hit); }

Vec3 flat_normal(const HeightField& shape, const ShapeHit& hit) { return flat_normal(*shape.data, hit.part); }

Vec3 moved_normal(const HeightField& shape, const Transform& to_world, const Vec3& point, const ShapeHit& hit) {
    const HeightFieldData& field = *shape.data;
    if (shape.normals->empty()) return to_world.normal(flat_normal(field, hit.part));
    const Place x(point.x, field.columns), z(point.z, field.rows);
    // What takes a normal from units of samples to the unit square.
    const Vec3 scale(field.columns - 1.0, 0x1p16, field.rows - 1.0);
    const auto at = [&](std::uint32_t to_x, std::uint32_t to_z) {
        const HeightField::SampleNormal& n = (*shape.normals)[std::size_t{z.index + to_z} * field.columns + x.index + to_x];
        return unit(to_world.normal(scale * Vec3(n[0], n[1], n[2])));
    };
    const Vec3 front = (1.0 - x.fraction) * at(0, 0) + x.fraction * at(1, 0);
    const Vec3 back = (1.0 - x.fraction) * at(0, 1) + x.fraction * at(1, 1);
    return (1.0 - z.fraction) * front + z.fraction * back;
}

bool contains(const HeightField& shape, const Vec3& point) {
    if (!(point.x >= 0.0 && point.x <= 1.0 && point.z >= 0.0 && point.z <= 1.0)) return false;
    return point.y < height_over(shape, Place(point.x, shape.data->columns), Place(point.z, shape.data->rows));
}

Bounds bounds(const HeightField& shape) {
    const Range all = shape.data->levels.back().ranges.front();
    return {{0.0, 0x1p-16 * all.low, 0.0}, {1.0, 0x1p-16 * all.high, 1.0}};
}

}  // namespace rt
