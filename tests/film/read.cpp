// Reading: every kind of PNG, damaged files, and which libraries a PNG run touches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/source.h"
#include "film/image_file.h"
#include "film/png.h"
#include "tests/film/module.h"

namespace rt {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class Reading : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "test_read.XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string file(const std::string& content) const {
        const std::string path = (folder / "picture").string();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    static std::string failure(const std::string& path) {
        try {
            read_image(path);
        } catch (const OptionError& error) {
            return error.what();
        }
        return "no error";
    }

    /// A PNG of one row, made by libpng from packed samples.
    StoredImage png(int width, int bits, int type, std::vector<png_byte> row, int interlace = PNG_INTERLACE_NONE,
                    bool transparent = false) const {
        const std::string path = (folder / "made.png").string();
        std::FILE* out = std::fopen(path.c_str(), "wb");
        png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
        png_infop info = png_create_info_struct(png);
        png_init_io(png, out);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), 1, bits, type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        const png_color palette[] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}, {255, 0, 128}};
        if (type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 4);
        png_byte alphas[] = {255, 128};
        png_color_16 key{};
        key.gray = 1;
        if (transparent) png_set_tRNS(png, info, alphas, 2, &key);
        png_write_info(png, info);
        png_set_interlace_handling(png);
        png_bytep rows[] = {row.data()};
        png_write_image(png, rows);
        png_write_end(png, info);
        png_destroy_write_struct(&png, &info);
        std::fclose(out);
        return read_image(path);
    }

    fs::path folder;
};

TEST_F(Reading, APictureOfMorePixelsThanAllowedIsALimit) {
    const auto error = [](const std::string& path, std::size_t most) -> std::string {
        try {
            read_image(path, most);
        } catch (const LimitError& limit) {
            return limit.what();
        }
        return "read";
    };
    const std::string pixmap = file("P2 3 2 9\n1 2 3 4 5 6");
    EXPECT_EQ(error(pixmap, 6), "read");
    EXPECT_EQ(error(pixmap, 5), "The picture '" + pixmap + "' has 3 x 2 pixels, more than 5 in all.");
    EXPECT_EQ(error(file("P6 9999999 9999999 255\n"), 1'000'000'000).find("The picture '"), 0u);
    png(4, 8, PNG_COLOR_TYPE_GRAY, {1, 2, 3, 4});
    const std::string made = (folder / "made.png").string();
    EXPECT_EQ(error(made, 4), "read");
    EXPECT_EQ(error(made, 3), "The picture '" + made + "' has 4 x 1 pixels, more than 3 in all.");
}

TEST_F(Reading, GreyOfEveryDepth) {
    EXPECT_THAT(png(4, 1, PNG_COLOR_TYPE_GRAY, {0b01010000}).values, ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(png(4, 2, PNG_COLOR_TYPE_GRAY, {0b00011011}).values, ElementsAre(0, 85, 170, 255));
    EXPECT_THAT(png(2, 4, PNG_COLOR_TYPE_GRAY, {0x1f}).values, ElementsAre(17, 255));
    EXPECT_THAT(png(2, 8, PNG_COLOR_TYPE_GRAY, {7, 200}).values, ElementsAre(7, 200));
    const StoredImage deep = png(2, 16, PNG_COLOR_TYPE_GRAY, {1, 2, 255, 255});
    EXPECT_THAT(deep.values, ElementsAre(258, 65535));
    EXPECT_EQ(deep.max_value, 65535);
    EXPECT_EQ(deep.channels, 1);
    EXPECT_THAT(png(1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 8}).values, ElementsAre(9, 8));
}

TEST_F(Reading, Palettes) {
    const StoredImage plain = png(3, 2, PNG_COLOR_TYPE_PALETTE, {0b00110100});
    EXPECT_EQ(plain.channels, 3);
    EXPECT_THAT(plain.values, ElementsAre(10, 20, 30, 255, 0, 128, 40, 50, 60));
    EXPECT_EQ(plain.kind, StoredImage::Kind::png);
    EXPECT_THAT(plain.indices, ElementsAre(0, 3, 1));
    const StoredImage clear = png(2, 8, PNG_COLOR_TYPE_PALETTE, {1, 2}, PNG_INTERLACE_NONE, true);
    EXPECT_THAT(clear.values, ElementsAre(40, 50, 60, 128, 70, 80, 90, 255));
}

TEST_F(Reading, TransparentColourBecomesAlpha) {
    EXPECT_THAT(png(2, 8, PNG_COLOR_TYPE_GRAY, {1, 2}, PNG_INTERLACE_NONE, true).values, ElementsAre(1, 0, 2, 255));
}

TEST_F(Reading, Interlaced) {
    EXPECT_THAT(png(5, 8, PNG_COLOR_TYPE_GRAY, {1, 2, 3, 4, 5}, PNG_INTERLACE_ADAM7).values, ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(Reading, PixmapsPlainAndBinary) {
    EXPECT_THAT(read_image(file("P3\n# made by hand\n2 1 # two\n100\n0 50 100  1 2 3")).values, ElementsAre(0, 50, 100, 1, 2, 3));
    EXPECT_EQ(read_image(file("P2 1 1 100 7\n")).max_value, 100);
    EXPECT_THAT(read_image(file("P2 1 2 9\n7 8")).values, ElementsAre(7, 8));
    EXPECT_THAT(read_image(file("P5 2 1 255\n a")).values, ElementsAre(32, 97));
    EXPECT_THAT(read_image(file(std::string("P6 1 1 65535\n\0\1\2\0\3\4", 19))).values, ElementsAre(1, 512, 772));
    for (const char* wrong : {"P6 2 1 255\nabc", "P3 1 1 255\n1 2", "P3 1 1 255\n1 2 256", "P7 1 1 1", "P3 0 1 255\n", "P6 -1 1 255\n",
                              "P3", "P3 1 1 0\n0 0 0", "P3 1 1 70000\n0 0 0", "P3 99999999999 1 255\n", "P6 9999999 9999999 255\nabc"}) {
        EXPECT_THAT(failure(file(wrong)), HasSubstr("Cannot read '")) << wrong;
    }
}

TEST_F(Reading, ErrorsNameTheFile) {
    const std::string none = (folder / "none.png").string();
    EXPECT_EQ(failure(none), "Cannot read '" + none + "': No such file or directory");
    EXPECT_EQ(failure(folder.string()), "Cannot read '" + folder.string() + "': Is a directory");
    const std::string empty = file("");
    EXPECT_EQ(failure(empty), "Cannot read '" + empty + "': the file is empty");
    EXPECT_THAT(failure(file("\x89PNG but not really")), HasSubstr("corrupted by ASCII conversion"));
}

TEST_F(Reading, WhatIsNoPictureIsRefused) {
    NEEDS_IMAGE_MODULE();
    EXPECT_THAT(failure(file("sphere { 0, 1 }\n")), HasSubstr("Cannot read '"));
}

TEST_F(Reading, EveryTruncationIsAnErrorAndNoCrash) {
    Film film(20, 20);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) film.pixels[i].r = static_cast<float>(i % 7) / 7.0f;
    const std::string path = (folder / "whole.png").string();
    write_image(film, path, ImageFormat::png, {}, {});
    std::ifstream in(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    // The last chunk's checksum is not needed to know every pixel.
    for (std::size_t size = 1; size + 12 < whole.size(); ++size) EXPECT_NE(failure(file(whole.substr(0, size))), "no error") << size;
}

TEST_F(Reading, AHugeSizeInAShortFileIsRefusedBeforeMemoryIsTaken) {
    // Header of 900,000 x 900,000 pixels at 16 bits with a valid checksum.
    std::string header = "\x89PNG\r\n\x1a\n";
    const png_byte chunk[] = {'I', 'H', 'D', 'R', 0, 0x0d, 0xbb, 0xa0, 0, 0x0d, 0xbb, 0xa0, 16, 2, 0, 0, 0};
    header += std::string("\0\0\0\x0d", 4) + std::string(chunk, chunk + sizeof chunk);
    std::uint32_t crc = 0xffffffffu;
    for (const png_byte byte : chunk) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    for (int shift = 24; shift >= 0; shift -= 8) header += static_cast<char>((~crc >> shift) & 0xff);
    header += std::string("\0\0\0\x01", 4) + "IDAT";
    EXPECT_THAT(failure(file(header)), HasSubstr("too short"));
}

bool maps_openimageio() {
    std::ifstream maps("/proc/self/maps");
    const std::string all{std::istreambuf_iterator<char>(maps), {}};
    return all.find("libOpenImageIO") != std::string::npos;
}

TEST_F(Reading, OnlyOtherFormatsLoadOpenImageIO) {
    NEEDS_IMAGE_MODULE();
    // In a fresh process, where no other test has loaded it.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            const std::string path = (folder / "p").string();
            write_image(Film(4, 4), path, ImageFormat::png, {}, {});
            read_image(path);
            write_image(Film(4, 4), path, ImageFormat::ppm, {}, {});
            read_image(path);
            const bool before = maps_openimageio();
            write_image(Film(4, 4), path, ImageFormat::bmp, {}, {});
            _exit(!before && maps_openimageio() ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

/// Back through the reader: numbers as they were.
TEST_F(Reading, APictureAsPngHasItsNumbers) {
    const StoredImage images[] = {{2, 1, 1, 255, {0, 255}},
                                  {1, 2, 2, 255, {1, 2, 3, 4}},
                                  {2, 1, 3, 65535, {0, 1, 2, 65535, 40000, 257}},
                                  {1, 1, 4, 255, {1, 2, 3, 4}}};
    for (const StoredImage& image : images) {
        const StoredImage back = read_image(file(png_of(image)));
        EXPECT_EQ(back.width, image.width);
        EXPECT_EQ(back.height, image.height);
        EXPECT_EQ(back.channels, image.channels);
        EXPECT_EQ(back.max_value, image.max_value);
        EXPECT_EQ(back.values, image.values);
    }
}

TEST_F(Reading, OtherNumbersAreScaledToThoseOfAPng) {
    EXPECT_THAT(read_image(file(png_of({3, 1, 1, 15, {0, 5, 15}}))).values, ElementsAre(0, 85, 255));
    EXPECT_THAT(read_image(file(png_of({2, 1, 1, 1000, {500, 1000}}))).values, ElementsAre(32768, 65535));
    EXPECT_THAT(read_image(file(png_of({5, 1, 1, 0, {0.0f, 0.5f, 2.0f, -1.0f, std::nanf("")}}))).values,
                ElementsAre(0, 32768, 65535, 0, 0));
}

}  // namespace
}  // namespace rt
