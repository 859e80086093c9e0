#include "syntax/unmodelled.h"

#include <algorithm>
#include <initializer_list>

namespace rt {

namespace {

constexpr std::initializer_list<Word> shapes{
    Word::bicubic_patch, Word::blob, Word::cubic,        Word::height_field,   Word::isosurface, Word::julia_fractal, Word::lathe,
    Word::light_group,   Word::ovus, Word::parametric,   Word::poly,           Word::polynomial, Word::prism,         Word::quadric,
    Word::quartic,       Word::sor,  Word::sphere_sweep, Word::superellipsoid, Word::text};

constexpr std::initializer_list<Word> patterns{
    Word::agate,           Word::aoi,      Word::average, Word::boxed,       Word::bozo,         Word::brick,         Word::bumps,
    Word::cells,           Word::crackle,  Word::cubic,   Word::cylindrical, Word::density_file, Word::dents,         Word::facets,
    Word::function,        Word::gradient, Word::granite, Word::hexagon,     Word::image_map,    Word::image_pattern, Word::julia,
    Word::leopard,         Word::magnet,   Word::mandel,  Word::marble,      Word::object,       Word::onion,         Word::pavement,
    Word::pigment_pattern, Word::planar,   Word::quilted, Word::radial,      Word::ripples,      Word::slope,         Word::spherical,
    Word::spiral1,         Word::spiral2,  Word::spotted, Word::square,      Word::tiling,       Word::triangular,    Word::uv_mapping,
    Word::waves,           Word::wood,     Word::wrinkles};

constexpr std::initializer_list<Word> modifiers{
    Word::agate_turb,    Word::color_map,   Word::colour_map,  Word::control0,  Word::control1,        Word::cubic_wave,   Word::exponent,
    Word::frequency,     Word::interpolate, Word::lambda,      Word::map_type,  Word::noise_generator, Word::octaves,      Word::omega,
    Word::once,          Word::phase,       Word::pigment_map, Word::poly_wave, Word::ramp_wave,       Word::scallop_wave, Word::sine_wave,
    Word::triangle_wave, Word::turbulence,  Word::use_alpha,   Word::warp};

constexpr std::initializer_list<Word> items{Word::fog, Word::media, Word::rainbow, Word::sky_sphere};

/// Features that are worth a line of their own where they stand inside something that is skipped as a whole.
constexpr std::initializer_list<Word> inner_features{
    Word::bump_map,   Word::crand,        Word::density,     Word::dispersion, Word::function,   Word::image_map,   Word::irid,
    Word::looks_like, Word::material_map, Word::media,       Word::normal,     Word::normal_map, Word::pigment_map, Word::projected_through,
    Word::slope_map,  Word::texture_list, Word::texture_map, Word::turbulence, Word::uv_mapping, Word::warp};

bool contains(std::initializer_list<Word> words, Word w) { return std::find(words.begin(), words.end(), w) != words.end(); }

void report_inner(Reader& reader, const Token& token) {
    if (token.kind != Token::Kind::word) return;
    if (contains(shapes, token.word) || contains(patterns, token.word) || contains(inner_features, token.word))
        reader.unmodelled(token.span, text(token.word));
}

}  // namespace

bool is_unmodelled_shape(Word w) { return contains(shapes, w); }
bool is_unmodelled_pattern(Word w) { return contains(patterns, w); }
bool is_pattern_modifier(Word w) { return contains(modifiers, w); }
bool is_unmodelled_item(Word w) { return contains(items, w); }

void skip_unmodelled_block(Reader& reader, const Token& word) {
    reader.unmodelled(word.span, text(word.word));
    reader.begin_block(text(word.word));
    skip_to_block_end(reader);
    reader.end_block();
}

void skip_inner_block(Reader& reader) {
    reader.begin_block("{");
    skip_to_block_end(reader);
    reader.end_block();
}

void skip_to_block_end(Reader& reader) {
    for (std::size_t depth = 0;;) {
        const Token& next = reader.peek();
        if (next.kind == Token::Kind::end || (next.is('}') && depth == 0)) return;
        if (next.is('{')) ++depth;
        if (next.is('}')) --depth;
        report_inner(reader, reader.take());
    }
}

}  // namespace rt
