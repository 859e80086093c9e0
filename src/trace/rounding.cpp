#include "trace/rounding.h"

#include <xmmintrin.h>

namespace rt {

RoundingScope::RoundingScope(Rounding rounding) : before_(_mm_getcsr()) { _mm_setcsr(floating_point_state(rounding)); }

RoundingScope::~RoundingScope() { _mm_setcsr(before_); }

}  // namespace rt
