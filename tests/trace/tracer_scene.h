// Scenes built by hand for the tracer's tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "tests/scene/checkers.h"
#include "trace/camera.h"
#include "trace/tracer.h"
#include "world/compile.h"

namespace rt::tracer_test {

inline Finish plain(const Rgb& ambient = Rgb(0.0), double diffuse = 0.0) {
    Finish f;
    f.ambient = ambient;
    f.diffuse = diffuse;
    return f;
}

inline PigmentColor color(const Rgb& rgb, double filter = 0.0, double transmit = 0.0) { return {rgb, filter, transmit}; }

inline Texture texture(const Pigment& pigment, const Finish& finish) { return {PlainTexture{pigment, finish}}; }

inline Texture texture(const PigmentColor& c, const Finish& finish) {
    Pigment p;
    p.content = c;
    return texture(p, finish);
}

inline Pigment checker(const PigmentColor& a, const PigmentColor& b) {
    Pigment pa, pb;
    pa.content = a;
    pb.content = b;
    return checker_of(pa, pb);
}

inline Object object(Shape shape, std::vector<Texture> layers, const Interior& interior = {}) {
    Object o;
    o.shape = std::move(shape);
    o.texture = TextureLayers(std::move(layers));
    o.interior = Shared<Interior>(interior);
    return o;
}

inline Object object(Shape shape, const Texture& layer, const Interior& interior = {}) {
    return object(std::move(shape), std::vector<Texture>{layer}, interior);
}

inline Light point_light(const Vec3& location, const Rgb& c = Rgb(1.0)) {
    Light l;
    l.location = location;
    l.color = c;
    return l;
}

inline TraceOptions povray_options() {
    TraceOptions o;
    o.shading = ShadingModel::povray;
    o.distances = Distances::povray;
    return o;
}

/// A scene with world and tracer over it.
struct Traced {
    explicit Traced(Scene s, const TraceOptions& options = povray_options()) : scene(std::move(s)) {
        CompileOptions compile_options;
        compile_options.threads = 1;
        world = std::make_unique<World>(compile(scene, compile_options, [](std::string_view) {}));
        tracer = std::make_unique<Tracer>(*world, options);
    }
    Radiance look(const Vec3& from, const Vec3& towards) { return tracer->camera_ray({from, unit(towards)}); }
    Radiance pixel(int i, int j, int width, int height) {
        return tracer->camera_ray(camera_ray(world->camera, i + 0.5, j + 0.5, width, height));
    }

    Scene scene;
    std::unique_ptr<World> world;
    std::unique_ptr<Tracer> tracer;
};

inline Scene scene_with(std::vector<Object> objects, std::vector<Light> lights = {}, const Rgb& background = Rgb(0.0)) {
    Scene s;
    s.language_version = 3.7;
    s.objects = std::move(objects);
    s.lights = std::move(lights);
    s.background = color(background);
    s.camera.location = {1e4, 2e4, -3e4};  // outside of everything: rays are aimed by hand
    return s;
}

inline Plane floor_plane(double height = 0.0) { return {Vec3(0, 1, 0), height}; }

/// A ball of glass before a mirror over a checkered plane under two lights.
inline World small_world() {
    Scene scene;
    scene.camera.location = Vec3(0.0, 1.5, -5.0);
    scene.lights = {point_light(Vec3(5.0, 8.0, -5.0)), point_light(Vec3(-3.0, 4.0, -6.0), Rgb(0.3, 0.4, 0.5))};
    Finish mirror = plain(Rgb(0.1), 0.5);
    mirror.reflection.min = mirror.reflection.max = Rgb(0.6);
    Interior glass;
    glass.ior = 1.5;
    scene.objects.push_back(object(Sphere{Vec3(-0.8, 1.0, 1.0), 1.0}, texture(color(Rgb(0.8, 0.3, 0.2)), mirror)));
    scene.objects.push_back(object(Sphere{Vec3(0.5, 1.0, -1.0), 0.9}, texture(color(Rgb(0.9, 1.0, 0.9), 0.8), mirror), glass));
    scene.objects.push_back(
        object(Plane{Vec3(0.0, 1.0, 0.0), 0.0}, texture(checker(color(Rgb(0.9)), color(Rgb(0.1, 0.2, 0.1))), plain(Rgb(0.1), 0.7))));
    return compile(scene, {}, [](std::string_view) {});
}

inline testing::AssertionResult is_near(const Rgb& got, const Rgb& want, double tolerance) {
    const Rgb d = got - want;
    if (std::fabs(d.r) <= tolerance && std::fabs(d.g) <= tolerance && std::fabs(d.b) <= tolerance) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "got " << got.r << " " << got.g << " " << got.b << ", want " << want.r << " " << want.g << " "
                                       << want.b << ", off by " << d.r << " " << d.g << " " << d.b;
}

}  // namespace rt::tracer_test

#define EXPECT_RGB_NEAR(got, want, tolerance) EXPECT_TRUE(rt::tracer_test::is_near(got, want, tolerance))
