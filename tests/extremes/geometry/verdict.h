// The pictures that settings and programs make of a scene of extreme geometry, beside the reference.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tests/extremes/bytes.h"

namespace rt::extremes {

/// How the program is asked.
struct Setting {
    const char* name;
    const char* options;
};
inline constexpr std::array<Setting, 4> settings{{{"exact", "--precision exact --distances scaled"},
                                                  {"fast", "--precision fast --distances scaled"},
                                                  {"exact, povray", "--precision exact --distances povray"},
                                                  {"fast, povray", "--precision fast --distances povray"}}};
inline constexpr std::size_t exact_scaled = 0, fast_scaled = 1;

inline constexpr int geometry_width = 64, geometry_height = 48;

/// The reference's picture and which of its pixels can be judged.
struct Truth {
    std::string name;
    Bytes picture;             ///< 113 bits
    std::vector<bool> stable;  ///< pixels that stay within one step when the camera moves by 2^-46 of the scene's largest coordinate,
    ///< and when of surfaces nearer than 2^-52 of it the first is met, or the last
    int unstable = 0;
    std::vector<std::size_t> objects;  ///< what the camera sees there; `object_count` where that is nothing
    std::size_t object_count = 0;
};

/// Of the stable pixels of a picture; `wrong` are more than one step of 8 bits from the truth.
struct Count {
    int wrong = 0;
    int steps = 0;       ///< the largest distance
    int non_finite = 0;  ///< of all pixels
    int speckles = 0;    ///< wrong pixels most of whose neighbours are right
    int lost = 0;        ///< objects of whose visible pixels most are wrong
    int unstable = 0;    ///< of the other pixels, those more than one step away
};

struct Verdict {
    Truth truth;
    std::array<Bytes, settings.size()> ours;
    Bytes textbook_single, textbook_double;
    std::optional<Bytes> povray;
    bool povray_refuses = false;  ///< it is installed, but does not render the scene
};

/// Scenes of pov/extremes/geometry, in order of their names: paths.
std::vector<std::string> geometry_scenes();

/// Throws what read_solids() throws.
Truth truth_of(const std::string& scene);
Count count(const Bytes& picture, const Truth& truth);

/// How many pixels a setting of the program may have wrong in that scene: what it is known not to do, 0 but for a few.
int known_wrong(const std::string& name, std::size_t setting);
/// No pixel of any setting is no number, and with scaled distances not more than known are wrong.
bool right(const Verdict& verdict);

/// The truth and the program's own pictures. Throws std::runtime_error if the program fails.
Verdict verdict_of_ours(const std::string& scene);
/// Textbook formulas in doubles.
Bytes textbook_double(const std::string& scene);
/// All pictures, POV-Ray's where it is installed.
Verdict verdict(const std::string& scene);

}  // namespace rt::extremes
