// What a user can choose about tracing, with POV-Ray's defaults.
#pragma once

#include <memory>
#include <optional>

#include "shading/lamps.h"
#include "trace/course_rules.h"

namespace rt {

class Environment;

enum class ShadingModel {
    general,  ///< the general microfacet form
    povray,   ///< POV-Ray's finish model
};

enum class Distances {
    scaled,  ///< offsets from the error of the hit point, no limits
    povray,  ///< its absolute 1e-4, 1e-3 and 1e7
};

/// What keeps the light of a lamp from a surface.
enum class ShadowKind {
    full,    ///< every surface; those that light can pass tint it
    opaque,  ///< only surfaces that no light can pass anywhere; all others as if they were not there
    none,    ///< nothing
};

/// Parts of the picture that POV-Ray's +Q leaves out.
struct Quality {
    bool lighting = true;  ///< else the pigment's rgb as it is
    bool shadows = true;
    bool transmission = true;
    bool reflection = true;
    bool normals = true;  ///< else surfaces have no bumps
    bool quick_colors = false;

    /// POV-Ray's +Qn, n = 0..11.
    static Quality povray(int n);
};

/// Samples in a row and in a column of the whole picture.
struct SampleGrid {
    int columns = 1, rows = 1;
};

struct TraceOptions {
    ShadingModel shading = ShadingModel::general;
    Distances distances = Distances::scaled;
    std::optional<int> max_trace_level;  ///< overrides the scene's
    std::optional<double> adc_bailout;   ///< likewise
    Quality quality;
    ShadowKind shadows = ShadowKind::full;  ///< where `quality` has shadows
    std::optional<SampleGrid> specular_aa;  ///< general: microfacet highlights at least as wide as the camera's samples; unset: as they are
    LampRules lamps;
    std::shared_ptr<const Environment> environment;  ///< instead of the scene's background
    std::optional<CourseRules> course;               ///< the course's rules instead of POV-Ray's: nothing above counts then
};

/// Lines drawn over the picture.
struct EdgeOptions {
    enum class Kind { off, silhouette, crease, all };
    Kind kind = Kind::off;
    double width = 1.0;          ///< in pixels
    Rgb color{0.0};              ///< in the working space
    double crease_angle = 30.0;  ///< degrees between the surface's normals from which on a crease has a line
    bool operator==(const EdgeOptions&) const = default;
};

/// How pixels become samples.
struct Sampling {
    enum class Method {
        none,      ///< the pixel's centre
        grid,      ///< the centres of n x n sub-pixels, averaged
        povray1,   ///< POV-Ray's non-adaptive method, without jitter
        povray2,   ///< POV-Ray's adaptive method, without jitter
        adaptive,  ///< more samples where they lessen the error most, until it is max_error (progressive.h)
    };
    Method method = Method::none;
    int depth = 3;           ///< grid: n; povray: +R, 1..9
    double threshold = 0.3;  ///< +A
    double gamma = 2.5;      ///< Antialias_Gamma: exponent 1/gamma in the comparison of colours
    int block = 32;          ///< +BS
    double max_error = 0.0;  ///< adaptive: RMSE of the picture's encoded channels, which are 0..1
};

}  // namespace rt
