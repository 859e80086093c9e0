#include "tests/causes/mistakes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace rt::test {

namespace {

std::size_t index(const StoredImage& image, int x, int y, std::size_t channel) {
    const int inside_x = std::clamp(x, 0, image.width - 1), inside_y = std::clamp(y, 0, image.height - 1);
    return (static_cast<std::size_t>(inside_y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(inside_x)) *
               static_cast<std::size_t>(image.channels) +
           channel;
}

/// Each value as value(image, x, y, channel) says, rounded and cut off as a file has it.
template <typename Value>
StoredImage made(const StoredImage& image, const Value& value) {
    StoredImage other = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c)
                other.values[index(image, x, y, c)] =
                    std::clamp(std::round(static_cast<float>(value(image, x, y, c))), 0.0f, static_cast<float>(image.max_value));
    return other;
}

StoredImage curved(const StoredImage& image, const std::function<double(double)>& curve) {
    return made(image, [&](const StoredImage& from, int x, int y, std::size_t c) {
        return 255.0 * curve(static_cast<double>(from.values[index(from, x, y, c)]) / 255.0);
    });
}

StoredImage moved(const StoredImage& image, int dx, int dy) {
    return made(image, [&](const StoredImage& from, int x, int y, std::size_t c) { return from.values[index(from, x - dx, y - dy, c)]; });
}

double at(const StoredImage& image, int x, int y, std::size_t c) { return static_cast<double>(image.values[index(image, x, y, c)]); }

StoredImage with_noise(const StoredImage& image, double amount) {
    std::mt19937 random(7);
    std::normal_distribution<double> step(0.0, 255.0 * amount);
    return made(image, [&](const StoredImage& from, int x, int y, std::size_t c) { return at(from, x, y, c) + step(random); });
}

StoredImage with_specks(const StoredImage& image) {
    std::mt19937 random(8);
    StoredImage other = image;
    for (int i = 0; i < image.width * image.height / 12; ++i) {
        const int x = static_cast<int>(random() % static_cast<unsigned>(image.width)),
                  y = static_cast<int>(random() % static_cast<unsigned>(image.height));
        const float value = random() % 2 ? 255.0f : 0.0f;
        for (std::size_t c = 0; c < 3; ++c) other.values[index(image, x, y, c)] = value;
    }
    return other;
}

}  // namespace

const std::vector<Spoil>& spoils() {
    using Image = const StoredImage&;
    static const std::vector<Spoil> all{
        {"mirrored picture",
         {"mirrored"},
         [](Image i) { return made(i, [](Image f, int x, int y, std::size_t c) { return at(f, f.width - 1 - x, y, c); }); }},
        {"flipped picture",
         {"upside down"},
         [](Image i) { return made(i, [](Image f, int x, int y, std::size_t c) { return at(f, x, f.height - 1 - y, c); }); }},
        {"turned picture",
         {"turned by 180 degrees"},
         [](Image i) { return made(i, [](Image f, int x, int y, std::size_t c) { return at(f, f.width - 1 - x, f.height - 1 - y, c); }); }},
        {"BGR",
         {"channels swapped"},
         [](Image i) { return made(i, [](Image f, int x, int y, std::size_t c) { return at(f, x, y, c < 3 ? 2 - c : c); }); }},
        {"negative", {"negative"}, [](Image i) { return curved(i, [](double v) { return 1.0 - v; }); }},
        {"gamma 1/2.2", {"gamma twice"}, [](Image i) { return curved(i, [](double v) { return std::pow(v, 1.0 / 2.2); }); }},
        {"sRGB",
         {"gamma twice"},
         [](Image i) { return curved(i, [](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; }); }},
        {"gamma 2.2", {"gamma missing"}, [](Image i) { return curved(i, [](double v) { return std::pow(v, 2.2); }); }},
        {"gamma 1.8", {"gamma missing"}, [](Image i) { return curved(i, [](double v) { return std::pow(v, 1.8); }); }},
        {"brighter", {"exposure"}, [](Image i) { return curved(i, [](double v) { return 1.35 * v; }); }},
        {"darker", {"exposure"}, [](Image i) { return curved(i, [](double v) { return 0.6 * v; }); }},
        {"moved by 2", {"shifted"}, [](Image i) { return moved(i, 2, 0); }},
        {"moved by 1", {"shifted"}, [](Image i) { return moved(i, 0, -1); }},
        {"half a pixel",
         {"half-pixel shift"},
         [](Image i) {
             return made(i, [](Image f, int x, int y, std::size_t c) {
                 return 0.25 * (at(f, x, y, c) + at(f, x - 1, y, c) + at(f, x, y - 1, c) + at(f, x - 1, y - 1, c));
             });
         }},
        {"noise", {"noise"}, [](Image i) { return with_noise(i, 0.06); }},
        {"strong noise", {"noise"}, [](Image i) { return with_noise(i, 0.2); }},
        {"specks", {"noise"}, [](Image i) { return with_specks(i); }},
        {"black picture", {"black"}, [](Image i) { return curved(i, [](double) { return 0.0; }); }},
        {"one colour", {"one colour"}, [](Image i) { return curved(i, [](double) { return 0.3; }); }},
        {"unfinished",
         {"unfinished"},
         [](Image i) { return made(i, [](Image f, int x, int y, std::size_t c) { return y > f.height / 2 ? 0.0 : at(f, x, y, c); }); }},
    };
    return all;
}

const std::vector<PlantedFault>& planted_faults() {
    static const std::vector<PlantedFault> all{
        {"mirrored", {"mirrored"}},
        {"upside_down", {"upside down"}},
        {"half_pixel", {"half-pixel shift"}},
        {"normal_side", {"wrong normal side"}},
        {"triangle_side", {"wrong normals"}},
        {"normal_by_matrix", {"wrong normals"}},
        {"normal_in_object_space", {"wrong normals"}},
        {"normal_unnormalised", {"normals not normalised"}},
        {"half_unnormalised", {"specular wrong"}},
        {"light_unnormalised", {"light not normalised"}},
        {"object_space_distance", {"distances in object space"}},
        {"offset_missing", {"shadow acne"}},
        {"offset_reversed", {"false shadows"}},
        {"no_shadows", {"missing shadows"}},
        {"glass_without_shadow", {"missing shadows"}},
        {"shadow_from_behind", {"false shadows"}},
        {"unfiltered", {"missing filter"}},
        {"mirror_untinted", {"mirror not tinted"}},
        {"depth_short", {"wrong depth"}},
        {"depth_long", {"wrong depth"}},
        {"ior_inverted", {"refraction ratio"}},
        {"unbent", {"refraction ratio"}},
        {"no_fresnel", {"missing Fresnel"}},
        {"fresnel_sides", {"missing Fresnel", "refraction wrong"}},
        {"no_absorption", {"missing absorption", "missing filter"}},
        {"no_total_reflection", {"no total reflection"}},
        {"no_transmission", {"no refraction"}},
        {"no_reflection", {"no reflection"}},
        {"wrong_mirror", {"reflection wrong"}},
        {"no_ambient", {"ambient missing"}},
        {"no_diffuse", {"diffuse missing"}},
        {"no_specular", {"specular missing"}},
        {"wrong_exponent", {"specular wrong"}},
        {"phong_for_blinn", {"specular wrong"}},
        {"white_lights", {"wrong lamp colour"}},
        {"one_light", {"missing lamps"}},
        {"lit_from_behind", {"diffuse wrong"}},
        {"local_unscaled", {"wrong share"}},
        {"gamma_twice", {"gamma twice"}},
        {"no_antialiasing", {"missing anti-aliasing"}},
        {"black", {"black"}},
    };
    return all;
}

}  // namespace rt::test
