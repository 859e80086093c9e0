#include "film/encode.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "film/quantiser.h"

namespace rt {
namespace {

double decode_srgb(double x) { return x < 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); }

double encode_srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055; }

double raise(double value, double power) { return power == 1.0 ? value : std::pow(std::fmax(value, 0.0), power); }

/// POV-Ray takes a gamma this close to 1 for 1.
double power_of(const Curve& curve) { return std::abs(curve.power - 1.0) <= 0.01 ? 1.0 : curve.power; }

/// The same file, from linear light.
Encoding from_linear(Encoding encoding) {
    encoding.working = Curve{};
    return encoding;
}

/// The linear light of what a file holds, the inverse of encode() from linear light.
double decode(double stored, const Encoding& encoding) {
    if (encoding.raw) return stored;
    return encoding.file.kind == Curve::Kind::srgb ? decode_srgb(stored) : raise(stored, power_of(encoding.file));
}

double highest(const Encoding& encoding) { return encoding.bits == 8 ? 255.0 : 65535.0; }

}  // namespace

double to_linear(double value, const Encoding& encoding) {
    if (encoding.raw) return value;
    return encoding.working.kind == Curve::Kind::srgb ? decode_srgb(value) : raise(value, power_of(encoding.working));
}

double encode(double value, const Encoding& encoding) {
    if (encoding.raw || encoding.working == encoding.file) return value;
    const bool from_power = encoding.working.kind == Curve::Kind::power;
    const bool to_power = encoding.file.kind == Curve::Kind::power;
    if (from_power && to_power) return raise(value, power_of(encoding.working) / power_of(encoding.file));
    if (from_power) return encode_srgb(to_linear(value, encoding));
    return to_power ? raise(decode_srgb(value), 1.0 / power_of(encoding.file)) : value;
}

std::uint16_t quantise(double value, const Encoding& encoding) {
    const double e = encode(value, encoding);
    if (!(e > 0.0)) return 0;
    return static_cast<std::uint16_t>(std::floor(std::fmin(e, 1.0) * highest(encoding) + 0.5));
}

double stored_alpha(const Pixel& pixel) {
    const double coverage = 1.0 - pixel.transmittance;
    const double alpha = std::fmax(coverage, grey(Rgb(pixel.r, pixel.g, pixel.b)));
    return std::clamp(std::isnan(alpha) ? 0.0 : alpha, 0.0, 1.0);
}

struct RowEncoder::State {
    State(const Film& f, const Encoding& e)
        : film(f), encoding(e), linear(from_linear(e)), direct(e, static_cast<std::size_t>(f.width) * f.height * 3) {
        if (e.dither) carry.resize(static_cast<std::size_t>(f.width) + 2), below.resize(carry.size());
    }

    /// Linear light of a pixel as stored: divided by alpha where there is one.
    Rgb stored_light(const Pixel& p, double& alpha) const {
        Rgb light(to_linear(p.r, encoding), to_linear(p.g, encoding), to_linear(p.b, encoding));
        alpha = 1.0;
        if (!encoding.alpha) return light;
        alpha = stored_alpha({static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b), p.transmittance});
        return alpha > 0.0 ? light / alpha : Rgb(0.0);
    }

    std::uint16_t dithered(double light, int channel, std::size_t x);
    void dither_row(const Pixel* pixels, std::uint16_t* out);

    const Film& film;
    Encoding encoding;
    Encoding linear;
    Quantiser direct;
    int y = 0;
    std::vector<Rgb> carry;  ///< errors for the row in hand; [x + 1] belongs to column x
    std::vector<Rgb> below;  ///< errors for the next row
};

std::uint16_t RowEncoder::State::dithered(double light, int channel, std::size_t x) {
    const double wanted = light + carry[x + 1][channel];
    const std::uint16_t stored = quantise(wanted, linear);
    const double error = std::clamp(std::isnan(wanted) ? 0.0 : wanted, 0.0, 1.0) - decode(stored / highest(linear), linear);
    carry[x + 2][channel] += error * 7.0 / 16.0;
    below[x][channel] += error * 3.0 / 16.0;
    below[x + 1][channel] += error * 5.0 / 16.0;
    below[x + 2][channel] += error * 1.0 / 16.0;
    return stored;
}

/// POV-Ray swaps its two error rows only after it has read the first pixel of a row: that pixel gets what was meant for the first pixel of
/// the row above, and its own share is lost.
void RowEncoder::State::dither_row(const Pixel* pixels, std::uint16_t* out) {
    const Rgb first = carry[1];
    carry.swap(below);
    std::fill(below.begin(), below.end(), Rgb(0.0));
    const Rgb own = carry[1];
    carry[1] = first;
    for (std::size_t x = 0; x < static_cast<std::size_t>(film.width); ++x) {
        double alpha = 1.0;
        const Rgb light = stored_light(pixels[x], alpha);
        for (int c = 0; c < 3; ++c) *out++ = dithered(light[c], c, x);
        if (encoding.alpha) *out++ = static_cast<std::uint16_t>(std::floor(alpha * highest(encoding) + 0.5));
    }
    carry[1] = own;
}

RowEncoder::RowEncoder(const Film& film, const Encoding& encoding) : state_(std::make_unique<State>(film, encoding)) {}
RowEncoder::~RowEncoder() = default;

int RowEncoder::channels() const { return state_->encoding.alpha ? 4 : 3; }

void RowEncoder::next(std::uint16_t* out) {
    State& s = *state_;
    const Pixel* row = &s.film.pixels[static_cast<std::size_t>(s.y++) * s.film.width];
    if (s.encoding.dither) return s.dither_row(row, out);
    for (const Pixel* p = row; p != row + s.film.width; ++p) {
        if (!s.encoding.alpha) {
            *out++ = s.direct(p->r), *out++ = s.direct(p->g), *out++ = s.direct(p->b);
            continue;
        }
        double alpha = 1.0;
        const Rgb light = s.stored_light(*p, alpha);
        for (int c = 0; c < 3; ++c) *out++ = quantise(light[c], s.linear);
        *out++ = static_cast<std::uint16_t>(std::floor(alpha * highest(s.encoding) + 0.5));
    }
}

std::vector<std::uint16_t> quantise(const Film& film, const Encoding& encoding) {
    RowEncoder rows(film, encoding);
    const std::size_t row = static_cast<std::size_t>(film.width) * rows.channels();
    std::vector<std::uint16_t> numbers(row * film.height);
    for (int y = 0; y < film.height; ++y) rows.next(numbers.data() + y * row);
    return numbers;
}

}  // namespace rt
