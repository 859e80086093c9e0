// sceneinfo: what a scene says, as the course prints it.
#include <fmt/compile.h>

#include <iterator>
#include <utility>

#include "commands/pixel/course_text.h"

namespace rt {

namespace {

/// The lines that describe a shape's own data.
struct ShapeLines {
    std::string operator()(const Sphere& s) const {
        return fmt::format(FMT_COMPILE("- Center: {}\n- Radius: {}\n"), vector_text(s.center), number_text(s.radius));
    }
    std::string operator()(const Plane& s) const {
        return fmt::format("- Normal: {}\n- Distance: {}\n", vector_text(s.normal), number_text(s.distance));
    }
    std::string operator()(const Box& s) const { return fmt::format("- Min: {}\n- Max: {}\n", vector_text(s.min), vector_text(s.max)); }
    std::string operator()(const Cone& s) const {
        return fmt::format("- Base: {}\n- Base Radius: {}\n- Cap: {}\n- Cap Radius: {}\n", vector_text(s.base), number_text(s.base_radius),
                           vector_text(s.cap), number_text(s.cap_radius));
    }
    std::string operator()(const Torus& s) const {
        return fmt::format("- Major Radius: {}\n- Minor Radius: {}\n", number_text(s.major_radius), number_text(s.minor_radius));
    }
    std::string operator()(const Disc& s) const {
        return fmt::format("- Center: {}\n- Normal: {}\n- Radius: {}\n- Hole Radius: {}\n", vector_text(s.center), vector_text(s.normal),
                           number_text(s.radius), number_text(s.hole_radius));
    }
    std::string operator()(const Triangle& s) const { return corners(s); }
    std::string operator()(const SmoothTriangle& s) const { return corners(s); }
    std::string operator()(const Polygon& s) const { return fmt::format("- Points: {}\n", s.points.size()); }
    std::string operator()(const Mesh& s) const {
        return fmt::format("- Vertices: {}\n- Triangles: {}\n", s.data->vertices.size(), s.data->faces.size());
    }
    std::string operator()(const FurtherShape&) const { return ""; }  // the course has none

private:
    template <typename T>
    static std::string corners(const T& s) {
        return fmt::format(FMT_COMPILE("- Vertex A: {}\n- Vertex B: {}\n- Vertex C: {}\n"), vector_text(s.a), vector_text(s.b),
                           vector_text(s.c));
    }
};

/// The plain texture that shows where there is one: the top layer, of a pattern the first entry's.
const PlainTexture* plain_texture(const std::vector<Texture>& layers) {
    if (layers.empty()) return nullptr;
    if (const auto* plain = std::get_if<PlainTexture>(&layers.back().content)) return plain;
    return plain_texture(*std::get<Shared<PatternTexture>>(layers.back().content)->map->textures.front());
}

Rgb plain_color(const Pigment& pigment) {
    if (const auto* color = std::get_if<PigmentColor>(&pigment.content)) return color->rgb;
    const auto& map = std::get<Shared<PatternPigment>>(pigment.content)->map;
    if (const auto* colors = std::get_if<Shared<ColorMap>>(&map)) return (*colors)->colors.front().rgb;
    if (const auto* pigments = std::get_if<Shared<PigmentMap>>(&map)) return plain_color((*pigments)->pigments.front());
    return Rgb(0.0);
}

std::string texture_text(const std::vector<Texture>& layers) {
    const PlainTexture* const texture = plain_texture(layers);
    if (!texture) return "";
    return fmt::format(FMT_COMPILE("- Color: {}\n- Material:\n  - Ambient: {}\n  - Diffuse: {}\n"),
                       vector_text(plain_color(texture->pigment)), number_text(texture->finish.ambient.r),
                       number_text(texture->finish.diffuse));
}

}  // namespace

std::string sceneinfo_text(const Scene& scene) {
    const Camera& camera = scene.camera;
    std::string text = fmt::format("Camera:\n- Location: {}\n- Up: {}\n- Right: {}\n- Look at: {}\n", vector_text(camera.location),
                                   vector_text(camera.up), vector_text(camera.right), vector_text(camera.look_at.value_or(Vec3(0.0))));
    text += fmt::format("\n---\n\n{} light(s)\n", scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        text += fmt::format("\nLight[{}]:\n- Location: {}\n- Color: {}\n", i, vector_text(scene.lights[i].location),
                            vector_text(scene.lights[i].color));
    text += fmt::format("\n---\n\n{} object(s)\n", scene.objects.size());
    constexpr std::size_t bytes_an_object = 256;  // most take less
    text.reserve(text.size() + bytes_an_object * scene.objects.size());
    const void* described = nullptr;  // objects in a row share a texture
    std::string texture;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        fmt::format_to(std::back_inserter(text), FMT_COMPILE("\nObject[{}]:\n- Type: {}\n{}"), i, type_text(object),
                       std::visit(ShapeLines{}, object.shape));
        if (!object.texture) continue;
        if (std::exchange(described, object.texture->identity()) != object.texture->identity()) texture = texture_text(**object.texture);
        text += texture;
    }
    return text;
}

}  // namespace rt
