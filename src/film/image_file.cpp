#include "film/image_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "core/source.h"
#include "film/oiio_module.h"
#include "film/output_file.h"
#include "film/png.h"
#include "film/ppm.h"

namespace rt {
namespace {

struct FormatEntry {
    const char* name;  ///< as in a file name
    ImageFormat format;
    const char* oiio;  ///< OpenImageIO's name
    FormatLimits limits;
};

/// The first entry of a format has its usual extension.
constexpr std::array formats{
    FormatEntry{"png", ImageFormat::png, "png", {8, 16, true, false}},
    FormatEntry{"exr", ImageFormat::exr, "openexr", {16, 32, true, true}},
    FormatEntry{"hdr", ImageFormat::hdr, "hdr", {8, 8, false, true}},
    FormatEntry{"tiff", ImageFormat::tiff, "tiff", {8, 16, true, false}},
    FormatEntry{"jpg", ImageFormat::jpeg, "jpeg", {8, 8, false, false}},
    FormatEntry{"ppm", ImageFormat::ppm, "pnm", {8, 16, false, false}},
    FormatEntry{"tga", ImageFormat::tga, "targa", {8, 8, true, false}},
    FormatEntry{"bmp", ImageFormat::bmp, "bmp", {8, 8, true, false}},
    FormatEntry{"tif", ImageFormat::tiff, "tiff", {8, 16, true, false}},
    FormatEntry{"jpeg", ImageFormat::jpeg, "jpeg", {8, 8, false, false}},
};

const FormatEntry& entry_of(ImageFormat format) {
    for (const FormatEntry& entry : formats) {
        if (entry.format == format) return entry;
    }
    return formats[0];
}

/// What a format can hold of an encoding.
Encoding possible(Encoding encoding, const FormatLimits& limits) {
    encoding.alpha = encoding.alpha && limits.alpha;
    encoding.bits = limits.bits_for(encoding.bits);
    return encoding;
}

/// Linear light, RGB or RGBA with the colour as it arrived (not divided by alpha).
std::vector<float> linear_values(const Film& film, const Encoding& encoding) {
    std::vector<float> values;
    values.reserve(film.pixels.size() * (encoding.alpha ? 4 : 3));
    for (const Pixel& p : film.pixels) {
        for (const float v : {p.r, p.g, p.b}) values.push_back(static_cast<float>(to_linear(v, encoding)));
        if (encoding.alpha) values.push_back(1.0f - p.transmittance);
    }
    return values;
}

/// Hands the picture to the module, which writes the whole file at `path`. Returns its complaint, or an empty text.
std::string write_through_module(const Film& film, const std::string& path, const FormatEntry& entry, const Encoding& encoding,
                                 const ImageMetadata& metadata) {
    std::vector<RaytraceText> text;
    for (const auto& [key, value] : metadata.text) text.push_back({key.c_str(), value.c_str()});
    RaytracePicture picture{film.width,
                            film.height,
                            encoding.alpha ? 4 : 3,
                            raytrace_uint8,
                            nullptr,
                            text.data(),
                            text.size(),
                            encoding.file.kind == Curve::Kind::srgb};
    std::vector<float> floats;
    std::vector<std::uint16_t> numbers;
    std::vector<std::uint8_t> bytes;
    if (entry.limits.linear) {
        floats = linear_values(film, encoding);
        picture.sample = encoding.bits == 32 || entry.format == ImageFormat::hdr ? raytrace_float : raytrace_half;
        picture.data = floats.data();
    } else {
        numbers = quantise(film, encoding);
        picture.sample = encoding.bits == 16 ? raytrace_uint16 : raytrace_uint8;
        if (encoding.bits == 8) bytes.assign(numbers.begin(), numbers.end());
        picture.data = encoding.bits == 8 ? static_cast<const void*>(bytes.data()) : numbers.data();
    }
    const char* complaint = image_module().write(path.c_str(), entry.oiio, &picture);
    return complaint ? complaint : "";
}

/// OpenImageIO writes only to names, so the picture is made in a scratch file and copied.
void write_other(const Film& film, OutputFile& file, const FormatEntry& entry, const Encoding& encoding, const ImageMetadata& metadata) {
    const ScratchFile scratch;
    const std::string complaint = write_through_module(film, scratch.path(), entry, encoding, metadata);
    if (!complaint.empty()) file.fail(0, complaint);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> made(std::fopen(scratch.path().c_str(), "rbe"), std::fclose);
    if (!made) file.fail(errno);
    std::vector<char> buffer(1 << 16);
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), made.get())) file.write(buffer.data(), size);
    if (std::ferror(made.get())) file.fail(errno);
}

}  // namespace

bool format_of(const std::string& path, ImageFormat& format) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const FormatEntry& entry : formats) {
        if (extension != fmt::format(".{}", entry.name)) continue;
        format = entry.format;
        return true;
    }
    return false;
}

const char* extension(ImageFormat format) { return entry_of(format).name; }

FormatLimits limits_of(ImageFormat format) { return entry_of(format).limits; }

void write_image(const Film& film, const std::string& path, ImageFormat format, const Encoding& encoding, const ImageMetadata& metadata) {
    const FormatEntry& entry = entry_of(format);
    const Encoding held = possible(encoding, entry.limits);
    OutputFile file(path);
    if (film.width < 1 || film.height < 1) file.fail(0, "the picture has no pixels");
    switch (format) {
        case ImageFormat::png:
            write_png(film, file, held, metadata);
            break;
        case ImageFormat::ppm:
            write_ppm(film, file, held);
            break;
        default:
            write_other(film, file, entry, held, metadata);
    }
    file.commit();
}

void check_image_target(const std::string& path, ImageFormat format) {
    if (format != ImageFormat::png && format != ImageFormat::ppm) (void)image_module();
    check_file_target(path);
}

void check_file_target(const std::string& path) {
    struct stat info {};
    const bool exists = stat(path.c_str(), &info) == 0;
    const bool replaceable = !exists || S_ISREG(info.st_mode) || S_ISDIR(info.st_mode);
    // Opening a pipe would already tell its reader that something comes.
    if (path != "-" && replaceable) const OutputFile probe(path);
}

std::string png_bytes(const Film& film, const Encoding& encoding, const ImageMetadata& metadata) {
    return png_of(film, possible(encoding, limits_of(ImageFormat::png)), metadata);
}

namespace {

/// Where the module puts a picture.
struct Place {
    StoredImage image;
    std::size_t max_pixels = 0;
    bool too_large = false;
};

std::size_t pixels_of(const StoredImage& image) {
    return static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
}

float* begin_picture(void* user, int width, int height, int channels, int max_value) {
    auto& place = *static_cast<Place*>(user);
    StoredImage& image = place.image;
    image.width = width, image.height = height, image.channels = channels, image.max_value = max_value;
    place.too_large = pixels_of(image) > place.max_pixels;
    if (place.too_large) return nullptr;
    try {
        image.values.resize(static_cast<std::size_t>(width) * height * channels);
    } catch (const std::exception&) {
        return nullptr;
    }
    return image.values.data();
}

}  // namespace

void require_pixels(const std::string& path, const StoredImage& image, std::size_t max_pixels) {
    if (pixels_of(image) > max_pixels)
        throw LimitError(
            fmt::format("The picture '{}' has {} x {} pixels, more than {} in all.", path, image.width, image.height, max_pixels));
}

StoredImage read_image(const std::string& path, std::size_t max_pixels) {
    const auto refuse = [&](const char* why) -> void { throw OptionError(fmt::format("Cannot read '{}': {}", path, why)); };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!file) refuse(std::strerror(errno));
    struct stat info {};
    if (fstat(fileno(file.get()), &info) == 0 && S_ISDIR(info.st_mode)) refuse(std::strerror(EISDIR));
    const int first = std::fgetc(file.get());
    if (first == EOF) refuse("the file is empty");
    std::ungetc(first, file.get());
    if (first == 0x89) return read_png(file.get(), path, max_pixels);
    if (first == 'P') {
        StoredImage image = read_pnm(file.get(), path, max_pixels);
        image.kind = StoredImage::Kind::pixmap;
        return image;
    }
    Place place{.image = {}, .max_pixels = max_pixels};
    if (first == 'G') place.image.kind = StoredImage::Kind::gif;
    if (first == 'I' || first == 'M') place.image.kind = StoredImage::Kind::tiff;
    if (first == '#') place.image.kind = StoredImage::Kind::hdr;
    const RaytraceSink sink{begin_picture, &place};
    const char* const complaint = image_module().read(path.c_str(), &sink);
    if (place.too_large) require_pixels(path, place.image, max_pixels);
    if (complaint) refuse(complaint);
    return std::move(place.image);
}

}  // namespace rt
