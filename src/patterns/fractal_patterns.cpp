#include "patterns/fractal_patterns.h"

#include <algorithm>
#include <limits>

namespace rt {

namespace {

/// A complex number: std::complex spends most of a product on infinities that end a loop here anyway.
struct Complex {
    double re = 0.0;
    double im = 0.0;
};

Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
Complex operator+(Complex a, double b) { return {a.re + b, a.im}; }
Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
Complex operator*(double a, Complex b) { return {a * b.re, a * b.im}; }
double norm(Complex a) { return a.re * a.re + a.im * a.im; }
Complex operator/(Complex a, Complex b) {
    const double n = norm(b);
    return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
}

Complex power(Complex z, int exponent) {
    Complex result = z;
    for (int i = 1; i < exponent; ++i) result = result * z;
    return result;
}

/// How an orbit went: where it ended, after how many steps, and how near to 0 it came.
struct Orbit {
    bool outside = false;
    int steps = 0;
    Complex end;
    double least_norm = 0.0;
};

template <typename Step, typename IsOutside>
Orbit follow(int iterations, Complex z, double least_norm, Step step, IsOutside is_outside) {
    Orbit orbit{false, 0, z, least_norm};
    for (; orbit.steps < iterations; ++orbit.steps) {
        orbit.end = step(orbit.end);
        orbit.least_norm = std::min(orbit.least_norm, norm(orbit.end));
        if (is_outside(orbit.end)) {
            orbit.outside = true;
            break;
        }
    }
    return orbit;
}

double value_of(const FractalNumbers& numbers, const Orbit& orbit) {
    const Complex z = orbit.end;
    if (orbit.outside && numbers.exterior == 1) return orbit.steps / static_cast<double>(numbers.iterations);
    const int type = orbit.outside ? numbers.exterior : numbers.interior;
    const double factor = orbit.outside ? numbers.exterior_factor : numbers.interior_factor;
    switch (type) {
        case 0:
            return factor;
        case 1:
            return std::sqrt(orbit.least_norm) * factor;
        case 2:
            return z.re * factor;
        case 3:
            return z.im * factor;
        case 4:
            return z.re * z.re * factor;
        case 5:
            return z.im * z.im * factor;
        default:
            break;
    }
    return orbit.outside ? std::sqrt(norm(z)) * factor : z.re * z.re + z.im * z.im * factor;  // as POV-Ray has it
}

double power_fractal(const FractalNumbers& numbers, Complex z, Complex c) {
    const auto step = [&](Complex at) { return power(at, numbers.exponent) + c; };
    return value_of(numbers, follow(numbers.iterations, z, norm(z), step, [](Complex at) { return norm(at) > 4.0; }));
}

}  // namespace

double mandel(const FractalNumbers& numbers, const Vec3& p) { return power_fractal(numbers, {p.x, p.y}, {p.x, p.y}); }
double julia(const FractalNumbers& numbers, const Vec3& p) { return power_fractal(numbers, {p.x, p.y}, {numbers.c.x, numbers.c.y}); }

double magnet(const FractalNumbers& numbers, const Vec3& p) {
    const Complex z = numbers.julia ? Complex{p.x, p.y} : Complex{};
    const Complex c = numbers.julia ? Complex{numbers.c.x, numbers.c.y} : Complex{p.x, p.y};
    const Complex c1 = c + -1.0, c2 = c + -2.0, product = c1 * c2;
    const auto first = [&](Complex at) { return power((at * at + c1) / (2.0 * at + c2), 2); };
    const auto second = [&](Complex at) {
        const Complex squared = at * at;
        return power((squared * at + 3.0 * (c1 * at) + product) / (3.0 * squared + 3.0 * (c2 * at) + product + 1.0), 2);
    };
    const auto is_outside = [](Complex at) { return norm(at) > 1e4 || norm(at + -1.0) < 1e-4; };
    const double least = numbers.julia ? norm(z) : std::numeric_limits<double>::max();
    return value_of(numbers, numbers.magnet == 1 ? follow(numbers.iterations, z, least, first, is_outside)
                                                 : follow(numbers.iterations, z, least, second, is_outside));
}

}  // namespace rt
