// The floor under every trace time: the same camera rays and one shadow ray per lit light, straight to Embree's own triangles and spheres
// in single precision, with nothing around them. usage: embree_floor SCENE WIDTH HEIGHT THREADS RUNS | embree_floor --isa
// Prints one line a run: seconds of the loop, camera rays, shadow rays, seconds of building the index with as many threads. Exit 3: the
// scene has other shapes. --isa: what Embree says of itself, among it the instruction sets that it chooses from on this machine.
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <pmmintrin.h>

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "syntax/parser.h"
#include "trace/camera.h"
#include "world/surface_index.h"

namespace {

using namespace rt;

constexpr int tile_side = 16;

void add_triangles(RTCDevice device, RTCScene scene, const Surfaces& surfaces) {
    if (surfaces.faces.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), surfaces.vertices.size()));
    for (const Vec3& v : surfaces.vertices) {
        for (int i = 0; i < 3; ++i) *points++ = static_cast<float>(v[i]);
    }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), surfaces.faces.size()));
    for (const Surfaces::Face& face : surfaces.faces) corners = std::copy(face.begin(), face.end(), corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

void add_spheres(RTCDevice device, RTCScene scene, const Surfaces& surfaces) {
    if (surfaces.spheres.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* point = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), surfaces.spheres.size()));
    for (const Sphere& sphere : surfaces.spheres) {
        for (int i = 0; i < 3; ++i) *point++ = static_cast<float>(sphere.center[i]);
        *point++ = static_cast<float>(sphere.radius);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

struct Work {
    RTCScene scene;
    const World& world;
    int width, height;
};

/// Rays that leave `from`, in Embree's form.
RTCRay ray_from(const Vec3& from, const Vec3& direction, double near_end, double far_end) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = static_cast<float>(near_end);
    ray.tfar = static_cast<float>(far_end);
    ray.mask = 0xffffffffu;
    return ray;
}

/// One pixel: its shade under point lights, and the shadow rays it took.
float shade(const Work& work, int x, int y, std::uint64_t& shadow_rays) {
    const Ray ray = camera_ray(work.world.camera, x + 0.5, y + 0.5, work.width, work.height);
    RTCRayHit hit{ray_from(ray.origin, ray.direction, 0.0, 1e30), {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(work.scene, &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return 0.0f;
    const Vec3 point = ray.at(static_cast<double>(hit.ray.tfar));
    Vec3 normal = unit(Vec3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z));
    if (dot(normal, ray.direction) > 0.0) normal = -normal;
    float sum = 0.1f;
    for (const Light& light : work.world.lights) {
        const Vec3 to_light = light.location - point;
        const double distance = length(to_light), n_dot_l = dot(normal, to_light) / distance;
        if (n_dot_l <= 0.0) continue;
        RTCRay shadow = ray_from(point, to_light / distance, 1e-4, distance);
        rtcOccluded1(work.scene, &context, &shadow);
        ++shadow_rays;
        if (shadow.tfar >= 0.0f) sum += static_cast<float>(n_dot_l);
    }
    return sum;
}

struct Result {
    double seconds;
    std::uint64_t shadow_rays;
};

Result run(const Work& work, int threads, std::vector<float>& picture) {
    const int columns = (work.width + tile_side - 1) / tile_side, rows = (work.height + tile_side - 1) / tile_side;
    std::atomic<int> next{0};
    std::atomic<std::uint64_t> shadow_rays{0};
    const auto work_on_tiles = [&] {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
        std::uint64_t own = 0;
        for (int tile = next++; tile < columns * rows; tile = next++) {
            const int x0 = tile % columns * tile_side, y0 = tile / columns * tile_side;
            for (int y = y0; y < std::min(y0 + tile_side, work.height); ++y) {
                for (int x = x0; x < std::min(x0 + tile_side, work.width); ++x) {
                    picture[static_cast<std::size_t>(y * work.width + x)] = shade(work, x, y, own);
                }
            }
        }
        shadow_rays += own;
    };
    const auto begin = std::chrono::steady_clock::now();
    {
        std::vector<std::jthread> workers;
        for (int i = 0; i < threads; ++i) workers.emplace_back(work_on_tiles);
    }
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), shadow_rays};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--isa") {
        rtcReleaseDevice(rtcNewDevice("verbose=1"));
        return 0;
    }
    if (argc != 6) return 2;
    const int width = std::stoi(argv[2]), height = std::stoi(argv[3]), threads = std::stoi(argv[4]), runs = std::stoi(argv[5]);
    ParseOptions options;
    options.image_width = width;
    options.image_height = height;
    const MessageSink silent = [](std::string_view) {};
    const World world = compile(parse_file(argv[1], options, silent), {}, silent);
    const Surfaces& s = world.surfaces->surfaces();
    if (!(s.planes.empty() && s.placed_spheres.empty() && s.boxes.empty() && s.cones.empty() && s.toruses.empty() && s.discs.empty() &&
          s.polygons.empty())) {
        return 3;
    }
    const auto begin = std::chrono::steady_clock::now();
    RTCDevice device = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    RTCScene scene = rtcNewScene(device);
    add_triangles(device, scene, s);
    add_spheres(device, scene, s);
    rtcCommitScene(scene);
    const double build = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Work work{scene, world, width, height};
    std::vector<float> picture(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int i = 0; i < runs; ++i) {
        const Result result = run(work, threads, picture);
        fmt::print("{:.6f} {} {} {:.6f}\n", result.seconds, picture.size(), result.shadow_rays, build);
    }
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return 0;
}
