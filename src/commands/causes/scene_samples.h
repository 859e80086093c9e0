// Pixels of a wrong picture, beside the rays that our own tracer sends through them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands/job/render_job.h"
#include "grading/color_picture.h"
#include "grading/finding.h"
#include "trace/ray_log.h"
#include "trace/tracer.h"

namespace rt {

/// One pixel that stands for `weight` pixels like it.
struct PixelSample {
    int x = 0, y = 0;  ///< from the top left
    double weight = 1.0;
    Color actual{};
    Rgb light{0.0};              ///< ours, the mean over its rays
    std::vector<RayLog> rays{};  ///< one for each of its sub-pixels
};

/// The scene of a test, traced by ourselves: in what follows a *variant* is the light of all samples under some mistake.
class SceneSamples {
public:
    /// Reads the scene of a course's `render` or `raycast` and traces some thousand pixels, chosen evenly among those that differ and those
    /// that do not. Empty if the arguments are none of these, the scene cannot be read, asks for indirect light, or comes out otherwise
    /// than expected in more than a quarter of the pixels. `inputs`: the folder that the scene's path calls ../resources.
    static std::optional<SceneSamples> read(const std::vector<std::string>& arguments, const std::string& inputs,
                                            const ColorPicture& expected, const ColorPicture& actual);

    /// What tracing takes: changed for a variant.
    struct Stage {
        const RenderJob& job;
        const Scene& scene;
        RenderOptions options;
        double shift_x = 0.0, shift_y = 0.0;  ///< of the camera rays, in pixels, right and down
        CameraBasis camera;
        std::optional<Scene> other_scene{};       ///< instead of `scene`
        std::vector<CompiledInterior> interiors;  ///< of the world
    };
    /// The samples' light with another stage. Empty if the changed scene cannot be traced.
    std::optional<std::vector<Rgb>> traced(const std::function<void(Stage&)>& change) const;

    /// The camera rays of a sample, as they are.
    std::vector<Ray> rays_of(const PixelSample& sample) const { return rays_of(sample, options_, world_->camera, 0.0, 0.0); }

    const std::vector<PixelSample>& samples() const { return samples_; }
    const Scene& scene() const { return scene_; }
    const World& world() const { return *world_; }
    const CourseRules& rules() const { return *job_.course; }
    /// How far the picture is from ours.
    const Misfit& whole() const { return whole_; }
    double picture_pixels() const { return picture_pixels_; }
    bool has_many_objects() const;

private:
    std::vector<Ray> rays_of(const PixelSample& sample, const RenderOptions& options, const CameraBasis& camera, double dx,
                             double dy) const;
    std::size_t affordable(Tracer& tracer, const ColorPicture& picture) const;
    bool choose(const ColorPicture& expected, const ColorPicture& actual);

    RenderJob job_;
    Scene scene_;
    std::unique_ptr<World> world_;
    RenderOptions options_;
    std::vector<PixelSample> samples_;
    Misfit whole_;
    double picture_pixels_ = 0.0;
};

/// 0..1, as a picture has it.
inline Color shown(const Rgb& light) {
    const auto channel = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    return {channel(light.r), channel(light.g), channel(light.b)};
}

}  // namespace rt
