// How many materials a scene's textures become.
#include "world/material_table.h"

#include <gtest/gtest.h>

#include <deque>

#include "tests/scene/checkers.h"

namespace rt::material_table_test {
namespace {

/// A checker of two colours: three pigments.
TextureLayers checkered() { return std::vector<Texture>{Texture{PlainTexture{checker_of(Pigment{}, Pigment{}), {}}}}; }

Object object(const TextureLayers& texture, double ior) {
    Object object;
    object.texture = texture;
    object.interior = Shared<Interior>(Interior{ior});
    return object;
}

class MaterialLimit : public testing::Test {
protected:
    Scene scene;
    CompileOptions options;
    MessageSink sink = [](std::string_view) {};
    MaterialTable table{scene, options, sink, 10};
    std::deque<Object> objects;  ///< the table looks back at them

    std::uint32_t add(const TextureLayers& texture, double ior) { return table.add(objects.emplace_back(object(texture, ior))); }
};

TEST_F(MaterialLimit, EqualTexturesCountOnce) {
    const TextureLayers shared = checkered();
    for (int i = 0; i < 100; ++i) EXPECT_EQ(add(shared, 1.5), 0u);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(add(checkered(), 1.5), 0u);
}

TEST_F(MaterialLimit, EachIndexOfRefractionMakesAMaterial) {
    const TextureLayers shared = checkered();
    for (int i = 0; i < 5; ++i) EXPECT_EQ(add(shared, 1.1 + i), static_cast<std::uint32_t>(i));
    EXPECT_THROW(add(shared, 9.0), LimitError);
}

TEST_F(MaterialLimit, OneColorCountsNothing) {
    const TextureLayers plain = std::vector<Texture>(1);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(add(plain, 1.1 + i), static_cast<std::uint32_t>(i));
}

/// A shape's textures are materials that other objects can have as well, and what they do the object does.
TEST_F(MaterialLimit, TexturesOfAShapeAreMaterialsOfTheirOwn) {
    PlainTexture glass, mirror;
    glass.pigment.content = PigmentColor{Rgb(1.0), 0.0, 0.5};
    mirror.finish.reflection.min = mirror.finish.reflection.max = Rgb(0.5);
    const TextureLayers plain = std::vector<Texture>(1), clear = std::vector<Texture>{Texture{glass}},
                        shiny = std::vector<Texture>{Texture{mirror}};
    const std::uint32_t alone = add(clear, 1.5);
    Object mesh = object(plain, 1.5);
    mesh.shape_textures = std::vector<TextureLayers>{clear, shiny, clear};
    const std::uint32_t index = table.add(objects.emplace_back(mesh));
    const Material material = table[index];
    ASSERT_EQ(material.shape_textures.size(), 4u);
    EXPECT_EQ(material.shape_textures[3], add(plain, 1.5)) << "the object's own";
    EXPECT_TRUE(material.layers.empty());
    EXPECT_EQ(material.shape_textures[0], alone);
    EXPECT_EQ(material.shape_textures[2], alone);
    EXPECT_TRUE(material.can_transmit);
    EXPECT_TRUE(material.can_reflect);
    EXPECT_TRUE(table[material.shape_textures[1]].can_reflect);
    EXPECT_FALSE(table[material.shape_textures[1]].can_transmit);
    EXPECT_EQ(table.add(objects.emplace_back(mesh)), index) << "equal lists are one";
    mesh.shape_textures = std::vector<TextureLayers>{clear, shiny};
    EXPECT_NE(table.add(objects.emplace_back(mesh)), index);
    EXPECT_NE(add(plain, 1.5), index) << "without them the texture is another material";
}

TEST(AlbedoTables, AreMadeOncePerLobeAndOnlyWhereTheyAreAskedFor) {
    Scene scene;
    CompileOptions options;
    const MessageSink sink = [](std::string_view) {};
    ModelChoice choice;
    choice.model.env = Surroundings::albedo;
    options.choose = [&](const Finish&) { return choice; };
    MaterialTable table(scene, options, sink);
    std::deque<Object> objects;
    const auto albedo = [&](double color, double ior, double specular) {
        PlainTexture shiny;
        shiny.pigment.content = PigmentColor{Rgb(color)};
        shiny.finish.specular = specular;
        const TextureLayers layers = std::vector<Texture>{Texture{shiny}};
        return table[table.add(objects.emplace_back(object(layers, ior)))].layers.front().finish.model.albedo;
    };
    const auto first = albedo(0.1, 1.5, 0.5);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(albedo(0.2, 1.5, 0.7), first) << "neither the colour nor s belongs to the lobe";
    EXPECT_NE(albedo(0.1, 1.6, 0.5), first);
    choice.alpha = 0.123;
    EXPECT_NE(albedo(0.3, 1.5, 0.5), first);
    EXPECT_EQ(albedo(0.1, 1.5, 0.0), nullptr) << "no highlight, no mirror";
    choice.alpha = 0.0;
    EXPECT_EQ(albedo(0.4, 1.5, 0.5), nullptr) << "a mirror has Fresnel's weight";
    choice.model.env = Surroundings::fresnel;
    choice.alpha = 0.2;
    EXPECT_EQ(albedo(0.5, 1.5, 0.5), nullptr);
}

}  // namespace
}  // namespace rt::material_table_test
