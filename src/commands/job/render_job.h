// Everything one render was asked for, with what was left to defaults still open where a scene file may state its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/base/output_name.h"
#include "commands/job/animation.h"
#include "commands/job/model_choices.h"
#include "commands/job/quality_choice.h"
#include "film/encode.h"
#include "syntax/parser.h"
#include "trace/options.h"
#include "trace/render.h"
#include "world/compile.h"

namespace rt {

/// +SC +EC +SR +ER as written: pixels counted from 1, both ends included, or fractions of the picture.
struct RegionEdges {
    std::optional<double> start_column, end_column, start_row, end_row;
};

/// The region of a width x height picture; empty if no edge is given. Throws OptionError for one that is empty or leaves the picture.
std::optional<Region> resolve_region(const RegionEdges& edges, int width, int height);

struct RenderJob {
    std::string scene;
    OutputRequest output;
    int width = 800;
    int height = 600;
    std::optional<Region> region;
    int threads = 0;  ///< 0: all cores
    Sampling sampling;
    int scale = 1;               ///< see RenderOptions
    std::optional<double> time;  ///< seconds that the whole program may take; sampling is adaptive then
    bool preview = false;        ///< the picture is written while it is made, coarse at first
    std::optional<int> povray_quality;
    std::optional<int> max_trace_level;  ///< instead of the scene's; under the course's rules one more than their further rays
    std::optional<double> adc_bailout;   ///< likewise; the course's rules have none
    std::optional<ShadowKind> shadows;   ///< unset: full; the course's rules have their own
    std::optional<bool> specular_aa;     ///< unset: off
    std::optional<int> light_samples;    ///< lamps along each side of an area light, at most; unset: the scene's

    // Choices that a scene file may make in `//! raytrace:` comments; what is set here came from the command line and wins.
    std::optional<ShadingModel> shading;
    std::optional<Distances> distances;  ///< unset: povray under the shading of that name, else scaled
    std::optional<Precision> precision;

    ChosenQuality quality;                  ///< what of it no option states; carried out when the scene is read
    std::optional<CourseRules> course;      ///< under the course's profile, its own rules unless a shading is chosen
    std::vector<std::string> environment;   ///< one picture of all directions, or six of a cube; none: the scene's background
    std::vector<ModelOption> model;         ///< choices from the catalogue of shading, in order
    EdgeOptions edges;                      ///< lines over the picture; complete once the scene is read
    std::vector<ModelOption> edge_options;  ///< what the command line says of them, in order

    IndexKind index = IndexKind::automatic;
    Profile profile = Profile::povray;
    Curve file_gamma{Curve::Kind::srgb, 1.0};
    std::optional<int> bits;  ///< per channel, as asked for; unset: what the format usually has
    bool output_alpha = false;
    bool dither = false;

    ParseOptions parse;
    std::optional<Animation> animation;  ///< its frames are rendered one by one; unset: a single picture
    bool quiet = false;
    bool stats = false;
    bool progress = true;
    std::vector<std::string> notes;  ///< for stderr, once
};

}  // namespace rt
