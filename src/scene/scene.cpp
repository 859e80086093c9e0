#include "scene/scene.h"

namespace rt {

// Out of line: in the header the cells' own comparison would not be known yet.
bool CheckerPigment::operator==(const CheckerPigment& other) const = default;
bool CheckerTexture::operator==(const CheckerTexture& other) const = default;

}  // namespace rt
