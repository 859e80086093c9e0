#include "commands/job/knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/base/values.h"
#include "commands/job/course_arguments.h"
#include "commands/job/job_steps.h"
#include "commands/job/render_draft.h"
#include "commands/job/without_effect.h"
#include "core/source.h"
#include "world/surface_index.h"

namespace rt {

namespace {

constexpr std::array<KnobValue, 19> samples{{{"1", "--ss 1"},
                                             {"POV-Ray 2, 0.3, 2", "--aa 2,0.3,2"},
                                             {"POV-Ray 1, 0.3, 2 x 2", "--aa 1,0.3,2"},
                                             {"2 x 2", "--ss 2"},
                                             {"error 1/32", "--max-error 0.03125"},
                                             {"POV-Ray 1, 0.1, 3 x 3", "--aa 1,0.1,3"},
                                             {"POV-Ray 2, 0.1, 3", "--aa 2,0.1,3"},
                                             {"3 x 3", "--ss 3"},
                                             {"error 1/64", "--max-error 0.015625"},
                                             {"4 x 4", "--ss 4"},
                                             {"POV-Ray 2, 0.03, 4", "--aa 2,0.03,4"},
                                             {"error 1/128", "--max-error 0.0078125"},
                                             {"6 x 6", "--ss 6"},
                                             {"8 x 8", "--ss 8"},
                                             {"error 1/256", "--max-error 0.00390625"},
                                             {"12 x 12", "--ss 12"},
                                             {"16 x 16", "--ss 16"},
                                             {"error 1/512", "--max-error 0.001953125"},
                                             {"error 1/1024", "--max-error 0.0009765625"}}};
constexpr std::array<KnobValue, 4> scales{{{"1/4", "--scale 4"}, {"1/3", "--scale 3"}, {"1/2", "--scale 2"}, {"all", "--scale 1"}}};
constexpr std::array<KnobValue, 8> levels{{{"1", "--max-trace-level 1"},
                                           {"2", "--max-trace-level 2"},
                                           {"3", "--max-trace-level 3"},
                                           {"4", "--max-trace-level 4"},
                                           {"5", "--max-trace-level 5"},
                                           {"8", "--max-trace-level 8"},
                                           {"12", "--max-trace-level 12"},
                                           {"20", "--max-trace-level 20"}}};
constexpr std::array<KnobValue, 6> bailouts{{{"1/4", "--adc-bailout 0.25"},
                                             {"1/10", "--adc-bailout 0.1"},
                                             {"1/32", "--adc-bailout 0.03125"},
                                             {"1/255", "--adc-bailout 0.00392156862745098"},
                                             {"1/1000", "--adc-bailout 0.001"},
                                             {"0", "--adc-bailout 0"}}};
constexpr std::array<KnobValue, 3> shadow_kinds{{{"none", "--shadows none"}, {"opaque", "--shadows opaque"}, {"full", "--shadows full"}}};
constexpr std::array<KnobValue, 6> light_samples{{{"1", "--light-samples 1"},
                                                  {"2 x 2", "--light-samples 2"},
                                                  {"3 x 3", "--light-samples 3"},
                                                  {"5 x 5", "--light-samples 5"},
                                                  {"9 x 9", "--light-samples 9"},
                                                  {"the scene's", "--light-samples all"}}};
constexpr std::array<KnobValue, 2> widenings{{{"on", "--specular-aa on"}, {"off", "--specular-aa off"}}};
constexpr std::array<KnobValue, 3> fresnels{
    {{"Schlick", "--F schlick"}, {"Schlick with a dip", "--F schlick-f82"}, {"exact", "--F conductor"}}};
constexpr std::array<KnobValue, 3> distributions{{{"GGX", "--D ggx"}, {"Beckmann", "--D beckmann"}, {"Blinn", "--D blinn"}}};
constexpr std::array<KnobValue, 7> maskings{{{"none", "--G none"},
                                             {"Cook-Torrance", "--G cook-torrance"},
                                             {"GGX", "--G ggx"},
                                             {"GGX, correlated", "--G ggx-hc"},
                                             {"Beckmann, rational", "--G beckmann-rational"},
                                             {"Beckmann", "--G beckmann"},
                                             {"Beckmann, correlated", "--G beckmann-hc"}}};
constexpr std::array<KnobValue, 2> precisions{{{"fast", "--precision fast"}, {"exact", "--precision exact"}}};
constexpr std::array<KnobValue, 5> indirect{{{"4, 1", "-gi_samples=4,1"},
                                             {"16, 4", "-gi_samples=16,4"},
                                             {"32, 8", "-gi_samples=32,8"},
                                             {"64, 16", "-gi_samples=64,16"},
                                             {"256, 16", "-gi_samples=256,16"}}};

bool always(const KnobScene&) { return true; }
bool has_further_rays(const KnobScene& s) { return s.world.features.reflects || s.world.features.transmits; }
/// The course's rules know no weight of a ray.
bool has_weights(const KnobScene& s) { return !s.job.course && has_further_rays(s); }
bool has_shadow_rays(const KnobScene& s) { return !s.job.povray_quality || Quality::povray(*s.job.povray_quality).shadows; }
bool has_shadows(const KnobScene& s) {
    const auto shines = [](const Light& light) { return !light.shadowless; };
    const auto blocks = [](const CompiledObject& object) { return !object.no_shadow; };
    return !s.job.course && has_shadow_rays(s) && std::any_of(s.world.lights.begin(), s.world.lights.end(), shines) &&
           std::any_of(s.world.objects.begin(), s.world.objects.end(), blocks);
}
/// As the scene states them, since the world may have fewer lamps already.
bool has_area_lights(const KnobScene& s) {
    const bool shadows = has_shadow_rays(s) && s.job.shadows != ShadowKind::none;
    return !s.job.course && std::any_of(s.scene.lights.begin(), s.scene.lights.end(), [&](const Light& light) {
        const bool many = light.area && std::max(light.area->size1, light.area->size2) > 1;
        return many && (light.area->area_illumination || (shadows && !light.shadowless));
    });
}
bool reads_fresnel(const KnobScene& s) { return picture_reads("F", s.job, s.scene, s.world); }
bool reads_distribution(const KnobScene& s) { return picture_reads("D", s.job, s.scene, s.world); }
bool reads_masking(const KnobScene& s) { return picture_reads("G", s.job, s.scene, s.world); }
/// A list of surfaces is asked in doubles, whatever the precision.
bool has_indexed_triangles(const KnobScene& s) {
    return s.world.surfaces && s.world.surfaces->indexed() && !s.world.surfaces->surfaces().faces.empty();
}
bool has_indirect_light(const KnobScene& s) { return s.job.course && !s.job.course->indirect_samples.empty(); }

constexpr auto sampling = ErrorSource::sampling, model = ErrorSource::model, precision = ErrorSource::precision;

constexpr std::array table{
    Knob{"samples", "rays through a pixel", samples, "1", sampling, true, false, always},
    Knob{"scale", "share of width and height that is traced", scales, "all", sampling, true, false, always},
    Knob{"max-trace-level", "rays that follow one another", levels, "", model, true, false, has_further_rays},
    Knob{"adc-bailout", "weight below which a ray is not followed", bailouts, "", model, true, false, has_weights},
    Knob{"shadows", "what keeps light from a surface", shadow_kinds, "full", model, true, false, has_shadows},
    Knob{"light-samples", "lamps in an area light", light_samples, "the scene's", model, true, true, has_area_lights},
    Knob{"fresnel", "reflectance by the angle", fresnels, "Schlick", model, true, true, reads_fresnel},
    Knob{"distribution", "shape of a highlight", distributions, "GGX", model, false, true, reads_distribution},
    Knob{"masking", "highlights at grazing angles", maskings, "GGX", model, false, true, reads_masking},
    Knob{"specular-aa", "highlights as wide as a sample", widenings, "off", sampling, true, false, reads_distribution},
    Knob{"precision", "numbers that triangles are found with", precisions, "exact", precision, true, true, has_indexed_triangles},
    Knob{"indirect-samples", "directions of indirect light", indirect, "64, 16", sampling, true, false, has_indirect_light},
};

constexpr std::string_view indirect_option = "-gi_samples=";

}  // namespace

std::span<const Knob> knobs() { return table; }

const Knob* find_knob(std::string_view name) {
    const auto known = std::find_if(table.begin(), table.end(), [&](const Knob& knob) { return knob.name == name; });
    return known == table.end() ? nullptr : &*known;
}

void turn(RenderJob& job, std::string_view words) {
    if (words.starts_with(indirect_option)) {
        if (!job.course) throw OptionError(fmt::format("'{}' goes with the course's rules", words));
        job.course->indirect_samples = indirect_samples_of(words.substr(indirect_option.size()));
        return;
    }
    RenderDraft draft;
    draft.job = job;
    CommandLine line("", "");
    define_sampling(line, draft);
    define_shading(line, draft.job);
    define_knobs(line, draft.job);
    const std::vector<std::string> others = line.parse(split(words, ' '));
    if (!others.empty()) throw OptionError(fmt::format("'{}' is no option of a render", others.front()));
    if (chooses_samples(draft)) choose_sampling(draft);
    give_course_its_depth(draft.job);
    job = std::move(draft.job);
}

}  // namespace rt
