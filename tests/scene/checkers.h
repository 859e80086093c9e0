// Checkers as scenes hold them, for tests that put scenes together.
#pragma once

#include "scene/scene.h"

namespace rt {

inline Pigment checker_of(const Pigment& a, const Pigment& b, const std::optional<Transform>& transform = std::nullopt) {
    PatternPigment pattern;
    pattern.pattern.pattern = make_pattern(PatternKind::checker);
    if (transform) append(pattern.pattern.pattern, *transform);
    pattern.map = Shared<PigmentMap>(PigmentMap{{0.0, 1.0}, {a, b}});
    Pigment pigment;
    pigment.content = Shared<PatternPigment>(pattern);
    return pigment;
}

inline Texture checker_of(const std::vector<Texture>& a, const std::vector<Texture>& b,
                          const std::optional<Transform>& transform = std::nullopt) {
    PatternTexture pattern;
    pattern.pattern.pattern = make_pattern(PatternKind::checker);
    if (transform) append(pattern.pattern.pattern, *transform);
    pattern.map = TextureMap{{0.0, 1.0}, {TextureLayers(a), TextureLayers(b)}};
    Texture texture;
    texture.content = Shared<PatternTexture>(pattern);
    return texture;
}

inline const PatternPigment& pattern_of(const Pigment& pigment) { return *std::get<Shared<PatternPigment>>(pigment.content); }
inline const PatternTexture& pattern_of(const Texture& texture) { return *std::get<Shared<PatternTexture>>(texture.content); }

/// The transform of a pattern that has one, at a point.
inline Vec3 moved(const Pattern& pattern, const Vec3& p) {
    return pattern.warps.empty() ? p : std::get<Transform>(pattern.warps.at(0)).point(p);
}
inline Vec3 moved(const Pigment& pigment, const Vec3& p) {
    if (std::holds_alternative<PigmentColor>(pigment.content)) return pigment.transform ? pigment.transform->point(p) : p;
    return moved(pattern_of(pigment).pattern.pattern, p);
}

}  // namespace rt
