#include "commands/base/difference_file.h"

#include <fmt/format.h>

#include "commands/base/program.h"
#include "grading/difference.h"

namespace rt {

void write_difference_picture(const NamedImage& a, const NamedImage& b, double scale, const std::string& path, ImageFormat format) {
    const StoredImage picture = difference_picture(a.image, b.image, scale);
    Film film(picture.width, picture.height);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const auto channel = [&](std::size_t c) { return picture.values[3 * i + c] / static_cast<float>(picture.max_value); };
        film.pixels[i] = {channel(0), channel(1), channel(2), 0.0f};
    }
    Encoding as_is;
    as_is.raw = true;
    const ImageMetadata metadata{{{"Software", fmt::format("raytrace {}", program_version())},
                                  {"Difference", fmt::format("{} {} scale={}", a.name, b.name, scale)}}};
    write_image(film, path, format, as_is, metadata);
}

}  // namespace rt
