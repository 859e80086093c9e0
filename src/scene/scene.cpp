#include "scene/object_probe.h"

namespace rt {

// Out of line: where these are declared, what they compare is not known yet.
bool StatedPattern::operator==(const StatedPattern&) const = default;
bool Pigment::operator==(const Pigment&) const = default;
bool PigmentMap::operator==(const PigmentMap&) const = default;
bool Normal::operator==(const Normal&) const = default;
bool NormalMap::operator==(const NormalMap&) const = default;
bool Texture::operator==(const Texture&) const = default;
bool TextureMap::operator==(const TextureMap&) const = default;
bool PatternTexture::operator==(const PatternTexture&) const = default;

}  // namespace rt
