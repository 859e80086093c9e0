#include "world/local_frame.h"

namespace rt {

LocalFrame::LocalFrame(const Bounds& box) : centre(0.5 * box.min + 0.5 * box.max) {
    // Far from the origin the rounding of doubles themselves must stay small against the unit.
    const double away = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
    const double half = std::fmax(0.5 * max_component(box.max - box.min), std::ldexp(away, -27));
    int exponent = 0;
    std::frexp(half > 0.0 ? half : 1.0, &exponent);
    // The largest power of two whose inverse is a normal number bounds the other end.
    scale = std::ldexp(1.0, std::max(exponent, -1020));
    inverse_scale = 1.0 / scale;
}

}  // namespace rt
