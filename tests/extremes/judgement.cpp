#include "tests/extremes/judgement.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "film/image_file.h"
#include "tests/extremes/robust.h"
#include "tests/extremes/textbook.h"

namespace rt::extremes {

namespace {

namespace fs = std::filesystem;

/// Stands in for a width of 0 in 113 bits: so narrow that only the very centre of a highlight would tell it from nothing.
constexpr double narrowest = 1e-40;

double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

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

void render_ours(const std::string& scene, Judgement& judgement) {
    const fs::path base = fs::temp_directory_path() / fmt::format("extremes_{}_{}", judgement.name, getpid());
    const std::string picture = base.string() + ".png", log = base.string() + ".log";
    const std::string command =
        fmt::format("'{}' '{}' -W {} -H {} -o '{}' 2>'{}'", PROGRAM, scene, picture_width, picture_height, picture, log);
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command + "\n" + contents(log));
    const StoredImage image = read_image(picture);
    judgement.ours = {image.width, image.height, {}, non_finite(contents(log))};
    for (const float value : image.values) judgement.ours.values.push_back(static_cast<std::uint8_t>(value));
    judgement.png = contents(picture);
    fs::remove(picture);
    fs::remove(log);
}

template <typename T, template <typename> typename Terms, typename S = T>
Bytes rendered(const Description& description, double least_alpha = 0.0) {
    return encode(Renderer<T, Terms, S>(description, least_alpha).picture(picture_width, picture_height));
}

}  // namespace

Bytes encode(const Picture& picture) {
    Bytes bytes{picture.width, picture.height, {}, 0};
    for (const Rgb& pixel : picture.pixels) {
        bytes.non_finite += !rt::is_finite(pixel);
        for (int k = 0; k < 3; ++k) {
            const double shown = srgb(pixel[k] > 0.0 ? std::min(pixel[k], 1.0) : 0.0);
            bytes.values.push_back(static_cast<std::uint8_t>(std::floor(255 * shown + 0.5)));
        }
    }
    return bytes;
}

Wrong wrong(const Bytes& picture, const Bytes& truth) {
    Wrong result;
    for (std::size_t i = 0; i < truth.values.size(); i += 3) {
        int steps = 0;
        for (std::size_t k = i; k < i + 3; ++k) steps = std::max(steps, std::abs(picture.values.at(k) - truth.values[k]));
        result.pixels += steps > 1;
        result.steps = std::max(result.steps, steps);
    }
    return result;
}

bool right(const Judgement& judgement) { return wrong(judgement.ours, judgement.truth).pixels + judgement.ours.non_finite == 0; }

std::vector<std::string> scenes() {
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(PROJECT_ROOT) / "pov/extremes"))
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

Judgement judge(const std::string& scene) {
    const Description description = describe(scene);
    Judgement judgement;
    judgement.name = fs::path(scene).stem();
    render_ours(scene, judgement);
    judgement.truth = rendered<Quad, Robust>(description);
    judgement.textbook = rendered<Quad, Textbook>(description, narrowest);
    judgement.naive_single = rendered<double, Textbook, float>(description);
    judgement.naive_double = rendered<double, Textbook>(description);
    return judgement;
}

}  // namespace rt::extremes
