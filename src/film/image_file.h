// Pictures to files and back. PNG goes through libpng, PPM through nothing; every other format through OpenImageIO, in a module that is
// loaded when the first such file is touched.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "film/encode.h"

namespace rt {

enum class ImageFormat { png, exr, hdr, tiff, jpeg, ppm, tga, bmp };

struct ImageMetadata {
    std::vector<std::pair<std::string, std::string>> text;  ///< keyword (1..79 Latin-1 bytes), value
};

/// Format by the file name's extension in small or capital letters; false if it is none of ours.
bool format_of(const std::string& path, ImageFormat& format);
/// "png", "jpg", ... as in a file name.
const char* extension(ImageFormat format);

/// What a format can hold.
struct FormatLimits {
    int fewest_bits, most_bits;  ///< per channel; there is nothing between them
    bool alpha;
    bool linear;  ///< unclamped linear light; HDR's bits are those beside its shared exponent
    int bits_for(int wanted) const { return wanted <= fewest_bits ? fewest_bits : most_bits; }
};
FormatLimits limits_of(ImageFormat format);

/// Writes beside the target and renames, so a picture appears whole or not at all; an error leaves an existing file as it was.
/// `path` "-" writes to standard output; a device or pipe is written directly; a symbolic link stays and its target is replaced. The
/// bits are those that the format has for the wanted ones, alpha that it cannot hold is left out; EXR and HDR get unclamped linear light.
/// Throws OutputError with the path and the system's reason, OptionError when the format needs a module that is not installed.
void write_image(const Film& film, const std::string& path, ImageFormat format, const Encoding& encoding, const ImageMetadata& metadata);

/// Throws what write_image() would throw at once for such a target (missing folder, no permission, module not installed), so that nobody
/// waits for a picture that cannot be written. Leaves no trace.
void check_image_target(const std::string& path, ImageFormat format);
/// The same for a file that is no picture.
void check_file_target(const std::string& path);

/// The bytes that write_image() writes as PNG. Throws OutputError.
std::string png_bytes(const Film& film, const Encoding& encoding, const ImageMetadata& metadata);

/// A picture as stored: 8- and 16-bit formats hold integers in 0..max_value, float formats hold linear floats (max_value 0).
struct StoredImage {
    enum class Kind { png, gif, pixmap, tiff, hdr, other };  ///< pixmap: PPM, PGM and their like
    int width = 0, height = 0, channels = 0;                 ///< 1..4 channels
    int max_value = 255;                                     ///< 255 or 65535; a pixmap may state another
    std::vector<float> values;                               ///< interleaved, row by row from the top; integers as they are in the file
    std::optional<double> gamma = std::nullopt;              ///< the exponent that decodes it, where a PNG says so and does not say sRGB
    Kind kind = Kind::other;
    std::vector<std::uint8_t> indices = {};  ///< of a PNG with a palette: the number of each pixel's entry
};

inline constexpr std::size_t any_number_of_pixels = std::numeric_limits<std::size_t>::max();

/// Reads any format. Throws OptionError naming the file and what is wrong with it, LimitError if it has more than `max_pixels`, before they
/// are read.
StoredImage read_image(const std::string& path, std::size_t max_pixels = any_number_of_pixels);

/// Throws that LimitError.
void require_pixels(const std::string& path, const StoredImage& image, std::size_t max_pixels);

}  // namespace rt
