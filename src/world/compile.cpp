#include "world/compile.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "world/material_table.h"
#include "world/surface_index.h"

namespace rt {

namespace {

bool is_black(const Rgb& c) { return std::fabs(c.r) < 1e-10 && std::fabs(c.g) < 1e-10 && std::fabs(c.b) < 1e-10; }

void thin_out(Light& light, int most) {
    if (!light.area) return;
    AreaLight& area = *light.area;
    area.size1 = std::min(area.size1, most), area.size2 = std::min(area.size2, most);
    if (area.size1 == 1 && area.size2 == 1) light.area.reset();
}

void compile_surroundings(const Scene& scene, World& world) {
    const PatternDefaults defaults = pattern_defaults(scene);
    world.noise = defaults.noise;
    world.irid_wavelength = scene.settings.irid_wavelength;
    if (scene.sky_sphere) {
        for (const Pigment& pigment : scene.sky_sphere->pigments) world.sky.push_back(compile_pigment(pigment, defaults, false));
        world.sky_emission = scene.sky_sphere->emission;
    }
    for (const Fog& fog : scene.fogs)
        if (fog.distance != 0.0) world.fogs.push_back(fog);
    world.rainbows = scene.rainbows;
    world.features.atmosphere = !world.fogs.empty() || !world.rainbows.empty();
}

std::vector<Light> compile_lights(const std::vector<Light>& stated, std::optional<int> light_samples) {
    std::vector<Light> lights;
    for (const Light& light : stated) {
        if (is_black(light.color)) continue;
        lights.push_back(light);
        if (light_samples) thin_out(lights.back(), *light_samples);
    }
    return lights;
}

/// Which lights shine on which objects: those of the group that an object is in, and of the whole scene unless a group keeps them out.
void compile_light_groups(const Scene& scene, World& world) {
    world.features.light_groups = scene.light_groups > 0;
    if (!world.features.light_groups) return;
    std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
    for (const Object& object : scene.objects) {
        const auto [found, is_new] =
            known.try_emplace({object.light_group, object.own_lights_only}, static_cast<std::uint32_t>(world.light_lists.size()));
        world.light_list_of.push_back(found->second);
        if (!is_new) continue;
        std::vector<bool>& list = world.light_lists.emplace_back();
        for (const Light& light : world.lights)
            list.push_back(light.group == 0 ? !object.own_lights_only : light.group == object.light_group);
    }
}

void add_masks(World& world, Surfaces& surfaces) {
    const auto has_mask = [](const Light& light) { return light.mask.has_value(); };
    if (std::none_of(world.lights.begin(), world.lights.end(), has_mask)) return;
    for (const Light& light : world.lights) world.masks.push_back(light.mask ? surfaces.add_mask(**light.mask) : MaskRange{});
}

std::uint8_t seen_bits(const Object& object, bool transmits) {
    std::uint8_t bits = 0;
    if (!object.no_image) bits |= seen_by::image;
    if (!object.no_reflection) bits |= seen_by::reflected;
    if (!object.no_shadow) bits |= seen_by::shadow;
    if (!object.no_shadow && !transmits) bits |= seen_by::blocker;
    return bits;
}

/// One list of interiors for all objects. What no ray can be inside of shares element 0; every other object has its own, since a ray's
/// list of interiors tells objects apart by it. Parts that have one medium in common share its element.
class InteriorTable {
public:
    explicit InteriorTable(std::vector<CompiledInterior>& interiors) : interiors_(interiors) { interiors_.emplace_back(); }

    std::uint32_t add(const Object& object, const Material& material) {
        if (!object.interior && !material.can_transmit && !stated_ior(object)) return 0;
        const auto next = static_cast<std::uint32_t>(interiors_.size());
        if (object.medium != 0) {
            const auto [known, is_new] = of_medium_.try_emplace(object.medium, next);
            if (!is_new) return known->second;
        }
        interiors_.push_back(compile_interior(object));
        return next;
    }

private:
    std::vector<CompiledInterior>& interiors_;
    std::unordered_map<std::uint32_t, std::uint32_t> of_medium_;
};

void require(const Material& material, const CompiledInterior& interior, Features& features) {
    features.transmits |= material.can_transmit;
    features.refracts |= material.can_transmit && interior.ior != 1.0;
    features.reflects |= material.can_reflect;
    features.fades |= interior.fade_power > 0.0 || interior.fade_distance != 0.0;
}

/// Whether the general form differs from POV-Ray's own: its highlight is another one, or there is none where POV-Ray would have one.
bool needs_catalogue(const SurfaceFinish& surface) {
    const SurfaceModel& model = surface.model;
    return model.s > 0.0 || surface.finish.specular > 0.0 || model.diffuse != Diffuse::lambert || model.ambient_per_light || model.lecture;
}

void require(const std::vector<LayerNode>& layers, Features& features) {
    features.layers |= layers.size() > 1;
    for (const LayerNode& layer : layers) {
        if (layer.textures) {
            features.patterns = true;
            for (const std::vector<LayerNode>& entry : layer.textures->entries) require(entry, features);
            continue;
        }
        features.patterns |= layer.pigment.front().surface != nullptr;
        features.normals |= layer.normal != nullptr;
        features.catalogue |= needs_catalogue(layer.finish);
        features.grain |= layer.finish.finish.crand != 0.0 || layer.finish.finish.irid.has_value();
    }
}

/// The arrays are made once at their size: a mesh of millions of faces has no room to be copied.
void reserve(const Scene& scene, Surfaces& surfaces) {
    std::size_t vertices = 0, faces = 0;
    for (const Object& object : scene.objects) {
        if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
            vertices += mesh->data->vertices.size();
            faces += mesh->data->faces.size();
        } else if (std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape)) {
            vertices += 3;
            faces += 1;
        }
    }
    surfaces.vertices.reserve(vertices);
    surfaces.faces.reserve(faces);
    surfaces.face_object.reserve(faces);
    surfaces.objects.reserve(scene.objects.size());
}

/// A set counts once, with the interior of the whole: by its first part of that medium.
bool is_around_camera(const Scene& scene, const Surfaces& surfaces, std::uint32_t object, const Vec3& camera, std::uint32_t& last_set) {
    const std::uint32_t set = surfaces.set_of(object);
    if (set == Body::none) {
        // What was turned inside out reaches everywhere, but POV-Ray asks it in its box alone.
        if (surfaces.objects[object].inverse && !contains(surfaces.bounds(object), camera)) return false;
        return surfaces.contains(object, camera);
    }
    const std::uint32_t medium = surfaces.bodies[set].medium;
    if (set == last_set || medium == 0 || scene.objects[object].medium != medium) return false;
    last_set = set;
    return contains(surfaces.bodies[set].gate, camera) && surfaces.contains(object, camera);
}

void find_camera_interiors(const Scene& scene, const Surfaces& surfaces, World& world) {
    // Nobody asks for the list where nothing is transparent and no mirror can be fresnel's.
    if (!world.features.transmits && !world.features.reflects && !world.features.atmosphere) return;
    std::uint32_t last_set = Body::none;
    for (std::uint32_t object = 0; object < world.objects.size(); ++object) {
        if (!is_around_camera(scene, surfaces, object, world.camera.origin, last_set)) continue;
        // Opaque bodies around the camera count as well: they are what a transparent one is nested in.
        std::uint32_t& interior = world.objects[object].interior;
        if (interior == 0) {
            world.interiors.push_back(world.interiors.front());
            world.interiors.back().hollow = scene.objects[object].hollow;
            interior = static_cast<std::uint32_t>(world.interiors.size() - 1);
        }
        world.camera_interiors.push_back(interior);
    }
}

/// The box around the bounded surfaces.
Bounds box_around(const Surfaces& surfaces) {
    Bounds all;
    for (std::uint32_t object = 0; object < surfaces.objects.size(); ++object) {
        if (surfaces.objects[object].seen == seen_by::masked_light) continue;
        const Bounds box = surfaces.bounds(object);
        if (box.is_finite() && !box.is_empty() && surfaces.objects[object].count > 0) all.extend(box);
    }
    return all;
}

/// Of the object that was added last, where its material asks for one.
void add_frame(const Object& object, const Material& material, World& world) {
    if (!material.uses_uv && material.shape_textures.empty()) return;
    world.objects.back().frame = static_cast<std::uint32_t>(world.frames.size());
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    // The faces of a large mesh are not kept for their textures alone.
    const Shape shape = mesh != nullptr && !material.uses_uv ? Shape(Mesh{{}, mesh->textures}) : object.shape;
    world.frames.push_back({shape, object.transform.value_or(Transform{})});
}

/// Whether POV-Ray asks every object of the scene instead of an index, which it has from three on; lights count, and sets once.
bool is_small(const Scene& scene) {
    std::size_t count = scene.lights.size() + scene.objects.size() + scene.sets.size();
    for (const ObjectSet& set : scene.sets)
        for (const SetNode& node : set.nodes)
            if (node.kind == SetNode::Kind::surface) --count;
    return count < 3;
}

Surfaces compile_objects(const Scene& scene, const CompileOptions& options, const MessageSink& warn, World& world) {
    Surfaces surfaces;
    reserve(scene, surfaces);
    MaterialTable materials(scene, options, warn, options.max_nodes);
    InteriorTable interiors(world.interiors);
    world.objects.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        const std::uint32_t material = materials.add(object);
        const bool loose_triangle = std::holds_alternative<Triangle>(object.shape) || std::holds_alternative<SmoothTriangle>(object.shape);
        const std::uint32_t interior = interiors.add(object, materials[material]);
        require(materials[material], world.interiors[interior], world.features);
        world.features.visibility_flags |= object.no_image || object.no_reflection;
        surfaces.add(object, seen_bits(object, materials[material].can_transmit));
        world.objects.push_back({material, interior, object.no_shadow, object.no_image, object.no_reflection, object.double_illuminate,
                                 object.span, loose_triangle});
        add_frame(object, materials[material], world);
    }
    const bool few = is_small(scene);
    for (const ObjectSet& set : scene.sets) surfaces.add_set(set, few);
    add_masks(world, surfaces);
    const PatternDefaults defaults = pattern_defaults(scene);
    for (Placed<FurtherShape>& placed : surfaces.further) compile_functions(placed.shape, defaults);
    world.materials = materials.take();
    for (const Material& material : world.materials) {
        require(material.layers, world.features);
        require(material.interior_layers, world.features);
    }
    return surfaces;
}

/// Light arrives along one shadow ray a lamp, and each surface in a chain adds a ray, or two if it can transmit.
double most_rays(const World& world, const FewRays& few) {
    if (!few.shaded) return few.camera;
    if (world.features.area_lights) return infinity;
    const double surfaces = world.features.transmits ? std::exp2(few.further + 1.0) : world.features.reflects ? few.further + 1.0 : 1.0;
    return few.camera * surfaces * (1.0 + static_cast<double>(world.lights.size()));
}

/// What `automatic` means in this world. Both kinds find the same hits if they have to be exact.
IndexKind choose_index(const World& world, const CompileOptions& options) {
    // To build an index takes as long as some 80 rays that ask every surface: measured 4.6 ms and 0.06 ms a ray for 7,400 spheres.
    constexpr double list_rays = 64.0;
    const bool free = options.index == IndexKind::automatic && options.precision == Precision::exact;
    return free && options.few_rays && most_rays(world, *options.few_rays) <= list_rays ? IndexKind::brute_force : options.index;
}

}  // namespace

World compile(const Scene& scene, const CompileOptions& options, const MessageSink& warn) {
    World world;
    world.camera = camera_basis(scene.camera, options.profile, scene.sources, warn);
    world.lights = compile_lights(scene.lights, options.light_samples);
    for (const Light& light : world.lights) world.features.area_lights |= light.area.has_value();
    compile_light_groups(scene, world);
    for (const Light& light : world.lights) world.features.fogged_lights |= light.media_attenuation && !scene.fogs.empty();
    world.background_transmit = scene.background.transmit;
    world.ambient_light = scene.settings.ambient_light;
    world.max_trace_level = scene.settings.max_trace_level;
    world.adc_bailout = scene.settings.adc_bailout;
    world.legacy_opacity = scene.language_version < 3.7;
    world.background = scene.background.rgb * (world.legacy_opacity ? 1.0 : 1.0 - scene.background.transmit);
    compile_surroundings(scene, world);
    try {
        Surfaces surfaces = compile_objects(scene, options, warn, world);
        find_camera_interiors(scene, surfaces, world);
        if (const Bounds box = box_around(surfaces); box.is_finite()) {
            world.scene_extent = std::fmax(max_abs(box.min), max_abs(box.max));
            world.scene_size = max_component(box.max - box.min);
        }
        CompileOptions chosen = options;
        chosen.index = choose_index(world, options);
        world.surfaces = std::make_unique<SurfaceIndex>(std::move(surfaces), chosen);
    } catch (const std::bad_alloc&) {
        throw LimitError("not enough memory for the scene's surfaces. --limit memory=N allows more.");
    }
    return world;
}

}  // namespace rt
