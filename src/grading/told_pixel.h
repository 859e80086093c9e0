// A pixel's rays as some program told them: what two programs' records can be compared by. What a record leaves out is empty.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/ray.h"

namespace rt {

/// Light that reaches a ray's origin, by kind; `radiance` is all of it.
enum class LightPart { ambient, diffuse, specular, reflection, refraction, background, radiance };
inline constexpr std::size_t light_parts = 7;

struct ToldShadow {
    std::uint32_t light = 0, sample = 0;
    Rgb transmitted{1.0};  ///< share that arrives
    bool through = false;  ///< known to have passed transparent objects
    bool exact = true;     ///< false: told is only whether any arrives
};

struct ToldLayer {
    Rgb rgb{0.0};
    double filter = 0.0, transmit = 0.0;
};

struct ToldHit {
    std::uint32_t object = 0;  ///< counted from 1
    std::string type;
    double t = 0.0;
    Vec3 point{0.0};
    std::optional<Vec3> normal;
    std::optional<Ray> object_ray;  ///< in the object's own space, if it has a transform
    std::optional<bool> inside;
    std::vector<ToldLayer> layers;                   ///< top one first
    std::optional<std::vector<ToldShadow>> shadows;  ///< empty: not told of
};

struct ToldRay {
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    enum class Kind { camera, reflection, refraction };
    enum class End { surface, background, level, weight };
    struct Shares {
        double local = 1.0, reflection = 0.0, transmission = 0.0;
    };

    std::size_t parent = none;  ///< always a smaller index
    Kind kind = Kind::camera;
    bool total = false;  ///< a reflection that is known to be total
    End end = End::background;
    Ray ray;
    std::optional<ToldHit> hit;  ///< if `end` is a surface
    std::optional<Rgb> factor;   ///< on this ray's radiance in its parent's
    std::array<std::optional<Rgb>, light_parts> light;
    std::optional<Shares> shares;

    const std::optional<Rgb>& part(LightPart which) const { return light[static_cast<std::size_t>(which)]; }
    std::optional<Rgb>& part(LightPart which) { return light[static_cast<std::size_t>(which)]; }
};

/// A pixel's ray goes along direction + u right + v up, u and v in -1/2..1/2.
struct ToldCamera {
    Vec3 direction{0.0}, right{0.0}, up{0.0};
    int width = 0, height = 0;
};

struct ToldPixel {
    int x = 0, y = 0;
    bool from_top = false;  ///< how y is counted
    std::array<int, 3> color{};
    std::optional<ToldCamera> camera;           ///< of a perspective view
    std::vector<std::vector<ToldRay>> samples;  ///< each with its camera ray first
    bool rounded = false;                       ///< a number told as 0 may be a small one
};

}  // namespace rt
