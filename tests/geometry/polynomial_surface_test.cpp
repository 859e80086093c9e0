// Quadrics and algebraic surfaces of higher degree: the order of coefficients, hits, insides, bounds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shape.h"
#include "tests/geometry/check_hits.h"

namespace rt::test::polynomial_surface_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

Quad power(Quad x, int n) {
    Quad p = 1;
    for (; n > 0; --n) p = p * x;
    return p;
}

/// The polynomial's value, and the sum of its terms without their signs.
struct Terms {
    Quad sum = 0, size = 0;
};

Terms terms(const Poly& poly, const Quad3& p) {
    Terms t;
    std::size_t next = 0;
    const int n = poly.data->degree;
    for (int a = n; a >= 0; --a)
        for (int b = n - a; b >= 0; --b)
            for (int c = n - a - b; c >= 0; --c) {
                const Quad term = Quad(poly.data->coefficients[next++]) * power(p.x, a) * power(p.y, b) * power(p.z, c);
                t.sum += term;
                t.size += abs(term);
            }
    return t;
}

Terms terms(const Quadric& q, const Quad3& p) {
    Terms t;
    for (const Quad term :
         {q.squares.x * p.x * p.x, q.squares.y * p.y * p.y, q.squares.z * p.z * p.z, q.products.x * p.x * p.y, q.products.y * p.x * p.z,
          q.products.z * p.y * p.z, q.linear.x * p.x, q.linear.y * p.y, q.linear.z * p.z, Quad(q.constant)}) {
        t.sum += term;
        t.size += abs(term);
    }
    return t;
}

Poly sum_of_powers(int n, double constant) {
    std::vector<double> c(poly_coefficients(n));
    c[poly_index(n, n, 0, 0)] = c[poly_index(n, 0, n, 0)] = c[poly_index(n, 0, 0, n)] = 1.0;
    c[poly_index(n, 0, 0, 0)] = constant;
    return make_poly(n, c);
}

Poly random_poly(int n, Random& random) {
    std::vector<double> c(poly_coefficients(n));
    for (double& x : c) x = random.between(-1.0, 1.0);
    return make_poly(n, c);
}

/// The first hit of random rays: the polynomial vanishes there, up to the rounding of the ray and of its terms; the normal is the gradient.
template <typename S>
void check_hits(const S& shape, double size, unsigned seed, int rays = 1000) {
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = aimed_at(random.in_cube(size), size, random);
        ShapeHit hit;
        if (!intersect(shape, ray, {}, hit)) continue;
        ++hits;
        const Quad3 p = at(ray, hit.t);
        const Terms t = terms(shape, p);
        const Vec3 point = ray.at(hit.t), n = normal(shape, point, hit);
        const double h = 1e-5 * (size + length(point));
        Vec3 gradient;
        for (int k = 0; k < 3; ++k) {
            Vec3 step(0.0);
            step[k] = h;
            gradient[k] = static_cast<double>(terms(shape, point + step).sum - terms(shape, point - step).sum) / (2 * h);
        }
        ASSERT_NEAR(length(n - gradient), 0.0, 1e-5 * static_cast<double>(t.size) / size) << i;
        const double moved = hit_error(ray, hit.t, size) * length(n);
        ASSERT_LE(static_cast<double>(abs(t.sum)), moved + 100 * 0x1p-53 * static_cast<double>(t.size)) << i;
    }
    ASSERT_GT(hits, rays / 10);
}

TEST(Poly, CoefficientsStandInTheOrderOfTheFile) {
    EXPECT_EQ(poly_coefficients(2), 10u);
    EXPECT_EQ(poly_coefficients(35), 8436u);
    // Of degree 3: x3 x2y x2z x2 xy2 xyz xy xz2 xz x y3 y2z y2 yz2 yz y z3 z2 z 1
    EXPECT_EQ(poly_index(3, 3, 0, 0), 0u);
    EXPECT_EQ(poly_index(3, 2, 1, 0), 1u);
    EXPECT_EQ(poly_index(3, 2, 0, 0), 3u);
    EXPECT_EQ(poly_index(3, 1, 1, 1), 5u);
    EXPECT_EQ(poly_index(3, 1, 0, 2), 7u);
    EXPECT_EQ(poly_index(3, 0, 3, 0), 10u);
    EXPECT_EQ(poly_index(3, 0, 1, 1), 14u);
    EXPECT_EQ(poly_index(3, 0, 0, 0), 19u);
}

TEST(Poly, HitsLieOnTheSurface) {
    Random random(5);
    check_hits(sum_of_powers(2, -1.0), 1.0, 1);
    check_hits(sum_of_powers(6, -64.0), 2.0, 2, 200);
    check_hits(sum_of_powers(4, -1e12), 1e3, 3, 300);
    for (unsigned i = 0; i < 5; ++i) check_hits(random_poly(3, random), 2.0, 10 + i, 300);
    for (unsigned i = 0; i < 5; ++i) check_hits(random_poly(4, random), 2.0, 20 + i, 300);
    check_hits(random_poly(7, random), 2.0, 30, 100);
    check_hits(sum_of_powers(34, -1.0), 1.0, 31, 12);
}

TEST(Poly, AllHitsAlongALine) {
    // (x^2 - 1)(x^2 - 4) = x^4 - 5 x^2 + 4: planes at +-1, +-2, through 0 and at the borders of the pieces.
    std::vector<double> c(poly_coefficients(4));
    c[poly_index(4, 4, 0, 0)] = 1.0, c[poly_index(4, 2, 0, 0)] = -5.0, c[poly_index(4, 0, 0, 0)] = 4.0;
    EXPECT_THAT(all_hits(make_poly(4, c), {{-5, 1, 2}, {2, 0, 0}}),
                ElementsAre(DoubleNear(1.5, 1e-15), DoubleNear(2.0, 1e-15), DoubleNear(3.0, 1e-15), DoubleNear(3.5, 1e-15)));
    // x (x - 1) (x - 2): a root nearest to the origin.
    std::vector<double> d(poly_coefficients(3));
    d[poly_index(3, 3, 0, 0)] = 1.0, d[poly_index(3, 2, 0, 0)] = -3.0, d[poly_index(3, 1, 0, 0)] = 2.0;
    EXPECT_THAT(all_hits(make_poly(3, d), {{-4, 0, 0}, {1, 0, 0}}),
                ElementsAre(DoubleNear(4.0, 1e-15), DoubleNear(5.0, 1e-15), DoubleNear(6.0, 1e-15)));
    // A degree that is stated higher than it is.
    std::vector<double> e(poly_coefficients(5));
    e[poly_index(5, 1, 0, 0)] = 1.0, e[poly_index(5, 0, 0, 0)] = -3.0;
    EXPECT_THAT(all_hits(make_poly(5, e), {{-4, 0, 0}, {1, 0, 0}}), ElementsAre(DoubleNear(7.0, 2e-15)));
    EXPECT_THAT(all_hits(make_poly(2, std::vector<double>(10)), {{-4, 0, 0}, {1, 0, 0}}), IsEmpty());
}

TEST(Quadric, HitsLieOnTheSurface) {
    Random random(6);
    check_hits(Quadric{}, 1.0, 1);
    check_hits(Quadric{Vec3(1, 0.5, -1.2), Vec3(0.2, -0.1, 0.3), Vec3(0.1, 0.2, -0.3), -1}, 2.0, 2);
    check_hits(Quadric{Vec3(1, -1, 1), Vec3(0.0), Vec3(0.0), 0}, 2.0, 3);
    check_hits(Quadric{Vec3(1, 0, 1), Vec3(0.0), Vec3(0, -1, 0), 0}, 2.0, 4);
    check_hits(Quadric{Vec3(0.0), Vec3(0.0), Vec3(1, 2, 3), -1}, 2.0, 5);
    for (unsigned i = 0; i < 8; ++i)
        check_hits(Quadric{random.in_cube(1.0), random.in_cube(1.0), random.in_cube(1.0), random.between(-1.0, 0.0)}, 2.0, 10 + i);
}

TEST(Quadric, ParityIsTheInside) {
    check_inside(Quadric{Vec3(1, 0.5, 2), Vec3(0.2, -0.1, 0.3), Vec3(0.1, 0.2, -0.3), -1}, 2.0, 1);
    check_inside(Quadric{Vec3(1, 0.5, -1.2), Vec3(0.2, -0.1, 0.3), Vec3(0.1, 0.2, -0.3), -1}, 2.0, 2);
    check_inside(sum_of_powers(4, -1.0), 1.5, 3);
    check_inside(FurtherShape(sum_of_powers(6, -1.0)), 1.5, 4);
}

TEST(Quadric, EllipsoidsAreBounded) {
    // ((x - 1) / 2)^2 + (y / 3)^2 + (z + 4)^2 = 1
    const Quadric q{Vec3(0.25, 1.0 / 9.0, 1.0), Vec3(0.0), Vec3(-0.5, 0.0, 8.0), 0.25 + 16.0 - 1.0};
    EXPECT_NEAR(length(bounds(q).min - Vec3(-1, -3, -5)), 0.0, 1e-5);
    EXPECT_NEAR(length(bounds(q).max - Vec3(3, 3, -3)), 0.0, 1e-5);
    EXPECT_FALSE(bounds(Quadric{Vec3(1, 1, 0)}).is_finite());
    EXPECT_FALSE(bounds(Quadric{Vec3(1, 1, -1)}).is_finite());
    EXPECT_FALSE(bounds(Quadric{Vec3(-1, -1, -1)}).is_finite());
    const Quadric skew{Vec3(1, 1, 1), Vec3(1.2, 0.0, 0.0), Vec3(0.0), -1};
    Random random(7);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = aimed_at(random.in_cube(1.0), 2.0, random);
        for (const double t : all_hits(skew, ray)) {
            const Vec3 p = ray.at(t);
            const double slack = hit_error(ray, t, 2.0);
            for (int k = 0; k < 3; ++k) ASSERT_TRUE(p[k] >= bounds(skew).min[k] - slack && p[k] <= bounds(skew).max[k] + slack);
            ++hits;
        }
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(max_abs(bounds(skew).max), 1.26);
}

TEST(Quadric, NamesAreThoseOfTheFile) {
    EXPECT_STREQ(name(Shape(Quadric{})), "quadric");
    EXPECT_STREQ(name(Shape(sum_of_powers(3, 1.0))), "poly");
}

}  // namespace
}  // namespace rt::test::polynomial_surface_test
