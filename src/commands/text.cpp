#include "commands/text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "commands/names.h"
#include "commands/stats.h"

namespace rt {

namespace {

std::string vector_text(const Vec3& v) { return fmt::format("{{{:.4f} {:.4f} {:.4f}}}", v.x, v.y, v.z); }

std::string sampling_text(const Sampling& s) {
    switch (s.method) {
        case Sampling::Method::none:
            return "none";
        case Sampling::Method::grid:
            return fmt::format("grid,{}", s.depth);
        case Sampling::Method::povray1:
            return fmt::format("1,{},{}", s.threshold, s.depth);
        case Sampling::Method::povray2:
            return fmt::format("2,{},{}", s.threshold, s.depth);
    }
    return "?";
}

/// The type's name as the course prints it: a capital first letter.
std::string type_text(const Shape& shape) {
    std::string type = name(shape);
    if (!type.empty() && type[0] >= 'a' && type[0] <= 'z') type[0] = static_cast<char>(type[0] - 'a' + 'A');
    return type;
}

/// The lines that describe a shape's own data.
struct ShapeLines {
    std::string operator()(const Sphere& s) const {
        return fmt::format("- Center: {}\n- Radius: {:.4f}\n", vector_text(s.center), s.radius);
    }
    std::string operator()(const Plane& s) const {
        return fmt::format("- Normal: {}\n- Distance: {:.4f}\n", vector_text(s.normal), s.distance);
    }
    std::string operator()(const Box& s) const { return fmt::format("- Min: {}\n- Max: {}\n", vector_text(s.min), vector_text(s.max)); }
    std::string operator()(const Cone& s) const {
        return fmt::format("- Base: {}\n- Base Radius: {:.4f}\n- Cap: {}\n- Cap Radius: {:.4f}\n", vector_text(s.base), s.base_radius,
                           vector_text(s.cap), s.cap_radius);
    }
    std::string operator()(const Torus& s) const {
        return fmt::format("- Major Radius: {:.4f}\n- Minor Radius: {:.4f}\n", s.major_radius, s.minor_radius);
    }
    std::string operator()(const Disc& s) const {
        return fmt::format("- Center: {}\n- Normal: {}\n- Radius: {:.4f}\n- Hole Radius: {:.4f}\n", vector_text(s.center),
                           vector_text(s.normal), s.radius, s.hole_radius);
    }
    std::string operator()(const Triangle& s) const { return corners(s); }
    std::string operator()(const SmoothTriangle& s) const { return corners(s); }
    std::string operator()(const Polygon& s) const { return fmt::format("- Points: {}\n", s.points.size()); }
    std::string operator()(const Mesh& s) const {
        return fmt::format("- Vertices: {}\n- Triangles: {}\n", s.data->vertices.size(), s.data->faces.size());
    }

private:
    template <typename T>
    static std::string corners(const T& s) {
        return fmt::format("- Vertex A: {}\n- Vertex B: {}\n- Vertex C: {}\n", vector_text(s.a), vector_text(s.b), vector_text(s.c));
    }
};

/// The plain texture that shows where there is one: the top layer, of a checker the first cell's.
const PlainTexture* plain_texture(const std::vector<Texture>& layers) {
    if (layers.empty()) return nullptr;
    if (const auto* plain = std::get_if<PlainTexture>(&layers.back().content)) return plain;
    return plain_texture(std::get<CheckerTexture>(layers.back().content).cells[0]);
}

Rgb plain_color(const Pigment& pigment) {
    if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) return color->rgb;
    return plain_color(std::get<CheckerPigment>(pigment.content).cells[0]);
}

}  // namespace

std::string_view program_version() { return RAYTRACE_VERSION; }

ImageMetadata picture_metadata(const RenderJob& job, const Scene& scene) {
    std::string options =
        fmt::format("size={}x{} profile={} shading={} distances={} precision={} aa={} gamma={}", job.width, job.height,
                    name_of(profile_names, job.profile), name_of(shading_names, *job.shading), name_of(distances_names, *job.distances),
                    name_of(precision_names, *job.precision), sampling_text(job.sampling), gamma_text(scene.settings.gamma));
    for (const ModelOption& option : job.model) options += fmt::format(" {}={}", option.key, option.value);
    if (job.povray_quality) options += fmt::format(" quality={}", *job.povray_quality);
    if (job.region) options += fmt::format(" crop={},{},{},{}", job.region->x0, job.region->x1, job.region->y0, job.region->y1);
    if (job.parse.clock != 0.0) options += fmt::format(" clock={}", job.parse.clock);
    for (const auto& [name, value] : job.parse.declares) options += fmt::format(" {}={}", name, value);
    return {{{"Software", fmt::format("raytrace {}", program_version())}, {"Scene", job.scene}, {"Options", options}}};
}

std::string sceneinfo_text(const Scene& scene) {
    const Camera& camera = scene.camera;
    std::string text = fmt::format("Camera:\n- Location: {}\n- Up: {}\n- Right: {}\n- Look at: {}\n", vector_text(camera.location),
                                   vector_text(camera.up), vector_text(camera.right), vector_text(camera.look_at.value_or(Vec3(0.0))));
    text += fmt::format("\n---\n\n{} light(s)\n", scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        text += fmt::format("\nLight[{}]:\n- Location: {}\n- Color: {}\n", i, vector_text(scene.lights[i].location),
                            vector_text(scene.lights[i].color));
    text += fmt::format("\n---\n\n{} object(s)\n", scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        text += fmt::format("\nObject[{}]:\n- Type: {}\n{}", i, type_text(object.shape), std::visit(ShapeLines{}, object.shape));
        const PlainTexture* texture = object.texture ? plain_texture(**object.texture) : nullptr;
        if (!texture) continue;
        text += fmt::format("- Color: {}\n- Material:\n  - Ambient: {:.4f}\n  - Diffuse: {:.4f}\n",
                            vector_text(plain_color(texture->pigment)), texture->finish.ambient.r, texture->finish.diffuse);
    }
    return text;
}

void write_stdout(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written) throw OutputError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

void write_stderr(std::string_view text) noexcept {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void open_standard_streams() noexcept {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDWR) < 0) return;  // open() takes the lowest free number
    }
}

}  // namespace rt
