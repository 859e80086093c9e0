#include "tests/extremes/description.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "shading/names.h"
#include "syntax/parser.h"

namespace rt::extremes {

namespace {

void require(bool holds, const std::string& path, const std::string& what) {
    if (!holds) throw std::runtime_error(path + ": the second renderer has no " + what);
}

void choose(Surface& surface, const std::vector<SceneOption>& options, const std::string& path) {
    for (const SceneOption& option : options) {
        const std::string& value = option.value;
        if (option.key == "D") {
            surface.D = find_named(distribution_names, value).value();
        } else if (option.key == "G") {
            surface.G = find_named(masking_names, value).value();
        } else if (option.key == "F") {
            surface.F = find_named(fresnel_names, value).value();
        } else if (option.key == "k") {
            surface.k = std::stod(value);
        } else if (option.key == "alpha" && value == "direct") {
            surface.direct = true;
        } else {
            require(false, path, option.key + "=" + value);
        }
    }
}

Surface surface_of(const Object& object, const Scene& scene, const std::string& path) {
    Surface surface;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        surface.center = sphere->center;
        surface.radius = sphere->radius;
    } else {
        const auto* plane = std::get_if<Plane>(&object.shape);
        require(plane != nullptr, path, "shape but spheres and planes");
        surface.plane = true;
        surface.center = plane->normal;
        surface.radius = plane->distance;
    }
    require(!object.transform && object.texture && (*object.texture)->size() == 1, path, "transforms and layers");
    const auto& texture = std::get<PlainTexture>((*object.texture)->front().content);
    const auto& color = std::get<PigmentColor>(texture.pigment.content);
    const Finish& finish = texture.finish;
    surface.pigment = color.rgb;
    surface.ambient = finish.ambient * scene.settings.ambient_light;
    surface.diffuse = finish.diffuse;
    surface.s = std::fmin(std::fmax(finish.specular, 0.0), 1.0);
    require(finish.roughness || surface.s == 0.0, path, "highlight without roughness");
    surface.roughness = finish.roughness.value_or(0.0);
    surface.ior = object.interior && (*object.interior)->ior ? *(*object.interior)->ior : 1.5;
    surface.glass = color.transmit != 0.0;
    surface.casts_shadow = !object.no_shadow;
    require(finish.phong == 0.0 && finish.brilliance == 1.0 && finish.emission == Rgb(0.0), path, "phong, brilliance and emission");
    const bool mirrors = finish.reflection.fresnel && finish.reflection.min == Rgb(0.0) && finish.reflection.max == Rgb(1.0);
    if (surface.glass) {
        require(mirrors && finish.conserve_energy && color.transmit == 1.0 && color.filter == 0.0 && surface.s == 0.0 && !surface.plane &&
                    object.no_shadow,
                path, "glass but clear spheres that mirror by Fresnel and conserve energy");
    } else {
        require(finish.reflection.max == Rgb(0.0), path, "mirrors but glass");
    }
    choose(surface, scene.options, path);
    choose(surface, finish.options, path);
    return surface;
}

}  // namespace

Description describe(const std::string& path) {
    const Scene scene = parse_file(path, {}, [](std::string_view) {});
    Description description;
    description.camera = scene.camera;
    require(scene.camera.projection == Projection::perspective && !scene.camera.angle, path, "orthographic camera and camera angle");
    require(scene.settings.gamma.kind == Gamma::Kind::power && scene.settings.gamma.power == 1.0, path, "assumed_gamma but 1");
    description.background = scene.background.rgb;
    description.max_trace_level = scene.settings.max_trace_level;
    for (const Light& light : scene.lights) {
        require(light.type == Light::Type::point && !light.parallel && !light.area && light.fade_power == 0.0, path, "lamps but points");
        description.lamps.push_back({light.location, light.color});
    }
    for (const Object& object : scene.objects) {
        description.surfaces.push_back(surface_of(object, scene, path));
        require(!description.surfaces.back().glass || scene.settings.adc_bailout == 0.0, path, "adc_bailout but 0 with glass");
    }
    return description;
}

}  // namespace rt::extremes
