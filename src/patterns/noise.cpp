#include "patterns/noise.h"

#include <algorithm>
#include <array>
#include <utility>

#include "patterns/hash.h"
#include "patterns/noise_table.h"
#include "patterns/warp.h"

namespace rt {

namespace {

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

/// A coordinate's cell on the lattice, 0..4095, and the place in it.
struct LatticeAxis {
    unsigned index;
    double f;
    explicit LatticeAxis(double x) {
        if (!(std::fabs(x) < 4503599627370496.0)) x = 0.0;  // no fraction any more, or no number
        const double n = std::trunc(x >= 0.0 ? x : x - (1.0 - 1e-10));
        index = static_cast<unsigned>(static_cast<std::int64_t>(n) + 10000) & 4095U;
        f = x - n;
    }
};

/// Calls add(k, weight, place) for the eight corners of the cell that holds `p`: k 0..255, `place` as seen from the corner.
template <typename Add>
void for_corners(const Vec3& p, Add add) {
    const LatticeAxis x(p.x), y(p.y), z(p.z);
    const double sx = smooth(x.f), sy = smooth(y.f), sz = smooth(z.f);
    for (unsigned a = 0; a < 2; ++a) {
        const unsigned ha = permutation[x.index + a];
        const double wa = a == 1 ? sx : 1.0 - sx;
        for (unsigned b = 0; b < 2; ++b) {
            const unsigned hb = permutation[ha ^ (y.index + b)];
            const double wb = wa * (b == 1 ? sy : 1.0 - sy);
            for (unsigned c = 0; c < 2; ++c) {
                const unsigned k = permutation[hb ^ (z.index + c)] & 255U;
                add(k, wb * (c == 1 ? sz : 1.0 - sz), Vec3(x.f - a, y.f - b, z.f - c));
            }
        }
    }
}

/// What corner entry m says at `d` from the corner: half its value plus gradient . d.
double corner_value(unsigned m, const Vec3& d) {
    const double* r = &noise_table[m];
    return 0.5 * r[0] + r[1] * d.x + r[2] * d.y + r[3] * d.z;
}

double lattice_noise(const Vec3& p) {
    double sum = 0.0;
    for_corners(p, [&](unsigned k, double w, const Vec3& d) { sum += w * corner_value(k, d); });
    return sum;
}

/// Ken Perlin's noise with unit gradients.
struct PerlinTables {
    std::array<Vec3, 4098> gradient;
    std::array<std::uint16_t, 4098> index{};

    PerlinTables() {
        TableRandom draw{1};
        const auto component = [&] { return (draw() % 4096 - 2048) / 2048.0; };
        for (std::size_t i = 0; i < 2048; ++i) {
            Vec3 v;
            do {
                v.x = component();
                v.y = component();
                v.z = component();
            } while (dot(v, v) > 1.0 || dot(v, v) < 1e-5);
            gradient[i] = unit(v);
            index[i] = static_cast<std::uint16_t>(i);
        }
        for (std::size_t i = 2048; i >= 2; i -= 2) std::swap(index[i], index[static_cast<std::size_t>(draw()) % 2048]);
        for (std::size_t i = 0; i < 2050; ++i) {
            index[2048 + i] = index[i];
            gradient[2048 + i] = gradient[i];
        }
    }
};

double perlin_noise(const Vec3& p) {
    static const PerlinTables tables;
    unsigned cell[3], next[3];
    double r[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double t = (std::fabs(p[axis]) < 2251799813685248.0 ? p[axis] : 0.0) + 10000000.023157213;
        const double whole = std::floor(t);
        cell[axis] = static_cast<unsigned>(static_cast<std::int64_t>(whole)) & 2047U;
        next[axis] = (cell[axis] + 1) & 2047U;
        r[axis] = t - whole;
    }
    const auto value = [&](int a, int b, int c) {
        const unsigned x = tables.index[a ? next[0] : cell[0]];
        const unsigned y = tables.index[x + (b ? next[1] : cell[1])];
        return dot(tables.gradient[y + (c ? next[2] : cell[2])], Vec3(r[0] - a, r[1] - b, r[2] - c));
    };
    const double sx = smooth(r[0]), sy = smooth(r[1]), sz = smooth(r[2]);
    const auto along_x = [&](int b, int c) { return glm::mix(value(0, b, c), value(1, b, c), sx); };
    const auto along_y = [&](int c) { return glm::mix(along_x(0, c), along_x(1, c), sy); };
    return glm::mix(along_y(0), along_y(1), sz);
}

}  // namespace

double noise(NoiseGenerator generator, const Vec3& p) {
    switch (generator) {
        case NoiseGenerator::original:
            return clamp01(lattice_noise(p) + 0.5);
        case NoiseGenerator::range_corrected:
            return clamp01((lattice_noise(p) + 1.05242) * 0.48985582);
        case NoiseGenerator::perlin:
            break;
    }
    return clamp01(0.5 * (1.59 * perlin_noise(p) + 0.985));
}

Vec3 vector_noise(const Vec3& p) {
    Vec3 sum(0.0);
    for_corners(p, [&](unsigned k, double w, const Vec3& d) {
        sum += w * Vec3(corner_value(k, d), corner_value(k + 4, d), corner_value(k + 8, d));
    });
    return sum;
}

Vec3 vector_turbulence(const Turbulence& turbulence, const Vec3& p) {
    Vec3 sum = vector_noise(p);
    double weight = 1.0, scale = 1.0;
    for (int octave = 2; octave <= turbulence.octaves; ++octave) {
        weight *= turbulence.omega;
        scale *= turbulence.lambda;
        sum += weight * vector_noise(scale * p);
    }
    return sum;
}

double scalar_turbulence(NoiseGenerator generator, const Turbulence& turbulence, const Vec3& p) {
    const bool stretched = generator != NoiseGenerator::original;
    const auto octave_value = [&](const Vec3& q) { return stretched ? 2.0 * noise(generator, q) - 0.5 : noise(generator, q); };
    double sum = clamp01(octave_value(p));
    double weight = 1.0, scale = 1.0;
    for (int octave = 2; octave <= turbulence.octaves; ++octave) {
        weight *= turbulence.omega;
        scale *= turbulence.lambda;
        sum += weight * octave_value(scale * p);
    }
    return sum;
}

}  // namespace rt
