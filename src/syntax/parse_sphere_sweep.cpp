// sphere_sweep { }
#include <algorithm>

#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

enum class SweepKind { linear, cubic, b_spline };

SweepKind parse_sweep_kind(Reader& reader) {
    if (reader.accept(Word::linear_spline)) return SweepKind::linear;
    if (reader.accept(Word::cubic_spline)) return SweepKind::cubic;
    if (reader.accept(Word::b_spline)) return SweepKind::b_spline;
    reader.fail(reader.peek().span, "Invalid type of interpolation.");
}

std::vector<SweepPiece> pieces_of(SweepKind kind, const std::vector<SweptSphere>& s) {
    std::vector<SweepPiece> pieces;
    if (kind == SweepKind::linear) {
        for (std::size_t i = 0; i + 1 < s.size(); ++i) pieces.push_back(sweep_line(s[i], s[i + 1]));
    } else {
        const auto piece = kind == SweepKind::cubic ? sweep_cubic : sweep_b_spline;
        for (std::size_t i = 0; i + 3 < s.size(); ++i) pieces.push_back(piece(s[i], s[i + 1], s[i + 2], s[i + 3]));
    }
    return pieces;
}

}  // namespace

ParsedShape parse_sphere_sweep(Reader& reader) {
    const SweepKind kind = parse_sweep_kind(reader);
    reader.accept_comma();
    const std::size_t count = parse_count(reader);
    if (count < (kind == SweepKind::linear ? 2u : 4u)) reader.fail(reader.peek().span, "Too few modeling spheres for interpolation type.");
    std::vector<SweptSphere> spheres;
    spheres.reserve(reserve_limit(reader, count, 2));
    for (std::size_t i = 0; i < count; ++i) {
        reader.accept_comma();
        SweptSphere sphere;
        sphere.center = reader.parse_vector();
        reader.accept_comma();
        sphere.radius = reader.parse_float();
        spheres.push_back(sphere);
    }
    if (std::any_of(spheres.begin(), spheres.end(), [](const SweptSphere& sphere) { return sphere.radius < 0.0; }))
        reader.warn(reader.peek().span, "POV-Ray shows only a part of a sphere sweep with negative radii. It is drawn whole.");
    if (reader.accept(Word::tolerance)) reader.parse_float();  // of POV-Ray's search; here the hits are as exact as the numbers
    return SphereSweep{pieces_of(kind, spheres)};
}

}  // namespace rt
