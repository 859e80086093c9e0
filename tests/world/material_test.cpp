// Textures and finishes as they are compiled, and what is sampled from them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/checkers.h"
#include "world/compile.h"

namespace rt::material_test {
namespace {

using testing::HasSubstr;

Pigment solid(const Rgb& rgb, double filter = 0.0, double transmit = 0.0) {
    Pigment pigment;
    pigment.content = PigmentColor{rgb, filter, transmit};
    return pigment;
}

Pigment checkered(const Pigment& a, const Pigment& b, const Transform& transform = {}) { return checker_of(a, b, transform); }

Texture plain(const Pigment& pigment, const Finish& finish = {}) {
    Texture texture;
    texture.content = PlainTexture{pigment, finish};
    return texture;
}

Object textured(const std::vector<Texture>& layers) {
    Object object;
    object.shape = Sphere{};
    object.texture = TextureLayers(layers);
    return object;
}

World compiled(const std::vector<Object>& objects, const CompileOptions& options = {}, std::vector<std::string>* messages = nullptr) {
    Scene scene;
    scene.objects = objects;
    return compile(scene, options, [&](std::string_view text) {
        if (messages) messages->emplace_back(text);
    });
}

Rgb color_at(const World& world, const Vec3& p, std::size_t layer = 0, bool quick = false) {
    SampledTexture sampled;
    TexturePoint seen;
    seen.point = p;
    sample(world.materials[world.objects[0].material].layers, seen, {.quick_colors = quick}, sampled);
    return sampled.layers.at(layer).color.rgb;
}

const Rgb red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};

TEST(Material, LayersComeTopFirst) {
    const World world = compiled({textured({plain(solid(red)), plain(solid(green, 0.0, 0.5))})});
    EXPECT_EQ(color_at(world, {}, 0), green);
    EXPECT_EQ(color_at(world, {}, 1), red);
    EXPECT_TRUE(world.features.layers);
    EXPECT_TRUE(world.features.transmits);
}

TEST(Material, NestedCheckersAreEvaluatedInTheSpaceAroundThem) {
    // The outer cells are 4 wide; the inner ones half of an outer unit, 2.
    const Pigment inner = checkered(solid(red), solid(green), Transform::scale(Vec3(0.5)));
    const World world = compiled({textured({plain(checkered(inner, solid(blue), Transform::scale(Vec3(4.0))))})});
    EXPECT_EQ(color_at(world, {1, 1, 1}), red);
    EXPECT_EQ(color_at(world, {3, 1, 1}), green);
    EXPECT_EQ(color_at(world, {5, 1, 1}), blue);
    EXPECT_TRUE(world.features.patterns);
}

TEST(Material, CheckersOfTexturesHoldLayersAndTransforms) {
    const Texture texture = checker_of({plain(checkered(solid(red), solid(green)))}, {plain(solid(blue)), plain(solid(green, 0, 1))},
                                       Transform::scale(Vec3(2.0)));
    const World world = compiled({textured({texture})});
    EXPECT_EQ(color_at(world, {1, 1, 1}), red);  // in pattern space <.5, .5, .5>: the inner checker's cells are as large as the outer's
    EXPECT_EQ(color_at(world, {3, 3, 1}), red);
    EXPECT_EQ(color_at(world, {3, 1, 1}, 0), green);
    EXPECT_EQ(color_at(world, {3, 1, 1}, 1), blue);
    EXPECT_TRUE(world.features.patterns);
    EXPECT_TRUE(world.features.layers);
    EXPECT_TRUE(world.features.transmits);
}

TEST(Material, QuickColorsStandForTheTree) {
    Pigment pigment = checkered(solid(red), solid(green));
    pigment.quick_color = PigmentColor{blue};
    const World world = compiled({textured({plain(pigment)})});
    EXPECT_EQ(color_at(world, {0.5, 0.5, 0.5}, 0, true), blue);
    EXPECT_EQ(color_at(world, {0.5, 0.5, 0.5}, 0, false), red);
}

TEST(Material, EqualTexturesAreCompiledOnce) {
    std::vector<Object> objects;
    for (int i = 0; i < 1000; ++i) objects.push_back(textured({plain(solid(i % 2 ? red : green))}));
    World world = compiled(objects);
    EXPECT_EQ(world.materials.size(), 2u);
    EXPECT_EQ(world.objects[998].material, world.objects[0].material);
    EXPECT_NE(world.objects[999].material, world.objects[0].material);

    Finish other;
    other.conserve_energy = true;  // differs in a field that is easily forgotten
    objects.push_back(textured({plain(solid(red), other)}));
    EXPECT_EQ(compiled(objects).materials.size(), 3u);
    Interior glass;  // the reflectance of the general form depends on it
    glass.ior = 1.7;
    objects.push_back(textured({plain(solid(red))}));
    objects.back().interior = Shared<Interior>(glass);
    EXPECT_EQ(compiled(objects).materials.size(), 4u);
}

SurfaceFinish finish_of(const World& world) { return world.materials[world.objects[0].material].layers[0].finish; }

TEST(Finish, RoughnessBecomesAlpha) {
    const auto alpha = [](std::optional<double> roughness, AlphaMapping mapping) {
        Finish finish;
        finish.roughness = roughness;
        CompileOptions options;
        options.alpha = mapping;
        return finish_of(compiled({textured({plain(solid(red), finish)})}, options)).model.alpha;
    };
    EXPECT_DOUBLE_EQ(alpha(0.5, AlphaMapping::roughness2), 0.25);
    EXPECT_DOUBLE_EQ(alpha(0.5, AlphaMapping::direct), 0.5);
    EXPECT_DOUBLE_EQ(alpha(0.5, AlphaMapping::povray), std::sqrt(0.5));
    EXPECT_EQ(alpha(0.0, AlphaMapping::povray), 0.0);
    for (const AlphaMapping mapping : {AlphaMapping::roughness2, AlphaMapping::povray, AlphaMapping::direct})
        EXPECT_DOUBLE_EQ(alpha({}, mapping), std::sqrt(1.0 / 11.0));  // 0.30: POV-Ray's 0.05 by its own width, whatever the mapping
}

TEST(Finish, NormalReflectanceComesFromTheStatedIor) {
    const auto f0 = [](std::optional<double> interior_ior, std::optional<double> finish_ior) {
        Finish finish;
        finish.ior = finish_ior;
        Object object = textured({plain(solid(red), finish)});
        if (interior_ior) {
            Interior interior;
            interior.ior = interior_ior;
            object.interior = Shared<Interior>(interior);
        }
        return finish_of(compiled({object})).model.interface[0].f0;
    };
    EXPECT_DOUBLE_EQ(f0({}, {}), 0.04);
    EXPECT_DOUBLE_EQ(f0(2.0, {}), 1.0 / 9.0);
    EXPECT_DOUBLE_EQ(f0(2.0, 3.0), 0.25);
    EXPECT_DOUBLE_EQ(f0(0.0, {}), 0.04);  // accepted, says nothing
    EXPECT_DOUBLE_EQ(f0(1.0, {}), 0.0);
}

TEST(Finish, SpecularBeyondOneIsClampedWithOneWarning) {
    Finish finish;
    finish.specular = 2.5;
    std::vector<Object> objects = {textured({plain(solid(red), finish)})};
    finish.specular = -1.0;
    objects.push_back(textured({plain(solid(green), finish)}));
    std::vector<std::string> messages;
    const World world = compiled(objects, {}, &messages);
    EXPECT_EQ(finish_of(world).model.s, 1.0);
    EXPECT_EQ(finish_of(world).finish.specular, 2.5);
    EXPECT_EQ(world.materials[1].layers[0].finish.model.s, 0.0);
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_THAT(messages[0], HasSubstr("specular"));
    CompileOptions other_shading;
    other_shading.general_shading = false;
    messages.clear();
    compiled(objects, other_shading, &messages);
    EXPECT_TRUE(messages.empty());
}

TEST(Finish, ExponentAndReflectionAreDerived) {
    Finish finish;
    finish.roughness = 0.0;
    finish.reflection.max = {0, 0, 0.1};
    World world = compiled({textured({plain(solid(red), finish)})});
    EXPECT_EQ(finish_of(world).specular_exponent, 0.0);
    EXPECT_TRUE(finish_of(world).reflects);
    EXPECT_TRUE(world.materials[0].can_reflect);
    world = compiled({textured({plain(solid(red))})});
    EXPECT_DOUBLE_EQ(finish_of(world).specular_exponent, 20.0);
    EXPECT_FALSE(world.materials[0].can_reflect);
}

TEST(Interior, LegacyKeywordsOfTheTopLayerWin) {
    Finish bottom, top;
    bottom.ior = 1.3, bottom.refraction = 0.5;
    top.ior = 1.6, top.caustics = 3.0;
    Interior stated;
    stated.ior = 1.2, stated.caustics = 45.0, stated.fade_distance = 2.0, stated.fade_power = 1.0, stated.fade_color = green;
    Object object = textured({plain(solid(red, 0.9), bottom), plain(solid(red, 0.9), top)});
    object.interior = Shared<Interior>(stated);
    const World world = compiled({object});
    const CompiledInterior& interior = world.interiors[world.objects[0].interior];
    EXPECT_EQ(interior.ior, 1.6);
    EXPECT_EQ(interior.caustics, 3.0);
    EXPECT_EQ(interior.refraction, 1.0);
    EXPECT_EQ(interior.fade_distance, 2.0);
    EXPECT_EQ(interior.fade_color, green);
    EXPECT_TRUE(world.features.refracts);
    EXPECT_TRUE(world.features.fades);
}

TEST(Interior, ObjectsDoNotShareOneEvenIfTheyShareItsDeclaration) {
    // POV-Ray's rays tell two overlapping copies of a declared glass ball apart.
    const Shared<Interior> glass{Interior{1.5, 0.0, 0.0, 0.0, Rgb(0.0)}};
    Object object = textured({plain(solid(red, 0.9))});
    object.interior = glass;
    const World world = compiled({object, object});
    EXPECT_NE(world.objects[0].interior, world.objects[1].interior);
}

TEST(Interior, OpaqueObjectsWithoutOneShareTheFirst) {
    const World world = compiled({textured({plain(solid(red))}), textured({plain(solid(green))})});
    EXPECT_EQ(world.interiors.size(), 1u);
    EXPECT_EQ(world.objects[1].interior, 0u);
}

}  // namespace
}  // namespace rt::material_test
