#include "film/spaced_fill.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rt {

namespace {

float middle(float a, float b, float c, float d) {
    const auto light = [](float v) { return std::isfinite(v) ? v : 0.0f; };
    return std::max(0.0f, (9.0f * (light(b) + light(c)) - light(a) - light(d)) / 16.0f);
}

/// The pixel `at` a place on a line of `length` pixels that lie `stride` apart, between those at multiples of `spacing`.
void fill(Pixel* line, int at, int length, std::ptrdiff_t stride, int spacing) {
    const int last = (length - 1) / spacing * spacing, half = spacing / 2;
    const auto pixel = [&](int place) -> const Pixel& { return line[std::clamp(place, 0, last) * stride]; };
    const Pixel &a = pixel(at - half - spacing), &b = pixel(at - half), &c = pixel(at + half), &d = pixel(at + half + spacing);
    line[at * stride] = {middle(a.r, b.r, c.r, d.r), middle(a.g, b.g, c.g, d.g), middle(a.b, b.b, c.b, d.b),
                         std::min(1.0f, middle(a.transmittance, b.transmittance, c.transmittance, d.transmittance))};
}

}  // namespace

void fill_between(Film& film, int spacing, std::span<const std::uint8_t> known) {
    const auto is_known = [&](int x, int y) { return known[static_cast<std::size_t>(y) * film.width + x] != 0; };
    for (; spacing > 1; spacing /= 2) {
        const int half = spacing / 2;
        for (int y = 0; y < film.height; y += spacing)
            for (int x = half; x < film.width; x += spacing)
                if (!is_known(x, y)) fill(&film.at(0, y), x, film.width, 1, spacing);
        for (int y = half; y < film.height; y += spacing)
            for (int x = 0; x < film.width; x += half)
                if (!is_known(x, y)) fill(&film.at(x, 0), y, film.height, film.width, spacing);
    }
}

}  // namespace rt
