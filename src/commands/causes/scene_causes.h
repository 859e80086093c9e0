// Why a picture is wrong, by making our own picture of the scene wrong in the same way.
#pragma once

#include "commands/causes/reshading.h"
#include "commands/causes/scene_samples.h"

namespace rt {

/// Every mistake of a table that explains some of the difference, each with what it leaves, the more special ones first. `roughness`:
/// the share of the difference that lies between neighbouring pixels, see `roughness_of`.
std::vector<Finding> scene_findings(const SceneSamples& samples, double roughness);

// Its parts: other sums over the same rays, other rays, and what the differing pixels have in common.
std::vector<Finding> reshading_findings(const SceneSamples& samples);
std::vector<Finding> path_findings(const SceneSamples& samples);
std::vector<Finding> retracing_findings(const SceneSamples& samples);
std::vector<Finding> shadow_findings(const SceneSamples& samples, double roughness);
std::vector<Finding> locus_findings(const SceneSamples& samples);

/// The samples' light under another shading.
std::vector<Rgb> reshaded(const SceneSamples& samples, const Reshading& how);

/// How far the picture is from `light`.
Misfit misfit(const SceneSamples& samples, const std::vector<Rgb>& light);
/// "without shadows: 3 % of the difference is left (120 of 4210 pixels)".
std::string what_is_left(const SceneSamples& samples, const std::string& words, const Misfit& left);

}  // namespace rt
