// Points in the space of knobs: one value for each.
#pragma once

#include <compare>
#include <span>
#include <string>
#include <vector>

#include "commands/job/knobs.h"
#include "commands/job/quality.h"

namespace rt {

/// A knob that is left as the scene has it.
inline constexpr std::size_t as_stated = static_cast<std::size_t>(-1);

/// A knob that the scene can feel and that neither the command line nor the scene has chosen.
struct TurnedKnob {
    const Knob* table = nullptr;
    std::size_t plain = as_stated;  ///< number of the value that a run has which says nothing, or as_stated if it is none of them
    std::size_t coarser = 0;        ///< so many values are coarser than what the scene states
    const Knob* operator->() const { return table; }
};
using TurnedKnobs = std::vector<TurnedKnob>;

/// For each turned knob the number of its value, or as_stated.
struct Setting {
    std::vector<std::size_t> values;
    auto operator<=>(const Setting&) const = default;
};

/// A knob as it stands beside what the scene states.
TurnedKnob turned_knob(const Knob& knob, const Scene& scene);

/// What a run has that says nothing.
Setting plain_setting(const TurnedKnobs& knobs);
/// What `--quality` makes of a run: a cheap preset leaves what the scene states coarser, an exact one what it states finer.
Setting preset_setting(const QualityPreset& preset, const TurnedKnobs& knobs);

/// Whether a command line takes it: an error that is asked for chooses the pixels itself, and goes with no share of them.
bool goes_together(const Setting& setting, const TurnedKnobs& knobs);

/// The values' words, a text for each knob that is not left as it is stated.
std::vector<std::string> words_of(const Setting& setting, const TurnedKnobs& knobs);

/// A preset's name, or that of the nearest preset with what differs: "good: samples 2 x 2, precision fast"; of several nearest ones the
/// last, of those that the knobs cannot tell apart the first.
std::string name_of(const Setting& setting, const TurnedKnobs& knobs);

/// A name as one of files: "good-samples-2-x-2-precision-fast".
std::string file_name_of(const std::string& name);

/// "3 x 3", or "as stated".
std::string_view value_name(const Knob& knob, std::size_t value);

}  // namespace rt
