// prism { }
#include <algorithm>

#include "syntax/parameters.h"
#include "syntax/parse_curve.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

bool same(const Vec2& a, const Vec2& b) { return std::fabs(a.x - b.x) < epsilon && std::fabs(a.y - b.y) < epsilon; }

void check_prism_count(Reader& reader, SplineKind spline, std::size_t count) {
    const Span place = reader.peek().span;
    if (spline == SplineKind::linear && count < 3) reader.fail(place, "Prism with linear splines must have at least three points.");
    if (spline == SplineKind::quadratic && count < 5) reader.fail(place, "Prism with quadratic splines must have at least five points.");
    if (spline == SplineKind::cubic && count < 6) reader.fail(place, "Prism with cubic splines must have at least six points.");
    if (spline == SplineKind::bezier && count % 4 != 0) reader.fail(place, "Prism with Bezier splines must have four points per segment.");
}

void warn_open(Reader& reader) { reader.warn(reader.peek().span, "Prism not closed. Ignoring it."); }

/// Adds the pieces of one loop, whose last point is to be its first one exactly.
void add_loop(std::vector<CurvePiece> pieces, Outline& outline) {
    if (pieces.empty()) return;
    pieces.back().points[3] = pieces.front().points[0];
    for (const CurvePiece& piece : pieces) outline.add(piece);
}

/// Loops end where their first point recurs. The last one is closed by a line, but a single point is none.
void add_linear(Reader& reader, std::vector<Vec2> points, Outline& outline) {
    for (std::size_t first = 0; first + 1 < points.size();) {
        std::size_t last = first + 1;
        while (last < points.size() && !same(points[last], points[first])) ++last;
        if (last == points.size()) {
            reader.warn(reader.peek().span, "Linear prism not closed. Closing it.");
            points.push_back(points[first]);
        }
        add_loop(spline_pieces(SplineKind::linear, {points.begin() + static_cast<std::ptrdiff_t>(first),
                                                    points.begin() + static_cast<std::ptrdiff_t>(last) + 1}),
                 outline);
        first = last + 1;
    }
}

/// The first point of a loop only bends it, the second one is where it begins and ends; after a cubic one comes another that only bends.
void add_bent(Reader& reader, SplineKind spline, const std::vector<Vec2>& points, Outline& outline) {
    const std::size_t behind = spline == SplineKind::cubic ? 1 : 0;
    for (std::size_t first = 0; first < points.size();) {
        std::size_t last = first + 2;
        while (last + behind < points.size() && !same(points[last], points[first + 1])) ++last;
        if (last + behind >= points.size()) {
            warn_open(reader);
            return;
        }
        const std::size_t end = last + behind + 1;
        add_loop(
            spline_pieces(spline, {points.begin() + static_cast<std::ptrdiff_t>(first), points.begin() + static_cast<std::ptrdiff_t>(end)}),
            outline);
        first = end;
    }
}

/// Pieces that begin where the last one ended make loops.
void add_bezier(Reader& reader, const std::vector<Vec2>& points, Outline& outline) {
    std::vector<CurvePiece> loop;
    for (CurvePiece piece : spline_pieces(SplineKind::bezier, points)) {
        if (!loop.empty()) piece.points[0] = loop.back().points[3];
        loop.push_back(piece);
        if (!same(piece.points[3], loop.front().points[0])) continue;
        add_loop(std::move(loop), outline);
        loop.clear();
    }
    if (!loop.empty()) warn_open(reader);
}

}  // namespace

ParsedShape parse_prism(Reader& reader) {
    Prism prism;
    SplineKind spline = SplineKind::linear;
    for (;;) {
        if (accept_spline(reader, spline)) continue;
        if (reader.accept(Word::linear_sweep))
            prism.conic = false;
        else if (reader.accept(Word::conic_sweep))
            prism.conic = true;
        else
            break;
    }
    const double a = reader.parse_float();
    reader.accept_comma();
    const double b = reader.parse_float();
    reader.accept_comma();
    prism.low = std::fmin(a, b);
    prism.high = std::fmax(a, b);
    const std::size_t count = parse_count(reader);
    check_prism_count(reader, spline, count);
    const std::vector<Vec2> points = parse_points(reader, count);
    prism.open = reader.accept(Word::open);
    Outline outline;
    if (spline == SplineKind::linear)
        add_linear(reader, points, outline);
    else if (spline == SplineKind::bezier)
        add_bezier(reader, points, outline);
    else
        add_bent(reader, spline, points, outline);
    if (outline.pieces.empty()) {
        if (spline != SplineKind::bezier) reader.fail(reader.peek().span, "Too few points in prism.");
        return std::nullopt;
    }
    turn_outwards(outline);
    prism.outline = std::move(outline);
    return prism;
}

}  // namespace rt
