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
#include "scene/cells.h"
#include "scene/set.h"

namespace rt {

/// POV-Ray's five channels. Opacity of the surface terms is 1 - filter - transmit.
struct PigmentColor {
    Rgb rgb{0.0};
    double filter = 0.0;
    double transmit = 0.0;
    bool operator==(const PigmentColor&) const = default;
};

struct Pigment;

/// `checker A, B`: cubes of size 1 in pattern space. Later patterns become further alternatives of `Pigment::content`.
struct CheckerPigment {
    Cells<Pigment> cells;
    bool operator==(const CheckerPigment&) const;
};

struct Pigment {
    std::variant<PigmentColor, CheckerPigment> content;
    std::optional<Transform> transform;  ///< pattern space to the space around it
    std::optional<PigmentColor> quick_color;
    bool operator==(const Pigment&) const = default;
};

/// `//! raytrace: key=value`; at file level or inside one finish.
struct SceneOption {
    std::string key;
    std::string value;
    Span span;
    int level = 0;  ///< above that of the choices which the block inherited from another one
    bool operator==(const SceneOption&) const = default;
};

struct Reflection {
    Rgb min{0.0};
    Rgb max{0.0};
    double falloff = 1.0;
    double exponent = 1.0;
    double metallic = 0.0;
    bool fresnel = false;
    bool operator==(const Reflection&) const = default;
};

/// Coefficients are as POV-Ray uses them; `albedo` forms are already multiplied out. Nothing is clamped.
struct Finish {
    Rgb ambient{0.1};
    Rgb emission{0.0};
    double diffuse = 0.6;
    double diffuse_back = 0.0;
    double brilliance = 1.0;
    double phong = 0.0;
    double phong_size = 40.0;
    double specular = 0.0;
    std::optional<double> roughness;  ///< POV-Ray's default is 0.05; whether it was stated matters to the general form
    double metallic = 0.0;
    Reflection reflection;
    bool conserve_energy = false;
    // The legacy keywords of POV-Ray 3.0 inside finish.
    std::optional<double> ior;
    std::optional<double> refraction;  ///< factor on all transmitted light
    std::optional<double> caustics;    ///< the exponent itself
    std::vector<SceneOption> options;  ///< our own choices, from comments inside the finish
    bool operator==(const Finish&) const = default;
};

struct Texture;

struct PlainTexture {
    Pigment pigment;
    Finish finish;
    bool operator==(const PlainTexture&) const = default;
};

/// `texture { checker texture{..} texture{..} }`. Each cell may be layered.
struct CheckerTexture {
    Cells<std::vector<Texture>> cells;
    std::optional<Transform> transform;
    bool operator==(const CheckerTexture&) const;
};

struct Texture {
    std::variant<PlainTexture, CheckerTexture> content;
    bool operator==(const Texture&) const = default;
};

/// First is the bottom layer, last the top one.
using TextureLayers = Shared<std::vector<Texture>>;

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
    std::optional<Shared<Interior>> interior;
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool double_illuminate = false;
    bool inverse = false;
    bool hollow = false;
    std::optional<std::uint32_t> shares_interior;  ///< with that object of the same list, which is before this one
    Span span;
    bool operator==(const Object&) const = default;

    Object() = default;
    Object(const Object&) = default;
    Object& operator=(const Object&) = default;
    // The vectors inside do not promise it, and a list that grows would copy.
    Object(Object&&) noexcept = default;
    Object& operator=(Object&&) noexcept = default;
};

/// Vectors as stated; `direction`, `right` and `up` are not yet combined with `angle` and `look_at` (that depends on the profile).
struct Camera {
    enum class Type { perspective, orthographic };
    Type type = Type::perspective;
    Vec3 location{0.0};
    Vec3 direction{0.0, 0.0, 1.0};
    Vec3 up{0.0, 1.0, 0.0};
    Vec3 right{1.33, 0.0, 0.0};
    Vec3 sky{0.0, 1.0, 0.0};
    std::optional<Vec3> look_at;
    std::optional<double> angle;  ///< degrees; 0 where an orthographic camera says `angle` without a number
    bool up_or_right_stated = false;
    Transform transform;  ///< applied after everything else
    Span span;
    bool operator==(const Camera&) const = default;
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

/// All of the light's transforms are already applied to location, point_at and the area axes.
struct Light {
    enum class Type { point, spotlight, cylinder };
    Type type = Type::point;
    bool parallel = false;
    bool shadowless = false;
    Vec3 location{0.0};
    Rgb color{0.0};
    Vec3 point_at{0.0, 0.0, 1.0};
    double radius = 0.0;   ///< half angle in degrees (spotlight) or length (cylinder)
    double falloff = 0.0;  ///< likewise
    double tightness = 0.0;
    double fade_distance = 0.0;
    double fade_power = 0.0;
    std::optional<AreaLight> area;
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
    std::vector<SetNode> sets;                    ///< those that take pieces of surfaces away, and what they are made of
    std::vector<Object> clips;                    ///< what clips: seen by no ray
    PigmentColor background{Rgb(0.0), 0.0, 1.0};  ///< none stated: black, and transparent in a picture with alpha
    GlobalSettings settings;
    double language_version = 0.0;  ///< last #version; 0 when none was seen and no include restored one
    std::vector<Unmodelled> unmodelled;
    std::vector<SceneOption> options;
    std::vector<std::vector<SceneOption>> finish_options;  ///< of each finish block that states some, in use or not
    Sources sources;
};

}  // namespace rt
