// The options of a render: what each says, before all are put together.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "commands/base/command_line.h"
#include "commands/job/render_job.h"

namespace rt {

inline constexpr int largest_side = 1'000'000;
inline constexpr double unbounded = HUGE_VAL;

/// What the options say before they are put together.
struct RenderDraft {
    RenderJob job;
    RegionEdges edges;
    std::string input;
    std::optional<Region> crop;
    std::optional<int> grid;
    std::optional<double> max_error;
    bool antialias = false;
    std::optional<bool> jitter;
    std::optional<double> jitter_amount;
    AnimationDraft animation;
    std::string dither_method;
};

/// Each adds options to the line that set the draft.
void define_picture(CommandLine& line, RenderDraft& d);
void define_sampling(CommandLine& line, RenderDraft& d);
void define_shading(CommandLine& line, RenderJob& job);
void define_knobs(CommandLine& line, RenderJob& job);
void define_scene(CommandLine& line, RenderDraft& d);
void define_run(CommandLine& line, RenderJob& job);

/// After all options are read; each throws OptionError for what does not go together.
void choose_scene(RenderDraft& d, const std::vector<std::string>& others);
/// Whether any option said how pixels become samples.
bool chooses_samples(const RenderDraft& d);
void choose_sampling(RenderDraft& d);
void choose_region(RenderDraft& d);
void choose_animation(RenderDraft& d);
void check_dithering(const RenderDraft& d);

/// As POV-Ray does it, a name without ending gets its own.
std::string scene_path(const std::string& name);

}  // namespace rt
