// POV-Ray's texts for the keywords that moved from finish to interior.
#pragma once

#include <string_view>

namespace rt {

inline constexpr std::string_view refraction_unnecessary =
    "Refraction value unnecessary to turn on refraction. To attenuate, the fade_power and fade_distance keywords should be specified in "
    "'interior{...}' statement. Use of this syntax may not be backwards compatible with earlier versions of POV-Ray. The #version "
    "directive or +MV switch will not help.";
inline constexpr std::string_view ior_moved =
    "Index of refraction value should be specified in 'interior{...}' statement. Use of this syntax may not be backwards compatible with "
    "earlier versions of POV-Ray. The #version directive or +MV switch will not help.";
inline constexpr std::string_view caustics_moved =
    "Caustics value should be specified in 'interior{...}' statement. Use of this syntax may not be backwards compatible with earlier "
    "versions of POV-Ray. The #version directive or +MV switch will not help.";

}  // namespace rt
