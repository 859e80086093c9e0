// One pattern of a pigment, a normal or a density, as a value: its kind and numbers, the chain of transforms and warps before it, the
// frequency, phase and wave behind it. Everything is a pure function of a point. What POV-Ray keeps in single precision is `float` here.
//
//     q = pattern_point(pattern, p)       the chain, last written first, then the keyword `turbulence`
//     raw = raw_value(pattern, q)         what the kind says
//     v = wave_value(pattern, raw)        frequency, phase and wave: what a map is asked with
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "core/shared.h"
#include "core/vec.h"
#include "patterns/image.h"
#include "patterns/noise.h"
#include "patterns/warp.h"

namespace rt {

/// The words of scene files, in POV-Ray's spelling.
enum class PatternKind : std::uint8_t {
    agate,
    aoi,
    average,
    boxed,
    bozo,
    brick,
    bump_map,  ///< of normals alone
    bumps,
    cells,
    checker,
    crackle,
    cubic,
    cylindrical,
    density_file,
    dents,
    facets,
    function,
    gradient,
    granite,
    hexagon,
    image_pattern,
    julia,
    leopard,
    magnet,
    mandel,
    marble,
    object,
    onion,
    pigment_pattern,
    planar,
    quilted,
    radial,
    ripples,
    slope,
    spherical,
    spiral1,
    spiral2,
    spotted,
    square,
    triangular,
    waves,
    wood,
    wrinkles,
};

/// The kind that `word` names; nothing for other words.
std::optional<PatternKind> pattern_kind(std::string_view word);
std::string_view name(PatternKind kind);

/// Patterns of cells (checker, brick, hexagon, square, triangular, cubic): how many colours they list, which are a map from 0 to that
/// number less 1; 0 for all others.
int cell_count(PatternKind kind);
inline bool has_cells(PatternKind kind) { return cell_count(kind) > 0; }
/// How many colours stand in a list behind the kind's word: those of its cells; of `object`, what is outside and what is inside, which are
/// a map from 0 to 1.
inline int list_size(PatternKind kind) { return kind == PatternKind::object ? 2 : cell_count(kind); }
/// Patterns whose value somebody else computes at `pattern_point`: function, pigment_pattern, object, average (none).
bool is_computed_elsewhere(PatternKind kind);

enum class WaveType : std::uint8_t { ramp, triangle, sine, scallop, cubic, poly };

/// `ramp_wave` ... `poly_wave`; nothing for other words.
std::optional<WaveType> wave_type(std::string_view word);

// The numbers of the kinds that have some.

struct AgateNumbers {
    float turbulence = 1.0F;  ///< `agate_turb`
    bool operator==(const AgateNumbers&) const = default;
};

struct BrickNumbers {
    Vec3 size{8.0, 3.0, 4.5};  ///< with the mortar
    double mortar = 0.5;
    bool operator==(const BrickNumbers&) const = default;
};

struct CrackleNumbers {
    double metric = 2.0;
    double offset = 0.0;
    Vec3 form{-1.0, 1.0, 0.0};
    bool solid = false;
    bool operator==(const CrackleNumbers&) const = default;
};

struct GradientNumbers {
    Vec3 direction{1.0, 0.0, 0.0};  ///< as written; not zero
    bool operator==(const GradientNumbers&) const = default;
};

/// julia, mandel and magnet.
struct FractalNumbers {
    int magnet = 1;      ///< formula 1 or 2 of `magnet`
    bool julia = false;  ///< `magnet n julia c, ...`, not `magnet n mandel ...`
    Vec2 c{0.0};         ///< of both kinds of julia
    int iterations = 1;  ///< steps at most; what a point costs
    int exponent = 2;    ///< of julia and mandel: 2 to 33
    /// What points outside show: 0 the factor alone, 1 the share of steps (without factor), 2 and 3 the real and imaginary part, 4 and 5
    /// their squares, 6 the magnitude.
    int exterior = 1;
    double exterior_factor = 1.0;
    /// What points inside show: 0 the factor alone, 1 how near the orbit came to 0, 2 to 5 as outside, 6 the squared magnitude.
    int interior = 0;
    double interior_factor = 1.0;
    bool operator==(const FractalNumbers&) const = default;
};

struct QuiltedNumbers {
    float control0 = 1.0F;
    float control1 = 1.0F;
    bool operator==(const QuiltedNumbers&) const = default;
};

struct FacetsNumbers {
    float size = 0.1F;
    float coords = 0.0F;  ///< not 0: facets by place with this scale, not by direction
    double metric = 2.0;
    bool operator==(const FacetsNumbers&) const = default;
};

struct SlopeNumbers {
    Vec3 slope{0.0, 1.0, 0.0};
    Vec2 slope_range{0.0};  ///< lo, hi; no range where both are equal
    Vec3 altitude{0.0};     ///< zero: slope alone
    Vec2 altitude_range{0.0};
    bool operator==(const SlopeNumbers&) const = default;
};

/// spiral1 and spiral2.
struct SpiralNumbers {
    int arms = 1;
    bool operator==(const SpiralNumbers&) const = default;
};

/// One centre of ripples and waves.
struct WaveSource {
    Vec3 center;
    double frequency;  ///< of waves
    bool operator==(const WaveSource&) const = default;
};

/// The centres for the global `number_of_waves`, at least 1; POV-Ray's default is 10.
std::vector<WaveSource> wave_sources(int count);

/// ripples and waves.
struct WavesNumbers {
    Shared<std::vector<WaveSource>> sources;
    bool operator==(const WavesNumbers&) const = default;
};

/// A block of numbers 0..1; x runs fastest, then y.
struct ValueGrid {
    int width = 0;
    int height = 0;
    int depth = 0;
    std::vector<float> values;
    bool operator==(const ValueGrid&) const = default;
};

struct DensityNumbers {
    Shared<ValueGrid> grid;
    int interpolate = 0;  ///< 0 none, 1 trilinear, 2 tricubic
    bool operator==(const DensityNumbers&) const = default;
};

/// image_pattern and bump_map: the picture's file values as grey (or its alpha), the top row first, depth 1.
struct ImageNumbers {
    Shared<ValueGrid> grid;
    ImageMapping mapping;
    bool operator==(const ImageNumbers&) const = default;
};

using PatternNumbers = std::variant<std::monostate, AgateNumbers, BrickNumbers, CrackleNumbers, GradientNumbers, FractalNumbers,
                                    QuiltedNumbers, FacetsNumbers, SlopeNumbers, SpiralNumbers, WavesNumbers, DensityNumbers, ImageNumbers>;

struct Pattern {
    PatternKind kind = PatternKind::bozo;
    NoiseGenerator noise = NoiseGenerator::range_corrected;
    WaveType wave = WaveType::ramp;
    float frequency = 1.0F;  ///< 0: neither frequency nor phase acts
    float phase = 0.0F;
    float wave_exponent = 1.0F;            ///< of `poly_wave`
    PatternNumbers numbers;                ///< those of `kind`
    std::vector<Warp> warps;               ///< transforms and warps, in the order of the file
    std::optional<Turbulence> turbulence;  ///< the keywords `turbulence`, `octaves`, `omega`, `lambda`: last of all, whatever their place
    bool operator==(const Pattern&) const = default;
};

/// A pattern of `kind` with POV-Ray's defaults: its numbers, the triangle wave for marble, wood, spiral1 and spiral2, and frequency 0 for
/// cells, whose numbers are what a map is asked with until a frequency is stated.
Pattern make_pattern(PatternKind kind);

/// Appends a transform (pattern space to the space around it) to the chain, as one step with a transform just before it.
void append(Pattern& pattern, const Transform& transform);

/// What a pattern may ask of the surface besides the point; zero where there is none (skies, functions), and `slope` and `aoi` are 0.
struct PatternSurface {
    Vec3 normal{0.0};     ///< unit, as perturbed so far, turned against the ray
    Vec3 direction{0.0};  ///< of the ray, unit
};

/// From the space around to the point that the kind and the entries of a map see.
Vec3 pattern_point(const Pattern& pattern, const Vec3& p);
/// The kind's value at a pattern point: of cells their number; 0 for kinds computed elsewhere.
double raw_value(const Pattern& pattern, const Vec3& q, const PatternSurface& surface = {});
/// Frequency, phase and wave.
double wave_value(const Pattern& pattern, double raw);
/// All three: what a map is asked with.
double pattern_value(const Pattern& pattern, const Vec3& p, const PatternSurface& surface = {});

/// The value of a picture, which is not empty, at a place on it.
double image_height(const ImageNumbers& image, const Vec2& place);

/// The number of the cell at a pattern point, 0 to cell_count - 1, before frequency, phase and wave.
int raw_cell(const Pattern& pattern, const Vec3& q);
/// The same from the space around.
int pattern_cell(const Pattern& pattern, const Vec3& p);

}  // namespace rt
