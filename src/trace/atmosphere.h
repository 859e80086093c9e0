// What a ray meets where it meets nothing: the sky, fog and rainbows.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "world/world.h"

namespace rt {

/// Light that joins what comes along a ray, and what is left of that.
struct Veil {
    Rgb light{0.0};
    Rgb left{1.0};
    double transmittance = 1.0;  ///< of `left`, for alpha
};

class Atmosphere {
public:
    explicit Atmosphere(const World& world);

    /// On the way along a ray from its origin to `length`, infinite where it meets nothing. `inside`: the interiors that it is in.
    Veil along(const Ray& ray, double length, std::span<const std::uint32_t> inside) const;

    /// What fog leaves of light that comes from a lamp `length` away against the ray.
    Rgb dimmed(const Ray& ray, double length, std::span<const std::uint32_t> inside) const;

    /// Light from a direction that nothing lies in, the background's behind the sky's; `transmittance` receives what is seen of it.
    Rgb sky(const Vec3& direction, double& transmittance) const;

private:
    struct Bow {
        const Rainbow* stated;
        Vec3 axis, up, right;
    };
    bool is_open(std::span<const std::uint32_t> inside) const;
    Veil fog(const Ray& ray, double length) const;
    void arch(const Ray& ray, double length, Veil& veil) const;

    const World& world_;
    std::vector<Bow> bows_;
};

}  // namespace rt
