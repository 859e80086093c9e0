// The kernel of every combination has bit for bit the values of the general function.
#include "shading/kernels.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace rt::kernels_test {
namespace {

using Specular = SurfaceModel::Specular;

class Draw {
public:
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    Vec3 direction() { return unit(Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))); }

private:
    std::mt19937_64 random_{11};
};

void expect_same_bits(const SurfaceModel& model, const ViewedPoint& at, const Vec3& l, const Rgb& tint) {
    const Rgb fixed = highlight(model, at, l, tint), asked = highlight_by_switches(model, at, l, tint);
    for (int channel = 0; channel < 3; ++channel)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(fixed[channel]), std::bit_cast<std::uint64_t>(asked[channel]))
            << static_cast<int>(model.terms.D) << ' ' << static_cast<int>(model.terms.G) << ' ' << static_cast<int>(model.terms.F)
            << " alpha " << model.alpha << " values " << fixed[channel] << ' ' << asked[channel];
}

TEST(Kernels, EveryCombinationIsBitForBitTheGeneralFunction) {
    Draw draw;
    std::size_t lit = 0;
    for (int D = 0; D <= static_cast<int>(Distribution::gaussian); ++D)
        for (int G = 0; G <= static_cast<int>(Masking::none); ++G)
            for (int F = 0; F <= static_cast<int>(Fresnel::conductor); ++F)
                for (int i = 0; i < 60; ++i) {
                    SurfaceModel model;
                    model.terms = {.D = static_cast<Distribution>(D), .G = static_cast<Masking>(G), .F = static_cast<Fresnel>(F)};
                    model.terms.factor = i % 3 ? 1.0 : pi;
                    model.alpha = i % 10 ? std::pow(10.0, draw.uniform(-4.0, 0.5)) : 0.0;
                    model.colorless = i % 2 == 0;
                    for (Interface& x : model.interface)
                        x = model.colorless ? interface_of(1.5, 2.0) : interface_of(draw.uniform(0.2, 3.0), draw.uniform(0.0, 4.0));
                    prepare(model);
                    ASSERT_NE(model.kernel, highlight_by_switches);
                    const Vec3 n = draw.direction(), v = draw.direction();
                    const Vec3 m = unit(n + model.alpha * draw.direction()), l = i % 4 ? unit(2.0 * dot(m, v) * m - v) : draw.direction();
                    const ViewedPoint at = viewed_point(n, v, model.sine_of_view);
                    const Rgb tint = i % 5 ? Rgb(1.0) : Rgb(0.9, 0.5, 0.2);
                    expect_same_bits(model, at, l, tint);
                    lit += highlight(model, at, l, tint) != Rgb(0.0);
                }
    EXPECT_GT(lit, 2000u);
}

TEST(Kernels, TheSineOfTheViewIsLeftOutOnlyWhereNobodyAsks) {
    Draw draw;
    for (int G = 0; G <= static_cast<int>(Masking::none); ++G)
        for (const bool half : {false, true}) {
            SurfaceModel model;
            model.terms.G = static_cast<Masking>(G);
            model.terms.half_of_normal_and_view = half;
            model.alpha = 0.5;
            prepare(model);
            const Vec3 n(0, 0, 1), v = unit(Vec3(0.8, 0.2, 0.3)), l = unit(Vec3(-0.1, 0.4, 0.7));
            const Rgb with = highlight(model, viewed_point(n, v, true), l, Rgb(1.0));
            EXPECT_NE(with, Rgb(0.0));
            EXPECT_EQ(highlight(model, viewed_point(n, v, model.sine_of_view), l, Rgb(1.0)), with) << G << half;
            const bool differs = highlight(model, viewed_point(n, v, false), l, Rgb(1.0)) != with;
            EXPECT_EQ(model.sine_of_view, differs) << G << half;
        }
}

TEST(Kernels, VariantsAndPhongKeepTheGeneralFunction) {
    const auto general = [](const auto& change) {
        SurfaceModel model;
        change(model);
        prepare(model);
        return model.kernel == highlight_by_switches;
    };
    EXPECT_FALSE(general([](SurfaceModel&) {}));
    EXPECT_TRUE(general([](SurfaceModel& m) { m.terms.fresnel_at_view = true; }));
    EXPECT_TRUE(general([](SurfaceModel& m) { m.terms.half_of_normal_and_view = true; }));
    EXPECT_TRUE(general([](SurfaceModel& m) { m.terms.clamped_denominator = true; }));
    EXPECT_TRUE(general([](SurfaceModel& m) { m.terms.without_cosine = true; }));
    for (const Specular other : {Specular::none, Specular::phong, Specular::blinn_phong})
        EXPECT_TRUE(general([&](SurfaceModel& m) { m.specular = other; }));
}

TEST(Kernels, TheDiffuseShareIsWhatTheHighlightLeaves) {
    const auto share = [](Diffuse diffuse, bool shares) {
        SurfaceModel model;
        model.diffuse = diffuse;
        model.shares = shares;
        model.s = 0.25;
        prepare(model);
        return diffuse_factor(model, viewed_point({0, 0, 1}, {0, 0, 1}, false), {0, 0, 1}, 1.0);
    };
    EXPECT_EQ(share(Diffuse::lambert, true), 0.75);
    EXPECT_EQ(share(Diffuse::lambert, false), 1.0);
    EXPECT_EQ(share(Diffuse::oren_nayar, true), 0.75);  // sigma 0
    EXPECT_EQ(share(Diffuse::gooch, true), 0.0);
    EXPECT_EQ(share(Diffuse::none, false), 0.0);
}

}  // namespace
}  // namespace rt::kernels_test
