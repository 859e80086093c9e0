// What a scene file says, as plain values with POV-Ray's defaults. No pointers, no Embree, nothing computed for a renderer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/shared.h"
#include "core/source.h"
#include "core/transform.h"
#include "geometry/shape.h"
#include "scene/atmosphere.h"
#include "scene/camera.h"
#include "scene/set.h"
#include "scene/texture.h"

namespace rt {

struct Interior {
    std::optional<double> ior;  ///< unstated: 1
    double caustics = 0.0;      ///< exponent: 45 times the number in the file
    double fade_distance = 0.0;
    double fade_power = 0.0;
    Rgb fade_color{0.0};
    bool operator==(const Interior&) const = default;
};

struct Object {
    Shape shape;
    std::optional<Transform> transform;
    std::optional<TextureLayers> texture;  ///< always set by the parser (the default texture at the object's end)
    std::optional<TextureLayers> interior_texture;
    /// Of parts of the shape, which names them by their numbers here (geometry/texture_weight.h); unset: none is stated.
    std::optional<Shared<std::vector<TextureLayers>>> shape_textures;
    std::optional<Shared<Interior>> interior;
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool double_illuminate = false;
    bool inverse = false;
    bool hollow = false;
    bool uv_mapping = false;        ///< all patterns of its textures are seen at (u, v, 0)
    std::uint32_t medium = 0;       ///< objects of one number above 0, parts of one set, have one interior in common
    std::uint32_t light_group = 0;  ///< the innermost that it is in, whose lights shine on it; 0: none
    bool own_lights_only = false;   ///< the lights of the whole scene do not shine on it
    bool shows_light = false;       ///< of a looks_like: no group keeps the lights of the whole scene from it
    Span span;
    bool operator==(const Object&) const = default;

    Object() = default;
    Object(const Object&) = default;
    Object& operator=(const Object&) = default;
    // The vectors inside do not promise it, and a list that grows would copy.
    Object(Object&&) noexcept = default;
    Object& operator=(Object&&) noexcept = default;
};

/// A grid of n1 x n2 shadow samples spanned by two axes around the light's location.
struct AreaLight {
    Vec3 axis1{0.0}, axis2{0.0};
    int size1 = 1, size2 = 1;
    std::optional<int> adaptive;  ///< unstated: always subdivide
    bool circular = false;
    bool orient = false;
    bool area_illumination = false;
    bool operator==(const AreaLight&) const = default;
};

/// All of the light's transforms are already applied to location, point_at, the area axes and the mask.
struct Light {
    enum class Type { point, spotlight, cylinder };
    Type type = Type::point;
    bool parallel = false;
    bool shadowless = false;
    bool media_attenuation = false;  ///< fog dims it
    Vec3 location{0.0};
    Rgb color{0.0};
    Vec3 point_at{0.0, 0.0, 1.0};
    double radius = 0.0;   ///< half angle in degrees (spotlight) or length (cylinder)
    double falloff = 0.0;  ///< likewise
    double tightness = 0.0;
    double fade_distance = 0.0;
    double fade_power = 0.0;
    std::optional<AreaLight> area;
    std::uint32_t group = 0;  ///< the light group on which alone it shines; 0: the whole scene
    /// It shines only where the way to it leads through this, and what is beyond casts no shadows.
    std::optional<Shared<Mask>> mask;
    Span span;
    bool operator==(const Light&) const = default;
};

/// The gamma model of the parse's end; how it meets the file is `film/encode.h`.
struct Gamma {
    enum class Kind {
        legacy,  ///< no assumed_gamma and no version of 3.7 or later: values go to the file as they are
        power,   ///< working space is linear^(1/power); power 1 is linear
        srgb,    ///< working space is the sRGB curve
    };
    Kind kind = Kind::legacy;
    double power = 1.0;
    bool operator==(const Gamma&) const = default;
};

struct GlobalSettings {
    Gamma gamma;
    Rgb ambient_light{1.0};
    static constexpr int highest_trace_level = 256;
    int max_trace_level = 5;  ///< 1..highest_trace_level
    double adc_bailout = 1.0 / 255.0;
    std::optional<NoiseGenerator> noise_generator;  ///< unstated: as the language version has it
    int number_of_waves = 10;                       ///< of ripples and waves; at least 1
    Rgb irid_wavelength{0.70, 0.52, 0.48};
    bool operator==(const GlobalSettings&) const = default;
};

/// Something the file asks for that the program does not model, met at `span`.
struct Unmodelled {
    std::string feature;
    Span span;
    bool operator==(const Unmodelled&) const = default;
};

struct Scene {
    Camera camera;
    std::vector<Light> lights;
    std::vector<Object> objects;                  ///< in file order; ties between equally near surfaces go to the first
    std::vector<ObjectSet> sets;                  ///< no object is in two of them
    std::uint32_t light_groups = 0;               ///< how many there are: 1 is the first
    PigmentColor background{Rgb(0.0), 0.0, 1.0};  ///< none stated: black, and transparent in a picture with alpha
    std::optional<SkySphere> sky_sphere;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    GlobalSettings settings;
    double language_version = 0.0;  ///< last #version; 0 when none was seen and no include restored one
    std::vector<Unmodelled> unmodelled;
    std::vector<SceneOption> options;
    std::vector<std::vector<SceneOption>> finish_options;  ///< of each finish block that states some, in use or not
    Sources sources;
};

}  // namespace rt
