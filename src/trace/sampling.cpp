#include "trace/sampling.h"

#include <cmath>

#include "film/encode.h"

namespace rt {

double Comparison::operator()(double value) const {
    const Encoding from_srgb{.working = {Curve::Kind::srgb, 1.0}};
    return std::pow(std::fmax(srgb ? to_linear(value, from_srgb) : value, 0.0), exponent);
}

Contrast::Contrast(const Pixel& p, const Comparison& comparison)
    : r(comparison(p.r)), g(comparison(p.g)), b(comparison(p.b)), transmittance(p.transmittance) {}

double distance(const Contrast& a, const Contrast& b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) + std::abs(a.transmittance - b.transmittance);
}

int sample_centres(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels) {
    std::vector<Vec2> row(static_cast<std::size_t>(tile.width()));
    for (int y = tile.y0; y < tile.y1; ++y) {
        if (task.stopped()) return y - tile.y0;
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = {tile.x0 + static_cast<int>(i) + 0.5, y + 0.5};
        task.samples(row, 1, std::span(pixels).subspan(static_cast<std::size_t>(y - tile.y0) * row.size(), row.size()));
    }
    return tile.height();
}

int sample_grid(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels) {
    const int n = task.sampling.depth;
    const std::size_t count = static_cast<std::size_t>(n) * n;
    std::vector<Vec2> points(count);
    std::vector<Pixel> samples(count);
    std::size_t next = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (task.stopped()) return y - tile.y0;
            for (int sub_y = 0; sub_y < n; ++sub_y) {
                for (int sub_x = 0; sub_x < n; ++sub_x) points[sub_y * n + sub_x] = {x * n + sub_x + 0.5, y * n + sub_y + 0.5};
            }
            task.samples(points, n, samples);
            PixelSum sum;
            for (const Pixel& sample : samples) sum.add(sample);
            pixels[next++] = sum.over(static_cast<double>(count)).pixel();
        }
    }
    return tile.height();
}

int samples_a_side(const Sampling& sampling) { return sampling.method == Sampling::Method::grid ? sampling.depth : 1; }

int sample_tile(const SamplingTask& task, const Region& tile, std::vector<Pixel>& pixels) {
    pixels.assign(static_cast<std::size_t>(tile.width()) * tile.height(), Pixel{});
    switch (task.sampling.method) {
        case Sampling::Method::none:
            return sample_centres(task, tile, pixels);
        case Sampling::Method::grid:
            return sample_grid(task, tile, pixels);
        case Sampling::Method::povray1:
            return sample_povray1(task, tile, pixels);
        case Sampling::Method::povray2:
            return sample_povray2(task, tile, pixels);
        case Sampling::Method::adaptive:
            break;  // is no matter of one tile: render_progressive()
    }
    return 0;
}

}  // namespace rt
