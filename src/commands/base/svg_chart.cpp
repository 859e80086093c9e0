#include "commands/base/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

constexpr std::string_view grid = "#ddd", border = "#888";

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

/// The values at which the axis has ticks: steps, or the decades, at most about eight of them.
std::vector<double> ticks(const Axis& axis) {
    std::vector<double> result;
    if (!axis.logarithmic) {
        const int count = static_cast<int>(std::floor((axis.most - axis.least) / axis.step + 1e-9));
        for (int i = 0; i <= count; ++i) result.push_back(axis.least + i * axis.step);
        return result;
    }
    const int first = static_cast<int>(std::ceil(std::log10(axis.least) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.most) + 1e-9)), stride = std::max(1, (last - first + 7) / 8);
    for (int decade = first; decade <= last; decade += stride) result.push_back(std::pow(10.0, decade));
    return result;
}

std::string tick_text(const Axis& axis, double value) {
    if (axis.logarithmic && (value < 0.0099 || value > 1001.0)) return fmt::format("1e{}", std::lround(std::log10(value)));
    return fmt::format("{:.4g}", value);
}

/// A path through the points; a new piece begins behind every point that is no number.
std::string path(const std::vector<Vec2>& points, const ChartCurve& curve) {
    std::string d;
    bool drawing = false;
    for (const Vec2& p : points) {
        const bool known = std::isfinite(p.x) && std::isfinite(p.y);
        if (known) d += fmt::format("{}{:.2f} {:.2f}", drawing ? " L" : " M", p.x, p.y);
        drawing = known;
    }
    if (d.empty()) return "";
    return fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="1.8" stroke-linejoin="round"{}/>)"
                       "\n",
                       d.substr(1), curve.color, curve.dashed ? R"( stroke-dasharray="7 4")" : "");
}

/// The part of a curve inside the frame, with the points where it leaves the frame above or below. `p` counts from 0 to 1 on both axes.
std::vector<Vec2> cut(const std::vector<Vec2>& p) {
    std::vector<Vec2> result;
    const Vec2 gap(NAN, NAN);
    const auto inside = [](const Vec2& q) { return q.y >= 0.0 && q.y <= 1.0; };
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (i > 0 && inside(p[i - 1]) != inside(p[i])) {
            const double outside = inside(p[i]) ? p[i - 1].y : p[i].y, edge = outside < 0.0 ? 0.0 : 1.0;
            result.push_back(p[i - 1] + (p[i] - p[i - 1]) * ((edge - p[i - 1].y) / (p[i].y - p[i - 1].y)));
        }
        result.push_back(inside(p[i]) ? p[i] : gap);
    }
    return result;
}

}  // namespace

double place_on(const Axis& axis, double value) {
    if (!axis.logarithmic) return (value - axis.least) / (axis.most - axis.least);
    constexpr double smallest = 1e-300;  // stands far below any axis
    return std::log(std::max(value, smallest) / axis.least) / std::log(axis.most / axis.least);
}

std::string svg_text(const SvgText& where, std::string_view text) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{}" text-anchor="{}" fill="{}">{}</text>)"
                       "\n",
                       where.x, where.y, where.size, where.anchor, where.color, escaped(text));
}

std::string svg_line(const Vec2& from, const Vec2& to, std::string_view color, double width) {
    return fmt::format(R"(<line x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}" stroke="{}" stroke-width="{}"/>)"
                       "\n",
                       from.x, from.y, to.x, to.y, color, width);
}

std::string svg_chart(const Frame& frame, std::string_view title, const Axis& x, const Axis& y, const std::vector<ChartCurve>& curves) {
    const double right = frame.x + frame.width, bottom = frame.y + frame.height;
    std::string svg = svg_text({frame.x, frame.y - 9, 14}, title);
    for (const double tick : ticks(x)) {
        const double at = frame.x + frame.width * place_on(x, tick);
        svg += svg_line({at, frame.y}, {at, bottom}, grid) + svg_text({at, bottom + 16, 12, "middle"}, tick_text(x, tick));
    }
    for (const double tick : ticks(y)) {
        const double at = bottom - frame.height * place_on(y, tick);
        svg += svg_line({frame.x, at}, {right, at}, grid) + svg_text({frame.x - 6, at + 4, 12, "end"}, tick_text(y, tick));
    }
    svg += svg_text({right, bottom + 32, 12, "end"}, x.label) + svg_text({right, frame.y - 9, 12, "end"}, y.label);
    svg += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="{}"/>)"
                       "\n",
                       frame.x, frame.y, frame.width, frame.height, border);
    for (const ChartCurve& curve : curves) {
        std::vector<Vec2> points;
        for (const Vec2& p : curve.points) points.emplace_back(place_on(x, p.x), place_on(y, p.y));
        points = cut(points);
        for (Vec2& p : points) p = {frame.x + frame.width * p.x, bottom - frame.height * p.y};
        svg += path(points, curve);
    }
    return svg;
}

std::string svg_polar(const Vec2& center, double radius, const std::vector<ChartCurve>& curves) {
    const auto at = [&](double degrees, double r) {
        return center + radius * r * Vec2(std::sin(radians(degrees)), -std::cos(radians(degrees)));
    };
    std::string svg;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const double r = radius * share;
        svg += fmt::format(R"(<path d="M{:.2f} {:.2f} A{:.2f} {:.2f} 0 0 1 {:.2f} {:.2f}" fill="none" stroke="{}"/>)"
                           "\n",
                           center.x - r, center.y, r, r, center.x + r, center.y, share == 1.0 ? border : grid);
        svg += svg_text({center.x + r, center.y + 17, 12, "middle"}, fmt::format("{:g}", share));
    }
    for (int degrees = -90; degrees <= 90; degrees += 15) {
        svg += svg_line(center, at(degrees, 1.0), grid);
        const Vec2 text = at(degrees, 1.06);
        if (std::abs(degrees) < 90) svg += svg_text({text.x, text.y + 4, 12, "middle"}, fmt::format("{}°", degrees));
    }
    svg += svg_line(at(-90, 1.0), at(90, 1.0), border);
    for (const ChartCurve& curve : curves) {
        std::vector<Vec2> points;
        for (const Vec2& p : curve.points) points.push_back(at(p.x, p.y));
        svg += path(points, curve);
    }
    return svg;
}

std::string svg_document(int width, int height, std::string_view content) {
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" font-family="DejaVu Sans, Verdana, sans-serif">
<rect width="{0}" height="{1}" fill="white"/>
{2}</svg>
)",
                       width, height, content);
}

}  // namespace rt
