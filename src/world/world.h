// The compiled scene, immutable: what rays can meet and what they find there. Bounded surfaces are in an index, unbounded planes in a list
// beside it. Everything in it is in world space.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/hit.h"
#include "world/material.h"
#include "world/shape_frame.h"

namespace rt {

/// Which objects a ray can see.
enum class RayKind : std::uint8_t {
    image,      ///< camera rays and what was only transmitted since: skips no_image
    reflected,  ///< after any reflection: skips no_reflection
    shadow,     ///< skips no_shadow
};

struct Hit {
    ShapeHit shape;               ///< t is the world ray's
    std::uint32_t primitive = 0;  ///< the world's own numbering; for `World::normal`
    std::uint32_t object = 0;     ///< index of the object in the scene, from 0
};

/// What blocked a shadow ray. The next one from nearby asks it first, since most neighbours are in the same shadow.
struct Blocker {
    static constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t object = none;
    std::uint32_t primitive = 0;
};

struct CompiledObject {
    std::uint32_t material = 0;
    std::uint32_t interior = 0;  ///< index into interiors; every object has one
    bool no_shadow = false, no_image = false, no_reflection = false, double_illuminate = false;
    Span span;
    bool loose_triangle = false;  ///< one face of a larger surface, most likely
    std::uint32_t frame = 0;      ///< index into frames, where the material uses (u, v) or the textures of a shape
};

/// Pixel (u, v) in [-1/2, 1/2]^2, v upwards. Perspective: from origin along direction + u right + v up.
/// Orthographic: from origin + u right + v up along direction. Others: trace/camera.h.
struct CameraBasis {
    Projection projection = Projection::perspective;
    Vec3 origin{0.0}, direction{0.0, 0.0, 1.0}, right{1.33, 0.0, 0.0}, up{0.0, 1.0, 0.0};
    double angle = 0.0, vertical_angle = 0.0;  ///< radians, of the projections that take some
};

/// What the scene requires of the tracer; computed once, and nothing after it pays for what is false.
struct Features {
    bool transmits = false;  ///< some material can transmit
    bool refracts = false;   ///< ... and some interior of such an object has an ior other than 1
    bool reflects = false;
    bool fades = false;  ///< some interior has fade_power > 0 or a fade_distance
    bool patterns = false;
    bool layers = false;   ///< some material has several layers
    bool normals = false;  ///< some layer is bumped
    bool area_lights = false;
    bool atmosphere = false;        ///< fog or rainbows
    bool fogged_lights = false;     ///< ... fog that dims lights
    bool grain = false;             ///< some finish has crand or irid
    bool visibility_flags = false;  ///< some object is no_image or no_reflection
    bool light_groups = false;      ///< not every light shines on every object
    bool catalogue = false;         ///< some finish has specular above 0 or another diffuse term than Lambert's
};

/// The surfaces of what a light is projected through, in a row behind those of the scene's objects.
struct MaskRange {
    std::uint32_t first = 0, count = 0;
};

class SurfaceIndex;

/// Rays that are searched for together.
inline constexpr std::size_t packet_size = 8;

class World {
public:
    World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    /// Nearest hit with t inside `range` among the objects that `kind` sees; ties go to the object first in the file (and in it to the
    /// face first stated). `ray.direction` is unit. Thread-safe.
    bool nearest(const Ray& ray, const Interval& range, RayKind kind, Hit& hit) const;
    /// The same for rays that start near each other and go much the same way, like those of neighbouring pixels: cheaper than one by one.
    /// At most `packet_size` of them; bit i of the answer says whether ray i met something, and hits[i] what.
    std::uint32_t nearest(std::span<const Ray> rays, const Interval& range, RayKind kind, std::span<Hit> hits) const;
    /// True if an object that casts shadows and can never transmit has a hit inside `range`. `last` may be what blocked another ray, and
    /// becomes what blocks this one; the answer does not depend on it. Thread-safe.
    bool occluded(const Ray& ray, const Interval& range, Blocker& last) const;
    bool occluded(const Ray& ray, const Interval& range) const {
        Blocker last;
        return occluded(ray, range, last);
    }
    /// Whether the ray meets what the light of that index is projected through, and if so, where first. Thread-safe.
    std::optional<double> through(std::uint32_t light, const Ray& ray, const Interval& range) const;
    /// Does the light of that index shine on the object? Only asked where there are light groups.
    bool lights_up(std::uint32_t light, std::uint32_t object) const { return light_lists[light_list_of[object]][light]; }
    /// Unit normal as the shape states it (negated by `inverse`), not turned to the viewer; interpolated for smooth triangles.
    Vec3 normal(const Hit& hit, const Vec3& point) const;
    /// Unit normal that stands on the surface itself, of either sign: `normal` but for smooth faces, where it is the flat one.
    Vec3 flat_side(const Hit& hit, const Vec3& normal) const;
    /// Whether a ray of this direction meets the surface from its inner side, which shows the interior texture. For most shapes that is
    /// the sign of direction . normal; in a mesh the flat side of the face decides, whatever its interpolated normal.
    bool met_from_inside(const Hit& hit, const Vec3& point, const Vec3& direction) const;

    /// (u, v) of a hit on an object whose material uses them.
    Vec2 uv(const Hit& hit, const Vec3& point) const;
    /// Appends which textures show at a hit on an object whose shape states some: those of mixtures whose weight is below `least` not.
    void texture_weights(const Hit& hit, const Vec3& point, double least, std::vector<TextureWeight>& out) const;

    CameraBasis camera;
    std::vector<Light> lights;
    std::vector<MaskRange> masks;                ///< of each light; none if no light has one
    std::vector<std::vector<bool>> light_lists;  ///< one entry a light; only where there are light groups, like the next
    std::vector<std::uint32_t> light_list_of;    ///< which of them holds for each object
    std::vector<CompiledObject> objects;
    std::vector<Material> materials;
    std::vector<CompiledInterior> interiors;
    std::vector<ShapeFrame> frames;
    std::vector<Fog> fogs;  ///< those that can be seen; `up` unit
    std::vector<Rainbow> rainbows;
    NoiseGenerator noise = NoiseGenerator::range_corrected;  ///< of turbulent fog and films
    Rgb irid_wavelength{1.0};
    std::vector<PigmentTree> sky;  ///< of a sky_sphere, the nearest last
    Rgb sky_emission{1.0};
    /// Interiors of the objects that contain the camera, in file order.
    std::vector<std::uint32_t> camera_interiors;
    Rgb background{0.0};
    double background_transmit = 1.0;
    Rgb ambient_light{1.0};
    int max_trace_level = 5;
    double adc_bailout = 1.0 / 255.0;
    /// Language before 3.7: opacity is 1 - (filter * max(rgb) + transmit).
    bool legacy_opacity = false;
    double scene_extent = 0.0;  ///< largest absolute coordinate of the bounded surfaces
    double scene_size = 0.0;    ///< longest side of the box around them
    Features features;
    std::unique_ptr<SurfaceIndex> surfaces;  ///< how rays are answered; made by `compile`
};

}  // namespace rt
