// What functions ask of a scene: function { pigment { } } and function { pattern { } }.
#pragma once

#include <variant>

#include "core/function.h"
#include "scene/pigment.h"

namespace rt {

/// As it is stated. The world has those that can answer in its place.
class StatedSource final : public FunctionSource {
public:
    explicit StatedSource(std::variant<Pigment, StatedPattern> what) : stated(std::move(what)) {}
    std::array<double, 6> values(const Vec3&) const override { return {}; }

    std::variant<Pigment, StatedPattern> stated;
};

}  // namespace rt
