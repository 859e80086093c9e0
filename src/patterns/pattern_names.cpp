// The words of scene files, and what each kind begins with.
#include "core/name_table.h"
#include "patterns/pattern.h"

namespace rt {

namespace {

using K = PatternKind;

constexpr NameTable<PatternKind, 43> kinds{{
    {"agate", K::agate},
    {"aoi", K::aoi},
    {"average", K::average},
    {"boxed", K::boxed},
    {"bozo", K::bozo},
    {"brick", K::brick},
    {"bump_map", K::bump_map},
    {"bumps", K::bumps},
    {"cells", K::cells},
    {"checker", K::checker},
    {"crackle", K::crackle},
    {"cubic", K::cubic},
    {"cylindrical", K::cylindrical},
    {"density_file", K::density_file},
    {"dents", K::dents},
    {"facets", K::facets},
    {"function", K::function},
    {"gradient", K::gradient},
    {"granite", K::granite},
    {"hexagon", K::hexagon},
    {"image_pattern", K::image_pattern},
    {"julia", K::julia},
    {"leopard", K::leopard},
    {"magnet", K::magnet},
    {"mandel", K::mandel},
    {"marble", K::marble},
    {"object", K::object},
    {"onion", K::onion},
    {"pigment_pattern", K::pigment_pattern},
    {"planar", K::planar},
    {"quilted", K::quilted},
    {"radial", K::radial},
    {"ripples", K::ripples},
    {"slope", K::slope},
    {"spherical", K::spherical},
    {"spiral1", K::spiral1},
    {"spiral2", K::spiral2},
    {"spotted", K::spotted},
    {"square", K::square},
    {"triangular", K::triangular},
    {"waves", K::waves},
    {"wood", K::wood},
    {"wrinkles", K::wrinkles},
}};

constexpr NameTable<WaveType, 6> wave_types{{
    {"ramp_wave", WaveType::ramp},
    {"triangle_wave", WaveType::triangle},
    {"sine_wave", WaveType::sine},
    {"scallop_wave", WaveType::scallop},
    {"cubic_wave", WaveType::cubic},
    {"poly_wave", WaveType::poly},
}};

PatternNumbers default_numbers(PatternKind kind) {
    switch (kind) {
        case K::agate:
            return AgateNumbers{};
        case K::brick:
            return BrickNumbers{};
        case K::crackle:
            return CrackleNumbers{};
        case K::gradient:
            return GradientNumbers{};
        case K::julia:
        case K::mandel:
        case K::magnet:
            return FractalNumbers{};
        case K::quilted:
            return QuiltedNumbers{};
        case K::facets:
            return FacetsNumbers{};
        case K::slope:
            return SlopeNumbers{};
        case K::spiral1:
        case K::spiral2:
            return SpiralNumbers{};
        case K::ripples:
        case K::waves:
            return WavesNumbers{wave_sources(10)};
        case K::density_file:
            return DensityNumbers{};
        case K::bump_map:
        case K::image_pattern:
            return ImageNumbers{};
        default:
            return {};
    }
}

}  // namespace

std::optional<PatternKind> pattern_kind(std::string_view word) { return find_name(kinds, word); }
std::string_view name(PatternKind kind) { return name_of(kinds, kind); }
std::optional<WaveType> wave_type(std::string_view word) { return find_name(wave_types, word); }

int cell_count(PatternKind kind) {
    switch (kind) {
        case K::brick:
        case K::checker:
            return 2;
        case K::hexagon:
            return 3;
        case K::square:
            return 4;
        case K::cubic:
        case K::triangular:
            return 6;
        default:
            return 0;
    }
}

bool is_computed_elsewhere(PatternKind kind) {
    return kind == K::average || kind == K::function || kind == K::object || kind == K::pigment_pattern;
}

Pattern make_pattern(PatternKind kind) {
    Pattern pattern;
    pattern.kind = kind;
    pattern.numbers = default_numbers(kind);
    if (has_cells(kind)) pattern.frequency = 0.0F;
    if (kind == K::marble || kind == K::wood || kind == K::spiral1 || kind == K::spiral2) pattern.wave = WaveType::triangle;
    return pattern;
}

}  // namespace rt
