// How the processor rounds. Pictures are made in its usual way; the others tell which pixels hang by the last bits of the numbers.
#pragma once

#include <cstdint>

namespace rt {

enum class Rounding : std::uint8_t { nearest, downward, upward, toward_zero };

/// What the register MXCSR holds while rays are traced: this rounding, all exceptions masked, denormal numbers kept.
constexpr unsigned floating_point_state(Rounding rounding) {
    constexpr unsigned masked = 0x1f80, bits_of_rounding = 13;
    return masked | static_cast<unsigned>(rounding) << bits_of_rounding;
}

/// The calling thread rounds in this way while the object lives. Compilers move arithmetic across its ends where they see it: what is to be
/// rounded stands in functions that are called.
class RoundingScope {
public:
    explicit RoundingScope(Rounding rounding);
    ~RoundingScope();
    RoundingScope(const RoundingScope&) = delete;
    RoundingScope& operator=(const RoundingScope&) = delete;

private:
    unsigned before_;
};

}  // namespace rt
