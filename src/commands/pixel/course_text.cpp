#include "commands/pixel/course_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

namespace rt {

namespace {

std::string color_text(const PixelName& pixel) { return fmt::format("({}, {}, {})", pixel.color[0], pixel.color[1], pixel.color[2]); }

std::string hit_text(const Scene& scene, const RayNode& node) {
    return fmt::format("T = {}\nObject Type: {}\n", number_text(node.t), type_text(scene.objects[node.object]));
}

std::string object_text(const Scene& scene, const RayNode& node) {
    return fmt::format("(ID #{} - {})", node.object + 1, type_text(scene.objects[node.object]));
}

/// One line of a ray's record: the name stands right-aligned before the colon.
struct Line {
    std::string name, value;
    std::string text() const { return name.empty() ? fmt::format("  {}", value) : fmt::format("{:>16}: {}", name, value); }
};

std::string_view kind_text(RayNode::Kind kind) {
    if (kind == RayNode::Kind::camera) return "Primary";
    return kind == RayNode::Kind::reflected || kind == RayNode::Kind::total ? "Reflection" : "Refraction";
}

/// Why a ray has no surface at its end.
std::string_view end_text(RayNode::End end) {
    if (end == RayNode::End::level) return "Not followed: as deep as rays go.";
    return end == RayNode::End::weight ? "Not followed: too faint to matter." : "No intersection.";
}

/// What is known of one ray, in the course's order. The line that says its kind comes first.
std::vector<Line> lines_of(const Scene& scene, const RayLog& log, const RayNode& node) {
    std::vector<Line> lines{{"", fmt::format("Iteration type: {}", kind_text(node.kind))}, {"Ray", ray_text(node.ray)}};
    if (node.object == RayNode::none) {
        lines.push_back({"", std::string(end_text(node.end))});
    } else {
        const std::optional<Transform>& transform = scene.objects[node.object].transform;
        if (transform && !transform->is_identity()) lines.push_back({"Transformed Ray", ray_text(transform->inverse_ray(node.ray))});
        lines.push_back({"Hit Object", object_text(scene, node)});
        lines.push_back({"Intersection", fmt::format("{} at T = {}", vector_text(node.point), number_text(node.t))});
        lines.push_back({"Normal", vector_text(node.normal)});
        lines.push_back({"Final Color", vector_text(node.radiance)});
        lines.push_back({"Ambient", vector_text(node.ambient)});
        lines.push_back({"Diffuse", vector_text(node.diffuse)});
        lines.push_back({"Specular", vector_text(node.specular)});
        lines.push_back({"Reflection", vector_text(node.reflection)});
        lines.push_back({"Refraction", vector_text(node.refraction)});
        if (node.shares)
            lines.push_back({"Contributions", fmt::format("{} Local, {} Reflection, {} Transmission", number_text(node.shares->local),
                                                          number_text(node.shares->reflection), number_text(node.shares->transmission))});
    }
    if (kind_text(node.kind) == "Refraction") lines.push_back({"Extra Info", log.nodes[node.parent].inside ? "into-air" : "into-object"});
    return lines;
}

/// A ray and those that it caused, drawn as a tree. `margin` is what the branches of its ancestors draw.
void draw(const Scene& scene, const RayLog& log, std::uint32_t index, const std::string& margin, std::string& text) {
    const RayNode& node = log.nodes[index];
    std::vector<std::uint32_t> children;
    for (std::uint32_t i = index + 1; i < log.nodes.size(); ++i)
        if (log.nodes[i].parent == index) children.push_back(i);
    std::vector<Line> lines = lines_of(scene, log, node);
    text += fmt::format("{}o - {}\n", margin, lines.front().value);
    const char* stem = children.empty() ? " " : "|";
    for (std::size_t i = 1; i < lines.size(); ++i) text += fmt::format("{}{} {}\n", margin, stem, lines[i].text());
    for (const ShadowAnswer& shadow : node.shadows)
        text += fmt::format(
            "{}{} {}\n", margin, stem,
            Line{"Shadow Ray", fmt::format("Light[{}] {}", shadow.light, shadow.transmitted == Rgb(0.0) ? "is hidden" : "arrives")}.text());
    for (std::size_t i = 0; i < children.size(); ++i) {
        const bool last = i + 1 == children.size();
        text += fmt::format("{}{}\\\n", margin, last ? " " : "|");
        draw(scene, log, children[i], margin + (last ? "  " : "| "), text);
    }
}

}  // namespace

std::string number_text(double x) {
    constexpr double rounding = 1e-12;  // more than the results of a few operations in double precision are off
    const double shown = x * (1.0 + rounding);
    // Its size in ten thousandths: a whole number and a rest, known to 1e-4 even after the product was rounded. Unless the rest is about a
    // half, that decides the digits; sceneinfo prints a hundred thousand numbers.
    const double size = std::fabs(shown) * 1e4;
    const double whole = std::floor(size);
    const double rest = (size - whole) + std::fma(std::fabs(shown), 1e4, -size);
    if (!(size < 1e12) || std::fabs(rest - 0.5) < 1e-3) return fmt::format("{:.4f}", shown);
    char text[24];
    char* at = std::end(text);
    auto left = static_cast<std::uint64_t>(whole) + (rest > 0.5);
    for (int digit = 0; digit < 5 || left > 0; ++digit, left /= 10) {
        if (digit == 4) *--at = '.';
        *--at = static_cast<char>('0' + left % 10);
    }
    if (std::signbit(shown)) *--at = '-';
    return {at, std::end(text)};
}

std::string vector_text(const Vec3& v) {
    std::string text = "{";
    for (int i = 0; i < 3; ++i) text.append(i == 0 ? "" : " ").append(number_text(v[i]));
    return text + "}";
}

std::string ray_text(const Ray& ray) { return fmt::format("{} -> {}", vector_text(ray.origin), vector_text(ray.direction)); }

std::string type_text(const Object& object) {
    std::string type = name(object.shape);
    if (!type.empty() && type[0] >= 'a' && type[0] <= 'z') type[0] = static_cast<char>(type[0] - 'a' + 'A');
    return type;
}

std::string pixelray_text(const PixelName& pixel, const Ray& ray) {
    return fmt::format("Pixel: [{}, {}] Ray: {}\n", pixel.x, pixel.y, ray_text(ray));
}

std::string firsthit_text(const PixelName& pixel, const Scene& scene, const RayNode& camera_ray) {
    const std::string ray = pixelray_text(pixel, camera_ray.ray);
    if (camera_ray.object == RayNode::none) return ray + "No Hit\n";
    const Rgb color = camera_ray.layers.empty() ? Rgb(0.0) : camera_ray.layers.front().rgb;  // none has weight enough
    return ray + hit_text(scene, camera_ray) +
           fmt::format("Color: {} {} {}\n", number_text(color.r), number_text(color.g), number_text(color.b));
}

std::string pixelcolor_text(const PixelName& pixel, const Scene& scene, const RayNode& camera_ray, std::string_view brdf) {
    const std::string ray = pixelray_text(pixel, camera_ray.ray);
    if (camera_ray.object == RayNode::none) return ray + "No Hit\n";
    return ray + hit_text(scene, camera_ray) + fmt::format("BRDF: {}\nColor: {}\n", brdf, color_text(pixel));
}

std::string printrays_text(const PixelName& pixel, const Scene& scene, std::span<const RayLog> samples) {
    std::string text = fmt::format("Pixel: [{}, {}] Color: {}\n", pixel.x, pixel.y, color_text(pixel));
    for (const RayLog& log : samples) {
        for (const RayNode& node : log.nodes) {
            text += "----\n";
            for (const Line& line : lines_of(scene, log, node)) text += line.text() + "\n";
        }
        text += fmt::format("\n\n{:->80}\n\n", "");
    }
    return text;
}

std::string pixeltrace_text(const PixelName& pixel, const Scene& scene, std::span<const RayLog> samples) {
    std::string text = fmt::format("Pixel: [{}, {}] Color: {}\n", pixel.x, pixel.y, color_text(pixel));
    for (const RayLog& log : samples) {
        draw(scene, log, 0, "", text);
        text += fmt::format("\n{:->80}\n\n", "");
    }
    return text;
}

}  // namespace rt
