// Optional record of everything one camera ray met: data only, filled by the tracer when it is given one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/world.h"

namespace rt {

/// What a surface point was told about one sample of one light.
struct ShadowAnswer {
    std::uint32_t light = 0;             ///< index in the world
    std::uint32_t sample = 0;            ///< of an area light: row * columns + column; else 0
    Rgb transmitted{1.0};                ///< share of the light that arrives
    std::vector<std::uint32_t> crossed;  ///< transparent objects on the way, in order
};

/// One ray and what was found at its end. Contributions are radiance along this ray; they sum to `radiance`.
struct RayNode {
    enum class Kind : std::uint8_t { camera, reflected, refracted, straight, total };
    enum class End : std::uint8_t { surface, background, level, weight };
    static constexpr std::uint32_t none = 0xffffffffu;

    std::uint32_t parent = none;  ///< always a smaller index
    Kind kind = Kind::camera;
    End end = End::surface;
    Ray ray;
    int level = 1;
    double weight = 1.0;
    Rgb factor{1.0};        ///< on this ray's radiance in its parent's
    double exponent = 1.0;  ///< a reflected ray's radiance is raised to 1 / exponent first

    // The surface, if `end` says so.
    std::uint32_t object = none;
    std::uint32_t part = 0;
    double t = infinity;
    Vec3 point{0.0}, normal{0.0};
    bool inside = false;
    std::vector<PigmentColor> layers;  ///< colours that the patterns chose, top layer first
    std::vector<ShadowAnswer> shadows;

    Rgb ambient{0.0}, diffuse{0.0}, specular{0.0}, reflection{0.0}, refraction{0.0}, background{0.0};
    Rgb veil_light{0.0}, veil_left{1.0};  ///< of fog and rainbows before it: radiance = veil_light + veil_left * the sum of all above
    Rgb radiance{0.0};

    /// The light of one of the textures that are mixed at the surface, by its share; 1 where there is one.
    void add(double share, const Rgb& own_ambient, const Rgb& own_diffuse, const Rgb& own_specular) {
        ambient += share * own_ambient;
        diffuse += share * own_diffuse;
        specular += share * own_specular;
    }

    /// How the point's own light, its mirror and what lies behind it share `radiance`: said by the course's rules alone.
    struct Shares {
        double local = 1.0, reflection = 0.0, transmission = 0.0;
    };
    std::optional<Shares> shares;
};

struct RayLog {
    std::vector<RayNode> nodes;  ///< the camera ray first
};

/// Fills `reflection`, `refraction` and `radiance` of every node from its children.
void total(RayLog& log);

/// Equal for two rays that met the same parts of the same objects in the same order with the same answers of every light and the same
/// pattern cells: between such rays the picture is smooth.
std::uint64_t signature(const RayLog& log);

}  // namespace rt
