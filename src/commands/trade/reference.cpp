#include "commands/trade/reference.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace rt {

namespace {

bool is_prime(int n) {
    for (int divisor = 2; divisor * divisor <= n; ++divisor)
        if (n % divisor == 0) return false;
    return n > 1;
}

}  // namespace

int next_grid(const std::vector<int>& grids) {
    if (grids.empty()) return 5;
    double samples = 0.0;
    for (const int side : grids) samples += sqr(static_cast<double>(side));
    const int wanted = std::max(grids.back() + 1, static_cast<int>(std::lround(std::sqrt(samples))));
    for (int away = 0;; ++away)
        for (const int side : {wanted - away, wanted + away})
            if (side > grids.back() && is_prime(side)) return side;
}

Film joined(const Film& a, double samples_a, const Film& b, double samples_b) {
    Film film(a.width, a.height);
    const double all = samples_a + samples_b;
    const auto mean = [&](float x, float y) {
        return static_cast<float>((samples_a * static_cast<double>(x) + samples_b * static_cast<double>(y)) / all);
    };
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const Pixel &p = a.pixels[i], &q = b.pixels[i];
        film.pixels[i] = {mean(p.r, q.r), mean(p.g, q.g), mean(p.b, q.b), mean(p.transmittance, q.transmittance)};
    }
    return film;
}

double joined_error(double apart, double samples_a, double samples_b) {
    return apart * std::sqrt(samples_a * samples_b) / (samples_a + samples_b);
}

}  // namespace rt
