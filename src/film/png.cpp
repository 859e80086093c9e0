#include "film/png.h"

#include <fmt/format.h>
#include <png.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstring>

#include "core/source.h"

namespace rt {
namespace {

/// zlib packs at most this many bytes into one; a header that promises more than the file can hold is damaged.
constexpr std::size_t max_packing = 1032;

/// What libpng had to say before it jumped out.
struct Complaint {
    char text[200] = "";
    int code = 0;  ///< errno at that moment
};

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
    auto* complaint = static_cast<Complaint*>(png_get_error_ptr(png));
    complaint->code = errno;
    std::strncpy(complaint->text, text, sizeof complaint->text - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

/// Runs libpng calls; false if libpng gave up. The jump skips destructors, so `calls` creates nothing that needs one.
template <typename Calls>
bool guarded(png_structp png, const Calls& calls) {
    if (setjmp(png_jmpbuf(png))) return false;
    calls();
    return true;
}

struct Writer {
    Complaint complaint;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    Writer() = default;
    Writer(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
    Complaint complaint;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    Reader() = default;
    Reader(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// gAMA times 100000: the exponent that encodes linear light, 1/2.2 for the sRGB curve.
png_fixed_point gamma_chunk(const Curve& curve) {
    if (curve.kind == Curve::Kind::srgb) return 45455;
    const double gamma = std::abs(curve.power - 1.0) <= 0.01 ? 1.0 : curve.power;
    return static_cast<png_fixed_point>(std::lround(100000.0 / gamma));
}

std::vector<png_text> text_chunks(const ImageMetadata& metadata) {
    std::vector<png_text> chunks;
    for (const auto& [key, value] : metadata.text) {
        png_text chunk{};
        chunk.compression = PNG_TEXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(key.c_str());
        chunk.text = const_cast<char*>(value.c_str());
        chunk.text_length = value.size();
        chunks.push_back(chunk);
    }
    return chunks;
}

void write_header(const Writer& writer, const Film& film, const Encoding& encoding, const std::vector<png_text>& text) {
    const auto bits = static_cast<png_byte>(encoding.bits);
    png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(film.width), static_cast<png_uint_32>(film.height), bits,
                 encoding.alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_gAMA_fixed(writer.png, writer.info, gamma_chunk(encoding.file));
    if (encoding.file.kind == Curve::Kind::srgb) png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(writer.png, writer.info, text.data(), static_cast<int>(text.size()));
    // Half the time of zlib's default level for files 3 % larger.
    png_set_compression_level(writer.png, 2);
    png_set_filter(writer.png, 0, PNG_FILTER_UP);
    png_write_info(writer.png, writer.info);
}

/// File order: one byte a number, or two with the higher one first.
void store(const std::vector<std::uint16_t>& numbers, int bits, std::vector<png_byte>& bytes) {
    png_byte* out = bytes.data();
    for (const std::uint16_t n : numbers) {
        if (bits == 16) *out++ = static_cast<png_byte>(n >> 8);
        *out++ = static_cast<png_byte>(n);
    }
}

void append(png_structp png, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

/// The whole file, to wherever the writer's bytes go; false if libpng gave up.
bool write_film(const Writer& writer, const Film& film, const Encoding& encoding, const ImageMetadata& metadata) {
    RowEncoder rows(film, encoding);
    std::vector<std::uint16_t> numbers(static_cast<std::size_t>(film.width) * rows.channels());
    std::vector<png_byte> bytes(numbers.size() * (encoding.bits / 8));
    const std::vector<png_text> text = text_chunks(metadata);
    if (!guarded(writer.png, [&] { write_header(writer, film, encoding, text); })) return false;
    for (int y = 0; y < film.height; ++y) {
        rows.next(numbers.data());
        store(numbers, encoding.bits, bytes);
        if (!guarded(writer.png, [&] { png_write_row(writer.png, bytes.data()); })) return false;
    }
    return guarded(writer.png, [&] { png_write_end(writer.png, writer.info); });
}

/// For PNG files that are made in memory.
void check(bool good, const Writer& writer) {
    if (!good) throw OutputError(fmt::format("cannot make a PNG: {}", writer.complaint.text));
}

}  // namespace

void write_png(const Film& film, OutputFile& file, const Encoding& encoding, const ImageMetadata& metadata) {
    Writer writer;
    if (!writer.info) file.fail(ENOMEM);
    png_init_io(writer.png, file.stream());
    if (write_film(writer, film, encoding, metadata)) return;
    const int code = std::ferror(file.stream()) ? writer.complaint.code : 0;
    file.fail(code, code ? "" : writer.complaint.text);
}

std::string png_of(const Film& film, const Encoding& encoding, const ImageMetadata& metadata) {
    Writer writer;
    check(writer.info, writer);
    std::string file;
    png_set_write_fn(writer.png, &file, append, nullptr);
    check(write_film(writer, film, encoding, metadata), writer);
    return file;
}

namespace {

/// The factor from stored numbers to those of a PNG with `bits`.
float scale_to(int bits, int max_value) {
    const float full = bits == 16 ? 65535.0f : 255.0f;
    return max_value > 0 ? full / static_cast<float>(max_value) : full;
}

/// Row `y` of the picture as numbers of a PNG.
void row_numbers(const StoredImage& image, int y, float scale, float full, std::vector<std::uint16_t>& numbers) {
    const float* values = image.values.data() + static_cast<std::size_t>(y) * numbers.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const float value = scale * values[i];
        numbers[i] = static_cast<std::uint16_t>(std::lround(value > 0.0f ? std::min(value, full) : 0.0f));  // what is no number is 0
    }
}

}  // namespace

std::string png_of(const StoredImage& image) {
    constexpr int color_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    Writer writer;
    check(writer.info, writer);
    const int bits = image.max_value > 0 && image.max_value <= 255 ? 8 : 16;
    const float scale = scale_to(bits, image.max_value), full = bits == 16 ? 65535.0f : 255.0f;
    std::string file;
    check(guarded(writer.png,
                  [&] {
                      png_set_write_fn(writer.png, &file, append, nullptr);
                      png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
                      png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                                   bits, color_types[image.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                                   PNG_FILTER_TYPE_DEFAULT);
                      png_set_compression_level(writer.png, 2);
                      png_set_filter(writer.png, 0, PNG_FILTER_UP);
                      png_write_info(writer.png, writer.info);
                  }),
          writer);
    std::vector<std::uint16_t> numbers(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels));
    std::vector<png_byte> bytes(numbers.size() * static_cast<std::size_t>(bits / 8));
    for (int y = 0; y < image.height; ++y) {
        row_numbers(image, y, scale, full, numbers);
        store(numbers, bits, bytes);
        check(guarded(writer.png, [&] { png_write_row(writer.png, bytes.data()); }), writer);
    }
    check(guarded(writer.png, [&] { png_write_end(writer.png, writer.info); }), writer);
    return file;
}

namespace {

/// A palette as red, green, blue and alpha.
using Palette = std::array<std::array<png_byte, 4>, 256>;

Palette palette_of(const Reader& reader) {
    Palette palette{};
    png_colorp colors = nullptr;
    png_bytep alphas = nullptr;
    int count = 0, alpha_count = 0;
    png_get_PLTE(reader.png, reader.info, &colors, &count);
    png_get_tRNS(reader.png, reader.info, &alphas, &alpha_count, nullptr);
    for (int i = 0; i < count; ++i)
        palette[static_cast<std::size_t>(i)] = {colors[i].red, colors[i].green, colors[i].blue,
                                                i < alpha_count ? alphas[i] : png_byte{255}};
    return palette;
}

/// From the numbers of the palette's entries to colours; with alpha if any entry says so.
void look_up(const Reader& reader, std::vector<png_byte> indices, StoredImage& image) {
    const Palette palette = palette_of(reader);
    image.channels = png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0 ? 4 : 3;
    image.values.reserve(indices.size() * static_cast<std::size_t>(image.channels));
    for (const png_byte index : indices)
        image.values.insert(image.values.end(), palette[index].begin(), palette[index].begin() + image.channels);
    image.indices = std::move(indices);
}

/// Reads the header and asks for whole 8- or 16-bit channels, or the numbers of a palette's entries.
void read_header(const Reader& reader, std::FILE* file, StoredImage& image) {
    png_init_io(reader.png, file);
    png_read_info(reader.png, reader.info);
    if (png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE)
        png_set_packing(reader.png);
    else
        png_set_expand(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    image.channels = png_get_channels(reader.png, reader.info);
    image.max_value = png_get_bit_depth(reader.png, reader.info) == 16 ? 65535 : 255;
    png_fixed_point encoded = 0;
    if (png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) == 0 && png_get_gAMA_fixed(reader.png, reader.info, &encoded) != 0 &&
        encoded > 0)
        image.gamma = 1e5 / encoded;
}

}  // namespace

StoredImage read_png(std::FILE* file, const std::string& path, std::size_t max_pixels) {
    Reader reader;
    const auto refuse = [&](const char* why) { throw OptionError(fmt::format("Cannot read '{}': {}", path, why)); };
    if (!reader.info) refuse(std::strerror(ENOMEM));
    StoredImage image;
    image.kind = StoredImage::Kind::png;
    if (!guarded(reader.png, [&] { read_header(reader, file, image); })) refuse(reader.complaint.text);
    require_pixels(path, image, max_pixels);
    const std::size_t row = static_cast<std::size_t>(image.width) * image.channels * (image.max_value == 255 ? 1 : 2);
    struct stat info {};
    if (fstat(fileno(file), &info) == 0 && S_ISREG(info.st_mode) &&
        row * image.height / max_packing > static_cast<std::size_t>(info.st_size))
        refuse("the file is too short for its picture");
    std::vector<png_byte> bytes(row * image.height);
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.height; ++y) rows.push_back(bytes.data() + y * row);
    if (!guarded(reader.png, [&] {
            png_read_image(reader.png, rows.data());
            png_read_end(reader.png, nullptr);
        }))
        refuse(reader.complaint.text);
    if (png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE) {
        look_up(reader, std::move(bytes), image);
        return image;
    }
    image.values.reserve(static_cast<std::size_t>(image.width) * image.height * image.channels);
    if (image.max_value == 255) {
        image.values.assign(bytes.begin(), bytes.end());
    } else {
        for (std::size_t i = 0; i < bytes.size(); i += 2) image.values.push_back(static_cast<float>(bytes[i] << 8 | bytes[i + 1]));
    }
    return image;
}

}  // namespace rt
