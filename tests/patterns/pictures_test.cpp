// Normals and the like against POV-Ray's pictures, 16 bits a channel, linear: those kept in pictures.txt, and those of the installed
// povray.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/patterns/cases.h"
#include "tests/patterns/picture_cases.h"

namespace rt::pictures_test {
namespace {

/// Sixteen-bit red, green and blue of every point of the cap, by the case's text.
using Pictures = std::map<std::string, std::vector<int>>;

const std::string kept = PROJECT_ROOT "/tests/patterns/pictures.txt";
constexpr int pitch = 2 * cap_points;  // pixels from one cap to the next: spheres do not touch

void compare(const Pictures& expected) {
    for (const auto& [text, value] : picture_cases()) {
        const auto found = expected.find(text);
        ASSERT_NE(found, expected.end()) << text;
        ASSERT_EQ(found->second.size(), 3U * cap_points * cap_points) << text;
        int wrong = 0;
        std::string first;
        for (int i = 0; i < cap_points * cap_points; ++i) {
            const CapPoint at = cap_point(i % cap_points, i / cap_points);
            const Rgb color = value(at);
            const int* theirs = &found->second[static_cast<std::size_t>(3 * i)];
            double worst = 0.0;
            for (int c = 0; c < 3; ++c) worst = std::fmax(worst, std::fabs(65535.0 * std::fmin(1.0, std::fmax(0.0, color[c])) - theirs[c]));
            if (worst <= 1.5) continue;
            if (wrong++ == 0)
                first = fmt::format("at <{}, {}, {}> {} {} {} instead of {} {} {}", at.p.x, at.p.y, at.p.z, color.r, color.g, color.b,
                                    theirs[0] / 65535.0, theirs[1] / 65535.0, theirs[2] / 65535.0);
        }
        if (wrong > 0) ADD_FAILURE() << text << ": " << wrong << " points differ; " << first;
    }
}

void write_scene(const std::filesystem::path& path, int caps) {
    std::ofstream scene(path);
    scene << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";
    scene << fmt::format("camera {{ orthographic location <{0}, 9, 0> right {1}*x up 6*z direction -y sky z }}\n", 3.0 * (caps - 1),
                         6.0 * caps);
    const char* colors[3] = {"<1, 0, 0>", "<0, 1, 0>", "<0, 0, 1>"};
    for (int i = 0; i < 3; ++i) {
        const Vec3 l = 1000.0 * light_directions[i];
        scene << fmt::format("light_source {{ <{:.17g}, {:.17g}, {:.17g}> rgb {} parallel point_at 0 shadowless }}\n", l.x, l.y, l.z,
                             colors[i]);
    }
    int place = 0;
    for (const PictureCase& one : picture_cases())
        scene << "sphere { 0, 2.9 texture { " << one.text << " } translate " << 6 * place++ << "*x }\n";
}

/// The caps of a picture of all cases side by side.
Pictures read_picture(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string line, header;
    while (header.find("65535") == std::string::npos && std::getline(in, line))
        if (line[0] != '#') header += line + ' ';
    std::istringstream numbers(header.substr(3));  // after "P6"
    int width = 0, height = 0;
    numbers >> width >> height;
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(bytes.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 6);
    Pictures pictures;
    int place = 0;
    for (const PictureCase& one : picture_cases()) {
        for (int row = 0; row < cap_points; ++row)
            for (int column = 0; column < cap_points; ++column)
                for (int c = 0; c < 3; ++c) {
                    const int x = place * pitch + cap_points / 2 + column, y = cap_points / 2 + row;
                    const auto at = static_cast<std::size_t>(6 * (y * width + x) + 2 * c);
                    const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(bytes.at(i))); };
                    pictures[one.text].push_back(256 * byte(at) + byte(at + 1));
                }
        ++place;
    }
    return pictures;
}

TEST(PatternPictures, AreThoseKept) {
    std::ifstream in(kept);
    ASSERT_TRUE(in) << kept;
    Pictures pictures;
    std::string text, line;
    while (std::getline(in, text) && std::getline(in, line)) {
        std::istringstream numbers(line);
        for (int v = 0; numbers >> v;) pictures[text].push_back(v);
    }
    compare(pictures);
}

TEST(PatternPictures, AreThoseOfTheInstalledPovRay) {
    if (std::system("command -v povray > /dev/null 2>&1") != 0) GTEST_SKIP() << "povray is not installed";
    const auto folder = std::filesystem::path(testing::TempDir()) / fmt::format("pattern_pictures_{}", getpid());
    std::filesystem::create_directories(folder);
    const int caps = static_cast<int>(picture_cases().size());
    write_scene(folder / "caps.pov", caps);
    std::ofstream(folder / "cases.pgm", std::ios::binary) << case_picture_file();
    const std::string command = fmt::format("cd '{}' && povray +Icaps.pov +Ocaps.ppm +W{} +H{} +FP16 -A -D File_Gamma=1.0 > log 2>&1",
                                            folder.string(), pitch * caps, pitch);
    ASSERT_EQ(std::system(command.c_str()), 0) << folder;
    const Pictures measured = read_picture(folder / "caps.ppm");
    compare(measured);
    if (std::getenv("WRITE_PATTERN_VALUES") != nullptr) {
        std::ofstream out(kept);
        for (const PictureCase& one : picture_cases()) {
            out << one.text << "\n";
            for (const int v : measured.at(one.text)) out << v << " ";
            out << "\n";
        }
    }
    if (!HasFailure()) std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rt::pictures_test
