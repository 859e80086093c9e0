// Height field: a square of samples over x and z in [0, 1], two triangles between each four of them.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/shared.h"
#include "core/transform.h"
#include "geometry/hit_sink.h"

namespace rt {

/// Samples and what is made of them once.
struct HeightFieldData {
    /// Lowest and highest sample of a square of cells.
    struct Range {
        std::uint16_t low = 0xffff, high = 0;
        bool operator==(const Range&) const = default;
    };
    /// Of squares of 2^(i + 1) x 2^(i + 1) cells in level i, row by row; the last level is one square.
    struct Level {
        std::uint32_t columns = 0, rows = 0;
        std::vector<Range> ranges;
        bool operator==(const Level&) const = default;
    };

    /// `heights` of columns x rows samples, the row at z = 0 first; at least two of each.
    HeightFieldData(std::uint32_t columns, std::uint32_t rows, std::vector<std::uint16_t> heights);
    HeightFieldData() : HeightFieldData(2, 2, {0, 0, 0, 0}) {}

    std::uint16_t height(std::uint32_t i, std::uint32_t j) const { return heights[std::size_t{j} * columns + i]; }
    /// Of the cell between columns i, i + 1 and rows j, j + 1.
    Range cell(std::uint32_t i, std::uint32_t j) const;
    Vec3 point(std::uint32_t i, std::uint32_t j) const {
        return {static_cast<double>(i) / (columns - 1), 0x1p-16 * height(i, j), static_cast<double>(j) / (rows - 1)};
    }
    bool operator==(const HeightFieldData&) const = default;

    std::uint32_t columns, rows;
    std::vector<std::uint16_t> heights;
    std::vector<Level> levels;
};

struct HeightField {
    /// A normal at a sample, in units of samples, as POV-Ray keeps it: unit times 32767.
    using SampleNormal = std::array<std::int16_t, 3>;

    Shared<HeightFieldData> data;
    Shared<std::vector<SampleNormal>> normals;  ///< of each sample; empty: flat triangles
    double lowest = -1.0;                       ///< what lies below this y is not drawn
    static constexpr const char* word = "height_field";
    bool operator==(const HeightField&) const = default;
};

/// The mean of the normals of the right-angled triangles around each sample.
std::vector<HeightField::SampleNormal> sample_normals(const HeightFieldData& data);

/// The most samples, for which parts of cells are still numbers of 32 bits.
inline constexpr std::size_t most_height_samples = std::size_t{1} << 30;

/// Part 2 k is the triangle of cell k at its corner of low x and z, 2 k + 1 the other one. A ray that crosses an edge between two
/// triangles meets at least one of them.
void find_hits(const HeightField& shape, const Ray& ray, HitSink& sink);
Vec3 normal(const HeightField& shape, const Vec3& point, const ShapeHit& hit);
/// Of the triangle that was met, of any length: what `normal` is unless the field is smooth.
Vec3 flat_normal(const HeightField& shape, const ShapeHit& hit);
/// Of the shape moved: POV-Ray moves the normals of the samples and makes them unit before it mixes them. `point` is in the shape's space.
Vec3 moved_normal(const HeightField& shape, const Transform& to_world, const Vec3& point, const ShapeHit& hit);
/// Everything below the surface, however deep.
bool contains(const HeightField& shape, const Vec3& point);
Bounds bounds(const HeightField& shape);

}  // namespace rt
