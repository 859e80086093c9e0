// What a scene asks of its objects while it is read, and the object pattern of points: where a ray meets them, whether they contain a
// point.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace rt {

/// Objects and the sets that some of them are parts of, as a scene has them. Textures do not count.
struct Bodies {
    std::vector<Object> objects;
    std::vector<ObjectSet> sets;
    bool operator==(const Bodies&) const = default;
};

class ObjectProbe {
public:
    /// Where a ray meets a surface, and the unit normal there as the shape states it, not turned to the viewer.
    struct Met {
        Vec3 point{0.0};
        Vec3 normal{0.0};
    };
    virtual ~ObjectProbe() = default;
    /// The nearest surface farther than POV-Ray's 1e-4 and nearer than its 1e7; the direction need not be unit, and meets nothing if it
    /// has no length.
    virtual std::optional<Met> trace(const Vec3& from, const Vec3& direction) const = 0;
    /// Whether any of the objects contains the point.
    virtual bool contains(const Vec3& point) const = 0;
};

using ProbeMaker = std::function<std::shared_ptr<const ObjectProbe>(const Bodies& bodies)>;

}  // namespace rt
