// The camera as a scene states it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/name_table.h"
#include "core/transform.h"

namespace rt {

/// How the points of a picture become rays: `trace/camera.h`.
enum class Projection : std::uint8_t {
    perspective,
    orthographic,
    fisheye,
    ultra_wide_angle,
    panoramic,
    spherical,
    cylinder_1,  ///< upright, seen from one point
    cylinder_2,  ///< lying
    cylinder_3,  ///< upright, seen from a line along its axis
    cylinder_4,
};
inline constexpr NameTable<Projection, 10> projection_names{{{"perspective", Projection::perspective},
                                                             {"orthographic", Projection::orthographic},
                                                             {"fisheye", Projection::fisheye},
                                                             {"ultra_wide_angle", Projection::ultra_wide_angle},
                                                             {"panoramic", Projection::panoramic},
                                                             {"spherical", Projection::spherical},
                                                             {"cylinder 1", Projection::cylinder_1},
                                                             {"cylinder 2", Projection::cylinder_2},
                                                             {"cylinder 3", Projection::cylinder_3},
                                                             {"cylinder 4", Projection::cylinder_4}}};

struct Camera {
    Projection projection = Projection::perspective;
    Vec3 location{0.0};
    Vec3 direction{0.0, 0.0, 1.0};
    Vec3 up{0.0, 1.0, 0.0};
    Vec3 right{1.33, 0.0, 0.0};
    Vec3 sky{0.0, 1.0, 0.0};
    std::optional<Vec3> look_at;
    std::optional<double> angle;           ///< degrees; 0 where an orthographic camera says `angle` without a number
    std::optional<double> vertical_angle;  ///< degrees, of a spherical camera
    bool up_or_right_stated = false;
    Transform transform;  ///< applied after everything else
    Span span;
    bool operator==(const Camera&) const = default;
};

}  // namespace rt
