// What a user turns to trade the accuracy of a picture for time: one table of all of it, for `trade`, for help, and for presets.
#pragma once

#include <span>
#include <string_view>

#include "commands/job/render_job.h"
#include "scene/scene.h"
#include "world/world.h"

namespace rt {

/// Which part of a picture's error a knob moves.
enum class ErrorSource {
    sampling,   ///< what one picture of the same model lacks of its limit for infinitely many samples
    model,      ///< a simpler model than the scene's own
    precision,  ///< rounding
};

struct KnobValue {
    std::string_view name;   ///< for tables: "3 x 3", "none"
    std::string_view words;  ///< for the command line, apart by blanks: "--ss 3"; "-gi_samples=64,16" only in a course's command
};

/// A scene that is about to be rendered: `job` after read_scene(), so without open choices.
struct KnobScene {
    const RenderJob& job;
    const Scene& scene;
    const World& world;
};

struct Knob {
    std::string_view name;              ///< "samples", "max-trace-level"
    std::string_view changes;           ///< a line for readers
    std::span<const KnobValue> values;  ///< from cheap to exact, at least two; any order where they only differ
    std::string_view plain;             ///< name of the value that a run has which says nothing; "" where the scene states it
    ErrorSource source = ErrorSource::model;
    bool converges = true;  ///< the last value is the exact one and the others approach it; false: different surfaces, none of them exact
    bool builds = false;    ///< another value needs another build_world()
    bool (*felt)(const KnobScene&) = nullptr;  ///< whether this scene's picture can depend on it
};

/// All of them, in the order of tables.
std::span<const Knob> knobs();
/// Null for a name that none has.
const Knob* find_knob(std::string_view name);

/// Carries out a value's words on `job`, in place of what it had of that knob, before or after read_scene(). Throws OptionError for words
/// that are no options of a render.
void turn(RenderJob& job, std::string_view words);

}  // namespace rt
