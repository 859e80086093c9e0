// What the course's command line can choose about shading: the conventions of Cal Poly's CSC 473, apart from POV-Ray's.
#pragma once

#include <vector>

namespace rt {

/// What a pixel shows of the surface that its ray meets.
enum class CourseShow {
    shaded,   ///< local light, mirrors, transmission
    pigment,  ///< the pigment alone (`raycast`)
    normals,  ///< (n + 1) / 2
};

struct CourseRules {
    CourseShow show = CourseShow::shaded;
    bool cook_torrance = false;  ///< instead of Blinn-Phong's highlight
    bool fresnel = false;        ///< transparent objects mirror by Schlick's law
    bool beers = false;          ///< transmitted light fades with the length of its way, instead of by the pigment at once
    int further_rays = 6;        ///< depth: rays after the camera's
    /// Indirect light instead of ambient: directions tried at the camera ray's hit, at theirs, ...; empty: ambient light.
    std::vector<int> indirect_samples;

    static constexpr double offset = 0.001;  ///< how far beside the hit point further rays begin
    static constexpr double beer_density = 0.15;
};

}  // namespace rt
