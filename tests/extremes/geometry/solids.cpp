#include "tests/extremes/geometry/solids.h"

#include <algorithm>
#include <stdexcept>

#include "syntax/parser.h"

namespace rt::extremes {

namespace {

void require(bool holds, const std::string& path, const std::string& what) {
    if (!holds) throw std::runtime_error(path + ": the reference has no " + what);
}

void place(Solid& solid, const Object& object, const std::string& path) {
    if (!object.transform) return;
    const Mat3& linear = object.transform->linear;
    solid.scale = linear[0][0];
    require(solid.scale > 0.0 && linear == Mat3(solid.scale), path, "transforms but scales and translations");
    solid.offset = object.transform->offset;
}

void clothe(Solid& solid, const Object& object, const Scene& scene, const std::string& path) {
    require(object.texture && (*object.texture)->size() == 1 && !object.inverse && !object.no_reflection, path, "layers, inverse");
    const auto& texture = std::get<PlainTexture>((*object.texture)->front().content);
    const auto& color = std::get<PigmentColor>(texture.pigment.content);
    const Finish& finish = texture.finish;
    require(finish.phong == 0.0 && finish.specular == 0.0 && finish.brilliance == 1.0 && finish.emission == Rgb(0.0), path, "highlights");
    solid.ambient = color.rgb * finish.ambient * scene.settings.ambient_light;
    solid.diffuse = color.rgb * finish.diffuse;
    solid.ior = object.interior && (*object.interior)->ior ? *(*object.interior)->ior : 1.0;
    solid.glass = color.transmit != 0.0;
    solid.seen = !object.no_image;
    solid.casts_shadow = !object.no_shadow;
    const Reflection& mirror = finish.reflection;
    if (solid.glass) {
        const bool by_fresnel = mirror.fresnel && mirror.min == Rgb(0.0) && mirror.max == Rgb(1.0);
        require(by_fresnel && finish.conserve_energy && color.transmit == 1.0 && color.rgb == Rgb(1.0) && object.no_shadow &&
                    solid.ambient == Rgb(0.0) && solid.diffuse == Rgb(0.0) && solid.kind != Solid::Kind::plane &&
                    solid.kind != Solid::Kind::triangle,
                path, "glass but clear bodies that mirror by Fresnel and conserve energy");
    } else {
        require(mirror.min == mirror.max && !mirror.fresnel && mirror.metallic == 0.0 && mirror.exponent == 1.0, path, "mirrors by angle");
        solid.mirror = mirror.max;
    }
}

struct ShapeReader {
    Solid solid;
    std::vector<Solid>& solids;
    const std::string& path;

    void add(Solid::Kind kind, const Vec3& a, const Vec3& b, const Vec3& c, double size) {
        solid.kind = kind, solid.a = a, solid.b = b, solid.c = c, solid.size = size;
        solids.push_back(solid);
    }
    void operator()(const Sphere& s) { add(Solid::Kind::sphere, s.center, {}, {}, s.radius); }
    void operator()(const Plane& s) { add(Solid::Kind::plane, s.normal, {}, {}, s.distance); }
    void operator()(const Box& s) { add(Solid::Kind::box, s.min, s.max, {}, 0.0); }
    void operator()(const Triangle& s) { add(Solid::Kind::triangle, s.a, s.b, s.c, 0.0); }
    void operator()(const Cone& s) {
        require(!s.open && s.base_radius == s.cap_radius, path, "cones but closed cylinders");
        add(Solid::Kind::cylinder, s.base, s.cap, {}, s.base_radius);
    }
    void operator()(const Mesh& s) {
        require(s.data->normal_faces.empty(), path, "smooth meshes");
        const std::vector<Vec3>& p = s.data->vertices;
        for (const MeshData::Face& face : s.data->faces) add(Solid::Kind::triangle, p[face[0]], p[face[1]], p[face[2]], 0.0);
    }
    template <typename Other>
    void operator()(const Other&) {
        require(false, path, "other shapes");
    }
};

}  // namespace

double Solids::extent() const {
    double largest = max_abs(camera.location);
    for (const Solid& solid : solids) {
        if (solid.kind == Solid::Kind::plane) continue;
        for (const Vec3& p : {solid.a, solid.b, solid.c}) largest = std::max(largest, solid.scale * (max_abs(p) + solid.size));
        largest = std::max(largest, max_abs(solid.offset));
    }
    return largest;
}

Solids read_solids(const std::string& path) {
    const Scene scene = parse_file(path, {}, [](std::string_view) {});
    require(scene.camera.projection == Projection::perspective && !scene.camera.angle, path, "orthographic camera and camera angle");
    require(scene.settings.gamma.kind == Gamma::Kind::power && scene.settings.gamma.power == 1.0, path, "assumed_gamma but 1");
    require(scene.settings.adc_bailout == 0.0 && scene.options.empty(), path, "adc_bailout but 0, choices of shading");
    Solids result;
    result.camera = scene.camera;
    result.background = scene.background.rgb;
    result.max_trace_level = scene.settings.max_trace_level;
    for (const Light& light : scene.lights) {
        require(light.type == Light::Type::point && !light.parallel && !light.area && light.fade_power == 0.0, path, "lamps but points");
        result.lamps.push_back({light.location, light.color});
    }
    for (const Object& object : scene.objects) {
        ShapeReader reader{{}, result.solids, path};
        reader.solid.object = result.objects++;
        place(reader.solid, object, path);
        const std::size_t first = result.solids.size();
        std::visit(reader, object.shape);
        for (std::size_t i = first; i < result.solids.size(); ++i) clothe(result.solids[i], object, scene, path);
    }
    return result;
}

}  // namespace rt::extremes
