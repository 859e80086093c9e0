// What a light source holds besides itself: the object that shows it and the one that it is projected through.
#pragma once

#include <memory>

#include "syntax/blocks.h"

namespace rt {

/// What shows a light.
class LightLook {
public:
    /// After `looks_like`.
    LightLook(Reader& reader, const Light& light);
    void move(Reader& reader, const Span& place, const Transform& t);
    /// The set of it and its light.
    ObjectValue with(Reader& reader, Light light);

private:
    std::unique_ptr<SetValue> parts_;
};

/// Reads `looks_like { }` or `projected_through { }` if one comes next.
bool accept_light_object(Reader& reader, Light& light, std::optional<LightLook>& look);
void move_mask(Reader& reader, const Span& place, Mask& mask, const Transform& t);

}  // namespace rt
