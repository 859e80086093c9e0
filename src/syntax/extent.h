// The boxes that min_extent and max_extent tell of. They are POV-Ray's own, measured: in single precision, often looser than the object
// is, and looser still after turns.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/shape.h"
#include "scene/set.h"

namespace rt {

/// A box as POV-Ray keeps it: its lower corner and its sides.
struct Extent {
    static constexpr float far = 1e10F;  ///< where a box that has no end ends
    std::array<float, 3> lower{-far, -far, -far};
    std::array<float, 3> size{2 * far, 2 * far, 2 * far};

    Vec3 min() const { return {lower[0], lower[1], lower[2]}; }
    Vec3 max() const { return {lower[0] + size[0], lower[1] + size[1], lower[2] + size[2]}; }
    Bounds bounds() const { return {min(), max()}; }
    bool is_finite() const { return size[0] < far && size[1] < far && size[2] < far; }
    bool operator==(const Extent&) const = default;
};

/// Without end if the box is empty or has none in some direction.
Extent extent_around(const Bounds& box);
/// The box around the box's moved corners.
Extent moved(const Extent& extent, const Transform& t);

/// Shapes whose box is moved with each transform, as those of sets are; the box of any other is that of the shape as it stands.
bool keeps_its_extent(const Shape& shape);
Extent extent_of(const Shape& shape, const std::optional<Transform>& transform);
/// What bodies that clip or bound an object have in common; it may have no end in some directions.
Bounds box_around(const ObjectSet& bodies);
/// Of a shape without end that such bodies clip.
Extent clipped_extent(const Shape& shape, const std::optional<Transform>& transform, const Bounds& clip);
/// The box of less volume.
Extent smaller(const Extent& a, const Extent& b);

/// The box of a set, while its parts come.
class SetExtent {
public:
    explicit SetExtent(bool cuts) : cuts_(cuts), box_(cuts ? Bounds::everything() : Bounds{}) {}
    /// A part with its box. Of an intersection, what is inverted bounds nothing unless it is a plane.
    void add(const Extent& part, bool inverted);
    /// A part that is a shape; `own` is its box if it keeps one.
    void add(const Shape& shape, const std::optional<Transform>& transform, const std::optional<Extent>& own, bool inverted);
    Extent extent() const { return extent_around(box()); }
    Bounds box() const;

private:
    bool cuts_;
    Bounds box_;
    std::vector<Quadric> quadrics_;  ///< of an intersection: what they are cut to depends on the others
};

}  // namespace rt
