// Surfaces of revolution: lathe and sor.
#include "syntax/parameters.h"
#include "syntax/parse_curve.h"
#include "syntax/parse_shape.h"

namespace rt {

bool accept_spline(Reader& reader, SplineKind& spline) {
    if (reader.accept(Word::linear_spline))
        spline = SplineKind::linear;
    else if (reader.accept(Word::quadratic_spline))
        spline = SplineKind::quadratic;
    else if (reader.accept(Word::cubic_spline))
        spline = SplineKind::cubic;
    else if (reader.accept(Word::bezier_spline))
        spline = SplineKind::bezier;
    else
        return false;
    return true;
}

std::vector<Vec2> parse_points(Reader& reader, std::size_t count) {
    std::vector<Vec2> points;
    points.reserve(reserve_limit(reader, count, 2));
    for (std::size_t i = 0; i < count; ++i) {
        reader.accept_comma();
        points.push_back(reader.parse_vector2());
    }
    return points;
}

namespace {

void check_lathe_count(Reader& reader, SplineKind spline, std::size_t count) {
    const Span place = reader.peek().span;
    if (spline == SplineKind::linear && count < 2) reader.fail(place, "Lathe with linear splines must have at least two points.");
    if (spline == SplineKind::quadratic && count < 3) reader.fail(place, "Lathe with quadratic splines must have at least three points.");
    if (spline == SplineKind::cubic && count < 4)
        reader.fail(place, "Prism with cubic splines must have at least four points.");  // its word
    if (spline == SplineKind::bezier && count % 4 != 0) reader.fail(place, "Lathe with Bezier splines must have four points per segment.");
}

/// The slice between the points b and c; the curve through them leaves with the slopes of the chords a c and b d.
SorSlice slice(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double third = (c.y - b.y) / 3.0;
    const double b_slope = 2.0 * b.x * (c.x - a.x) / (c.y - a.y), c_slope = 2.0 * c.x * (d.x - b.x) / (d.y - b.y);
    return {b.y, c.y, {sqr(b.x), sqr(b.x) + third * b_slope, sqr(c.x) - third * c_slope, sqr(c.x)}};
}

}  // namespace

ParsedShape parse_lathe(Reader& reader) {
    SplineKind spline = SplineKind::linear;
    while (accept_spline(reader, spline)) continue;
    const std::size_t count = parse_count(reader);
    check_lathe_count(reader, spline, count);
    const std::vector<Vec2> points = parse_points(reader, count);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (points[i].x < 0.0) reader.fail(reader.peek().span, "Incorrect point in lathe.");
    Outline curve;
    for (const CurvePiece& piece : spline_pieces(spline, points)) curve.add(piece);
    if (curve.pieces.empty()) return std::nullopt;
    const CurvePiece first = curve.pieces.front();
    turn_outwards(curve);
    return Lathe{.curve = curve, .turned = curve.pieces.front() != first};
}

ParsedShape parse_sor(Reader& reader) {
    constexpr std::string_view wrong = "Incorrect point in surface of revolution.";
    const std::size_t count = parse_count(reader);
    if (count < 4) reader.fail(reader.peek().span, "Surface of revolution must have at least four points.");
    const std::vector<Vec2> p = parse_points(reader, count);
    const Span place = reader.peek().span;
    for (std::size_t i = 0; i < count; ++i) {
        const bool outer = i < 2 || i + 1 == count;  // these may be as high as the one before
        if (p[i].x < 0.0 || (i > 0 && (outer ? p[i].y < p[i - 1].y : p[i].y <= p[i - 1].y))) reader.fail(place, wrong);
    }
    Sor sor;
    sor.open = reader.accept(Word::open);
    std::vector<SorSlice> slices;
    for (std::size_t i = 0; i + 3 < count; ++i) slices.push_back(slice(p[i], p[i + 1], p[i + 2], p[i + 3]));
    sor.slices = std::move(slices);
    return sor;
}

}  // namespace rt
