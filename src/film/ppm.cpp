#include "film/ppm.h"

#include <fmt/format.h>

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

}  // namespace rt
