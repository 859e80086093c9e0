// What became of one scene in POV-Ray and in this program: plain values, the same for every report.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "commands/job/requirements.h"
#include "commands/job/stats.h"
#include "core/name_table.h"
#include "grading/result.h"

namespace rt {

/// Who makes a picture: POV-Ray, this program with POV-Ray's shading, and this program as it is when nothing is said about shading.
enum class Maker : std::uint8_t { povray, same, general };
inline constexpr std::size_t makers = 3;
inline constexpr NameTable<Maker, makers> maker_names{{{"povray", Maker::povray}, {"same", Maker::same}, {"general", Maker::general}}};

/// One run of one of them.
struct VersusRun {
    enum class State : std::uint8_t {
        not_run,
        done,     ///< there is a picture
        refused,  ///< the scene, with a message
        failed    ///< it was ended, or ended without picture and message
    };
    State state = State::not_run;
    std::vector<std::string> command;  ///< run in the scene's folder
    std::string message;               ///< of `refused` and `failed`
    std::uint64_t rays = 0;            ///< from the camera, mirrored and transmitted, as the program counts them
    std::uint64_t shadow_tests = 0;    ///< as the program counts them: POV-Ray an object that a ray is tried with, we a ray
    // Times
    bool alone = false;  ///< nothing of ours ran beside it
    int threads = 0;
    double wall_seconds = 0.0, cpu_seconds = 0.0;
    std::uint64_t peak_memory_bytes = 0;
    Phases phases;  ///< as the program prints them; POV-Ray's writing is in none of its own
};
inline constexpr NameTable<VersusRun::State, 4> run_state_names{{{"not run", VersusRun::State::not_run},
                                                                 {"done", VersusRun::State::done},
                                                                 {"refused", VersusRun::State::refused},
                                                                 {"failed", VersusRun::State::failed}}};

/// When a scene agrees. Pictures are compared as they are shown: 8 bits, encoded.
struct VersusLimits {
    double percent = 98.0;  ///< of the pixels lie within `step`
    double step = 2.0;      ///< of 255, in every channel
    double rmse = 0.01;     ///< is not reached, of full scale
    Maker judged = Maker::same;
};

/// How far one of our pictures is from POV-Ray's.
struct Likeness {
    PictureFigures figures;
    std::uint64_t beyond = 0;               ///< pixels with a channel farther than the step
    std::optional<DifferingRegion> region;  ///< the largest of such pixels
    std::array<int, 3> theirs{}, ours{};    ///< colours of the region's representative pixel, 0..255
    bool agrees = false;
    double percent_within() const {
        return figures.pixels ? 100.0 * static_cast<double>(figures.pixels - beyond) / static_cast<double>(figures.pixels) : 0.0;
    }
};

/// Worst first.
enum class VersusCause : std::uint8_t {
    differs,
    failed,
    refused,
    refused_elsewhere,
    not_modelled,
    povray_refuses,
    not_run,
    both_refuse,
    agrees
};
inline constexpr std::size_t versus_causes = 9;
inline constexpr NameTable<VersusCause, versus_causes> cause_names{{{"differs", VersusCause::differs},
                                                                    {"failed", VersusCause::failed},
                                                                    {"refused by us alone", VersusCause::refused},
                                                                    {"refused at different places", VersusCause::refused_elsewhere},
                                                                    {"not modelled", VersusCause::not_modelled},
                                                                    {"refused by POV-Ray alone", VersusCause::povray_refuses},
                                                                    {"not run", VersusCause::not_run},
                                                                    {"refused by both", VersusCause::both_refuse},
                                                                    {"agrees", VersusCause::agrees}}};

struct VersusResult {
    std::string name;  ///< unique among the scenes of a comparison; also that of the folder of its pictures
    std::string path;
    VersusCause cause = VersusCause::not_run;
    std::array<VersusRun, makers> runs;
    std::vector<MissingFeature> missing;                   ///< what the scene asks for and we do not model, each where it is first
    std::array<std::optional<Likeness>, makers> likeness;  ///< to POV-Ray's picture; its own has none

    const VersusRun& run(Maker maker) const { return runs[static_cast<std::size_t>(maker)]; }
    VersusRun& run(Maker maker) { return runs[static_cast<std::size_t>(maker)]; }
    const std::optional<Likeness>& like(Maker maker) const { return likeness[static_cast<std::size_t>(maker)]; }
    std::optional<Likeness>& like(Maker maker) { return likeness[static_cast<std::size_t>(maker)]; }
};

constexpr bool counts_as_agreeing(VersusCause cause) { return cause == VersusCause::agrees || cause == VersusCause::both_refuse; }

}  // namespace rt
