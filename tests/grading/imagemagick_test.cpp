// The counts of differing pixels against the installed ImageMagick 6, on random pictures of every depth and channel count.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "grading/difference.h"
#include "tests/grading/pictures.h"

namespace rt::imagemagick_test {
namespace {

/// Netpbm's "portable arbitrary map", which holds every kind of picture there is here.
void write_pam(const StoredImage& image, const std::string& path) {
    static const char* const kinds[] = {"GRAYSCALE", "GRAYSCALE_ALPHA", "RGB", "RGB_ALPHA"};
    std::ofstream out(path, std::ios::binary);
    out << "P7\nWIDTH " << image.width << "\nHEIGHT " << image.height << "\nDEPTH " << image.channels << "\nMAXVAL " << image.max_value
        << "\nTUPLTYPE " << kinds[image.channels - 1] << "\nENDHDR\n";
    for (float value : image.values) {
        const int number = static_cast<int>(value);
        if (image.max_value > 255) out.put(static_cast<char>(number >> 8));
        out.put(static_cast<char>(number & 255));
    }
}

/// Standard error of a command, where `compare` prints its count.
std::string errors_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(("{ " + command + "; } 2>&1 >/dev/null").c_str(), "r");
    if (pipe == nullptr) return text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
    pclose(pipe);
    return text;
}

class ImageMagick : public testing::TestWithParam<std::tuple<int, int, int, int>> {};

TEST_P(ImageMagick, CountsTheSamePixels) {
    if (errors_of("compare -version >&2").find("ImageMagick 6") == std::string::npos) GTEST_SKIP() << "ImageMagick 6 is not installed";
    const auto [channels_a, channels_b, max_a, max_b] = GetParam();
    const std::string folder = std::filesystem::temp_directory_path() / ("raytrace_counts_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    std::mt19937 random(static_cast<unsigned>(channels_a * 10 + channels_b) + static_cast<unsigned>(max_a));
    for (double amount : {0.003, 0.02, 0.12}) {
        StoredImage rgba = test::random_picture(48, 32, 4, 65535, random);
        for (std::size_t i = 3; i < rgba.values.size(); i += 4 * 5) rgba.values[i] = i % 3 == 0 ? 0.0f : 65535.0f;
        const StoredImage moved = test::nudged(rgba, amount, random);
        const auto reduced = [](const StoredImage& from, int channels, int max_value) {
            StoredImage to = test::picture(from.width, from.height, channels, max_value, {});
            for (std::size_t pixel = 0; pixel < from.values.size(); pixel += 4) {
                for (int i = 0; i < channels; ++i) {
                    const bool alpha = channels % 2 == 0 && i == channels - 1;
                    const float value = from.values[pixel + (alpha ? 3 : static_cast<std::size_t>(i))];
                    to.values.push_back(std::round(value * (static_cast<float>(max_value) / 65535.0f)));
                }
            }
            return to;
        };
        const StoredImage a = reduced(rgba, channels_a, max_a), b = reduced(moved, channels_b, max_b);
        write_pam(a, folder + "/a.pam");
        write_pam(b, folder + "/b.pam");
        for (double fuzz : {0.0, 1.0, 5.0, 12.5}) {
            const std::string command =
                "compare -metric AE -fuzz " + std::to_string(fuzz) + "% " + folder + "/a.pam " + folder + "/b.pam null:";
            const Difference result = compare(a, b, {fuzz});
            EXPECT_EQ(std::to_string(result.differing), errors_of(command)) << command << ", amount " << amount;
            if (fuzz == 0.0) {
                EXPECT_EQ(result.differing, result.differing_0);
            }
            if (fuzz == 1.0) {
                EXPECT_EQ(result.differing, result.differing_1);
            }
        }
    }
    std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ImageMagick,
                         testing::Combine(testing::Values(1, 2, 3, 4), testing::Values(1, 2, 3, 4), testing::Values(255, 65535),
                                          testing::Values(255, 65535)));

}  // namespace
}  // namespace rt::imagemagick_test
