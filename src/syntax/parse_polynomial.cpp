// Algebraic surfaces: quadric, cubic, quartic, poly, polynomial.
#include <fmt/format.h>

#include "geometry/roots.h"
#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

constexpr int highest_order = static_cast<int>(highest_degree);

int parse_order(Reader& reader, std::string_view shape) {
    const int order = parse_int(reader);
    if (order < 2 || order > highest_order) reader.fail(reader.peek().span, fmt::format("Order of {} is out of range.", shape));
    reader.accept_comma();
    return order;
}

/// `<` one number for each coefficient `>`.
ParsedShape parse_coefficients(Reader& reader, int order) {
    std::vector<double> coefficients(poly_coefficients(order));
    reader.expect('<');
    for (double& c : coefficients) {
        if (&c != &coefficients.front()) reader.accept_comma();
        c = reader.parse_float();
    }
    reader.expect('>');
    return make_poly(order, std::move(coefficients));
}

/// `(a, b, c)` of x^a y^b z^c. Of some negative ones POV-Ray makes a term that they do not name.
std::size_t parse_exponents(Reader& reader, int order) {
    reader.expect('(');
    const int a = parse_int(reader);
    reader.accept_comma();
    const int b = parse_int(reader);
    reader.accept_comma();
    const int c = parse_int(reader);
    reader.expect(')');
    if (a < 0 || b < 0 || c < 0 || a > order || b > order - a || c > order - a - b)
        reader.fail(reader.peek().span, "Coefficient of polynom is out of range.");
    return poly_index(order, a, b, c);
}

}  // namespace

ParsedShape parse_quadric(Reader& reader) {
    Quadric q;
    q.squares = reader.parse_vector();
    reader.accept_comma();
    q.products = reader.parse_vector();
    reader.accept_comma();
    q.linear = reader.parse_vector();
    reader.accept_comma();
    q.constant = reader.parse_float();
    return q;
}

ParsedShape parse_cubic(Reader& reader) { return parse_coefficients(reader, 3); }
ParsedShape parse_quartic(Reader& reader) { return parse_coefficients(reader, 4); }
ParsedShape parse_poly(Reader& reader) { return parse_coefficients(reader, parse_order(reader, "poly")); }

ParsedShape parse_polynomial(Reader& reader) {
    const int order = parse_order(reader, "polynom");
    std::vector<double> coefficients(poly_coefficients(order));
    while (reader.accept(Word::xyz)) {
        const std::size_t index = parse_exponents(reader, order);
        reader.expect(':');
        coefficients[index] = reader.parse_float();
        reader.accept_comma();
    }
    return make_poly(order, std::move(coefficients));
}

}  // namespace rt
