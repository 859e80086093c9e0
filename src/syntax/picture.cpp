#include "syntax/picture.h"

#include <algorithm>

#include "core/srgb.h"

namespace rt {

namespace {

constexpr float red_share = 0.297F, green_share = 0.589F, blue_share = 0.114F;

/// From the file's numbers, 0..1, to the working space.
class Decoder {
public:
    Decoder(const StatedPicture& picture, const Gamma& working)
        : working_(working),
          stated_(picture.gamma || picture.srgb ? picture.gamma : picture.file.gamma),
          linear_(picture.file.max_value == 0),
          raw_(!picture.gamma && !picture.srgb &&
               (picture.file.kind == PictureFile::Kind::pixmap || picture.file.kind == PictureFile::Kind::tiff)) {}

    double operator()(double v) const {
        if (working_.kind == Gamma::Kind::legacy || raw_) return v;
        if (linear_ && !stated_) return encode(v);
        return encode(stated_ ? std::pow(v, *stated_) : decode_srgb(v));
    }

private:
    double encode(double linear) const {
        if (working_.kind == Gamma::Kind::power) return working_.power == 1.0 ? linear : std::pow(linear, 1.0 / working_.power);
        return encode_srgb(linear);
    }

    Gamma working_;
    std::optional<double> stated_;
    bool linear_;
    bool raw_;  ///< PPM, PGM and TIFF: POV-Ray takes their numbers as those of the working space
};

/// PNGs of up to eight bits of grey are kept as bytes, rounded down after decoding: as POV-Ray does.
bool is_byte_grey(const PictureFile& file) { return file.kind == PictureFile::Kind::png && file.channels == 1 && file.max_value == 255; }

float kept_as_byte(double grey) {
    const auto q = static_cast<float>(grey);
    return std::trunc(255.0F * (red_share * q + green_share * q + blue_share * q)) / 255.0F;
}

/// Half a unit of the texel's last place: POV-Ray takes the numbers of an HDR, of eight bits beside one exponent, for the lower ends of
/// what they stand for.
double half_unit(const float* rgb) {
    const double largest = static_cast<double>(std::max({rgb[0], rgb[1], rgb[2]}));
    int exponent = 0;
    std::frexp(largest, &exponent);
    return largest > 0.0 ? std::ldexp(0.5, exponent - 8) : 0.0;
}

/// A texel's channels as red, green, blue and alpha, 0..1 for integers. Of a TIFF's sixteen bits the higher eight are left.
std::array<double, 4> channels_of(const PictureFile& file, std::size_t texel) {
    const auto count = static_cast<std::size_t>(file.channels);
    const float* v = &file.values[texel * count];
    const bool halved = file.kind == PictureFile::Kind::tiff && file.max_value == 65535;
    const double scale = file.max_value == 0 ? 1.0 : 1.0 / (halved ? 255 : file.max_value);
    const double more = file.kind == PictureFile::Kind::hdr && count >= 3 ? half_unit(v) : 0.0;
    const auto at = [&](std::size_t i) {
        const double number = static_cast<double>(v[i]);
        return scale * (halved ? std::floor(number / 256.0) : number) + more;
    };
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

namespace {

/// What the file has as numbers is taken as it is, but where the scene says how to decode it.
double number_of(const StatedPicture& picture, double v) {
    return picture.srgb ? decode_srgb(v) : picture.gamma ? std::pow(v, *picture.gamma) : v;
}

}  // namespace

ValueGrid values_of(const StatedPicture& picture) {
    const PictureFile& file = picture.file;
    ValueGrid grid{file.width, file.height, 1, {}};
    const auto size = static_cast<std::size_t>(file.width) * static_cast<std::size_t>(file.height);
    grid.values.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
        const auto [r, g, b, alpha] = channels_of(file, i);
        const auto [red, green, blue] = std::array{number_of(picture, r), number_of(picture, g), number_of(picture, b)};
        // Not weighed where there is one channel: the weights add up to a little less than 1.
        const float grey = file.channels < 3 ? static_cast<float>(red)
                                             : red_share * static_cast<float>(red) + green_share * static_cast<float>(green) +
                                                   blue_share * static_cast<float>(blue);
        grid.values.push_back(picture.use_alpha ? static_cast<float>(alpha) : is_byte_grey(file) ? kept_as_byte(red) : grey);
    }
    return grid;
}

namespace {

/// Of a colour of eight bits POV-Ray takes red for the high byte of the height and green for the low one.
float height_in_bytes(const StatedPicture& picture, std::size_t texel) {
    const auto [r, g, b, alpha] = channels_of(picture.file, texel);
    return static_cast<float>(255.0 * (256.0 * number_of(picture, r) + number_of(picture, g)));
}

}  // namespace

HeightFieldData heights_of(const StatedPicture& picture) {
    const PictureFile& file = picture.file;
    const auto columns = static_cast<std::uint32_t>(file.width), rows = static_cast<std::uint32_t>(file.height);
    const bool in_bytes = file.channels >= 3 && file.max_value == 255, by_index = !file.indices.empty();
    const ValueGrid grey = in_bytes ? ValueGrid{} : values_of(picture);
    std::vector<std::uint16_t> heights;
    heights.reserve(std::size_t{columns} * rows);
    for (std::uint32_t j = rows; j-- > 0;) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::size_t texel = std::size_t{j} * columns + i;
            const float height = by_index   ? 256.0F * file.indices[texel]
                                 : in_bytes ? height_in_bytes(picture, texel)
                                            : 65535.0F * grey.values[texel];
            heights.push_back(static_cast<std::uint16_t>(std::clamp(height, 0.0F, 65535.0F)));
        }
    }
    return {columns, rows, std::move(heights)};
}

}  // namespace rt
