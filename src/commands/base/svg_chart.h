// Charts as SVG: axes with ticks and labels, curves, a polar half. Text in, text out; knows nothing of what is shown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace rt {

struct ChartCurve {
    std::string_view color;  ///< as SVG names it
    bool dashed = false;
    std::vector<Vec2> points;  ///< in the units of the axes; in a polar chart (angle in degrees, radius 0..1)
};

struct Axis {
    double least = 0.0, most = 1.0;  ///< above 0 where logarithmic
    bool logarithmic = false;
    std::string label;
    double step = 0.0;  ///< between ticks of a linear axis
};

/// Place of a chart's frame in the picture, in pixels; ticks and labels stand outside of it.
struct Frame {
    double x, y, width, height;
};

/// Where a value stands between the ends of the axis, 0 to 1 inside; values that a logarithmic axis cannot hold are far below 0.
double place_on(const Axis& axis, double value);

/// A chart with its title above it. Curves are cut at the frame.
std::string svg_chart(const Frame& frame, std::string_view title, const Axis& x, const Axis& y, const std::vector<ChartCurve>& curves);

/// The upper half of a polar chart of this radius, angles from -90 (left) to 90 degrees, with circles at quarters of it.
std::string svg_polar(const Vec2& center, double radius, const std::vector<ChartCurve>& curves);

struct SvgText {
    double x, y;
    int size = 13;
    std::string_view anchor = "start";
    std::string_view color = "#222";
};
std::string svg_text(const SvgText& where, std::string_view text);
std::string svg_line(const Vec2& from, const Vec2& to, std::string_view color, double width = 1.0);

/// The whole file: `content` on white.
std::string svg_document(int width, int height, std::string_view content);

}  // namespace rt
