// Random scenes of every shape, and rays that look for trouble in them: at edges, at silhouettes, from far away.
#pragma once

#include <random>

#include "world/compile.h"

namespace rt {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double real(double low, double high) { return low + (high - low) * std::uniform_real_distribution<double>()(engine_); }
    /// Between low and high, evenly in its logarithm.
    double log(double low, double high) { return low * std::pow(high / low, real(0.0, 1.0)); }
    int whole(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
    bool chance(double p) { return real(0.0, 1.0) < p; }
    Vec3 in_cube(double half) { return {real(-half, half), real(-half, half), real(-half, half)}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = in_cube(1.0);
            if (const double l = length(v); l > 0.01 && l < 1.0) return unit(v);
        }
    }

private:
    std::mt19937_64 engine_;
};

/// Objects spread over a cube of half side `extent`.
Scene random_scene(Random& random, int objects, double extent);

/// Some ray: random, aimed at an edge, a vertex or a silhouette, along an axis, from inside or from very far.
Ray random_ray(Random& random, const Scene& scene, double extent);

/// A closed mesh of about `facets` triangles around the origin, from even ones to needles with sides in the ratio 1 to 10^4.
MeshData closed_mesh(int facets);

inline const MessageSink no_messages = [](std::string_view) {};

}  // namespace rt
