// Every surface of the scene as flat arrays, one per kind, ready for rays: triangles in world space, other shapes in their own space
// behind a transform unless they can be moved exactly. Knows how one object is tested; the order of the tests is the index's business.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/shape.h"
#include "world/world.h"

namespace rt {

/// Which rays meet an object, one bit each.
namespace seen_by {
inline constexpr std::uint8_t image = 1, reflected = 2, shadow = 4;
inline constexpr std::uint8_t blocker = 8;        ///< casts shadows and can never transmit
inline constexpr std::uint8_t masked_light = 16;  ///< that of the light which is projected through it, and nothing else
}  // namespace seen_by

/// A shape and where it stands.
template <typename S>
struct Placed {
    S shape;
    bool moved = false;  ///< false: `to_world` is the identity and is not applied
    Transform to_world;
};

/// What is a part of a set stands behind a kind of its own, so that nothing else asks for one.
enum class SurfaceKind : std::uint8_t {
    sphere,
    plane,
    placed_sphere,
    box,
    cone,
    torus,
    disc,
    polygon,
    further,
    part,
    part_triangles,
    triangles
};

/// One object of the scene: where its shape lies among the arrays of `Surfaces`.
struct Surface {
    static constexpr std::uint32_t flat = 0xffffffffu;
    SurfaceKind kind = SurfaceKind::sphere;
    std::uint8_t seen = 0;  ///< bits of `seen_by`
    bool inverse = false;   ///< normals are negated
    bool of_mesh = false;
    bool mirrored = false;               ///< a mesh whose transform turned it inside out
    std::uint32_t first_primitive = 0;   ///< primitives of an object are numbered in a row, objects in file order
    std::uint32_t count = 1;             ///< number of primitives: faces of a mesh
    std::uint32_t first = 0;             ///< index into the array of its kind
    std::uint32_t first_normals = flat;  ///< index into `normal_faces`
    std::uint32_t part = 0;              ///< index into `parts`, for the two kinds of them

    bool is_triangles() const { return kind >= SurfaceKind::part_triangles; }
};

/// A surface of which only what fits into a set counts.
struct Part {
    SurfaceKind kind = SurfaceKind::sphere;  ///< of its shape
    bool sheet = false;
    bool cut = false;        ///< only what fits counts; else all of it does
    bool gated = false;      ///< not every ray that meets it passes what stands around it
    std::uint32_t body = 0;  ///< index into `bodies`
    double extent = 0.0;     ///< largest absolute coordinate of the set's bounded bodies
    double size = infinity;  ///< longest side of the box
    Bounds box;              ///< outside of it nothing counts
};

/// A node of the trees of sets, each followed by its parts.
struct Body {
    static constexpr std::uint32_t none = 0xffffffffu;
    SetNode::Kind kind = SetNode::Kind::surface;
    std::uint32_t parent = none;
    std::uint32_t end = 0;     ///< one past its parts
    std::uint32_t object = 0;  ///< of a shape
    std::uint32_t medium = 0;  ///< `SetNode::medium`
    bool inverse = false;      ///< of a bounded one that was turned inside out: its bounds are around what is not it
    bool clips = false;        ///< `SetNode::clips`, and so on
    bool cuts = false;
    Bounds box;  ///< around it; of an inverse shape around what is not it
    /// A ray that misses this box misses the body, however far the body reaches: POV-Ray's box around it.
    Bounds gate = Bounds::everything();
    bool bounds_count = false;  ///< of a bounded one: a ray has to meet its bounds themselves, too
    std::uint32_t texture = TextureWeight::of_object;
};

/// Objects of a set that reach out of its gate. POV-Ray asks bodies in the order in which a ray enters their boxes, and none whose box
/// begins behind the nearest hit: what lies before its box is seen only where nothing else is met before that.
struct LateBody {
    Bounds gate;
    std::vector<std::uint32_t> objects;
};

/// A ray's question with the best answer so far; the ray and range outlive it. Equal distances go to the smaller primitive, so the order of
/// tests does not matter.
struct Query {
    Query(const Ray& r, const Interval& i, std::uint8_t bits) : ray(r), range(i), seen(bits) {}
    const Ray& ray;
    const Interval& range;
    std::uint8_t seen;
    Hit best;
    bool found = false;

    /// Takes `hit` if it is nearer than the best.
    bool offer(const ShapeHit& hit, std::uint32_t primitive, std::uint32_t object) {
        if (found && !(hit.t < best.shape.t || (hit.t == best.shape.t && primitive < best.primitive))) return false;
        best = {hit, primitive, object};
        found = true;
        return true;
    }

    /// The part of the range in which a hit could still be the best.
    Interval wanted() const {
        if (!found) return range;
        return {range.min, std::fmin(range.max, std::nextafter(best.shape.t, infinity))};
    }

    /// The ray as triangles ask for it; made when the first one does.
    const TriangleRay& sheared() {
        if (!sheared_) sheared_.emplace(ray);
        return *sheared_;
    }

private:
    std::optional<TriangleRay> sheared_;
};

/// A sphere in world space with all that its test reads, side by side.
struct IndexedSphere {
    Sphere sphere;
    std::uint32_t object = 0;
    std::uint32_t primitive = 0;
    std::uint8_t seen = 0;  ///< bits of `seen_by`

    bool test(Query& query) const {
        ShapeHit hit;
        return (seen & query.seen) && intersect(sphere, query.ray, query.range, hit) && query.offer(hit, primitive, object);
    }
};

struct Surfaces {
    using Face = MeshData::Face;
    std::vector<Surface> objects;  ///< in file order
    std::vector<Vec3> vertices;
    std::vector<Face> faces;
    std::vector<std::uint32_t> face_object;  ///< the object of each face
    std::vector<Vec3> normals;  ///< of smooth triangles, world space; a mesh's as the inverse transpose leaves them, since POV-Ray
                                ///< interpolates before it transforms
    std::vector<Face> normal_faces;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Placed<Sphere>> placed_spheres;
    std::vector<Placed<Box>> boxes;
    std::vector<Placed<Cone>> cones;
    std::vector<Placed<Torus>> toruses;
    std::vector<Placed<Disc>> discs;
    std::vector<Placed<Polygon>> polygons;
    std::vector<Placed<FurtherShape>> further;
    std::vector<Part> parts;
    std::vector<Body> bodies;
    std::vector<LateBody> late;

    /// Adds one object; `seen` are the bits of `seen_by`. Throws LimitError beyond 2^32 - 1 primitives.
    void add(const Object& object, std::uint8_t seen);
    /// Makes parts of the set's objects, after all objects were added. `few`: POV-Ray asks every object of such a scene.
    void add_set(const ObjectSet& set, bool few = false);
    /// Adds what a light is projected through, after all sets.
    MaskRange add_mask(const Mask& mask);

    /// Nearest hit of the ray with a whole object, offered to the query; true if it is the best so far.
    bool test(std::uint32_t object, Query& query) const;
    /// The same for one of its primitives.
    bool test_primitive(std::uint32_t object, std::uint32_t primitive, Query& query) const {
        const Surface& s = objects[object];
        if (!s.is_triangles()) return test(object, query);
        const std::uint32_t face = s.first + (primitive - s.first_primitive);
        return (s.seen & query.seen) && (s.kind == SurfaceKind::triangles ? test_face(face, query) : test_part_face(face, query));
    }
    /// The same for one triangle, whoever sees it.
    bool test_face(std::uint32_t face, Query& query) const {
        const Face& f = faces[face];
        ShapeHit hit;
        if (!intersect(vertices[f[0]], vertices[f[1]], vertices[f[2]], query.sheared(), query.range, hit)) return false;
        const std::uint32_t object = face_object[face];
        return query.offer(hit, objects[object].first_primitive + (face - objects[object].first), object);
    }

    /// For a triangle that single precision found: where the ray meets its plane, without asking whether that is inside the edges.
    bool offer_plane(std::uint32_t face, Query& query) const;

    Vec3 normal(const Hit& hit, const Vec3& point) const;
    /// Unit normal of the surface as it stands: the flat one, of either sign, where normals are smoothed, else `normal`.
    Vec3 flat_side(const Hit& hit, const Vec3& normal) const;
    /// Whether a ray of this direction comes from the inner side, which shows the interior texture.
    bool met_from_inside(const Hit& hit, const Vec3& point, const Vec3& direction) const;
    /// In world space; not finite for planes and for shapes too large for the numbers.
    Bounds bounds(std::uint32_t object) const;
    /// Whether the point is in the object's inside (or, for an inverse one, not); for a part, in its set's. Sheets have none.
    bool contains(std::uint32_t object, const Vec3& point) const;
    /// The body that is the whole set of a part; none for other objects.
    std::uint32_t set_of(std::uint32_t object) const;

    /// False for an object that does not show what it cuts. For others appends which textures of the parts of its set show at a point of
    /// its surface: of those that contain the point, in equal shares, none if these are below `least`.
    bool cut_weights(std::uint32_t object, const Vec3& point, double least, std::vector<TextureWeight>& out) const;

    /// The same as `test` for one triangle of a part, whoever sees it.
    bool test_part_face(std::uint32_t face, Query& query) const;

private:
    void add_triangle(const Transform& to_world, const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>* corner_normals, Surface& s);
    void add_mesh(const Transform& to_world, const MeshData& mesh, Surface& s);
    void add_shape(const Object& object, const Transform& to_world, Surface& s);
    void add_bodies(const ObjectSet& set, std::uint32_t first_solid);
    bool make_part(std::uint32_t body, double extent);
    void add_gates(const ObjectSet& set, std::uint32_t root, bool few);
    Bounds shape_gate(std::uint32_t object) const;
    Bounds gate_of(std::uint32_t body) const;
    Bounds gate_of_bounds(std::uint32_t bounded) const;
    bool within_bounds(std::uint32_t bounded, const Bounds& box) const;
    bool within(std::uint32_t body, const Vec3& corner) const;
    bool passes(std::uint32_t body, const Ray& ray) const;
    bool meets(std::uint32_t body, const Ray& ray) const;
    Bounds around(std::uint32_t body) const;
    Bounds shape_bounds(std::uint32_t object) const;
    bool holds_its_inside(std::uint32_t object) const;
    bool test_faces(const Surface& s, Query& query) const;
    bool test_part(std::uint32_t object, Query& query) const;
    bool test_further(std::uint32_t object, Query& query) const;
    bool counts(const Part& part, const Query& query, double t, const Vec3& normal) const;
    bool fits(std::uint32_t body, const Vec3& inner, const Vec3& outer) const;
    bool is_touch(std::uint32_t object, const Ray& ray, double t, double aside, double error) const;
    bool stands_for_itself(std::uint32_t body, const Query& query, double t, double aside) const;
    bool has_boundary(std::uint32_t body, const Query& query, const Interval& range) const;
    bool bounds_set(const Part& part, const Ray& ray, double t, const Vec3& normal, double& aside) const;
    bool holds(std::uint32_t body, const Vec3& point) const;
    bool add_shown(std::uint32_t body, std::uint32_t own, const Vec3& point, std::vector<TextureWeight>& out) const;
    bool body_contains(std::uint32_t object, const Vec3& point) const;
    bool shape_contains(std::uint32_t object, const Vec3& point) const;
};

}  // namespace rt
