#include "film/ppm.h"

#include <fmt/format.h>

#include <cctype>

#include "core/source.h"

namespace rt {

void write_ppm(const Film& film, OutputFile& file, const Encoding& encoding) {
    Encoding opaque = encoding;
    opaque.alpha = false;
    RowEncoder rows(film, opaque);
    const std::string header = fmt::format("P6\n{} {}\n{}\n", film.width, film.height, encoding.bits == 8 ? 255 : 65535);
    file.write(header.data(), header.size());
    std::vector<std::uint16_t> numbers(static_cast<std::size_t>(film.width) * 3);
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < film.height; ++y) {
        rows.next(numbers.data());
        bytes.clear();
        for (const std::uint16_t n : numbers) {
            if (encoding.bits != 8) bytes.push_back(static_cast<std::uint8_t>(n >> 8));
            bytes.push_back(static_cast<std::uint8_t>(n));
        }
        file.write(bytes.data(), bytes.size());
    }
}

namespace {

/// The numbers of a pixmap, one after the other.
class PixmapReader {
public:
    PixmapReader(std::FILE* file, const std::string& path) : file_(file), path_(path) {}

    [[noreturn]] void refuse(const char* why) const { throw OptionError(fmt::format("Cannot read '{}': {}", path_, why)); }

    int byte() {
        const int c = std::fgetc(file_);
        if (c == EOF) refuse("the file is too short for its picture");
        return c;
    }

    /// A decimal number after blanks and comments; the one character behind it is taken, too.
    int number() {
        int c = byte();
        while (c == '#' || std::isspace(c)) {
            while (c == '#' && byte() != '\n') {
            }
            c = byte();
        }
        int value = 0;
        for (; std::isdigit(c); c = std::fgetc(file_)) {
            value = 10 * value + (c - '0');
            if (value > 10'000'000) refuse("a number is too large");
        }
        if (c != EOF && !std::isspace(c)) refuse("a character is no part of a pixmap");
        return value;
    }

    int binary(int largest) {
        const int first = byte();
        return largest > 255 ? first << 8 | byte() : first;
    }

private:
    std::FILE* file_;
    const std::string& path_;
};

}  // namespace

StoredImage read_pnm(std::FILE* file, const std::string& path, std::size_t max_pixels) {
    PixmapReader reader(file, path);
    const int magic = reader.byte() == 'P' ? reader.byte() : 0;
    if (magic != '2' && magic != '3' && magic != '5' && magic != '6') reader.refuse("it is no grey or colour pixmap");
    StoredImage image;
    image.channels = magic == '3' || magic == '6' ? 3 : 1;
    image.width = reader.number();
    image.height = reader.number();
    image.max_value = reader.number();
    if (image.width < 1 || image.height < 1) reader.refuse("the picture has no pixels");
    if (image.max_value < 1 || image.max_value > 65535) reader.refuse("its largest value is not in 1..65535");
    require_pixels(path, image, max_pixels);
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height * image.channels;
    // Grows with what is really there: the header may promise anything.
    for (std::size_t i = 0; i < count; ++i) {
        const int value = magic >= '5' ? reader.binary(image.max_value) : reader.number();
        if (value > image.max_value) reader.refuse("a value is larger than its largest value");
        image.values.push_back(static_cast<float>(value));
    }
    return image;
}

}  // namespace rt
