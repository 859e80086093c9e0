#include "scene/scene.h"

namespace rt {

// Out of line: in the header the cells' own comparison would not be known yet. Written out: of vectors of cells clang 14 crashes on a
// comparison that is defaulted here.
bool CheckerPigment::operator==(const CheckerPigment& other) const { return cells == other.cells; }
bool CheckerTexture::operator==(const CheckerTexture& other) const { return cells == other.cells && transform == other.transform; }

}  // namespace rt
