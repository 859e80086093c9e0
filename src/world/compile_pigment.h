// Stated patterns, pigments and normals -> nodes.
#pragma once

#include <map>

#include "scene/object_probe.h"
#include "world/normal_node.h"

namespace rt {

/// What answers for the bodies of object patterns, each made once however many patterns ask for it.
class ProbeTable {
public:
    /// Throws LimitError where the bodies are too many.
    std::shared_ptr<const ObjectProbe> at(const Shared<Bodies>& bodies);

private:
    struct Known {
        Shared<Bodies> bodies;  ///< kept, so that no others come to lie at its address
        std::shared_ptr<const ObjectProbe> probe;
    };
    std::map<const Bodies*, Known> known_;
};

/// What patterns take from the scene where they state nothing of their own, and what those of one scene share.
struct PatternDefaults {
    NoiseGenerator noise = NoiseGenerator::range_corrected;
    std::optional<std::vector<WaveSource>> sources;  ///< of ripples and waves; unset: those the pattern has
    std::shared_ptr<ProbeTable> probes = std::make_shared<ProbeTable>();
};

PatternDefaults pattern_defaults(const Scene& scene);

/// `uv`: the surroundings say uv_mapping.
PatternNode compile_pattern(const StatedPattern& stated, const PatternDefaults& defaults, bool uv);
PigmentTree compile_pigment(const Pigment& pigment, const PatternDefaults& defaults, bool uv);
/// The same function; what it asks can answer then.
std::shared_ptr<const Function> compile_function(const std::shared_ptr<const Function>& stated, const PatternDefaults& defaults);
/// What an isosurface's function asks can answer then; nothing is done to other shapes.
void compile_functions(FurtherShape& shape, const PatternDefaults& defaults);
NormalNode compile_normal(const Normal& normal, const PatternDefaults& defaults, bool uv);

bool uses_uv(const PatternNode& node);
bool uses_uv(const PigmentTree& tree);
bool uses_uv(const NormalNode& node);
/// Whether some colour that the tree can show lets light pass.
bool can_transmit(const PigmentTree& tree);

}  // namespace rt
