// isosurface { }
#include <fmt/format.h>

#include "syntax/parameters.h"
#include "syntax/parse_shape.h"

namespace rt {

namespace {

void parse_container(Reader& reader, Isosurface& shape) {
    reader.begin_block("contained_by");
    if (reader.accept(Word::box)) {
        reader.begin_block("box");
        const Vec3 a = reader.parse_vector();
        reader.accept_comma();
        const Vec3 b = reader.parse_vector();
        shape.container = Box{glm::min(a, b), glm::max(a, b)};
        reader.end_block();
    } else if (reader.accept(Word::sphere)) {
        reader.begin_block("sphere");
        const Vec3 center = reader.parse_vector();
        reader.accept_comma();
        shape.container = Sphere{center, std::fabs(reader.parse_float())};
        reader.end_block();
    }
    reader.end_block();
}

/// A number that has to be above 0; another one is POV-Ray's own, with its warning.
double parse_positive(Reader& reader, const char* name, double own) {
    const double value = reader.parse_float();
    if (value > 0.0) return value;
    reader.warn(reader.peek().span, fmt::format("Isosurface '{}' is not positive. Using {:g} (default).", name, own));
    return own;
}

int parse_max_trace(Reader& reader) {
    const int count = parse_int(reader);
    if (count > most_isosurface_hits)
        reader.warn(reader.peek().span, fmt::format("Isosurface 'max_trace' exceeds maximum of {}. Using maximum.", most_isosurface_hits));
    if (count < 1) reader.warn(reader.peek().span, "Isosurface 'max_trace' is not positive. Using 1 (default).");
    return std::clamp(count, 1, most_isosurface_hits);
}

/// POV-Ray changes `max_gradient` while it traces, so that its picture depends on the order of the rays.
void skip_evaluate(Reader& reader, const Span& place) {
    reader.unmodelled(place, "evaluate");
    for (int i = 0; i < 3; ++i) {
        reader.parse_float();
        reader.accept_comma();
    }
}

bool accept_item(Reader& reader, Isosurface& shape) {
    const Token next = reader.peek();
    if (reader.accept(Word::contained_by))
        parse_container(reader, shape);
    else if (reader.accept(Word::threshold))
        shape.threshold = reader.parse_float();
    else if (reader.accept(Word::accuracy))
        shape.accuracy = parse_positive(reader, "accuracy", Isosurface{}.accuracy);
    else if (reader.accept(Word::max_gradient))
        shape.max_gradient = parse_positive(reader, "max_gradient", Isosurface{}.max_gradient);
    else if (reader.accept(Word::max_trace))
        shape.max_trace = parse_max_trace(reader);
    else if (reader.accept(Word::all_intersections))
        shape.max_trace = most_isosurface_hits;
    else if (reader.accept(Word::open))
        shape.open = true;
    else if (reader.accept(Word::evaluate))
        skip_evaluate(reader, next.span);
    else
        return false;
    return true;
}

}  // namespace

ParsedShape parse_isosurface(Reader& reader) {
    if (!reader.accept(Word::function)) reader.fail_expected("function");
    Isosurface shape;
    shape.function = reader.parse_pattern_function();
    while (accept_item(reader, shape)) {
    }
    if (!shape.function) return std::nullopt;
    return shape;
}

}  // namespace rt
