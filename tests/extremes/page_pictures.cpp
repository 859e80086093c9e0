#include "tests/extremes/page_pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "film/image_file.h"

namespace rt::extremes {

namespace {

std::string base64(const std::string& data) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < data.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < data.size() ? static_cast<unsigned char>(data[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > data.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

}  // namespace

std::string png(const Bytes& bytes) {
    Film film(bytes.width, bytes.height);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const auto channel = [&](std::size_t k) { return static_cast<float>(bytes.values[3 * i + k]) / 255.0f; };
        film.pixels[i] = {channel(0), channel(1), channel(2), 0.0f};
    }
    Encoding encoding;
    encoding.raw = true;
    const std::string path = std::filesystem::temp_directory_path() / fmt::format("extremes_page_{}.png", getpid());
    write_image(film, path, ImageFormat::png, encoding, {});
    std::ostringstream data;
    data << std::ifstream(path, std::ios::binary).rdbuf();
    std::filesystem::remove(path);
    return data.str();
}

Bytes difference(const Bytes& picture, const Bytes& truth) {
    Bytes result{truth.width, truth.height, {}, 0};
    for (std::size_t i = 0; i < truth.values.size() / 3; ++i) {
        const int steps = steps_apart(picture, truth, i);
        const auto value = [](int x) { return static_cast<std::uint8_t>(x); };
        const int grey = 32 + truth.values[3 * i + 1] / 4;
        if (steps == 0) result.values.insert(result.values.end(), {value(grey), value(grey), value(grey)});
        if (steps == 1) result.values.insert(result.values.end(), {60, 110, 230});
        if (steps > 1) result.values.insert(result.values.end(), {255, value(220 - std::min(220, 4 * steps)), 0});
    }
    return result;
}

std::string image(const std::string& data, std::string_view caption) {
    return fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n", caption,
                       base64(data));
}

}  // namespace rt::extremes
