#include "syntax/parse_shape.h"

#include <algorithm>
#include <array>

namespace rt {

namespace {

constexpr double sphere_limit = 1e-9;  ///< a torus whose major radius is that much smaller than the minor one is a sphere

/// A vector and the comma that may follow it.
Vec3 vector_then_comma(Reader& reader) {
    const Vec3 v = reader.parse_vector();
    reader.accept_comma();
    return v;
}

double float_then_comma(Reader& reader) {
    const double x = reader.parse_float();
    reader.accept_comma();
    return x;
}

ParsedShape parse_sphere(Reader& reader) {
    const Vec3 center = vector_then_comma(reader);
    return Sphere{center, std::fabs(reader.parse_float())};
}

ParsedShape parse_plane(Reader& reader) {
    const Vec3 normal = reader.parse_vector();
    if (length(normal) < epsilon) reader.fail(reader.peek().span, "Degenerate plane normal.");
    reader.accept_comma();
    return Plane{unit(normal), reader.parse_float()};
}

ParsedShape parse_box(Reader& reader) {
    const Vec3 a = vector_then_comma(reader);
    const Vec3 b = reader.parse_vector();
    return Box{glm::min(a, b), glm::max(a, b)};
}

ParsedShape finish_cone(Reader& reader, Cone cone, std::string_view degenerate) {
    if (length(cone.cap - cone.base) < epsilon) reader.fail(reader.peek().span, degenerate);
    cone.open = reader.accept(Word::open);
    return cone;
}

/// POV-Ray's cones of negative radii, as measured: two negative ones make a cylinder of the smaller; one of opposite sign makes two cones
/// tip to tip. Of a negative end that is wider than the other POV-Ray shows what is seen through a box as narrow as the other, which
/// depends on the directions of the axes; the whole is drawn here.
void mend_negative_radii(Reader& reader, Cone& cone) {
    const double smaller = std::fmin(cone.base_radius, cone.cap_radius), larger = std::fmax(cone.base_radius, cone.cap_radius);
    if (smaller < 0.0 && larger <= 0.0)
        cone.base_radius = cone.cap_radius = -larger;
    else if (-smaller > larger)
        reader.warn(reader.peek().span, "POV-Ray shows only a part of a cone whose negative radius is the larger one. It is drawn whole.");
}

ParsedShape parse_cone(Reader& reader) {
    Cone cone;
    cone.base = vector_then_comma(reader);
    cone.base_radius = float_then_comma(reader);
    cone.cap = vector_then_comma(reader);
    cone.cap_radius = reader.parse_float();
    mend_negative_radii(reader, cone);
    return finish_cone(reader, cone, "Degenerate cone/cylinder.");
}

ParsedShape parse_cylinder(Reader& reader) {
    Cone cone;
    cone.base = vector_then_comma(reader);
    cone.cap = vector_then_comma(reader);
    cone.base_radius = cone.cap_radius = std::fabs(reader.parse_float());
    return finish_cone(reader, cone, "Degenerate cylinder, base point = apex point.");
}

/// A major radius of zero makes a sphere, of which POV-Ray shows speckles: all roots of its quartic are double ones.
ParsedShape parse_torus(Reader& reader) {
    const Torus torus{float_then_comma(reader), reader.parse_float()};
    const double R = torus.major_radius, r = torus.minor_radius;
    if (r == 0.0) return std::nullopt;
    if (r < 0.0) {
        reader.warn(reader.peek().span, R < 0.0 ? "POV-Ray shows only a part of some tori with two negative radii. It is drawn whole."
                                                : "A torus with a negative minor radius is not visible.");
        if (R >= 0.0) return std::nullopt;
    }
    if (std::fabs(R) <= sphere_limit * std::fabs(r)) return Sphere{Vec3(0.0), std::fabs(r)};
    return torus;
}

ParsedShape parse_disc(Reader& reader) {
    const Vec3 center = vector_then_comma(reader);
    const Vec3 normal = vector_then_comma(reader);
    const double radius = std::fabs(float_then_comma(reader));
    const double hole = reader.at_expression() ? std::fabs(reader.parse_float()) : 0.0;
    if (length(normal) < epsilon) return std::nullopt;
    return Disc{center, unit(normal), radius, hole};
}

ParsedShape degenerate_triangle(Reader& reader) {
    reader.warn(reader.peek().span, "Degenerate triangle. Please remove.");
    return std::nullopt;
}

ParsedShape parse_triangle(Reader& reader) {
    const Vec3 a = vector_then_comma(reader);
    const Vec3 b = vector_then_comma(reader);
    const Vec3 c = reader.parse_vector();
    if (is_degenerate_triangle(a, b, c)) return degenerate_triangle(reader);
    return Triangle{a, b, c};
}

/// Outside a mesh the three normals must lie strictly on one side of the triangle.
ParsedShape parse_smooth_triangle(Reader& reader) {
    std::array<Vec3, 3> corner;
    std::array<Vec3, 3> normal;
    for (int i = 0; i < 3; ++i) {
        corner[i] = vector_then_comma(reader);
        normal[i] = reader.parse_vector();
        if (i != 2) reader.accept_comma();
    }
    if (is_degenerate_triangle(corner[0], corner[1], corner[2])) return degenerate_triangle(reader);
    const Vec3 across = unit(cross(corner[1] - corner[0], corner[2] - corner[0]));
    int sides = 0;
    for (Vec3& n : normal) {
        if (!(length(n) > 0.0)) return degenerate_triangle(reader);
        n = unit(n);
        const double side = dot(n, across);
        sides += (side > 0.0) - (side < 0.0);
    }
    if (std::abs(sides) != 3) return degenerate_triangle(reader);
    return SmoothTriangle{corner[0], corner[1], corner[2], normal[0], normal[1], normal[2]};
}

/// POV-Ray takes exponents of zero and below as well, of which it shows nothing that could be foretold.
ParsedShape parse_superellipsoid(Reader& reader) {
    const Vec2 e = reader.parse_vector2();
    const double least = 1e-3;
    if (!(e.x > 0.0 && e.y > 0.0)) {
        reader.warn(reader.peek().span, "The exponents of a superellipsoid are to be above 0. It is not visible.");
        return std::nullopt;
    }
    return Superellipsoid{std::fmax(e.x, least), std::fmax(e.y, least)};
}

constexpr std::array<ShapeSyntax, 27> shapes{{
    {Word::sphere, parse_sphere},
    {Word::plane, parse_plane},
    {Word::box, parse_box},
    {Word::cone, parse_cone},
    {Word::cylinder, parse_cylinder},
    {Word::torus, parse_torus, true},
    {Word::disc, parse_disc},
    {Word::triangle, parse_triangle},
    {Word::smooth_triangle, parse_smooth_triangle},
    {Word::polygon, parse_polygon},
    {Word::mesh, parse_mesh, false, true},
    {Word::mesh2, parse_mesh2, false, true},
    {Word::quadric, parse_quadric},
    {Word::cubic, parse_cubic, true},
    {Word::quartic, parse_quartic, true},
    {Word::poly, parse_poly, true},
    {Word::polynomial, parse_polynomial, true},
    {Word::prism, parse_prism, true},
    {Word::lathe, parse_lathe, true},
    {Word::sor, parse_sor, true},
    {Word::blob, parse_blob, true, true},
    {Word::text, parse_text},
    {Word::superellipsoid, parse_superellipsoid},
    {Word::bicubic_patch, parse_bicubic_patch},
    {Word::height_field, parse_height_field, false, true},
    {Word::sphere_sweep, parse_sphere_sweep},
    {Word::isosurface, parse_isosurface},
}};

}  // namespace

const ShapeSyntax* find_shape(Word w) {
    const auto found = std::find_if(shapes.begin(), shapes.end(), [w](const ShapeSyntax& s) { return s.word == w; });
    return found == shapes.end() ? nullptr : &*found;
}

}  // namespace rt
