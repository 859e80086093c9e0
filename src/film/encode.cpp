#include "film/encode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/srgb.h"
#include "core/vec.h"
#include "film/quantiser.h"

namespace rt {
namespace {

double raise(double value, double power) { return power == 1.0 ? value : std::pow(std::fmax(value, 0.0), power); }

/// POV-Ray takes a gamma this close to 1 for 1.
double power_of(const Curve& curve) { return std::abs(curve.power - 1.0) <= 0.01 ? 1.0 : curve.power; }

/// Where a file number came from: the inverse of encode().
double decode(double stored, const Encoding& encoding) {
    Encoding inverse = encoding;
    std::swap(inverse.working, inverse.file);
    return encode(stored, inverse);
}

double highest(const Encoding& encoding) { return encoding.bits == 8 ? 255.0 : 65535.0; }

/// The number nearest to a fraction, clamped; NaN becomes 0. The product is rounded to single precision, as POV-Ray's is: it decides where
/// a value as plain as 0.7 stands just below half a step (178.49999 of 255) and POV-Ray writes the upper one.
std::uint16_t level(double fraction, const Encoding& encoding) {
    if (!(fraction > 0.0)) return 0;
    const float product = static_cast<float>(std::fmin(fraction, 1.0)) * static_cast<float>(highest(encoding));
    return static_cast<std::uint16_t>(std::floor(static_cast<double>(product) + 0.5));
}

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

std::uint16_t quantise(double value, const Encoding& encoding) { return level(encode(value, encoding), encoding); }

Pixel with_alpha(const Pixel& pixel) {
    const double coverage = 1.0 - pixel.transmittance;
    const double alpha = std::clamp(std::fmax(coverage, grey(Rgb(pixel.r, pixel.g, pixel.b))), 0.0, 1.0);
    if (!(alpha > 0.0)) return {0.0f, 0.0f, 0.0f, 1.0f};
    const auto divided = [&](float v) { return static_cast<float>(v / alpha); };
    return {divided(pixel.r), divided(pixel.g), divided(pixel.b), static_cast<float>(1.0 - alpha)};
}

struct RowEncoder::State {
    State(const Film& f, const Encoding& e) : film(f), encoding(e), table(e, static_cast<std::size_t>(f.width) * f.height * 3) {
        if (e.dither) carry.resize(static_cast<std::size_t>(f.width) + 2), below.resize(carry.size());
    }

    void plain_row(const Pixel* pixels, std::uint16_t* out) const;
    void dither_row(const Pixel* pixels, std::uint16_t* out);
    std::uint16_t dithered(double value, int channel, std::size_t x);

    const Film& film;
    Encoding encoding;
    Quantiser table;
    int y = 0;
    using Errors = std::array<double, 4>;
    std::vector<Errors> carry;  ///< errors for the row in hand; [x + 1] belongs to column x
    std::vector<Errors> below;  ///< errors for the next row
};

void RowEncoder::State::plain_row(const Pixel* pixels, std::uint16_t* out) const {
    for (const Pixel* p = pixels; p != pixels + film.width; ++p) {
        const Pixel stored = encoding.alpha ? with_alpha(*p) : *p;
        *out++ = table(stored.r), *out++ = table(stored.g), *out++ = table(stored.b);
        if (encoding.alpha) *out++ = level(1.0 - stored.transmittance, encoding);
    }
}

std::uint16_t RowEncoder::State::dithered(double value, int channel, std::size_t x) {
    const bool is_alpha = channel == 3;
    const double wanted = value + carry[x + 1][channel];
    const std::uint16_t stored = is_alpha ? level(wanted, encoding) : quantise(wanted, encoding);
    const double fraction = stored / highest(encoding);
    const double error = std::clamp(std::isnan(wanted) ? 0.0 : wanted, 0.0, 1.0) - (is_alpha ? fraction : decode(fraction, encoding));
    carry[x + 2][channel] += error * 7.0 / 16.0;
    below[x][channel] += error * 3.0 / 16.0;
    below[x + 1][channel] += error * 5.0 / 16.0;
    below[x + 2][channel] += error * 1.0 / 16.0;
    return stored;
}

/// POV-Ray swaps its two error rows only after it has read the first pixel of a row: that pixel gets what was meant for the first pixel of
/// the row above, and its own share is lost.
void RowEncoder::State::dither_row(const Pixel* pixels, std::uint16_t* out) {
    const Errors first = carry[1];
    carry.swap(below);
    std::fill(below.begin(), below.end(), Errors{});
    const Errors own = carry[1];
    carry[1] = first;
    for (std::size_t x = 0; x < static_cast<std::size_t>(film.width); ++x) {
        const Pixel stored = encoding.alpha ? with_alpha(pixels[x]) : pixels[x];
        *out++ = dithered(stored.r, 0, x), *out++ = dithered(stored.g, 1, x), *out++ = dithered(stored.b, 2, x);
        if (encoding.alpha) *out++ = dithered(1.0 - stored.transmittance, 3, x);
    }
    carry[1] = own;
}

RowEncoder::RowEncoder(const Film& film, const Encoding& encoding) : state_(std::make_unique<State>(film, encoding)) {}
RowEncoder::~RowEncoder() = default;

int RowEncoder::channels() const { return state_->encoding.alpha ? 4 : 3; }

void RowEncoder::next(std::uint16_t* out) {
    State& s = *state_;
    const Pixel* row = &s.film.pixels[static_cast<std::size_t>(s.y++) * s.film.width];
    s.encoding.dither ? s.dither_row(row, out) : s.plain_row(row, out);
}

std::vector<std::uint16_t> quantise(const Film& film, const Encoding& encoding) {
    RowEncoder rows(film, encoding);
    const std::size_t row = static_cast<std::size_t>(film.width) * rows.channels();
    std::vector<std::uint16_t> numbers(row * film.height);
    for (int y = 0; y < film.height; ++y) rows.next(numbers.data() + y * row);
    return numbers;
}

}  // namespace rt
