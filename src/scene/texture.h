// texture { }: layers of pigment, normal and finish, and patterns of textures.
#pragma once

#include <cstdint>
#include <string>

#include "core/source.h"
#include "scene/normal.h"
#include "scene/pigment.h"

namespace rt {

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

/// `irid { }`: a thin film.
struct Irid {
    double amount = 0.0;
    double thickness = 0.0;
    double turbulence = 0.0;
    bool operator==(const Irid&) const = default;
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
    double crand = 0.0;  ///< grain: diffuse light loses up to this much by chance
    std::optional<Irid> irid;
    // The legacy keywords of POV-Ray 3.0 inside finish.
    std::optional<double> ior;
    std::optional<double> refraction;  ///< factor on all transmitted light
    std::optional<double> caustics;    ///< the exponent itself
    std::vector<SceneOption> options;  ///< our own choices, from comments inside the finish
    bool operator==(const Finish&) const = default;
};

struct PlainTexture {
    Pigment pigment;
    Finish finish;
    std::optional<Shared<Normal>> normal = std::nullopt;
    bool uv_mapping = false;  ///< all its patterns are seen at (u, v, 0)
    bool operator==(const PlainTexture&) const = default;
};

struct PatternTexture;

struct Texture {
    std::variant<PlainTexture, Shared<PatternTexture>> content;
    bool operator==(const Texture&) const;
};

/// First is the bottom layer, last the top one.
using TextureLayers = Shared<std::vector<Texture>>;

/// Entries as those of a `ColorMap`; each may be layered.
struct TextureMap {
    std::vector<double> values;
    std::vector<TextureLayers> textures;
    bool operator==(const TextureMap&) const;
};

/// Between two entries both are shaded and the light is mixed.
struct PatternTexture {
    StatedPattern pattern;
    Shared<TextureMap> map;
    bool operator==(const PatternTexture&) const;
};

}  // namespace rt
