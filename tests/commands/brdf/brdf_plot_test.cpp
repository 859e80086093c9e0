// raytrace brdf plot: the curves are the functions, the picture is XML that stands where its axes say, mistakes are named.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "commands/base/svg_chart.h"
#include "commands/brdf/brdf_curves.h"
#include "tests/commands/support.h"

namespace rt::brdf_plot_test {
namespace {

using test::Outcome;
using test::run;

TEST(BrdfCurves, AreTheFormulas) {
    SurfaceModel model;
    model.alpha = 0.5;
    model.interface[0] = model.interface[1] = model.interface[2] = interface_of(3.0);  // F0 = 1/4
    EXPECT_NEAR(distribution_at(model, 0.0), 4.0 / pi, 1e-14);
    const double c2 = 0.75;  // cos^2 30
    EXPECT_NEAR(distribution_at(model, 30.0), 0.25 / (pi * std::pow(c2 * (0.25 - 1.0) + 1.0, 2.0)), 1e-14);
    EXPECT_NEAR(fresnel_at(model, 1, 0.0), 0.25, 1e-15);
    EXPECT_EQ(fresnel_at(model, 2, 90.0), 1.0);
    EXPECT_NEAR(fresnel_at(model, 0, 60.0), 0.25 + 0.75 / 32.0, 1e-14);
    // l and v mirrored at 60 degrees: G1 = 2 / (1 + sqrt(1 + alpha^2 tan^2)) twice, D at the normal, n.l rs = D G F / (4 n.v).
    const double G1 = 2.0 / (1.0 + std::sqrt(1.0 + 0.25 * 3.0));
    EXPECT_NEAR(masking_at(model, 60.0, 60.0), G1 * G1, 1e-14);
    EXPECT_NEAR(lobe_at(model, 60.0, 60.0), 4.0 / pi * G1 * G1 * (0.25 + 0.75 / 32.0) / (4.0 * 0.5), 1e-13);
    EXPECT_EQ(lobe_at(model, 90.0, 60.0), 0.0);
    EXPECT_EQ(masking_at(model, -90.0, 60.0), 0.0);
}

TEST(BrdfCurves, AnglesAreDenseWhereTheLobeIsNarrow) {
    const std::vector<double> angles = angles_around(45.0, 1e-4, -90.0, 90.0);
    EXPECT_EQ(angles.front(), -90.0);
    EXPECT_EQ(angles.back(), 90.0);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end()));
    const double degree = 1e-4 * 180.0 / pi;
    const auto within = [&](double away) {
        return std::count_if(angles.begin(), angles.end(), [&](double a) { return std::fabs(a - 45.0) <= away; });
    };
    EXPECT_GT(within(degree), 50);
    EXPECT_LT(angles.size(), 1000u);
}

TEST(SvgChart, CurvesStandWhereTheAxesSay) {
    const Axis x{0.0, 90.0, false, "x", 30.0}, y{1e-2, 1e2, true, "y & <z>", 0.0};
    EXPECT_EQ(place_on(x, 45.0), 0.5);
    EXPECT_DOUBLE_EQ(place_on(y, 1.0), 0.5);
    EXPECT_LT(place_on(y, 0.0), -10.0);
    // Cut where it leaves the frame: log10 falls from 2 to -6 over 80 degrees, so to -2 at 40.
    const std::string svg = svg_chart({100, 50, 180, 40}, "t", x, y, {{"red", false, {{0.0, 1e2}, {80.0, 1e-6}, {90.0, 1e-6}}}});
    EXPECT_NE(svg.find(R"(<path d="M100.00 50.00 L180.00 90.00" fill="none" stroke="red")"), std::string::npos) << svg;
    EXPECT_NE(svg.find("y &amp; &lt;z&gt;"), std::string::npos);
    for (const char* tick : {">0<", ">30<", ">60<", ">90<", ">0.01<", ">0.1<", ">1<", ">10<", ">100<"})
        EXPECT_NE(svg.find(tick), std::string::npos) << tick;
}

TEST(SvgChart, PolarAnglesCountFromAboveToTheRight) {
    const std::string svg = svg_polar({100, 100}, 50, {{"red", true, {{0.0, 1.0}, {90.0, 0.5}, {-90.0, 1.0}}}});
    EXPECT_NE(svg.find(R"(<path d="M100.00 50.00 L125.00 100.00 L50.00 100.00")"), std::string::npos) << svg;
    EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
}

/// Every tag is closed in its order and every attribute quoted: enough of XML for a picture without entities of its own.
void expect_xml(const std::string& text) {
    std::vector<std::string> open;
    ASSERT_TRUE(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "));
    for (std::size_t at = text.find('<', 2); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = text.substr(at + 1, end - at - 1);
        ASSERT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
        ASSERT_EQ(tag.find('<'), std::string::npos) << tag;
        if (tag.starts_with('/')) {
            ASSERT_FALSE(open.empty());
            ASSERT_EQ(tag.substr(1), open.back());
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(tag.substr(0, tag.find(' ')));
        }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_FALSE(std::regex_search(text, std::regex("[^a-z](nan|inf)")));
}

TEST(BrdfPlot, EveryChoiceIsAPicture) {
    const test::Workplace here;
    const std::vector<std::vector<std::string>> choices{
        {},
        {"--alpha", "1e-4,2"},
        {"--alpha", "1e-8,10"},
        {"--D", "beckmann", "--G", "beckmann", "--F", "dielectric", "--eta", "0.7", "--view", "80"},
        {"--D", "blinn", "--G", "cook-torrance", "--alpha", "0.05,0.5,2", "--view", "0"},
        {"--D", "gaussian", "--G", "none", "--F", "one", "--raw", "on", "--view", "89.9"},
        {"--preset", "reference", "--material", "shiny-gold"},
        {"--preset", "effects"},
        {"--preset", "lecture", "--half", "nv", "--denominator", "clamped"},
        {"--D", "blinn", "--blinn-power", "inverse-roughness"},
        {"--preset", "phong-lights"},
        {"--shading", "blinn-phong", "--exponent", "1e6"},
    };
    for (const std::vector<std::string>& choice : choices) {
        std::vector<std::string> words{"brdf", "plot"};
        words.insert(words.end(), choice.begin(), choice.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        expect_xml(outcome.out);
    }
}

/// The points of that colour's curve number `index`: the polar one, D, G.
std::vector<Vec2> points_of(const std::string& svg, const std::string& color, int index = 0) {
    std::vector<Vec2> points;
    const std::string line = "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.8\"";
    std::size_t stroke = svg.find(line);
    for (int i = 0; i < index && stroke != std::string::npos; ++i) stroke = svg.find(line, stroke + 1);
    if (stroke == std::string::npos) return points;
    const std::size_t begin = svg.rfind("<path d=\"", stroke) + 9;
    std::istringstream in(svg.substr(begin, svg.find('"', begin) - begin));
    char command = 0;
    for (Vec2 p; in >> command >> p.x >> p.y;) points.push_back(p);
    return points;
}

TEST(BrdfPlot, TheLobesAreDrawnAsTheFunctionsSay) {
    const test::Workplace here;
    const std::string svg = run({"brdf", "plot", "--alpha", "0.4", "--view", "30", "--eta", "2"}).out;
    const std::vector<Vec2> points = points_of(svg, "#0072b2");
    ASSERT_GT(points.size(), 300u);
    SurfaceModel model;
    model.alpha = 0.4;
    model.interface[0] = model.interface[1] = model.interface[2] = interface_of(2.0);
    double peak = 0.0, longest = 0.0;
    for (double angle = -89.9; angle < 90.0; angle += 0.1) peak = std::max(peak, lobe_at(model, angle, 30.0));
    for (const Vec2& p : points) {
        const Vec2 from(p.x - 255.0, 345.0 - p.y);  // of the polar chart's centre
        const double radius = std::hypot(from.x, from.y), angle = std::atan2(from.x, from.y) * (180.0 / pi);
        longest = std::max(longest, radius);
        if (radius < 20.0) continue;
        EXPECT_NEAR(radius, 210.0 * lobe_at(model, angle, 30.0) / peak, 0.5) << angle;
    }
    EXPECT_NEAR(longest, 210.0, 0.05);
    EXPECT_NE(svg.find("alpha 0.4: maximum " + std::to_string(peak).substr(0, 4)), std::string::npos);
}

/// Calls `expect` with the angle and the value of every point of a curve that begins at the frame's left end and reaches `last`.
void each_point(const std::vector<Vec2>& points, const Frame& frame, const Axis& x, const Axis& y, double last, const auto& expect) {
    ASSERT_GT(points.size(), 50u);
    EXPECT_NEAR(points.front().x, frame.x, 0.01);
    EXPECT_GT(points.back().x, frame.x + place_on(x, last) * frame.width - 0.01);
    for (const Vec2& p : points) {
        const double share = (p.x - frame.x) / frame.width, height = 1.0 - (p.y - frame.y) / frame.height;
        const auto between = [](const Axis& axis, double t) {
            return axis.logarithmic ? axis.least * std::pow(axis.most / axis.least, t) : axis.least + t * (axis.most - axis.least);
        };
        expect(between(x, share), between(y, height));
    }
}

SurfaceModel model_of(double alpha, const std::vector<double>& eta) {
    SurfaceModel model;
    model.alpha = alpha;
    for (std::size_t i = 0; i < 3; ++i) model.interface[i] = interface_of(eta[i]);
    return model;
}

const std::string first_color = "#0072b2", second_color = "#d55e00";
const Frame D_frame{590, 90, 380, 135}, G_frame{590, 288, 380, 120}, F_frame{590, 471, 380, 120};

/// Of two widths, each with its own curve, to the horizon; peaks 1 / (pi alpha^2) of 7.96 and 0.88.
void expect_D_chart(const std::string& svg, double norm, double bottom, double top) {
    for (const auto& [color, alpha] : {std::pair{first_color, 0.2}, std::pair{second_color, 0.6}}) {
        const SurfaceModel model = model_of(alpha, {1.5, 1.5, 1.5});
        each_point(points_of(svg, color, 1), D_frame, {0.0, 90.0, false, "", 15.0}, {bottom, top, true, "", 0.0}, 90.0,
                   [&](double angle, double value) { EXPECT_NEAR(value / (norm * distribution_at(model, angle)), 1.0, 0.01) << angle; });
    }
}

TEST(BrdfPlot, TheChartOfDIsDrawnAsTheFunctionSays) {
    const test::Workplace here;
    expect_D_chart(run({"brdf", "plot", "--alpha", "0.2,0.6"}).out, 1.0, 1e-5, 10.0);
    const std::string four = run({"brdf", "plot", "--alpha", "0.2,0.6", "--norm", "ct1982"}).out;
    expect_D_chart(four, 4.0, 1e-4, 100.0);
    EXPECT_NE(four.find(">4 D<"), std::string::npos);
    // A narrow lobe stands over the logarithm of the angle, until it leaves the chart at 1e-5 of its peak, beyond 7.5 degrees.
    const SurfaceModel narrow = model_of(0.01, {1.5, 1.5, 1.5});
    each_point(points_of(run({"brdf", "plot", "--alpha", "0.01"}).out, first_color, 1), D_frame, {0.01, 90.0, true, "", 0.0},
               {1e-1, 1e4, true, "", 0.0}, 7.5, [&](double angle, double value) {
                   if (value > 0.11) {
                       EXPECT_NEAR(value / distribution_at(narrow, angle), 1.0, 0.01) << angle;
                   }
               });
}

TEST(BrdfPlot, TheChartOfGIsDrawnAsTheFunctionSays) {
    const test::Workplace here;
    const std::string svg = run({"brdf", "plot", "--alpha", "0.2,0.6", "--view", "65"}).out;
    for (const auto& [color, alpha] : {std::pair{first_color, 0.2}, std::pair{second_color, 0.6}}) {
        const SurfaceModel model = model_of(alpha, {1.5, 1.5, 1.5});
        each_point(points_of(svg, color, 2), G_frame, {-90.0, 90.0, false, "", 30.0}, {0.0, 1.0, false, "", 0.25}, 90.0,
                   [&](double angle, double value) {
                       if (std::fabs(angle) < 89.0) {
                           EXPECT_NEAR(value, masking_at(model, angle, 65.0), 0.003) << angle;
                       }
                   });
    }
}

TEST(BrdfPlot, TheChartOfFHasACurveForEachChannel) {
    const test::Workplace here;
    const std::vector<double> eta{1.3, 2.0, 4.0};
    const std::string svg = run({"brdf", "plot", "--F", "dielectric", "--eta", "1.3,2,4"}).out;
    SurfaceModel model = model_of(0.3, eta);
    model.terms.F = Fresnel::dielectric;
    const Axis x{0.0, 90.0, false, "", 15.0}, y{0.0, 1.0, false, "", 0.25};
    const std::string colors[] = {"#c00000", "#00902a", "#0040d0"};
    for (int channel = 0; channel < 3; ++channel)
        each_point(points_of(svg, colors[channel]), F_frame, x, y, 90.0, [&](double angle, double value) {
            if (angle < 89.0) {
                EXPECT_NEAR(value, fresnel_at(model, channel, angle), 0.003) << channel << " " << angle;
            }
        });
    // One for all where they do not differ.
    const SurfaceModel grey = model_of(0.3, {2.0, 2.0, 2.0});
    const std::string one = run({"brdf", "plot", "--eta", "2"}).out;
    EXPECT_TRUE(points_of(one, colors[0]).empty());
    each_point(points_of(one, "#222"), F_frame, x, y, 90.0, [&](double angle, double value) {
        if (angle < 89.0) {
            EXPECT_NEAR(value, fresnel_at(grey, 0, angle), 0.003) << angle;
        }
    });
}

/// Where a text of the picture stands, and the side of that place on which it is.
std::pair<double, std::string> place_of(const std::string& svg, const std::string& text) {
    std::smatch found;
    const std::regex pattern("<text x=\"([^\"]*)\"[^>]*text-anchor=\"([a-z]*)\"[^>]*>" + text + "</text>");
    if (!std::regex_search(svg, found, pattern)) return {0.0, "nowhere"};
    return {std::stod(found[1]), found[2]};
}

TEST(BrdfPlot, TheViewerIsLeftAndTheMirrorDirectionRight) {
    const test::Workplace here;
    constexpr double center = 255.0;
    const std::string svg = run({"brdf", "plot", "--view", "40"}).out;
    const double away = 1.13 * 210.0 * std::sin(radians(40.0));
    const auto viewer = place_of(svg, "v"), mirror = place_of(svg, "mirror");
    EXPECT_NEAR(viewer.first, center - away, 6.0);
    EXPECT_NEAR(mirror.first, center + away, 6.0);
    // The lobe is on the mirror's side, too.
    const std::vector<Vec2> points = points_of(svg, first_color);
    const auto longest = std::max_element(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) {
        return std::hypot(a.x - center, a.y - 345.0) < std::hypot(b.x - center, b.y - 345.0);
    });
    EXPECT_GT(longest->x, center + 100.0);
    // Where both are one their names are apart.
    const std::string above = run({"brdf", "plot", "--view", "0"}).out;
    const auto v = place_of(above, "v"), m = place_of(above, "mirror");
    EXPECT_EQ(v.second, "end");
    EXPECT_EQ(m.second, "start");
    EXPECT_GE(m.first - v.first, 6.0);
}

TEST(BrdfPlot, AFileAppearsWhole) {
    const test::Workplace here;
    const Outcome outcome = run({"brdf", "plot", "-o", "plot.svg"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(here.files(), std::vector<std::string>{"plot.svg"});
    EXPECT_EQ(here.read("plot.svg"), run({"brdf", "plot"}).out);
    for (const char* name : {"plot", "PLOT.SVG"}) EXPECT_EQ(run({"brdf", "plot", "-o", name}).status, 0) << name;
    const Outcome nowhere = run({"brdf", "plot", "-o", "gone/plot.svg"});
    EXPECT_EQ(nowhere.status, 3);
    EXPECT_NE(nowhere.err.find("gone/plot.svg"), std::string::npos);
}

TEST(BrdfPlot, MistakesAreNamed) {
    const test::Workplace here;
    const auto fails = [](std::vector<std::string> words, const std::string& message) {
        words.insert(words.begin(), {"brdf", "plot"});
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "raytrace: " + message + "\n");
    };
    fails({"--f0", "0.5", "--eta", "1.5"}, "f0: 'eta' is stated as well, and each says what the surface reflects; expected one of them");
    fails({"--D", "phong"}, "D: 'phong' is unknown; expected one of ggx, beckmann, blinn, gaussian");
    fails({"--alpha", "0"}, "alpha: 0 is outside 1e-08 to 10");
    fails({"--alpha", "0.1,wide"}, "alpha: 'wide' is no number");
    fails({"--alpha", "1,1,1,1,1,1,1,1,1"}, "alpha: at most 8 curves");
    fails({"--view", "90"}, "view: 90 is outside 0 to 89.9");
    fails({"--shading", "povray"}, "brdf plot: POV-Ray's own finish model is not of the catalogue");
    fails({"--shading", "none"}, "brdf plot: shading 'none' has no lobe");
    fails({"--material", "mirror"}, "brdf plot: alpha 0 is a mirror, which has no lobe; choose widths by --alpha");
    fails({"--shading=phong", "--exponent=9", "--alpha=1"}, "brdf plot: --exponent and --alpha both state the width of the lobe");
    fails({"-o", "a.png"}, "output: '.png' is not the ending of an SVG file; expected '.svg' or none");
    fails({"--sigma", "1"}, "unknown option '--sigma'");
    fails({"lobe"}, "brdf plot: unexpected 'lobe'; see raytrace brdf plot --help");
}

}  // namespace
}  // namespace rt::brdf_plot_test
