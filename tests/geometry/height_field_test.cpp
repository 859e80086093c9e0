// Height fields: every triangle is met where it is, none is missed, and what lies below is the inside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/shape.h"
#include "tests/geometry/check_hits.h"

namespace rt::test::height_field_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

HeightField hills(std::uint32_t columns, std::uint32_t rows, unsigned seed) {
    Random random(seed);
    std::vector<std::uint16_t> heights(std::size_t{columns} * rows);
    for (std::uint16_t& height : heights) height = static_cast<std::uint16_t>(random.index(65536));
    HeightField field;
    field.data = HeightFieldData(columns, rows, heights);
    return field;
}

/// All triangles, one after the other.
std::vector<Triangle> triangles_of(const HeightFieldData& data) {
    std::vector<Triangle> all;
    for (std::uint32_t j = 0; j + 1 < data.rows; ++j) {
        for (std::uint32_t i = 0; i + 1 < data.columns; ++i) {
            all.push_back({data.point(i, j), data.point(i + 1, j), data.point(i, j + 1)});
            all.push_back({data.point(i + 1, j + 1), data.point(i, j + 1), data.point(i + 1, j)});
        }
    }
    return all;
}

std::vector<double> hits_one_by_one(const std::vector<Triangle>& triangles, const Ray& ray) {
    std::vector<double> ts;
    for (const Triangle& triangle : triangles) {
        ShapeHit hit;
        if (intersect(triangle, ray, {-infinity, infinity}, hit)) ts.push_back(hit.t);
    }
    std::sort(ts.begin(), ts.end());
    ts.erase(std::unique(ts.begin(), ts.end()), ts.end());
    return ts;
}

TEST(HeightFields, MeetWhatTheirTrianglesMeet) {
    for (const auto& [columns, rows] : {std::pair{2u, 2u}, {3u, 9u}, {17u, 2u}, {12u, 10u}}) {
        const HeightField field = hills(columns, rows, columns);
        const std::vector<Triangle> triangles = triangles_of(*field.data);
        Random random(rows);
        int met = 0;
        for (int i = 0; i < 1500; ++i) {
            Ray ray = aimed_at(Vec3(0.5) + random.in_cube(0.6), 0.5, random);
            if (i % 3 == 0) ray.direction[static_cast<int>(random.index(3))] = 0.0;
            if (i % 7 == 0)
                ray = {Vec3(static_cast<double>(random.index(columns)) / (columns - 1), 2.0, random.between(0.0, 1.0)), {0.0, -1.0, 0.0}};
            const std::vector<double> expected = hits_one_by_one(triangles, ray);
            ASSERT_EQ(all_hits(field, ray), expected) << columns << " x " << rows << " ray " << i;
            ShapeHit nearest;
            ASSERT_EQ(intersect(field, ray, {0.0, infinity}, nearest), !expected.empty() && expected.back() > 0.0);
            if (nearest.t != infinity) {
                ASSERT_EQ(nearest.t, *std::upper_bound(expected.begin(), expected.end(), 0.0));
            }
            met += expected.empty() ? 0 : 1;
        }
        EXPECT_GT(met, 300);
    }
}

TEST(HeightFields, NormalsPointUpFromTheTriangleThatWasMet) {
    const HeightField field = hills(6, 5, 1);
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const Ray down{{random.between(0.0, 1.0), 2.0, random.between(0.0, 1.0)}, {0.0, -1.0, 0.0}};
        ShapeHit hit, aside;
        ASSERT_TRUE(intersect(field, down, {0.0, infinity}, hit));
        const Vec3 n = unit(normal(field, down.at(hit.t), hit));
        EXPECT_GT(n.y, 0.0);
        const Ray beside{down.origin + Vec3(1e-6, 0.0, 1e-6), down.direction};
        if (!intersect(field, beside, {0.0, infinity}, aside) || aside.part != hit.part) continue;
        EXPECT_NEAR(dot(unit(beside.at(aside.t) - down.at(hit.t)), n), 0.0, 1e-6);
    }
}

TEST(HeightFields, EverythingBelowIsInside) {
    const HeightField field = hills(6, 5, 3);
    Random random(4);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p(random.between(-0.1, 1.1), random.between(-0.5, 1.1), random.between(-0.1, 1.1));
        EXPECT_EQ(contains(field, p),
                  all_hits(field, {p, {0.0, 1.0, 0.0}}).size() % 2 == 1 && all_hits(field, {p, {0.0, 1.0, 0.0}}).back() > 0.0)
            << "point " << i;
    }
    EXPECT_TRUE(contains(field, {0.5, -1e6, 0.5}));
    const Bounds box = bounds(field);
    EXPECT_TRUE(box.min.y > 0.0 && box.max.y < 1.0 && box.max.x == 1.0 && box.min.z == 0.0);
}

TEST(HeightFields, WaterHidesTheSurfaceAndRaisesTheInside) {
    HeightField field;
    field.data = HeightFieldData(2, 2, {0, 0, 0x8000, 0x8000});  // a slope from z = 0 to a height of 1/2 at z = 1
    const Ray low{{0.5, 2.0, 0.25}, {0.0, -1.0, 0.0}}, high{{0.5, 2.0, 0.75}, {0.0, -1.0, 0.0}};
    EXPECT_THAT(all_hits(field, low), ElementsAre(1.875));
    field.lowest = 0.25;
    EXPECT_THAT(all_hits(field, low), IsEmpty());
    EXPECT_THAT(all_hits(field, high), ElementsAre(1.625));
    EXPECT_TRUE(contains(field, {0.5, 0.3, 0.25}));
    EXPECT_FALSE(contains(field, {0.5, 0.32, 0.25})) << "halfway between the water at z = 0 and the sample at z = 1";
}

TEST(HeightFields, SmoothNormalsAreMeansOfTheTrianglesAroundASample) {
    const HeightFieldData slope(3, 2, {0, 1, 1, 0, 1, 1});  // rises by one over the first cell only
    const std::vector<HeightField::SampleNormal> n = sample_normals(slope);
    EXPECT_EQ(n.at(0), (HeightField::SampleNormal{-23169, 23169, 0}));
    EXPECT_EQ(n.at(1), (HeightField::SampleNormal{-12539, 30272, 0})) << "halfway between the slope and the plain";
    EXPECT_EQ(n.at(2), (HeightField::SampleNormal{0, 32767, 0}));
}

TEST(HeightFields, SmoothNormalsAreMovedBeforeTheyAreMixed) {
    HeightField field;
    field.data = HeightFieldData(2, 2, {0, 0, 0, 0});
    field.normals = std::vector<HeightField::SampleNormal>{{-16384, 16384, 0}, {0, 16384, 0}, {-16384, 16384, 0}, {0, 16384, 0}};
    // In the unit square a sample unit of height is 1/65536.
    const Transform to_samples = Transform::scale({1.0, 65536.0, 1.0});
    const Vec3 n = moved_normal(field, to_samples, {0.25, 0.0, 0.5}, {});
    EXPECT_NEAR(n.x, -0.75 * std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(n.y, 0.75 * std::sqrt(0.5) + 0.25, 1e-15);
    EXPECT_NEAR(n.z, 0.0, 1e-15);
}

TEST(HeightFields, SurviveAnyRay) {
    const HeightField field = hills(5, 5, 7);
    for (const double bad : {0.0, 1e-300, 1e300, infinity, std::nan("")}) {
        EXPECT_LT(all_hits(field, {Vec3(bad), Vec3(0.0, -1.0, bad)}).size(), 20u);
        EXPECT_FALSE(contains(field, Vec3(std::nan(""), bad, 0.5)));
    }
}

}  // namespace
}  // namespace rt::test::height_field_test
