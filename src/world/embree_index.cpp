#include "world/embree_index.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <limits>

#include "core/slots.h"
#include "world/embree_handles.h"
#include "world/traveller.h"

namespace rt {

namespace {

/// Embree's slab tests see every box plane displaced by less than 9e-7 in local units (coordinates up to 1, so distances up to 2): 2^-25
/// each from the rounded plane and ray origin, 2^-24 from their product with the reciprocal direction, and the relative errors 2^-24 of the
/// rounded direction and 2^-22 of Embree's reciprocal times the distance. Where the processor rounds in one direction, all of them are at
/// most twice as large, less than 1.5e-6 with Newton's step counted exactly. Boxes grow by that, and no box is missed.
constexpr double box_padding = 1.5e-6;
/// The box in which rays are clipped before they are rounded; its own test is in doubles.
constexpr double scene_padding = 8e-6;
/// From farther away (in half sizes of the scene) doubles no longer say where in the padded box a ray enters.
constexpr double far_origin = 1e7;

[[noreturn]] void fail(RTCError error) {
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw LimitError("not enough memory for the index of the scene's surfaces. --limit memory=N allows more.");
    throw std::runtime_error(fmt::format("Embree failed with error {}", static_cast<int>(error)));
}

/// Embree sets flush-to-zero in the threads that it builds with; whether the caller is one of them is up to its scheduler, which may also
/// hand the caller's rounding on to the others, for good. It builds with the usual one, whatever the caller's is.
class KeepFloatingPoint {
public:
    KeepFloatingPoint() {
        std::fegetenv(&environment_);
        std::fesetround(FE_TONEAREST);
    }
    ~KeepFloatingPoint() { std::fesetenv(&environment_); }
    KeepFloatingPoint(const KeepFloatingPoint&) = delete;
    KeepFloatingPoint& operator=(const KeepFloatingPoint&) = delete;

private:
    std::fenv_t environment_;
};

/// Embree hands the context through unchanged; rays it may copy and reorder, but for their numbers.
struct Context : RTCIntersectContext {
    explicit Context(Traveller* const* first) : travellers(first) { rtcInitIntersectContext(this); }
    Traveller* const* travellers;  ///< by ray number
};

template <typename Arguments>
const IndexData& data_of(const Arguments* args) {
    return *static_cast<const IndexData*>(args->geometryUserPtr);
}

/// Calls `f` with the traveller and the far end of every ray of a callback's packet.
template <typename F>
void for_each_ray(const int* valid, unsigned count, RTCRayN* rays, const RTCIntersectContext* context, F f) {
    Traveller* const* travellers = static_cast<const Context*>(context)->travellers;
    for (unsigned i = 0; i < count; ++i)
        if (valid[i]) f(*travellers[RTCRayN_id(rays, count, i)], RTCRayN_tfar(rays, count, i));
}

/// The callback for nearest hits, from one of traveller.h's tests: offers what it meets to the query, and lets Embree cull by a better hit.
template <auto test>
void on_intersect(const RTCIntersectFunctionNArguments* args) {
    for_each_ray(args->valid, args->N, RTCRayHitN_RayN(args->rayhit, args->N), args->context, [&](Traveller& ray, float& far) {
        if (test(data_of(args), ray, args->primID, far, false)) far = std::min(far, ray.far(ray.query.best.shape.t));
    });
}

/// The same for occlusion; the infinity says yes.
template <auto test>
void on_occluded(const RTCOccludedFunctionNArguments* args) {
    for_each_ray(args->valid, args->N, args->ray, args->context, [&](Traveller& ray, float& far) {
        if (test(data_of(args), ray, args->primID, far, true)) far = -std::numeric_limits<float>::infinity();
    });
}

/// Gives the memory back; assigning {} would keep it.
template <typename T>
void free_all(std::vector<T>& list) {
    std::vector<T>().swap(list);
}

void set_bounds(const RTCBoundsFunctionArguments* args, const Vec3& low, const Vec3& high) {
    RTCBounds& out = *args->bounds_o;
    out.lower_x = static_cast<float>(low.x - box_padding);
    out.lower_y = static_cast<float>(low.y - box_padding);
    out.lower_z = static_cast<float>(low.z - box_padding);
    out.upper_x = static_cast<float>(high.x + box_padding);
    out.upper_y = static_cast<float>(high.y + box_padding);
    out.upper_z = static_cast<float>(high.z + box_padding);
}

void bounds_of_sphere(const RTCBoundsFunctionArguments* args) {
    const IndexData& data = data_of(args);
    const Bounds box = bounds(data.spheres[args->primID].sphere);
    set_bounds(args, data.frame.to_local(box.min), data.frame.to_local(box.max));
}

void bounds_of_body(const RTCBoundsFunctionArguments* args) {
    const IndexData& data = data_of(args);
    const Bounds box = data.surfaces.bounds(data.bodies[args->primID]);
    set_bounds(args, data.frame.to_local(box.min), data.frame.to_local(box.max));
}

template <std::vector<TriangleBlock> IndexData::*blocks>
void bounds_of_block(const RTCBoundsFunctionArguments* args) {
    const TriangleBlock& block = (data_of(args).*blocks)[args->primID];
    Vec3 low(infinity), high(-infinity);
    for (const auto& corner : block.corner) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int lane = 0; lane < 4; ++lane) {
                low[axis] = std::min(low[axis], double{corner[axis][lane]});
                high[axis] = std::max(high[axis], double{corner[axis][lane]});
            }
        }
    }
    set_bounds(args, low, high);
}

/// Filter of Embree's own triangles, for nearest hits and for occlusion. Their rays come one at a time.
void filter_triangle(const RTCFilterFunctionNArguments* args) {
    if (!*args->valid) return;
    const IndexData& data = data_of(args);
    const unsigned triangle = reinterpret_cast<const RTCHit*>(args->hit)->primID;
    Query& query = (*static_cast<const Context*>(args->context)->travellers)->query;
    if (!data.surfaces.offer_plane(data.faces[triangle], query)) *args->valid = 0;
}

Bounds bounds_of_all(const Surfaces& surfaces, const std::vector<std::uint32_t>& objects) {
    Bounds box;
    for (const std::uint32_t object : objects) box.extend(surfaces.bounds(object));
    return box;
}

/// Node of the temporary tree that says which triangles lie together. A node without children is a leaf.
struct GroupNode {
    GroupNode* child[2] = {nullptr, nullptr};
    std::array<std::uint32_t, 4> faces{};
    std::uint32_t count = 0;
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(GroupNode), alignof(GroupNode))) GroupNode;
}
void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<GroupNode*>(node)->child[i] = static_cast<GroupNode*>(children[i]);
}
void set_children_bounds(void*, const RTCBounds**, unsigned, void*) {}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
    auto* leaf = static_cast<GroupNode*>(create_node(allocator, 0, nullptr));
    leaf->count = static_cast<std::uint32_t>(count);
    for (std::size_t i = 0; i < count; ++i) leaf->faces[i] = primitives[i].primID;
    return leaf;
}

void collect(const GroupNode& node, const IndexData& data, std::vector<TriangleBlock>& out) {
    if (node.count > 0) out.push_back(make_block(data.surfaces, std::span(node.faces).first(node.count), data.frame));
    for (const GroupNode* child : node.child)
        if (child) collect(*child, data, out);
}

/// Sets ray number i of a packet of Embree's, which may be of one; `end` bounds the distance at which hits count.
template <typename Rays>
void set_ray(Rays& rays, unsigned count, unsigned i, const Traveller& traveller, double end) {
    auto* ray = reinterpret_cast<RTCRayN*>(&rays);
    const Vec3& direction = traveller.query.ray.direction;
    RTCRayN_org_x(ray, count, i) = static_cast<float>(traveller.origin.x);
    RTCRayN_org_y(ray, count, i) = static_cast<float>(traveller.origin.y);
    RTCRayN_org_z(ray, count, i) = static_cast<float>(traveller.origin.z);
    RTCRayN_dir_x(ray, count, i) = static_cast<float>(direction.x);
    RTCRayN_dir_y(ray, count, i) = static_cast<float>(direction.y);
    RTCRayN_dir_z(ray, count, i) = static_cast<float>(direction.z);
    RTCRayN_tnear(ray, count, i) = 0.0f;
    RTCRayN_tfar(ray, count, i) = traveller.far(end);
    RTCRayN_time(ray, count, i) = 0.0f;
    RTCRayN_mask(ray, count, i) = ~0u;
    RTCRayN_id(ray, count, i) = i;
    RTCRayN_flags(ray, count, i) = 0;
}

/// Where the best hit so far, if any, ends the search.
double search_end(const Query& query, const Interval& inside) {
    return query.found ? std::min(inside.max, query.best.shape.t) : inside.max;
}

}  // namespace

struct EmbreeIndex::State {
    State(const Surfaces& surfaces, const std::vector<std::uint32_t>& o, const Bounds& tight)
        : data(surfaces, tight), objects(o), box(grown(tight, scene_padding * data.frame.scale)) {}

    IndexData data;
    std::vector<std::uint32_t> objects;  ///< everything in the index
    Bounds box;                          ///< of everything, padded
    DeviceHandle device;
    SceneHandle scene;

    void check() const {
        if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE) fail(error);
    }

    void attach(const GeometryHandle& geometry) {
        rtcSetGeometryUserData(geometry.get(), &data);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene.get(), geometry.get());
        check();
    }

    template <auto test>
    void add_callbacks(std::size_t count, RTCBoundsFunction bounds) {
        if (count == 0) return;
        const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
        check();
        rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(count));
        rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry.get(), on_intersect<test>);
        rtcSetGeometryOccludedFunction(geometry.get(), on_occluded<test>);
        attach(geometry);
    }

    void add_float_triangles() {
        const GeometryHandle geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        check();
        const auto& vertices = data.surfaces.vertices;
        const auto buffer = [&](RTCBufferType type, RTCFormat format, std::size_t count) {
            void* memory = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, 12, count);
            check();
            return memory;
        };
        auto* corner = static_cast<float*>(buffer(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices.size()));
        for (const Vec3& vertex : vertices)
            for (int axis = 0; axis < 3; ++axis) *corner++ = static_cast<float>(data.frame.to_local(vertex)[axis]);
        auto* index = static_cast<std::uint32_t*>(buffer(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, data.faces.size()));
        for (const std::uint32_t face : data.faces) index = std::copy_n(data.surfaces.faces[face].begin(), 3, index);
        rtcSetGeometryIntersectFilterFunction(geometry.get(), filter_triangle);
        rtcSetGeometryOccludedFilterFunction(geometry.get(), filter_triangle);
        attach(geometry);
    }

    /// Groups triangles that lie together by the surface area heuristic, for which four in a leaf cost as much as one.
    void make_blocks(std::vector<std::uint32_t>& faces, std::vector<TriangleBlock>& blocks) {
        std::vector<RTCBuildPrimitive> primitives;
        primitives.reserve(faces.size());
        for (const std::uint32_t face : faces) {
            Bounds box;
            for (const std::uint32_t vertex : data.surfaces.faces[face]) box.extend(data.frame.to_local(data.surfaces.vertices[vertex]));
            if (!box.is_finite()) continue;  // no ray meets it
            const glm::vec3 low(box.min), high(box.max);
            primitives.push_back({low.x, low.y, low.z, 0, high.x, high.y, high.z, face});
        }
        const BvhHandle bvh(rtcNewBVH(device.get()));
        check();
        RTCBuildArguments arguments = rtcDefaultBuildArguments();
        arguments.maxDepth = 64;
        arguments.sahBlockSize = 4;
        arguments.maxLeafSize = 4;
        arguments.bvh = bvh.get();
        arguments.primitives = primitives.data();
        arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
        arguments.createNode = create_node;
        arguments.setNodeChildren = set_children;
        arguments.setNodeBounds = set_children_bounds;
        arguments.createLeaf = create_leaf;
        const auto* root = static_cast<const GroupNode*>(rtcBuildBVH(&arguments));
        check();
        blocks.reserve(primitives.size() * 3 / 10);
        free_all(primitives);
        free_all(faces);
        if (root) collect(*root, data, blocks);
    }

    void sort_objects() {
        for (const std::uint32_t object : objects) {
            const Surface& s = data.surfaces.objects[object];
            if (s.kind == SurfaceKind::sphere)
                data.spheres.push_back({data.surfaces.spheres[s.first], object, s.first_primitive, s.seen});
            else if (!s.is_triangles())
                data.bodies.push_back(object);
            else
                for (std::uint32_t face = s.first; face < s.first + s.count; ++face)
                    (s.kind == SurfaceKind::triangles ? data.faces : data.part_faces).push_back(face);
        }
    }

    void build(Precision precision, int threads) {
        const KeepFloatingPoint keep;
        device.reset(rtcNewDevice(fmt::format("threads={}", threads).c_str()));
        if (!device) fail(rtcGetDeviceError(nullptr));
        scene.reset(rtcNewScene(device.get()));
        check();
        sort_objects();
        add_callbacks<test_sphere>(data.spheres.size(), bounds_of_sphere);
        add_callbacks<test_body>(data.bodies.size(), bounds_of_body);
        if (!data.faces.empty() && precision == Precision::fast) {
            add_float_triangles();
        } else if (!data.faces.empty()) {
            make_blocks(data.faces, data.blocks);
            add_callbacks<test_block>(data.blocks.size(), bounds_of_block<&IndexData::blocks>);
        }
        if (!data.part_faces.empty()) {
            make_blocks(data.part_faces, data.part_blocks);
            add_callbacks<test_part_block>(data.part_blocks.size(), bounds_of_block<&IndexData::part_blocks>);
        }
        rtcCommitScene(scene.get());
        check();
    }

    /// For the rare ray that aims at the scene from where its rounded copy would not be good enough.
    bool test_all(Query& query, bool any) const {
        bool met = false;
        for (const std::uint32_t object : objects) {
            met |= data.surfaces.test(object, query);
            if (met && any) return true;
        }
        return met;
    }
};

EmbreeIndex::EmbreeIndex(const Surfaces& surfaces, const std::vector<std::uint32_t>& objects, Precision precision, int threads) {
    state_ = std::make_unique<State>(surfaces, objects, bounds_of_all(surfaces, objects));
    state_->build(precision, threads);
}

EmbreeIndex::~EmbreeIndex() = default;

EmbreeIndex::Entry EmbreeIndex::enter(const Ray& ray, Interval& range) const {
    const Bounds& box = state_->box;
    if (contains(box, ray.origin) && range.min >= 0.0) return range.min < range.max ? Entry::inside : Entry::none;
    const Vec3 away = ray.origin - state_->data.frame.centre;
    const double distance = std::max({std::abs(away.x), std::abs(away.y), std::abs(away.z)});
    if (distance < far_origin * state_->data.frame.scale) return clip(ray, box, range) ? Entry::inside : Entry::none;
    return clip(ray, grown(box, 1e-14 * distance), range) ? Entry::far : Entry::none;
}

void EmbreeIndex::nearest(Query& query, Entry entry, const Interval& inside) const {
    if (entry == Entry::far) {
        state_->test_all(query, false);
        return;
    }
    Traveller traveller(state_->data.frame, query, inside.min);
    Traveller* const only = &traveller;
    Context context(&only);
    RTCRayHit ray;
    set_ray(ray.ray, 1, 0, traveller, search_end(query, inside));
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene.get(), &context, &ray);
}

void EmbreeIndex::nearest(std::span<Query* const> queries, std::span<const Interval> inside) const {
    Slots<Traveller, packet_size> travellers;
    std::array<Traveller*, packet_size> first{};
    alignas(32) std::array<int, packet_size> valid{};
    alignas(32) RTCRayHit8 rays;
    static_assert(packet_size == 8);
    for (unsigned i = 0; i < queries.size(); ++i) {
        valid[i] = -1;
        first[i] = &travellers.emplace(i, state_->data.frame, *queries[i], inside[i].min);
        set_ray(rays.ray, packet_size, i, *first[i], search_end(*queries[i], inside[i]));
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    Context context(first.data());
    rtcIntersect8(valid.data(), state_->scene.get(), &context, &rays);
}

bool EmbreeIndex::occluded(Query& query, Entry entry, const Interval& inside) const {
    if (entry == Entry::far) return state_->test_all(query, true);
    Traveller traveller(state_->data.frame, query, inside.min);
    Traveller* const only = &traveller;
    Context context(&only);
    RTCRay ray;
    set_ray(ray, 1, 0, traveller, inside.max);
    rtcOccluded1(state_->scene.get(), &context, &ray);
    return ray.tfar < 0.0f;
}

}  // namespace rt
