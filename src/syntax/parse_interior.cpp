// interior { }
#include "syntax/blocks.h"
#include "syntax/legacy_keywords.h"
#include "syntax/unmodelled.h"

namespace rt {

namespace {

bool accept_item(Reader& reader, Interior& interior) {
    const Token next = reader.peek();
    if (reader.accept(Word::ior)) {
        interior.ior = reader.parse_float();
    } else if (reader.accept(Word::caustics)) {
        interior.caustics = 45.0 * reader.parse_float();
    } else if (reader.accept(Word::fade_distance)) {
        interior.fade_distance = reader.parse_float();
    } else if (reader.accept(Word::fade_power)) {
        interior.fade_power = reader.parse_float();
    } else if (reader.accept(Word::fade_color) || reader.accept(Word::fade_colour)) {
        interior.fade_color = parse_rgb(reader);
    } else if (reader.accept(Word::refraction)) {
        reader.parse_float();
        reader.warn(reader.peek().span, refraction_unnecessary);
    } else if (reader.accept(Word::dispersion)) {
        if (reader.parse_float() != 1.0) reader.unmodelled(next.span, "dispersion");
    } else if (reader.accept(Word::dispersion_samples)) {
        reader.parse_float();
    } else if (reader.accept(Word::media)) {
        skip_unmodelled_block(reader, next);
    } else {
        return false;
    }
    return true;
}

}  // namespace

Shared<Interior> parse_interior(Reader& reader, Shared<Interior> base) {
    reader.begin_block("interior");
    if (const auto* declared = reader.accept_declared<Shared<Interior>>()) base = *declared;
    Interior interior = *base;
    bool edited = false;
    while (accept_item(reader, interior)) edited = true;
    reader.end_block();
    return edited ? Shared<Interior>(std::move(interior)) : base;
}

}  // namespace rt
