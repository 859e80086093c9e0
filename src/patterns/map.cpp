#include "patterns/map.h"

#include <array>

namespace rt {

namespace {

const Rgb black(0.0), white(1.0), red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), blue(0.0, 0.0, 1.0);
const Rgb cyan(0.0, 1.0, 1.0), magenta(1.0, 0.0, 1.0), yellow(1.0, 1.0, 0.0);

const std::array<DefaultMapEntry, 2> grey_map{{{0.0, black}, {1.0, white}}};
const std::array<DefaultMapEntry, 6> agate_map{{{0.0, white},
                                                {0.5, {0.95, 0.75, 0.5}},
                                                {0.5, {0.9, 0.7, 0.5}},
                                                {0.6, {0.9, 0.7, 0.4}},
                                                {0.6, {1.0, 0.7, 0.4}},
                                                {1.0, {0.6, 0.3, 0.0}}}};
const std::array<DefaultMapEntry, 6> bozo_map{{{0.4, white}, {0.4, green}, {0.6, green}, {0.6, blue}, {0.8, blue}, {0.8, red}}};
const std::array<DefaultMapEntry, 5> mandel_map{{{0.001, black}, {0.001, cyan}, {0.012, yellow}, {0.015, magenta}, {0.1, cyan}}};
const std::array<DefaultMapEntry, 3> marble_map{{{0.0, {0.9, 0.8, 0.8}}, {0.9, {0.9, 0.08, 0.08}}, {0.9, black}}};
const std::array<DefaultMapEntry, 4> radial_map{{{0.0, cyan}, {0.333, yellow}, {0.666, magenta}, {1.0, cyan}}};
const std::array<DefaultMapEntry, 2> wood_map{{{0.6, {0.666, 0.312, 0.2}}, {0.6, {0.4, 0.1333, 0.066}}}};

const std::array<Rgb, 2> brick_colors{{Rgb(0.5), {0.6, 0.15, 0.15}}};
const std::array<Rgb, 3> checker_colors{{blue, green, red}};  // and of hexagon
const std::array<Rgb, 6> face_colors{{red, green, blue, yellow, cyan, magenta}};

}  // namespace

MapPlace find_in_map(std::span<const double> positions, double value) {
    const std::size_t last = positions.size() - 1;
    if (value >= positions[last]) return {last, last, 0.0};
    if (!(value > positions[0])) return {0, 0, 0.0};
    std::size_t upper = 1;
    while (value > positions[upper]) ++upper;
    const double from = positions[upper - 1];
    return {upper - 1, upper, (value - from) / (positions[upper] - from)};
}

std::span<const DefaultMapEntry> default_color_map(PatternKind kind) {
    switch (kind) {
        case PatternKind::agate:
            return agate_map;
        case PatternKind::bozo:
            return bozo_map;
        case PatternKind::mandel:
            return mandel_map;
        case PatternKind::marble:
            return marble_map;
        case PatternKind::radial:
            return radial_map;
        case PatternKind::wood:
            return wood_map;
        default:
            return grey_map;
    }
}

std::span<const Rgb> default_cell_colors(PatternKind kind) {
    const auto count = static_cast<std::size_t>(list_size(kind));
    switch (kind) {
        case PatternKind::brick:
            return brick_colors;
        case PatternKind::cubic:
        case PatternKind::square:
        case PatternKind::triangular:
            return std::span(face_colors).first(count);
        default:
            return std::span(checker_colors).first(count);
    }
}

}  // namespace rt
