// Fractals of the plane z = 0: values before frequency, phase and wave.
#pragma once

#include "core/vec.h"
#include "patterns/pattern.h"

namespace rt {

/// z -> z^exponent + c from z = (x, y); c is (x, y) too, or `numbers.c` for julia. Outside: |z| > 2.
double mandel(const FractalNumbers& numbers, const Vec3& p);
double julia(const FractalNumbers& numbers, const Vec3& p);
/// The formulas of magnetism, from z = 0 with c = (x, y), or from z = (x, y) with `numbers.c`. Outside: |z| > 100 or |z - 1| < 0.01.
double magnet(const FractalNumbers& numbers, const Vec3& p);

}  // namespace rt
