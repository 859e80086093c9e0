#include "commands/job/surroundings.h"

#include "film/encode.h"
#include "film/image_file.h"

namespace rt {

namespace {

Film linear_film(const std::string& file) {
    const StoredImage stored = read_image(file);
    const Encoding from_srgb{.working = {Curve::Kind::srgb, 1.0}};
    const auto light = [&](float value) {
        return static_cast<float>(stored.max_value == 0 ? value : to_linear(static_cast<double>(value) / stored.max_value, from_srgb));
    };
    Film film(stored.width, stored.height);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const float* values = &stored.values[i * static_cast<std::size_t>(stored.channels)];
        const bool grey = stored.channels < 3;
        film.pixels[i] = {light(values[0]), light(values[grey ? 0 : 1]), light(values[grey ? 0 : 2]), 0.0f};
    }
    return film;
}

}  // namespace

std::shared_ptr<const Environment> read_surroundings(const std::vector<std::string>& files) {
    if (files.empty()) return nullptr;
    if (files.size() == 1) return std::make_shared<const Environment>(Environment::latitude_longitude(linear_film(files[0])));
    std::array<Film, 6> faces;
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = linear_film(files[i]);
    return std::make_shared<const Environment>(Environment::cube(std::move(faces)));
}

}  // namespace rt
