#include "tests/parity/parity.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "commands/job/scene_answers.h"
#include "film/image_file.h"
#include "syntax/parser.h"
#include "trace/camera.h"
#include "trace/ray_log.h"
#include "world/compile.h"

namespace rt {

namespace {

Curve working_curve(const Gamma& gamma) {
    return gamma.kind == Gamma::Kind::srgb ? Curve{Curve::Kind::srgb, 1.0} : Curve{Curve::Kind::power, gamma.power};
}

TraceOptions povray_options() {
    TraceOptions options;
    options.shading = ShadingModel::povray;
    options.distances = Distances::povray;
    return options;
}

/// Anti-aliased pixels draw on samples of their neighbours too, so the grid spans them there.
bool on_edge(Tracer& tracer, const World& world, int x, int y, const StoredImage& picture, bool antialiased) {
    const double reach = antialiased ? 1.0 : 1.0 / 3.0;
    RayLog log;
    std::uint64_t first = 0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const Ray ray = camera_ray(world.camera, x + 0.5 + i * reach, y + 0.5 + j * reach, picture.width, picture.height);
            tracer.camera_ray(ray, log);
            const std::uint64_t met = signature(log);
            if (i == -1 && j == -1) first = met;
            if (met != first) return true;
        }
    }
    return false;
}

}  // namespace

std::size_t Parity::defects() const {
    return static_cast<std::size_t>(std::count_if(different.begin(), different.end(), [](const DifferentPixel& p) { return !p.edge; }));
}

Parity compare_with_povray(const std::string& scene_path, const std::string& picture_path, const ParityOptions& options) {
    const StoredImage picture = read_image(picture_path);
    if (picture.max_value != 65535 || picture.channels < 3)
        throw std::runtime_error(picture_path + ": expected 16 bits and three channels");
    const MessageSink silent = [](std::string_view) {};
    ParseOptions parse;
    parse.image_width = picture.width;
    parse.image_height = picture.height;
    parse.library_paths = options.library_paths;
    give_answers(parse);
    const Scene scene = parse_file(scene_path, parse, silent);
    const World world = compile(scene, {}, silent);

    RenderOptions render_options;
    render_options.width = picture.width;
    render_options.height = picture.height;
    render_options.sampling = options.sampling;
    render_options.trace = povray_options();
    render_options.working_gamma = scene.settings.gamma.power;
    render_options.working_srgb = scene.settings.gamma.kind == Gamma::Kind::srgb;
    const RenderResult result = render(world, render_options);

    Encoding encoding;
    encoding.raw = scene.settings.gamma.kind == Gamma::Kind::legacy;
    encoding.working = working_curve(scene.settings.gamma);
    encoding.file = Curve{};
    encoding.bits = 16;
    const std::vector<std::uint16_t> ours = quantise(result.film, encoding);

    Parity parity;
    parity.pixels = static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height);
    Tracer tracer(world, render_options.trace);
    for (std::size_t i = 0; i < parity.pixels; ++i) {
        int steps = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int theirs = static_cast<int>(picture.values[i * static_cast<std::size_t>(picture.channels) + c]);
            steps = std::max(steps, std::abs(theirs - static_cast<int>(ours[i * 3 + c])));
        }
        if (steps <= options.tolerance) continue;
        const int x = static_cast<int>(i) % picture.width, y = static_cast<int>(i) / picture.width;
        parity.different.push_back({x, y, steps, on_edge(tracer, world, x, y, picture, options.sampling.method != Sampling::Method::none)});
    }
    return parity;
}

}  // namespace rt
