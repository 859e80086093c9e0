// camera { }
#include <fmt/format.h>

#include "syntax/blocks.h"
#include "syntax/parameters.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

bool is_type(Word w) {
    switch (w) {
        case Word::perspective:
        case Word::orthographic:
        case Word::fisheye:
        case Word::ultra_wide_angle:
        case Word::omnimax:
        case Word::panoramic:
        case Word::spherical:
        case Word::cylinder:
        case Word::mesh_camera:
            return true;
        default:
            return false;
    }
}

/// The types that the block begins with; the last one holds.
Word parse_type(Reader& reader, Camera& camera) {
    Token type;
    type.word = Word::perspective;
    std::string name(text(type.word));
    while (reader.peek().kind == Token::Kind::word && is_type(reader.peek().word)) {
        type = reader.take();
        name = text(type.word);
        if (type.word == Word::cylinder) {
            const int n = parse_int(reader);
            if (n < 1 || n > 4) reader.fail(reader.last_place(), "Invalid cylinder camera type, valid are types 1 to 4.");
            name += fmt::format(" {}", n);
        }
        if (type.word == Word::mesh_camera) skip_inner_block(reader);
    }
    const std::optional<Projection> projection = find_name(projection_names, name);
    if (!projection) reader.unmodelled(type.span, fmt::format("{} camera", name));
    camera.projection = projection.value_or(Projection::perspective);
    return type.word;
}

void parse_angle(Reader& reader, Camera& camera, Word type) {
    const bool optional = type == Word::orthographic && !reader.at_expression();
    camera.angle = optional ? 0.0 : reader.parse_float();
    if (*camera.angle < 0.0) reader.fail(reader.peek().span, "Negative viewing angle.");
    if (type != Word::spherical) return;
    reader.accept_comma();
    if (reader.at_expression()) camera.vertical_angle = reader.parse_float();
}

bool accept_vector_item(Reader& reader, Camera& camera) {
    if (reader.accept(Word::location)) {
        camera.location = reader.parse_vector();
    } else if (reader.accept(Word::direction)) {
        camera.direction = reader.parse_vector();
    } else if (reader.accept(Word::sky)) {
        camera.sky = reader.parse_vector();
    } else if (reader.accept(Word::look_at)) {
        camera.look_at = reader.parse_vector();
    } else if (reader.accept(Word::up)) {
        camera.up = reader.parse_vector();
        camera.up_or_right_stated = true;
    } else if (reader.accept(Word::right)) {
        camera.right = reader.parse_vector();
        camera.up_or_right_stated = true;
    } else {
        return false;
    }
    return true;
}

/// Focal blur and the like: values are read, a blur that would show is reported.
bool accept_unmodelled_camera_item(Reader& reader) {
    const Token next = reader.peek();
    if (reader.accept(Word::aperture)) {
        if (reader.parse_float() != 0.0) reader.unmodelled(next.span, "aperture");
    } else if (reader.accept(Word::blur_samples)) {
        reader.parse_float();
        reader.accept_comma();
        if (reader.at_expression()) reader.parse_float();
    } else if (reader.accept(Word::focal_point)) {
        reader.parse_vector();
    } else if (reader.accept(Word::confidence) || reader.accept(Word::variance)) {
        reader.parse_float();
    } else if (reader.accept(Word::normal) || reader.accept(Word::bokeh)) {
        skip_unmodelled_block(reader, next);
    } else {
        return false;
    }
    return true;
}

void append_transform(Reader& reader, const Span& place, Camera& camera, const Transform& t) {
    camera.transform = camera.transform.then(t);
    require_finite(reader, place, camera.transform);
}

bool perpendicular(const Vec3& a, const Vec3& b) {
    const double lengths = length(a) * length(b);
    return !(lengths > 0.0) || std::fabs(dot(a, b)) <= epsilon * lengths;
}

/// POV-Ray's warnings about the vectors as they are when the block ends.
void check_vectors(Reader& reader, const Span& place, const Camera& camera) {
    Vec3 direction = camera.direction;
    Vec3 right = camera.right;
    Vec3 up = camera.up;
    if (camera.look_at) {
        const Vec3 forward = *camera.look_at - camera.location;
        if (length(forward) < epsilon) reader.fail(place, "Camera location and look_at point must be different.");
        direction = unit(forward);
        right = cross(camera.sky, direction);
        if (length(right) < epsilon) {
            reader.warn(place,
                        "Camera location to look_at direction and sky direction should be different. Using default/supplied right vector "
                        "instead.");
            right = camera.right;
        }
        up = cross(direction, right);
    }
    const Transform& t = camera.transform;
    const Vec3 d = t.direction(direction);
    const Vec3 r = t.direction(right);
    const Vec3 u = t.direction(up);
    if (!perpendicular(d, r) || !perpendicular(d, u) || !perpendicular(r, u))
        reader.warn(place, "Camera vectors are not perpendicular. Making look_at the last statement may help.");
}

Camera parse_from_declared(Reader& reader, Camera camera) {
    const Span place = reader.peek().span;
    if (const std::optional<Transform> t = accept_transforms(reader)) append_transform(reader, place, camera, *t);
    reader.end_block();
    return camera;
}

}  // namespace

Camera parse_camera(Reader& reader) {
    const Span begin = reader.peek().span;
    reader.begin_block("camera");
    if (const Camera* declared = reader.accept_declared<Camera>()) return parse_from_declared(reader, *declared);
    Camera camera;
    camera.span = begin;
    const Word type = parse_type(reader, camera);
    for (;;) {
        const Token next = reader.peek();
        if (reader.accept(Word::angle)) {
            parse_angle(reader, camera, type);
        } else if (const std::optional<Transform> t = accept_transform(reader)) {
            append_transform(reader, next.span, camera, *t);
        } else if (next.kind == Token::Kind::word && is_type(next.word) && next.word != type) {
            reader.fail_expected(fmt::format("{} camera modifier", text(type)));
        } else if (!accept_vector_item(reader, camera) && !accept_unmodelled_camera_item(reader)) {
            break;
        }
    }
    const Span end = reader.peek().span;
    reader.end_block();
    const bool narrow = type == Word::perspective || type == Word::orthographic;
    if (narrow && camera.angle && *camera.angle >= 180.0) reader.fail(end, "Viewing angle has to be smaller than 180 degrees.");
    check_vectors(reader, end, camera);
    return camera;
}

}  // namespace rt
