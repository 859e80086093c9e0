#include "tests/extremes/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "film/image_file.h"

namespace rt::extremes {

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// What the program says of pixels that were not finite.
int non_finite(const std::string& messages) {
    int count = 0;
    const std::size_t at = messages.find(" pixels were not finite");
    if (at != std::string::npos) count = std::atoi(messages.substr(messages.rfind(' ', at - 1) + 1).c_str());
    return count;
}

/// A file of that ending that no other test has, gone with this.
struct Scratch {
    explicit Scratch(const char* ending) : path(fs::temp_directory_path() / fmt::format("extremes_{}{}", getpid(), ending)) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code none;
        fs::remove(path, none);
    }
    fs::path path;
};

/// What a command that writes messages to `log` has left in `picture`.
Bytes picture_in(const Scratch& picture, const Scratch& log) {
    const StoredImage image = read_image(picture.path.string());
    Bytes bytes{image.width, image.height, {}, non_finite(contents(log.path))};
    for (const float value : image.values) bytes.values.push_back(static_cast<std::uint8_t>(value));
    return bytes;
}

}  // namespace

Bytes render(const std::string& scene, const std::string& options, int width, int height, std::string* png) {
    const Scratch picture(".png"), log(".log");
    const std::string command = fmt::format("'{}' '{}' {} -W {} -H {} -o '{}' 2>'{}'", PROGRAM, scene, options, width, height,
                                            picture.path.string(), log.path.string());
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command + "\n" + contents(log.path));
    if (png != nullptr) *png = contents(picture.path);
    return picture_in(picture, log);
}

bool has_povray() { return std::system("command -v povray >/dev/null 2>&1") == 0; }

std::optional<Bytes> render_with_povray(const std::string& scene, int width, int height) {
    const Scratch picture(".png"), log(".log");
    const std::string command =
        fmt::format("povray '+I{}' '+L{}' '+O{}' +W{} +H{} +FN8 -D -A File_Gamma=sRGB Dither=off >'{}' 2>&1", scene,
                    fs::path(scene).parent_path().string(), picture.path.string(), width, height, log.path.string());
    if (std::system(command.c_str()) != 0) return std::nullopt;
    return picture_in(picture, log);
}

}  // namespace rt::extremes
