#include "syntax/picture.h"

#include <algorithm>

namespace rt {

namespace {

constexpr float red_share = 0.297F, green_share = 0.589F, blue_share = 0.114F;

double decode_srgb(double v) { return v < 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

/// From the file's numbers, 0..1, to the working space.
class Decoder {
public:
    Decoder(const StatedPicture& picture, const Gamma& working)
        : working_(working), stated_(picture.gamma ? picture.gamma : picture.file.gamma), linear_(picture.file.max_value == 0) {}

    double operator()(double v) const {
        if (working_.kind == Gamma::Kind::legacy) return v;
        if (linear_ && !stated_) return encode(v);
        return encode(stated_ ? std::pow(v, *stated_) : decode_srgb(v));
    }

private:
    double encode(double linear) const {
        if (working_.kind == Gamma::Kind::power) return working_.power == 1.0 ? linear : std::pow(linear, 1.0 / working_.power);
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    }

    Gamma working_;
    std::optional<double> stated_;
    bool linear_;
};

/// Grey pictures of eight bits are kept as bytes, rounded down after decoding: as POV-Ray does.
bool is_byte_grey(const PictureFile& file) { return file.channels == 1 && file.max_value == 255; }

float kept_as_byte(double grey) {
    const auto q = static_cast<float>(grey);
    return std::trunc(255.0F * (red_share * q + green_share * q + blue_share * q)) / 255.0F;
}

/// A texel's channels as red, green, blue and alpha, 0..1 for integers.
std::array<double, 4> channels_of(const PictureFile& file, std::size_t texel) {
    const auto count = static_cast<std::size_t>(file.channels);
    const double scale = file.max_value == 0 ? 1.0 : 1.0 / file.max_value;
    const float* v = &file.values[texel * count];
    const auto at = [&](std::size_t i) { return scale * static_cast<double>(v[i]); };
    if (count < 3) return {at(0), at(0), at(0), count == 2 ? at(1) : 1.0};
    return {at(0), at(1), at(2), count == 4 ? at(3) : 1.0};
}

}  // namespace

ColorImage colors_of(const StatedPicture& picture, const Gamma& working) {
    const PictureFile& file = picture.file;
    const Decoder decode(picture, working);
    ColorImage image{file.width, file.height, {}};
    const auto size = static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height);
    image.texels.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        const auto [r, g, b, alpha] = channels_of(file, i);
        std::array<float, 4> texel{static_cast<float>(decode(r)), static_cast<float>(decode(g)), static_cast<float>(decode(b)),
                                   static_cast<float>(1.0 - alpha)};
        if (is_byte_grey(file)) texel[0] = texel[1] = texel[2] = kept_as_byte(decode(r));
        image.texels.push_back(texel);
    }
    return image;
}

ValueGrid values_of(const StatedPicture& picture) {
    const PictureFile& file = picture.file;
    ValueGrid grid{file.width, file.height, 1, {}};
    const auto size = static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height);
    grid.values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        auto [r, g, b, alpha] = channels_of(file, i);
        if (picture.gamma) r = std::pow(r, *picture.gamma), g = std::pow(g, *picture.gamma), b = std::pow(b, *picture.gamma);
        const float grey = red_share * static_cast<float>(r) + green_share * static_cast<float>(g) + blue_share * static_cast<float>(b);
        grid.values.push_back(picture.use_alpha ? static_cast<float>(alpha) : is_byte_grey(file) ? kept_as_byte(r) : grey);
    }
    return grid;
}

}  // namespace rt
