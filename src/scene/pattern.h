// A pattern as a scene states it, with what is no number of its own.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "core/function.h"
#include "core/shared.h"
#include "patterns/pattern.h"

namespace rt {

struct Bodies;
struct Pigment;

/// What computes the value of a kind that is computed elsewhere: `pigment_pattern`, `function` and `object`.
using PatternSource = std::variant<std::monostate, Shared<Pigment>, std::shared_ptr<const Function>, Shared<Bodies>>;

struct StatedPattern {
    Pattern pattern;
    bool own_noise = false;   ///< `noise_generator` is stated; else the scene's counts
    bool uv_mapping = false;  ///< seen at (u, v, 0) of the surface instead of the point
    PatternSource source;
    bool operator==(const StatedPattern&) const;
};

}  // namespace rt
