#include "trace/options.h"

namespace rt {

Quality Quality::povray(int n) {
    Quality quality;
    quality.lighting = n >= 2;
    quality.shadows = n >= 4;
    quality.transmission = n >= 6;
    quality.reflection = n >= 8;
    quality.normals = n >= 8;
    quality.quick_colors = n <= 5;
    return quality;
}

}  // namespace rt
