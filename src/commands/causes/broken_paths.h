// Camera rays followed by the course's rules with one of them broken that decides where rays go: for pictures that are wrong in the same
// way.
#pragma once

#include "commands/causes/reshading.h"

namespace rt {

struct PathRules {
    Reshading::Normal normal = Reshading::Normal::right;
    double offset = CourseRules::offset;     ///< of further rays and shadow rays; below 0 they begin behind the surface
    bool raw_normals = false;                ///< as long as shapes and transforms make them
    bool side_ignored = false;               ///< the normal is not turned to the viewer inside of a body
    bool mirror_reversed = false;            ///< mirrored rays go the opposite way
    bool shadows_from_behind = false;        ///< what lies beyond a lamp hides it
    bool distances_in_object_space = false;  ///< a ray's t is counted in the space of the object, whatever its scale
};

/// Follows one camera ray. The log holds what reshaded() needs; its sums are not filled.
RayLog follow_broken(const ShadedScene& shaded, const PathRules& rules, const Ray& camera_ray);

/// The normal of an object as a mistake has it.
Vec3 changed_normal(const Object& object, const Vec3& normal, bool inside, Reshading::Normal how);

}  // namespace rt
