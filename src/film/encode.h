// Linear light to the numbers of a file: the one place with clamp, gamma and rounding.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "film/film.h"

namespace rt {

/// A transfer function between stored and linear light.
struct Curve {
    enum class Kind { power, srgb };
    Kind kind = Kind::power;
    double power = 1.0;  ///< linear = stored^power; within 1 % of 1 it is exactly 1
    bool operator==(const Curve&) const = default;
};

struct Encoding {
    bool raw = false;                    ///< legacy scenes: values are quantised as they are, whatever the curves say
    Curve working;                       ///< the scene's assumed_gamma
    Curve file{Curve::Kind::srgb, 1.0};  ///< File_Gamma; ignored by formats that hold linear light
    int bits = 8;                        ///< 8 or 16 per channel; OpenEXR also 32 (single precision, otherwise half)
    bool alpha = false;
    bool dither = false;  ///< Floyd-Steinberg as POV-Ray does it
};

/// Working-space value to linear light (unclamped; negative values become 0 under a power other than 1).
double to_linear(double value, const Encoding& encoding);
/// Working-space value to the file's 0..1 range before clamping.
double encode(double value, const Encoding& encoding);
/// floor(clamp(encode(v)) (2^bits - 1) + 1/2) with the product in single precision, as POV-Ray has it; NaN becomes 0.
std::uint16_t quantise(double value, const Encoding& encoding);
/// All pixels, interleaved RGB or (un-premultiplied) RGBA, row by row from the top.
std::vector<std::uint16_t> quantise(const Film& film, const Encoding& encoding);

/// A pixel as a file with alpha holds it: transmittance becomes 1 - alpha and the colour is divided by alpha, both in the working space.
/// Alpha is 1 - transmittance, but at least the grey value of the colour, so that light brighter than its coverage allows is not lost.
Pixel with_alpha(const Pixel& pixel);

/// The rows of a film as a file's numbers, one after the other: dithering carries its errors from row to row.
class RowEncoder {
public:
    /// The film outlives the encoder.
    RowEncoder(const Film& film, const Encoding& encoding);
    ~RowEncoder();
    /// 3, or 4 with alpha.
    int channels() const;
    /// The next row, width * channels() numbers.
    void next(std::uint16_t* out);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rt
