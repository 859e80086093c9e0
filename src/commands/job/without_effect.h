// Choices that nothing in the picture depends on.
#pragma once

#include <string>
#include <string_view>

#include "commands/job/render_job.h"
#include "scene/scene.h"
#include "world/world.h"

namespace rt {

/// Whether what some surface of `world` sends on depends on `key`, one of the catalogue of shading; `job` as it is rendered, without open
/// choices.
bool picture_reads(std::string_view key, const RenderJob& job, const Scene& scene, const World& world);

/// Names every option, and every choice that a comment of the file states, which no finish of `world` and none of its lamps read as they
/// are shaded in the end: "no effect here: --sigma, exponent=40 (nothing in the picture depends on them)"; "" where all have one. Not
/// named: what presets, materials and qualities set, what a finish states, numbers of a file's lines that an option turned off. `job` as it
/// is rendered, without open choices.
std::string note_on_choices_without_effect(const RenderJob& job, const Scene& scene, const World& world);

}  // namespace rt
