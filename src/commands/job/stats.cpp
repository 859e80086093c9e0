#include "commands/job/stats.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <fstream>

#include "commands/base/names.h"
#include "trace/camera.h"

namespace rt {

namespace {

std::string ray_line(std::string_view kind, std::uint64_t count, double seconds) {
    const double rate = seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
    return fmt::format("  {:<10}{:>14}  {:8.3f} M/s\n", kind, count, rate * 1e-6);
}

std::string file_gamma_text(const RenderJob& job, const Gamma& gamma) {
    if (gamma.kind == Gamma::Kind::legacy || job.profile == Profile::csc473) return "values as they are";
    return job.file_gamma.kind == Curve::Kind::srgb ? "srgb" : fmt::format("{}", job.file_gamma.power);
}

}  // namespace

std::size_t count_triangles(const Scene& scene) {
    std::size_t triangles = 0;
    for (const Object& object : scene.objects) {
        if (const auto* mesh = std::get_if<Mesh>(&object.shape)) triangles += mesh->data->faces.size();
        if (std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape)) ++triangles;
    }
    return triangles;
}

std::string gamma_text(const Gamma& gamma) {
    switch (gamma.kind) {
        case Gamma::Kind::legacy:
            return "none";
        case Gamma::Kind::srgb:
            return "srgb";
        case Gamma::Kind::power:
            break;
    }
    return fmt::format("{}", gamma.power);
}

std::size_t peak_memory() {
    // The kernel's count of the process itself; getrusage counts what the process was forked from, too.
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        std::size_t kilobytes = 0;
        if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts kilobytes
}

namespace {

void find_narrowest(const std::vector<LayerNode>& layers, double below, double& least) {
    for_each_layer(layers, [&](const LayerNode& layer) {
        const SurfaceModel& model = layer.finish.model;
        const bool lobe = model.specular == SurfaceModel::Specular::microfacet && model.s > 0.0 && model.alpha > 0.0;
        if (lobe && model.alpha < below) least = std::fmin(least, model.alpha);
    });
}

}  // namespace

NarrowLobes narrow_lobes(const World& world, int width, int height, const Sampling& sampling) {
    const int side = samples_a_side(sampling);  // the others divide only what differs already
    NarrowLobes narrow{.least_alpha = infinity, .spanned = 0.5 * pixel_angle(world.camera, width, height) / side};
    for (const Material& material : world.materials) {
        double least = infinity;
        find_narrowest(material.layers, narrow.spanned, least);
        find_narrowest(material.interior_layers, narrow.spanned, least);
        if (least < narrow.spanned) ++narrow.materials;
        narrow.least_alpha = std::fmin(narrow.least_alpha, least);
    }
    return narrow;
}

std::string stats_text(const RenderJob& job, const Scene& scene, const Stats& stats) {
    const Phases& p = stats.phases;
    const RayCounts& rays = stats.rays;
    const std::uint64_t all = rays.camera + rays.shadow + rays.reflected + rays.refracted + rays.edge;
    std::string text =
        fmt::format("time: parse {:.4f} s, build {:.4f} s, trace {:.4f} s, write {:.4f} s\n", p.parse, p.build, p.trace, p.write);
    text += fmt::format("scene: {} objects, {} triangles, {} lights\n", scene.objects.size(), count_triangles(scene), scene.lights.size());
    text += "rays:\n";
    text += ray_line("camera", rays.camera, p.trace) + ray_line("shadow", rays.shadow, p.trace);
    text += ray_line("reflected", rays.reflected, p.trace) + ray_line("refracted", rays.refracted, p.trace);
    if (rays.edge > 0) text += ray_line("edge", rays.edge, p.trace);
    text += ray_line("all", all, p.trace);
    if (const auto& c = stats.convergence; c && c->error)
        text += fmt::format("sampling: {} rounds, {} to {} samples a pixel, mean {:.2f}; estimated RMSE {:.3g}\n", c->rounds, c->least,
                            c->most, c->mean, *c->error);
    text += fmt::format("memory: peak {:.1f} MB\n", static_cast<double>(stats.peak_bytes) * 1e-6);
    text += fmt::format("threads: {}\n", stats.threads);
    text += fmt::format("precision: {}, distances: {}, shading: {}\n", name_of(precision_names, *job.precision),
                        name_of(distances_names, *job.distances), name_of(shading_names, *job.shading));
    text += fmt::format("gamma: working space {}, file {}\n", gamma_text(scene.settings.gamma), file_gamma_text(job, scene.settings.gamma));
    if (stats.narrow.materials > 0)
        text += fmt::format("lobes narrower than a sample: {} materials, alpha {:.3g} and more, below {:.3g}; highlights may be lost\n",
                            stats.narrow.materials, stats.narrow.least_alpha, stats.narrow.spanned);
    text += fmt::format("non-finite pixels: {}\n", stats.non_finite);
    return text;
}

}  // namespace rt
