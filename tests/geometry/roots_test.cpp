// Sign changes of polynomials on [0, 1] against Sturm's theorem in quadruple precision, and at places known beforehand.
#include "geometry/roots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/sturm.h"

namespace rt::test::roots_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<double> changes(const std::vector<double>& c, int sign_before = 0, double after = -1.0) {
    SignChanges found(c, SignChanges::Basis::powers, sign_before);
    std::vector<double> all;
    for (double x = after; found.next(x, x);) all.push_back(x);
    return all;
}

/// The product of x - r over the roots, the constant first.
std::vector<double> with_roots(const std::vector<double>& roots) {
    std::vector<double> c{1.0};
    for (const double r : roots) {
        c.push_back(0.0);
        for (std::size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - r * c[i];
        c[0] *= -r;
    }
    return c;
}

Polynomial in_quad(const std::vector<double>& c) { return Polynomial(c.rbegin(), c.rend()); }

TEST(Roots, OfSimplePolynomials) {
    EXPECT_THAT(changes({-0.25, 1.0}), ElementsAre(DoubleNear(0.25, 1e-16)));
    EXPECT_THAT(changes({-1.0, 2.0, 2.0}), ElementsAre(DoubleNear((std::sqrt(3.0) - 1.0) / 2.0, 1e-16)));
    EXPECT_THAT(changes(with_roots({0.125, 0.5, 0.75})),
                ElementsAre(DoubleNear(0.125, 1e-15), DoubleNear(0.5, 1e-15), DoubleNear(0.75, 1e-15)));
    EXPECT_THAT(changes({1.0}), IsEmpty());
    EXPECT_THAT(changes({}), IsEmpty());
    EXPECT_THAT(changes({0.0, 0.0, 0.0}), IsEmpty());
    EXPECT_THAT(changes({-1.0, 3.0, 0.0, 0.0}), ElementsAre(DoubleNear(1.0 / 3.0, 1e-16)));
    EXPECT_THAT(changes({infinity, -1.0}), IsEmpty());
}

TEST(Roots, TouchingIsNoChangeAndATripleRootIsOne) {
    EXPECT_THAT(changes(with_roots({0.5, 0.5})), IsEmpty());
    EXPECT_THAT(changes(with_roots({0.3, 0.3, 0.9})), ElementsAre(DoubleNear(0.9, 1e-15)));
    EXPECT_THAT(changes(with_roots({0.25, 0.25, 0.25, 0.25, 0.25})), testing::SizeIs(1));
    EXPECT_THAT(changes(with_roots({0.5, 0.5, 0.5})), ElementsAre(DoubleNear(0.5, 1e-5)));
    EXPECT_THAT(changes(with_roots({0.5, 0.5, 0.5, 0.5})), IsEmpty());
}

TEST(Roots, AtTheBordersOfPieces) {
    EXPECT_THAT(changes(with_roots({0.25, 0.5, 0.75})),
                ElementsAre(DoubleNear(0.25, 1e-15), DoubleNear(0.5, 1e-15), DoubleNear(0.75, 1e-15)));
    // At 0 there is a change if the sign before is said to be the other one.
    EXPECT_THAT(changes({0.0, 1.0}), IsEmpty());
    EXPECT_THAT(changes({0.0, 1.0}, -1), ElementsAre(0.0));
    EXPECT_THAT(changes({0.0, 1.0}, 1), IsEmpty());
    EXPECT_THAT(changes({1.0}, -1), ElementsAre(0.0));
}

TEST(Roots, InBernsteinsBasis) {
    const std::vector<double> b{-1.0, 0.5, 0.5, -1.0};  // -(1-x)^3 + 1.5 x (1-x)^2 + 1.5 x^2 (1-x) - x^3 = -1 + 4.5 x (1 - x)
    SignChanges found(b, SignChanges::Basis::bernstein);
    double x = -1.0;
    ASSERT_TRUE(found.next(x, x));
    EXPECT_NEAR(x, 1.0 / 3.0, 1e-16);
    ASSERT_TRUE(found.next(x, x));
    EXPECT_NEAR(x, 2.0 / 3.0, 1e-16);
    EXPECT_FALSE(found.next(x, x));
}

TEST(Roots, SignAtTheEnd) {
    const auto sign = [](const std::vector<double>& c, int before) {
        SignChanges found(c, SignChanges::Basis::powers, before);
        for (double x = 0.0; found.next(1.0, x);) ADD_FAILURE();
        return found.sign();
    };
    EXPECT_EQ(sign({-0.5, 1.0}, -1), 1);
    EXPECT_EQ(sign({1.0, -1.0}, 1), 1);  // zero at 1 itself
    EXPECT_EQ(sign(with_roots({0.5, 0.75}), 1), 1);
    EXPECT_EQ(sign({0.0}, -1), -1);
}

TEST(Roots, AfterAPlaceOnlyTheLaterOnes) {
    const std::vector<double> c = with_roots({0.1, 0.4, 0.6, 0.9});
    const std::vector<double> all = changes(c);
    ASSERT_EQ(all.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::vector<double> later = changes(c, 0, all[i]);
        EXPECT_EQ(later, std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end()));  // to the last bit
    }
}

// Polynomials of all degrees: between polynomials a little below and above, whose roots Sturm counts, lies what is found.
TEST(Roots, AgreeWithSturmCounts) {
    Random random(1);
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::size_t degree = 1 + random.index(i % 10 == 0 ? 20 : 10);
        std::vector<double> c;
        if (i % 2 == 0) {
            for (std::size_t k = 0; k <= degree; ++k) c.push_back(random.between(-1.0, 1.0) * random.magnitude(1e-3, 1.0));
        } else {
            std::vector<double> roots;
            for (std::size_t k = 0; k < degree; ++k) roots.push_back(random.between(-0.5, 1.5));
            c = with_roots(roots);
        }
        const std::vector<double> all = changes(c);
        found += static_cast<int>(all.size());
        ASSERT_TRUE(std::is_sorted(all.begin(), all.end()));
        double size = 0.0;
        for (const double x : c) size = std::max(size, std::fabs(x));
        const double error = 8.0 * static_cast<double>(degree) * 0x1p-53 * size;
        Polynomial above = in_quad(c), below = above;
        above.back() += error, below.back() -= error;
        const int sure = std::min(count_roots(above, 0, 1), count_roots(below, 0, 1));
        const int most = std::max(count_roots(above, 0, 1), count_roots(below, 0, 1));
        ASSERT_GE(static_cast<int>(all.size()), sure) << "round " << i;
        ASSERT_LE(static_cast<int>(all.size()), most) << "round " << i;
        // A root of a polynomial that near: the value changes its sign, or is as small as the error, next to what is found.
        for (const double x : all) {
            const Quad v = value(in_quad(c), x), d = value(in_quad(c), x + 0x1p-52) - value(in_quad(c), x - 0x1p-52);
            ASSERT_LE(static_cast<double>(abs(v)), error + static_cast<double>(abs(d))) << "round " << i << " x " << x;
        }
    }
    EXPECT_GT(found, 3000);
}

}  // namespace
}  // namespace rt::test::roots_test
