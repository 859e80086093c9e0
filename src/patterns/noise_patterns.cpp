#include "patterns/noise_patterns.h"

#include <algorithm>
#include <limits>

#include "patterns/hash.h"

namespace rt {

namespace {

double stretched_noise(NoiseGenerator generator, const Vec3& p) {
    const double n = noise(generator, p);
    return generator == NoiseGenerator::original ? n : clamp01(2.0 * n - 0.5);
}

const std::vector<WaveSource>& sources_of(const Pattern& pattern) { return *std::get<WavesNumbers>(pattern.numbers).sources; }

}  // namespace

double cycle(double v) { return std::sin(2.0 * pi * (v - std::trunc(v))); }

double dents(NoiseGenerator generator, const Vec3& p) {
    const double n = noise(generator, p);
    return n * n * n;
}

double wrinkles(NoiseGenerator generator, const Vec3& p) {
    double sum = 0.0, scale = 1.0;
    for (int i = 0; i < 10; ++i, scale *= 2.0) sum += stretched_noise(generator, scale * p) / scale;
    return sum / 2.0;
}

double granite(NoiseGenerator generator, const Vec3& p) {
    double sum = 0.0, scale = 1.0;
    for (int i = 0; i < 6; ++i, scale *= 2.0) {
        const double n = noise(generator, 4.0 * scale * p);
        const double q = generator == NoiseGenerator::original ? std::fabs(0.5 - n) : std::fmin(0.5, std::fabs(1.0 - 2.0 * n));
        sum += q / scale;
    }
    return sum;
}

double agate(const Pattern& pattern, const Vec3& p) {
    const double amount = std::get<AgateNumbers>(pattern.numbers).turbulence;
    const double t = scalar_turbulence(pattern.noise, pattern.turbulence.value_or(Turbulence{}), p);
    const double v = 0.5 * (1.0 + cycle(1.3 * amount * t + 1.1 * p.z));
    return std::pow(clamp01(v), 0.77);
}

double marble(const Pattern& pattern, const Vec3& p) {
    if (!pattern.turbulence) return p.x;
    return p.x + pattern.turbulence->amount.x * scalar_turbulence(pattern.noise, *pattern.turbulence, p);
}

double wood(const Pattern& pattern, const Vec3& p) {
    double x = p.x, y = p.y;
    if (pattern.turbulence) {
        const Vec3 displaced = p + vector_turbulence(*pattern.turbulence, p);
        x += cycle(displaced.x * pattern.turbulence->amount.x);
        y += cycle(displaced.y * pattern.turbulence->amount.y);
    }
    return std::sqrt(x * x + y * y);
}

double cells(const Vec3& p) {
    const Vec3 q = p + 1e-10;
    return cell_numbers()[static_cast<std::size_t>(hash3(cell_of(q.x), cell_of(q.y), cell_of(q.z)))];
}

std::vector<WaveSource> wave_sources(int count) {
    std::vector<WaveSource> sources;
    TableRandom draw{static_cast<std::uint32_t>(-560851967)};
    for (int i = 0; i < count; ++i) {
        const Vec3 center = unit(vector_noise(Vec3(i, 0.0, 0.0)));
        sources.push_back({center, 0.000030518509476 * draw() + 0.01});
    }
    return sources;
}

double ripples(const Pattern& pattern, const Vec3& p) {
    const auto& sources = sources_of(pattern);
    double sum = 0.0;
    for (const WaveSource& source : sources) sum += cycle(length(p - source.center) * pattern.frequency + pattern.phase);
    return 0.5 * (1.0 + sum / static_cast<double>(sources.size()));
}

double waves(const Pattern& pattern, const Vec3& p) {
    const auto& sources = sources_of(pattern);
    double sum = 0.0;
    for (const WaveSource& source : sources)
        sum += cycle(length(p - source.center) * pattern.frequency * source.frequency + pattern.phase) / source.frequency;
    return 0.2 * (2.5 + sum / static_cast<double>(sources.size()));
}

NearestFeatures nearest_features(const Vec3& p, double metric) {
    const auto power = [metric](double d) { return metric == 2.0 ? d * d : metric == 1.0 ? std::fabs(d) : std::pow(std::fabs(d), metric); };
    const auto& u = cell_numbers();
    const Vec3 corner(std::floor(p.x - 1e-10), std::floor(p.y - 1e-10), std::floor(p.z - 1e-10));
    const std::int64_t cell[3] = {cell_of(corner.x), cell_of(corner.y), cell_of(corner.z)};
    // Per axis and offset -2..2, the least that a point of such a cell adds to the sum: cells that cannot matter are passed over.
    double least[3][5];
    for (int axis = 0; axis < 3; ++axis)
        for (int o = -2; o <= 2; ++o) {
            const double from = corner[axis] + o - p[axis];
            const double gap = std::fmax(0.0, std::fmax(from, -from - 1.0)) - 1e-9;
            least[axis][o + 2] = gap > 0.0 && metric > 0.0 ? power(gap) : 0.0;
        }
    constexpr double far = std::numeric_limits<double>::infinity();
    NearestFeatures found{{far, far, far}, p};
    static constexpr int order[5] = {0, -1, 1, -2, 2};
    for (const int a : order)
        for (const int b : order)
            for (const int c : order) {
                if ((std::abs(a) == 2) + (std::abs(b) == 2) + (std::abs(c) == 2) > 1) continue;
                if (least[0][a + 2] + least[1][b + 2] + least[2][c + 2] > found.distance[2]) continue;
                const auto q = static_cast<std::size_t>(hash3(cell[0] + a, cell[1] + b, cell[2] + c));
                const Vec3 feature = corner + Vec3(a, b, c) + Vec3(u[q], u[q + 1], u[q + 2]);
                const Vec3 d = p - feature;
                const double sum = power(d.x) + power(d.y) + power(d.z);
                if (sum < found.distance[0]) {
                    found.distance[2] = found.distance[1];
                    found.distance[1] = found.distance[0];
                    found.distance[0] = sum;
                    found.nearest = feature;
                } else if (sum < found.distance[1]) {
                    found.distance[2] = found.distance[1];
                    found.distance[1] = sum;
                } else if (sum < found.distance[2]) {
                    found.distance[2] = sum;
                }
            }
    return found;
}

double crackle(const CrackleNumbers& numbers, NoiseGenerator generator, const Vec3& p) {
    const NearestFeatures found = nearest_features(p, numbers.metric);
    if (numbers.solid) return noise(generator, found.nearest);
    double sum = 0.0;
    const double offset = numbers.offset == 0.0 ? 0.0 : std::pow(numbers.offset, numbers.metric);
    for (int i = 0; i < 3; ++i) {
        const double d = found.distance[i] + offset;
        sum += numbers.form[i] * (numbers.metric == 2.0 ? std::sqrt(d) : std::pow(d, 1.0 / numbers.metric));
    }
    return clamp01(sum);
}

}  // namespace rt
