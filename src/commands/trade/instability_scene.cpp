#include "commands/trade/instability_scene.h"

#include <unordered_map>

namespace rt {

namespace {

/// The same map between spaces that are both larger by `factor`.
Transform between_scaled(const Transform& t, double factor) {
    return {t.linear, factor * t.offset, t.inverse_linear, factor * t.inverse_offset};
}

struct ScaleShape {
    double factor;

    void operator()(Sphere& s) const { s.center *= factor, s.radius *= factor; }
    void operator()(Plane& s) const { s.distance *= factor; }
    void operator()(Box& s) const { s.min *= factor, s.max *= factor; }
    void operator()(Cone& s) const { s.base *= factor, s.cap *= factor, s.base_radius *= factor, s.cap_radius *= factor; }
    void operator()(Torus& s) const { s.major_radius *= factor, s.minor_radius *= factor; }
    void operator()(Disc& s) const { s.center *= factor, s.radius *= factor, s.hole_radius *= factor; }
    template <typename Corners>
    void operator()(Corners& s) const {
        s.a *= factor, s.b *= factor, s.c *= factor;
    }
    void operator()(Polygon& s) const {
        for (Vec3& p : s.points) p *= factor;
    }
    void operator()(Mesh&) const {}          // its vertices are shared: by its transform
    void operator()(FurtherShape&) const {}  // by its transform as well
};

/// The patterns of textures, larger by a factor. Textures that were shared stay so.
class ScaledTextures {
public:
    explicit ScaledTextures(double factor) : larger_(Transform::scale(Vec3(factor))) {}

    void scale(std::optional<TextureLayers>& layers) {
        if (layers) scale(*layers);
    }
    void scale(TextureLayers& layers) {
        const auto [known, is_new] = made_.try_emplace(layers.identity(), layers);
        if (is_new && has_pattern(*layers)) known->second = TextureLayers(scaled(*layers));
        layers = known->second;
    }

private:
    static bool has_pattern(const std::vector<Texture>& layers) {
        return std::ranges::any_of(layers, [](const Texture& texture) {
            const auto* plain = std::get_if<PlainTexture>(&texture.content);
            return plain == nullptr || plain->normal || !std::holds_alternative<PigmentColor>(plain->pigment.content);
        });
    }
    /// Patterns within patterns lie in the outer one's space, which grows with it.
    std::vector<Texture> scaled(std::vector<Texture> layers) const {
        for (Texture& texture : layers) {
            if (auto* plain = std::get_if<PlainTexture>(&texture.content)) {
                if (auto* pigment = std::get_if<Shared<PatternPigment>>(&plain->pigment.content)) grow(pigment->edit().pattern);
                if (plain->normal) grow(plain->normal->edit().pattern);
            } else {
                grow(std::get<Shared<PatternTexture>>(texture.content).edit().pattern);
            }
        }
        return layers;
    }
    void grow(StatedPattern& stated) const { append(stated.pattern, larger_); }

    Transform larger_;
    std::unordered_map<const void*, TextureLayers> made_;
};

void scale(Shape& shape, std::optional<Transform>& transform, double factor) {
    std::visit(ScaleShape{factor}, shape);
    if (std::holds_alternative<Mesh>(shape) || std::holds_alternative<FurtherShape>(shape)) {
        transform = transform.value_or(Transform{}).then(Transform::scale(Vec3(factor)));
    } else if (transform) {
        transform = between_scaled(*transform, factor);
    }
}

void scale(Object& object, double factor) {
    scale(object.shape, object.transform, factor);
    if (object.interior && (*object.interior)->fade_distance != 0.0) object.interior->edit().fade_distance *= factor;
}

void scale(Light& light, double factor) {
    light.location *= factor;
    light.point_at *= factor;
    light.fade_distance *= factor;
    if (light.type == Light::Type::cylinder) light.radius *= factor, light.falloff *= factor;
    if (light.area) light.area->axis1 *= factor, light.area->axis2 *= factor;
}

void scale(Camera& camera, double factor) {
    camera.location *= factor;
    if (camera.look_at) *camera.look_at *= factor;
    camera.transform = between_scaled(camera.transform, factor);
    // Of the other cameras these say angles.
    if (camera.projection == Projection::orthographic) camera.direction *= factor, camera.right *= factor, camera.up *= factor;
    if (camera.projection == Projection::cylinder_3) camera.up *= factor;
    if (camera.projection == Projection::cylinder_4) camera.right *= factor;
}

}  // namespace

Scene scaled(Scene scene, double factor) {
    scale(scene.camera, factor);
    for (Light& light : scene.lights) scale(light, factor);
    ScaledTextures textures(factor);
    for (Object& object : scene.objects) {
        scale(object, factor);
        textures.scale(object.texture);
        textures.scale(object.interior_texture);
        if (object.shape_textures)
            for (TextureLayers& layers : object.shape_textures->edit()) textures.scale(layers);
    }
    for (ObjectSet& set : scene.sets)
        for (Solid& solid : set.solids) scale(solid.shape, solid.transform, factor);
    return scene;
}

}  // namespace rt
