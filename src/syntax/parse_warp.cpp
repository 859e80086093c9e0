// warp { }
#include <fmt/format.h>

#include "syntax/parameters.h"
#include "syntax/parse_pattern.h"

namespace rt {

namespace {

RepeatWarp parse_repeat(Reader& reader) {
    RepeatWarp warp;
    const Vec3 width = reader.parse_vector();
    const Span place = reader.last_place();
    int axes = 0;
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(width[i]) < 1e-10) continue;
        ++axes;
        warp.axis = i;
        warp.width = static_cast<float>(width[i]);
    }
    if (axes == 0) reader.fail(place, "No axis specified in repeat.");
    if (axes > 1) reader.fail(place, "Can only repeat along 1 axis.");
    for (;;) {
        if (reader.accept(Word::offset))
            warp.offset = reader.parse_vector();
        else if (reader.accept(Word::flip))
            warp.flip = reader.parse_vector();
        else
            return warp;
    }
}

BlackHoleWarp parse_black_hole(Reader& reader) {
    BlackHoleWarp warp;
    warp.center = reader.parse_vector();
    reader.accept_comma();
    warp.radius = reader.parse_float();
    for (;;) {
        if (reader.accept(Word::strength))
            warp.strength = reader.parse_float();
        else if (reader.accept(Word::falloff))
            warp.falloff = reader.parse_float();
        else if (reader.accept(Word::inverse))
            warp.inverse = true;
        else if (reader.accept(Word::repeat))
            warp.repeat = reader.parse_vector();
        else if (reader.accept(Word::turbulence))
            warp.turbulence = reader.parse_vector();
        else
            break;
    }
    const Vec3 stated = warp.repeat;
    if (!fit_repeat(warp)) return warp;
    for (int i = 0; i < 3; ++i)
        if (warp.repeat[i] != stated[i])
            reader.warn(reader.peek().span,
                        fmt::format("Black Hole repeat vector {} too small ; increased to {:g}", "XYZ"[i], warp.repeat[i]));
    return warp;
}

Warp parse_mapping(Reader& reader, MappingWarp::Kind kind) {
    MappingWarp warp;
    warp.kind = kind;
    if (kind == MappingWarp::Kind::planar && reader.at_expression()) {
        warp.orientation = reader.parse_vector();
        reader.accept_comma();
        warp.distance = reader.parse_float();
    }
    for (;;) {
        const Token next = reader.peek();
        if (reader.accept(Word::orientation))
            warp.orientation = reader.parse_vector();
        else if (reader.accept(Word::dist_exp))
            warp.distance_exponent = reader.parse_float();
        else if (reader.accept(Word::major_radius) && kind == MappingWarp::Kind::toroidal)
            warp.major_radius = reader.parse_float();
        else if (next.is(Word::major_radius))
            reader.fail(next.span, "Keyword 'major_radius' can only be used in a toroidal warp statement.");
        else
            return warp;
    }
}

Warp parse_turbulence(Reader& reader) {
    std::optional<Turbulence> warp = Turbulence{.amount = reader.parse_vector()};
    while (accept_turbulence_item(reader, warp)) continue;
    return *warp;
}

Warp parse_warp_kind(Reader& reader) {
    if (reader.accept(Word::repeat)) return parse_repeat(reader);
    if (reader.accept(Word::black_hole)) return parse_black_hole(reader);
    if (reader.accept(Word::turbulence)) return parse_turbulence(reader);
    if (reader.accept(Word::cylindrical)) return parse_mapping(reader, MappingWarp::Kind::cylindrical);
    if (reader.accept(Word::spherical)) return parse_mapping(reader, MappingWarp::Kind::spherical);
    if (reader.accept(Word::toroidal)) return parse_mapping(reader, MappingWarp::Kind::toroidal);
    if (reader.accept(Word::planar)) return parse_mapping(reader, MappingWarp::Kind::planar);
    if (reader.accept(Word::cubic)) return CubicWarp{};
    reader.fail_expected("warp type");
}

}  // namespace

Warp parse_warp(Reader& reader) {
    reader.begin_block("warp");
    Warp warp = parse_warp_kind(reader);
    reader.end_block();
    return warp;
}

}  // namespace rt
