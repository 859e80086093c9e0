// The named steps from a quick picture to an exact one: each a row of choices from the table of knobs.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands/job/knobs.h"
#include "commands/job/render_draft.h"
#include "scene/scene.h"

namespace rt {

struct QualityPreset {
    std::string_view name;
    std::string_view about;  ///< a line for readers
    /// Towards what it goes: a cheap one never makes a scene's own value finer, an exact one never makes it coarser.
    bool cheap = false;
    std::span<const QualityChoice> choices;  ///< knobs that are not in it stay as they are in a plain run
};

/// draft, fast, good, exact: from cheap to exact.
std::span<const QualityPreset> quality_presets();
/// Throws OptionError for a name that none has.
const QualityPreset& quality_of_name(std::string_view name);

/// A choice as options of a render, apart by blanks. Throws std::logic_error for one that the table of knobs does not have.
std::string_view words_of(const QualityChoice& choice);

enum class BesideScene { coarser, same, finer, unrelated };
/// What options of a knob are beside what the scene itself states of it in global_settings.
BesideScene beside_scene(std::string_view words, const Scene& scene);

/// --quality NAME.
void define_quality(CommandLine& line, RenderDraft& d);
/// Whether a word is an option that turns this knob.
bool turns(const std::vector<std::string>& words, const Knob& knob);
/// Leaves in the job's quality what none of the words of a command line states.
void choose_quality(RenderDraft& d, const std::vector<std::string>& words);
/// Carries out a job's quality; to be called when the scene's own choices are in the job. What the scene states as a choice stays.
void apply_quality(RenderJob& job, const Scene& scene);

}  // namespace rt
