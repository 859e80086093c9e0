// Pictures to files and back: what is in the file, and what is left when writing fails.
#include "film/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/source.h"
#include "tests/film/module.h"

namespace rt {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

Encoding linear_file(int bits = 8) {
    Encoding e;
    e.file = Curve{};
    e.bits = bits;
    return e;
}

/// Every pixel of its own colour.
Film ramp(int width, int height) {
    Film film(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            film.at(x, y) = {static_cast<float>(x) / static_cast<float>(width), static_cast<float>(y) / static_cast<float>(height), 0.25f,
                             0.5f};
        }
    }
    return film;
}

class Files : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "test_film.XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string in(const std::string& name) const { return (folder / name).string(); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }
    static std::string content(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static std::string failure(const std::string& path, const Film& film = Film(2, 2)) {
        try {
            write_image(film, path, ImageFormat::png, linear_file(), {});
        } catch (const OutputError& error) {
            return error.what();
        }
        return "no error";
    }

    fs::path folder;
};

TEST(Format, ByExtension) {
    ImageFormat format{};
    EXPECT_TRUE(format_of("a/b.PNG", format));
    EXPECT_EQ(format, ImageFormat::png);
    EXPECT_TRUE(format_of("x.y.jpg", format));
    EXPECT_EQ(format, ImageFormat::jpeg);
    EXPECT_TRUE(format_of("x.tif", format));
    EXPECT_EQ(format, ImageFormat::tiff);
    for (const char* other : {"png", "", "a.pov", "dir.png/file", ".png"}) EXPECT_FALSE(format_of(other, format)) << other;
    EXPECT_STREQ(extension(ImageFormat::exr), "exr");
    EXPECT_STREQ(extension(ImageFormat::jpeg), "jpg");
}

class RoundTrip : public Files, public testing::WithParamInterface<std::tuple<std::string, int, bool>> {};

TEST_P(RoundTrip, NumbersComeBack) {
    const auto& [name, bits, alpha] = GetParam();
    const std::string path = in("picture." + name);
    const Film film = ramp(13, 7);
    Encoding e = linear_file(bits);
    e.alpha = alpha;
    ImageFormat format{};
    ASSERT_TRUE(format_of(path, format));
    if (format != ImageFormat::png && format != ImageFormat::ppm) NEEDS_IMAGE_MODULE();
    write_image(film, path, format, e, {{{"Title", "round trip"}}});
    const StoredImage image = read_image(path);
    EXPECT_EQ(image.width, 13);
    EXPECT_EQ(image.height, 7);
    ASSERT_EQ(image.channels, alpha ? 4 : 3);
    EXPECT_EQ(image.max_value, bits == 8 ? 255 : 65535);
    const std::vector<std::uint16_t> numbers = quantise(film, e);
    EXPECT_EQ(image.values, std::vector<float>(numbers.begin(), numbers.end()));
    EXPECT_THAT(names(), ElementsAre("picture." + name));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         testing::Values(std::tuple{"png", 8, false}, std::tuple{"png", 16, false}, std::tuple{"png", 8, true},
                                         std::tuple{"png", 16, true}, std::tuple{"ppm", 8, false}, std::tuple{"ppm", 16, false},
                                         std::tuple{"tiff", 8, false}, std::tuple{"tiff", 16, true}, std::tuple{"tga", 8, false},
                                         std::tuple{"tga", 8, true}, std::tuple{"bmp", 8, false}),
                         [](const auto& info) {
                             return std::get<0>(info.param) + std::to_string(std::get<1>(info.param)) +
                                    (std::get<2>(info.param) ? "a" : "");
                         });

TEST_F(Files, LinearFormatsHoldUnclampedLight) {
    NEEDS_IMAGE_MODULE();
    Film film(1, 1);
    film.at(0, 0) = {2.5f, 0.25f, 0.0625f, 0.0f};
    Encoding e;
    e.file = {Curve::Kind::power, 2.2};
    for (const char* name : {"p.exr", "p.hdr"}) {
        ImageFormat format{};
        ASSERT_TRUE(format_of(name, format));
        write_image(film, in(name), format, e, {});
        const StoredImage image = read_image(in(name));
        EXPECT_EQ(image.max_value, 0);
        EXPECT_THAT(image.values, ElementsAre(2.5f, 0.25f, 0.0625f)) << name;
    }
    e.working = {Curve::Kind::power, 2.2};
    e.bits = 32;
    write_image(film, in("q.exr"), ImageFormat::exr, e, {});
    const StoredImage image = read_image(in("q.exr"));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.values[c] / std::exp(2.2 * std::log(double{(&film.at(0, 0).r)[c]})), 1.0, 1e-6);
}

TEST_F(Files, JpegIsClose) {
    NEEDS_IMAGE_MODULE();
    write_image(ramp(64, 48), in("p.jpg"), ImageFormat::jpeg, linear_file(), {});
    const StoredImage image = read_image(in("p.jpg"));
    const std::vector<std::uint16_t> numbers = quantise(ramp(64, 48), linear_file());
    ASSERT_EQ(image.values.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_NEAR(image.values[i], numbers[i], 12.0);
}

TEST_F(Files, AlphaIsLeftOutWhereAFormatHasNone) {
    NEEDS_IMAGE_MODULE();
    Encoding e = linear_file();
    e.alpha = true;
    for (const char* name : {"p.ppm", "p.jpg", "p.hdr"}) {
        ImageFormat format{};
        ASSERT_TRUE(format_of(name, format));
        write_image(ramp(4, 4), in(name), format, e, {});
        EXPECT_EQ(read_image(in(name)).channels, 3) << name;
    }
}

TEST_F(Files, ReplacesAnOlderPictureAndKeepsItsPermissions) {
    std::ofstream(in("p.png")) << "old";
    chmod(in("p.png").c_str(), 0640);
    write_image(ramp(5, 5), in("p.png"), ImageFormat::png, linear_file(), {});
    EXPECT_EQ(read_image(in("p.png")).width, 5);
    struct stat info {};
    stat(in("p.png").c_str(), &info);
    EXPECT_EQ(info.st_mode & 0777u, 0640u);
}

TEST_F(Files, SymbolicLinksStayAndTheirTargetsAreReplaced) {
    fs::create_directory(folder / "far");
    std::ofstream(in("far/real.png")) << "old";
    fs::create_symlink("far/real.png", folder / "link.png");
    fs::create_symlink("far/new.png", folder / "dangling.png");
    write_image(ramp(3, 3), in("link.png"), ImageFormat::png, linear_file(), {});
    write_image(ramp(4, 4), in("dangling.png"), ImageFormat::png, linear_file(), {});
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    EXPECT_TRUE(fs::is_symlink(folder / "dangling.png"));
    EXPECT_EQ(read_image(in("far/real.png")).width, 3);
    EXPECT_EQ(read_image(in("far/new.png")).width, 4);
    EXPECT_THAT(names(), ElementsAre("dangling.png", "far", "link.png"));
}

TEST_F(Files, ErrorsNameThePathAndTheReason) {
    EXPECT_EQ(failure(in("none/p.png")), "Cannot write '" + in("none/p.png") + "': No such file or directory");
    EXPECT_EQ(failure(folder.string()), "Cannot write '" + folder.string() + "': Is a directory");
    EXPECT_EQ(failure("/dev/full", ramp(200, 200)), "Cannot write '/dev/full': No space left on device");
    EXPECT_EQ(failure(""), "Cannot write '': No such file or directory");
    const std::string loop = in("loop.png");
    fs::create_symlink("loop.png", loop);
    EXPECT_EQ(failure(loop), "Cannot write '" + loop + "': Too many levels of symbolic links");
    const std::string long_name = in(std::string(300, 'n') + ".png");
    EXPECT_EQ(failure(long_name), "Cannot write '" + long_name + "': File name too long");
    EXPECT_THAT(names(), ElementsAre("loop.png"));
}

TEST_F(Files, TheLongestNameIsPossible) {
    const std::string name = std::string(251, 'n') + ".png";
    write_image(ramp(3, 3), in(name), ImageFormat::png, linear_file(), {});
    EXPECT_THAT(names(), ElementsAre(name));
}

TEST_F(Files, DevicesAreNotReplaced) {
    write_image(ramp(3, 3), "/dev/null", ImageFormat::png, linear_file(), {});
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// Runs `act` in a child process that lives under other limits; true if it says so.
template <typename Act>
bool in_child(const Act& act) {
    const pid_t child = fork();
    if (child == 0) _exit(act() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(Files, AFullDiskLeavesTheOldPictureAndNoRemains) {
    NEEDS_IMAGE_MODULE();
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::ppm, ImageFormat::tiff}) {
        std::ofstream(in("p")) << "old";
        EXPECT_TRUE(in_child([&] {
            // The kernel's nearest equivalent that needs no file system of its own: files may not grow beyond 1000 bytes.
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{1000, 1000};
            setrlimit(RLIMIT_FSIZE, &limit);
            try {
                write_image(ramp(100, 100), in("p"), format, linear_file(16), {});
            } catch (const OutputError& error) {
                return std::string(error.what()).starts_with("Cannot write '" + in("p") + "': ");
            }
            return false;
        })) << extension(format);
        EXPECT_EQ(content(in("p")), "old");
        EXPECT_THAT(names(), ElementsAre("p"));
    }
}

TEST_F(Files, ReadOnlyFilesAndFoldersAreRespected) {
    std::ofstream(in("p.png")) << "old";
    chmod(in("p.png").c_str(), 0444);
    fs::create_directory(folder / "closed");
    chmod(in("closed").c_str(), 0555);
    chmod(folder.c_str(), 0777);
    EXPECT_TRUE(in_child([&] {
        // The superuser may write everywhere.
        if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0) return false;
        return failure(in("p.png")) == "Cannot write '" + in("p.png") + "': Permission denied" &&
               failure(in("closed/p.png")) == "Cannot write '" + in("closed/p.png") + "': Permission denied";
    }));
    EXPECT_EQ(content(in("p.png")), "old");
    EXPECT_THAT(names(), ElementsAre("closed", "p.png"));
}

TEST_F(Files, StandardOutputGetsTheSameBytes) {
    NEEDS_IMAGE_MODULE();
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::ppm, ImageFormat::bmp}) {
        write_image(ramp(9, 9), in("file"), format, linear_file(), {});
        EXPECT_TRUE(in_child([&] {
            if (!std::freopen(in("piped").c_str(), "wb", stdout)) return false;
            write_image(ramp(9, 9), "-", format, linear_file(), {});
            return true;
        }));
        EXPECT_EQ(content(in("piped")), content(in("file"))) << extension(format);
    }
}

TEST_F(Files, TargetsAreCheckedWithoutATrace) {
    NEEDS_IMAGE_MODULE();
    std::ofstream(in("p.png")) << "old";
    check_image_target(in("p.png"), ImageFormat::png);
    check_image_target(in("new.exr"), ImageFormat::exr);
    check_image_target("-", ImageFormat::ppm);
    check_image_target("/dev/full", ImageFormat::png);
    EXPECT_THROW(check_image_target(in("none/p.png"), ImageFormat::png), OutputError);
    EXPECT_THROW(check_image_target(folder.string(), ImageFormat::png), OutputError);
    EXPECT_EQ(content(in("p.png")), "old");
    EXPECT_THAT(names(), ElementsAre("p.png"));
}

TEST_F(Files, EmptyPicturesAreRefused) { EXPECT_THAT(failure(in("p.png"), Film()), HasSubstr("the picture has no pixels")); }

TEST(PngBytes, AreThoseOfTheFileAndNeedNone) {
    const std::string folder = testing::TempDir();
    const char* const before = std::getenv("TMPDIR");
    const std::string kept = before ? before : "";
    setenv("TMPDIR", "/proc", 1);  // nobody can make a file there
    for (const int bits : {8, 16}) {
        Encoding encoding = linear_file(bits);
        encoding.alpha = bits == 16;
        const ImageMetadata metadata{{{"Software", "test"}}};
        const std::string file = folder + "png_bytes.png";
        write_image(ramp(7, 5), file, ImageFormat::png, encoding, metadata);
        std::ostringstream written;
        written << std::ifstream(file, std::ios::binary).rdbuf();
        EXPECT_EQ(png_bytes(ramp(7, 5), encoding, metadata), written.str());
        fs::remove(file);
    }
    EXPECT_THROW(png_bytes(Film(0, 0), linear_file(), {}), OutputError);
    before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace
}  // namespace rt
