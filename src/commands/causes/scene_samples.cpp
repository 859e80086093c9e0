#include "commands/causes/scene_samples.h"

#include <algorithm>

#include "commands/job/job_steps.h"
#include "commands/job/test_job.h"
#include "trace/camera.h"
#include "trace/tracer.h"

namespace rt {

namespace {

constexpr std::size_t most_samples = 4000, fewest_samples = 300;
constexpr double most_unlike = 0.25;            ///< share of pixels in which ours is not as expected, and which are left out
constexpr double rays_of_all_variants = 1.2e6;  ///< in which a test's traced_variants are traced: about a second
constexpr double traced_variants = 40.0;
constexpr std::size_t many_objects = 20'000;  ///< building them anew for a variant takes longer than its rays

Rgb mean_light(Tracer& tracer, const std::vector<Ray>& rays) {
    std::vector<Radiance> light(rays.size());
    tracer.camera_rays(rays, light);
    Rgb sum(0.0);
    for (const Radiance& radiance : light) sum += radiance.rgb;
    return sum / static_cast<double>(rays.size());
}

}  // namespace

bool SceneSamples::has_many_objects() const { return scene_.objects.size() > many_objects; }

std::vector<Ray> SceneSamples::rays_of(const PixelSample& sample, const RenderOptions& options, const CameraBasis& camera, double dx,
                                       double dy) const {
    const int n = samples_a_side(options.sampling);
    std::vector<Ray> rays;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            rays.push_back(camera_ray(camera, sample.x + (i + 0.5) / n + dx, sample.y + (j + 0.5) / n + dy, options.width, options.height));
    return rays;
}

std::optional<SceneSamples> SceneSamples::read(const std::vector<std::string>& arguments, const std::string& inputs,
                                               const ColorPicture& expected, const ColorPicture& actual) {
    try {
        std::optional<RenderJob> job = job_of_test(arguments, inputs);
        if (!job || !job->course->indirect_samples.empty() || job->width != expected.width || job->height != expected.height)
            return std::nullopt;
        const MessageSink silent = message_sink(true);
        SceneSamples all;
        all.job_ = std::move(*job);
        all.scene_ = read_scene(all.job_, silent);
        all.world_ = std::make_unique<World>(build_world(all.job_, all.scene_, silent));
        all.options_ = render_options(all.job_, all.scene_);
        if (!all.choose(expected, actual)) return std::nullopt;
        return all;
    } catch (const std::runtime_error&) {  // a scene or an option that is not ours: nothing can be said of it
        return std::nullopt;
    }
}

/// How many samples a test may have, by the rays that some of its pixels take: the same wherever it is graded.
std::size_t SceneSamples::affordable(Tracer& tracer, const ColorPicture& picture) const {
    constexpr std::size_t probes = 64;
    for (std::size_t k = 0; k < probes; ++k) {
        const std::size_t i = (2 * k + 1) * picture.pixels.size() / (2 * probes), width = static_cast<std::size_t>(picture.width);
        const PixelSample probe{.x = static_cast<int>(i % width), .y = static_cast<int>(i / width)};
        mean_light(tracer, rays_of(probe, options_, world_->camera, 0.0, 0.0));
    }
    const RayCounts& c = tracer.counts();
    const double rays = static_cast<double>(c.camera + c.shadow + c.reflected + c.refracted) / static_cast<double>(probes);
    return static_cast<std::size_t>(
        std::clamp(rays_of_all_variants / traced_variants / rays, static_cast<double>(fewest_samples), static_cast<double>(most_samples)));
}

bool SceneSamples::choose(const ColorPicture& expected, const ColorPicture& actual) {
    std::vector<std::size_t> sorted[2];  // pixels that do not differ, and those that do
    for (std::size_t i = 0; i < actual.pixels.size(); ++i)
        sorted[apart(expected.pixels[i], actual.pixels[i]) >= Misfit::visible].push_back(i);
    Tracer tracer(*world_, options_.trace);
    const std::size_t budget = affordable(tracer, actual);
    double tried = 0.0, unlike = 0.0;
    for (const std::vector<std::size_t>& pixels : {std::cref(sorted[1]), std::cref(sorted[0])}) {
        const std::size_t count = std::min(pixels.size(), budget / 2);
        const std::size_t first = samples_.size();
        double weight = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = pixels[(2 * k + 1) * pixels.size() / (2 * count)];
            PixelSample sample{.x = static_cast<int>(i % static_cast<std::size_t>(actual.width)),
                               .y = static_cast<int>(i / static_cast<std::size_t>(actual.width)),
                               .actual = actual.pixels[i]};
            const std::vector<Ray> rays = rays_of(sample, options_, world_->camera, 0.0, 0.0);
            for (const Ray& ray : rays)
                sample.light += tracer.camera_ray(ray, sample.rays.emplace_back()).rgb / static_cast<double>(rays.size());
            const double share = static_cast<double>(pixels.size()) / static_cast<double>(count);
            tried += share, weight += share;
            if (apart(shown(sample.light), expected.pixels[i]) >= Misfit::visible)
                unlike += share;  // there ours is no measure of what is right
            else
                samples_.push_back(std::move(sample));
        }
        for (std::size_t k = first; k < samples_.size(); ++k) samples_[k].weight = weight / static_cast<double>(samples_.size() - first);
    }
    if (samples_.empty() || unlike > most_unlike * tried) return false;
    for (const PixelSample& sample : samples_) whole_.add(apart(shown(sample.light), sample.actual), sample.weight);
    picture_pixels_ = static_cast<double>(actual.pixels.size());
    return whole_.differing > 0.0;
}

std::optional<std::vector<Rgb>> SceneSamples::traced(const std::function<void(Stage&)>& change) const {
    Stage stage{.job = job_, .scene = scene_, .options = options_, .camera = world_->camera, .interiors = world_->interiors};
    try {
        change(stage);
        std::optional<World> other;
        if (stage.other_scene) other = build_world(job_, *stage.other_scene, message_sink(true));
        if (!other) std::swap(world_->interiors, stage.interiors);
        std::vector<Rgb> light;
        Tracer tracer(other ? *other : *world_, stage.options.trace);
        for (const PixelSample& sample : samples_)
            light.push_back(mean_light(tracer, rays_of(sample, stage.options, stage.camera, stage.shift_x, stage.shift_y)));
        if (!other) std::swap(world_->interiors, stage.interiors);
        return light;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace rt
