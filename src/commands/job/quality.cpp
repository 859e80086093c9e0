#include "commands/job/quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "commands/job/knobs.h"
#include "core/source.h"

namespace rt {

namespace {

constexpr std::array<QualityChoice, 3> draft{{{"samples", "1"}, {"scale", "1/2"}, {"adc-bailout", "1/32"}}};
constexpr std::array<QualityChoice, 2> fast{{{"samples", "POV-Ray 1, 0.3, 2 x 2"}, {"adc-bailout", "1/32"}}};
constexpr std::array<QualityChoice, 4> good{
    {{"samples", "error 1/128"}, {"max-trace-level", "8"}, {"adc-bailout", "1/255"}, {"fresnel", "exact"}}};
constexpr std::array<QualityChoice, 4> exact{
    {{"samples", "error 1/512"}, {"max-trace-level", "20"}, {"adc-bailout", "1/1000"}, {"fresnel", "exact"}}};

constexpr std::array<QualityPreset, 4> presets{{{"draft", "what moves where, at once", true, draft},
                                                {"fast", "smooth edges for little", true, fast},
                                                {"good", "for looking at", false, good},
                                                {"exact", "within what 8 bits show", false, exact}}};

}  // namespace

std::span<const QualityPreset> quality_presets() { return presets; }

const QualityPreset& quality_of_name(std::string_view name) {
    for (const QualityPreset& preset : presets)
        if (preset.name == name) return preset;
    throw OptionError(fmt::format("'{}' is no quality; expected one of draft, fast, good, exact", name));
}

std::string_view words_of(const QualityChoice& choice) {
    if (const Knob* knob = find_knob(choice.knob))
        for (const KnobValue& value : knob->values)
            if (value.name == choice.value) return value.words;
    throw std::logic_error(fmt::format("no knob '{}' with value '{}'", choice.knob, choice.value));
}

BesideScene beside_scene(std::string_view words, const Scene& scene) {
    RenderJob job;
    turn(job, words);
    const auto beside = [](auto value, auto scenes, bool large_is_fine) {
        if (value == scenes) return BesideScene::same;
        return (value > scenes) == large_is_fine ? BesideScene::finer : BesideScene::coarser;
    };
    if (job.max_trace_level) return beside(*job.max_trace_level, scene.settings.max_trace_level, true);
    if (job.adc_bailout) return beside(*job.adc_bailout, scene.settings.adc_bailout, false);
    return BesideScene::unrelated;
}

void define_quality(CommandLine& line, RenderDraft& d) {
    line.value("--quality", "NAME", "draft, fast, good or exact: help quality", [&](const std::string& v) {
        const QualityPreset& preset = quality_of_name(v);
        d.job.quality = {preset.cheap, {preset.choices.begin(), preset.choices.end()}};
    });
}

bool turns(const std::vector<std::string>& words, const Knob& knob) {
    const auto option_of = [](std::string_view text) { return text.substr(0, text.find_first_of(" =")); };
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return std::any_of(knob.values.begin(), knob.values.end(),
                           [&](const KnobValue& value) { return option_of(word) == option_of(value.words); });
    });
}

void choose_quality(RenderDraft& d, const std::vector<std::string>& words) {
    std::erase_if(d.job.quality.choices, [&](const QualityChoice& choice) {
        const bool pixels_by_themselves = d.max_error || d.job.time || d.job.preview;
        const bool samples = choice.knob == "samples" && (chooses_samples(d) || d.job.time || d.job.scale > 1);
        const bool scale = choice.knob == "scale" && pixels_by_themselves;
        return samples || scale || turns(words, *find_knob(choice.knob));
    });
}

void apply_quality(RenderJob& job, const Scene& scene) {
    if (!job.quality.choices.empty() && job.profile == Profile::csc473 && !job.shading && job.model.empty())
        throw OptionError("--quality goes with another shading, not with the course's rules");
    const std::size_t stated = job.model.size();
    const ChosenQuality quality = job.quality;  // turn() puts another job in its place
    for (const QualityChoice& choice : quality.choices) {
        const std::string_view words = words_of(choice);
        if (beside_scene(words, scene) == (quality.cheap ? BesideScene::finer : BesideScene::coarser)) continue;
        if (choice.knob == "precision" && job.precision) continue;
        turn(job, words);
    }
    for (std::size_t i = stated; i < job.model.size(); ++i) job.model[i].implied = true;
}

}  // namespace rt
