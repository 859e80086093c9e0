// What is not modelled, by what modelling it would gain.
#pragma once

#include <string>
#include <vector>

#include "commands/job/requirements.h"

namespace rt {

/// What scenes miss, a list for each; a feature may be in it more than once.
using MissingOfScenes = std::vector<std::vector<MissingFeature>>;

struct MissingCount {
    std::string name;
    std::size_t scenes = 0;     ///< that ask for it
    std::size_t only_this = 0;  ///< of them, those that ask for nothing else that is missing
};
/// Most of `only_this` first, then most `scenes`, then by name.
std::vector<MissingCount> missing_counts(const MissingOfScenes& scenes);

/// A step on the way to having all.
struct MissingStep {
    std::string name;
    std::size_t completes = 0;  ///< scenes that then miss nothing, where all steps before are done
};
/// Every missing feature once: the next is that which completes most scenes together with those before; of equal ones that for which the
/// sum over the scenes that ask for it, 1/(features that the scene still misses), is largest; then by name.
std::vector<MissingStep> missing_order(const MissingOfScenes& scenes);

}  // namespace rt
