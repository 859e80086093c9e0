// The recursion of one worker by the course's rules: a ray to the light that comes back along it.
#pragma once

#include <vector>

#include "trace/course_surface.h"
#include "trace/tracer.h"

namespace rt {

class CourseRecursion {
public:
    CourseRecursion(const World& world, const CourseRules& rules);

    Radiance camera_ray(const Ray& ray, RayLog* log);
    /// The same light for each, one by one or together.
    void camera_rays(std::span<const Ray> rays, std::span<Radiance> light);

    RayCounts counts;

private:
    /// A ray on its way; `level` counts the rays before it.
    struct Path {
        Ray ray;
        RayKind kind = RayKind::image;
        int level = 0;
        int bounce = 0;                      ///< how often light was scattered on the way back
        std::uint64_t key = 0;               ///< of the random directions at its hit
        std::uint32_t node = RayNode::none;  ///< its record in the log
    };
    struct Arrival {
        Rgb light{0.0};
        double t = infinity;
    };
    /// A surface point with all that its light needs.
    struct Point {
        Vec3 at, normal, to_viewer;
        Vec3 side;  ///< the normal, turned to the viewer
        course::Surface surface;
        bool inside() const { return dot(normal, to_viewer) < 0.0; }
    };
    struct LocalLight {
        Rgb ambient{0.0}, diffuse{0.0}, specular{0.0};
    };

    void record(std::uint32_t parent, RayNode::Kind kind, Path& path);
    Arrival follow(const Path& path);
    Arrival arrive(const Path& path, const Hit* hit);
    Point point_at(const Ray& ray, const Hit& hit);
    course::Surface surface_of(const Hit& hit, const Vec3& at);
    Rgb shade(const Path& path, const Point& point);
    LocalLight local_light(const Path& path, const Point& point);
    Rgb indirect(const Path& path, const Point& point);
    bool lit(const Point& point, const Light& light);
    Rgb mirrored(const Path& path, const Point& point, double share);
    Rgb transmitted(const Path& path, const Point& point, const Vec3& direction, double share);
    Path further(const Path& path, const Point& point, const Vec3& direction, RayNode::Kind kind);
    RayNode* node(std::uint32_t index) { return log_ == nullptr ? nullptr : &log_->nodes[index]; }

    const World& world_;
    CourseRules rules_;
    std::vector<Blocker> blockers_;  ///< by light
    RayLog* log_ = nullptr;
};

}  // namespace rt
