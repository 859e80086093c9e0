// How many materials a scene's textures become.
#include "world/material_table.h"

#include <gtest/gtest.h>

#include <deque>

namespace rt {
namespace {

/// A checker of two colours: three pigments.
TextureLayers checkered() {
    Pigment pigment;
    pigment.content = CheckerPigment{{Pigment{}, Pigment{}}};
    return std::vector<Texture>{Texture{PlainTexture{pigment, {}}}};
}

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

}  // namespace
}  // namespace rt
