// Textures of the parts of a shape, mixed by their weights where the shape says so.
#include <gtest/gtest.h>

#include "tests/trace/tracer_scene.h"

namespace rt::shape_textures_test {
namespace {

using namespace tracer_test;

constexpr double exact = 1e-12;
constexpr std::uint32_t of_object = TextureWeight::of_object;

TextureLayers layers(const PigmentColor& c, const Finish& finish = plain(Rgb(1.0))) { return std::vector<Texture>{texture(c, finish)}; }

/// The triangle (0, 0), (4, 0), (0, 4) before the z axis, with what its corners show, and the textures they choose from.
Object face(const std::vector<std::uint32_t>& numbers, std::vector<TextureLayers> textures,
            const TextureLayers& own = layers(color({1, 1, 1}))) {
    MeshData data;
    data.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    data.faces = {{0, 1, 2}};
    Object mesh = object(Mesh{data, Shared<FaceTextures>({numbers.size() == 3, numbers})}, *own);
    mesh.shape_textures = std::move(textures);
    return mesh;
}

const std::vector<TextureLayers> red_green_blue{layers(color({1, 0, 0})), layers(color({0, 1, 0})), layers(color({0, 0, 1}))};
const Vec3 ahead{0, 0, 1};

TEST(ShapeTextures, AFaceShowsItsTextureWholly) {
    EXPECT_RGB_NEAR(Traced(scene_with({face({1}, red_green_blue)})).look({1, 1, -5}, ahead).rgb, Rgb(0, 1, 0), exact);
    EXPECT_RGB_NEAR(Traced(scene_with({face({of_object}, red_green_blue)})).look({1, 1, -5}, ahead).rgb, Rgb(1, 1, 1), exact);
}

TEST(ShapeTextures, CornersAreMixedByTheirWeights) {
    Traced t(scene_with({face({0, 1, 2}, red_green_blue)}));
    EXPECT_RGB_NEAR(t.look({1, 2, -5}, ahead).rgb, Rgb(0.25, 0.25, 0.5), exact);
    EXPECT_RGB_NEAR(t.look({0.5, 1, -5}, ahead).rgb, Rgb(0.625, 0.125, 0.25), exact);
    Traced with_own(scene_with({face({0, of_object, 0}, red_green_blue)}));
    EXPECT_RGB_NEAR(with_own.look({1, 2, -5}, ahead).rgb, Rgb(1, 0.25, 0.25), exact);
}

TEST(ShapeTextures, AWeightBelowTheBailoutIsLost) {
    Scene scene = scene_with({face({0, 1, 2}, red_green_blue)});
    scene.settings.adc_bailout = 0.3;
    Traced t(scene);
    EXPECT_RGB_NEAR(t.look({1, 2, -5}, ahead).rgb, Rgb(0, 0, 0.5), exact);
    EXPECT_RGB_NEAR(t.look({1.3, 1.3, -5}, ahead).rgb, Rgb(0.35, 0.325, 0.325), exact);
    scene.settings.adc_bailout = 0.6;
    const Radiance nothing = Traced(scene).look({1, 2, -5}, ahead);
    EXPECT_RGB_NEAR(nothing.rgb, Rgb(0.0), exact);
    EXPECT_EQ(nothing.transmittance, 0.0);
    TraceOptions low = povray_options();
    low.adc_bailout = 0.1;
    EXPECT_RGB_NEAR(Traced(scene, low).look({1, 2, -5}, ahead).rgb, Rgb(0.25, 0.25, 0.5), exact) << "the option counts";
}

TEST(ShapeTextures, AMixtureLetsThroughWhatItsTexturesDo) {
    const std::vector<TextureLayers> textures{layers(color({1, 0, 0})), layers(color({0, 0, 0}, 0.0, 1.0), plain())};
    Traced t(scene_with({face({0, 1, 1}, textures)}, {}, {0.5, 0.5, 1.0}));
    const Radiance seen = t.look({1, 2, -5}, ahead);
    EXPECT_RGB_NEAR(seen.rgb, Rgb(0.25 + 0.75 * 0.5, 0.75 * 0.5, 0.75), exact);
    EXPECT_NEAR(seen.transmittance, 0.0, exact) << "the background is opaque";
}

/// One ray goes on behind a mixture, or there would be 3^n of them behind n surfaces.
TEST(ShapeTextures, TransparentMixturesDoNotMultiplyTheRays) {
    const PigmentColor red = color({1, 0, 0}, 0.0, 0.5), green = color({0, 1, 0}, 0.0, 0.5), blue = color({0, 0, 1}, 0.0, 0.5);
    std::vector<Object> faces(6, face({0, 1, 2}, {layers(red), layers(green), layers(blue)}));
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].transform = Transform::translate({0, 0, static_cast<double>(i)});
    Traced t(scene_with(faces, {}, {0, 0, 64}));
    const Ray ray{{1, 2, -5}, ahead};
    RayLog log;
    const Radiance seen = t.tracer->camera_ray(ray, log);
    const double shown = 1.0 - std::pow(0.5, 6);
    EXPECT_RGB_NEAR(seen.rgb, Rgb(0.25 * shown, 0.25 * shown, 0.5 * shown + 1.0), exact);
    EXPECT_EQ(t.tracer->counts().refracted, faces.size());
    EXPECT_EQ(log.nodes.size(), 1 + faces.size());
    EXPECT_RGB_NEAR(log.nodes.front().radiance, seen.rgb, exact);
    EXPECT_EQ(t.tracer->camera_ray(ray).rgb, seen.rgb);
}

/// Each adds nothing to the stack: the way goes on behind the texture that has nearly all of the light.
TEST(ShapeTextures, MixturesThatPartCanBeMany) {
    Finish mirror = plain();
    mirror.reflection.min = mirror.reflection.max = Rgb(1e-9);
    PatternTexture mixture;
    mixture.pattern.pattern = make_pattern(PatternKind::gradient);
    mixture.map = TextureMap{{0.0, 1.0}, {layers(color(Rgb(0.0), 0.0, 1.0), plain()), layers(color(Rgb(0.0), 0.0, 1.0), mirror)}};
    Texture seen;
    seen.content = Shared<PatternTexture>(mixture);
    std::vector<Object> discs(9000, object(Disc{{0, 0, 0}, {0, 0, 1}, 100.0, 0.0}, {seen}));
    for (std::size_t i = 0; i < discs.size(); ++i) discs[i].transform = Transform::translate({0, 0, 0.01 * static_cast<double>(i)});
    Scene scene = scene_with(discs, {}, {1, 2, 4});
    scene.settings.adc_bailout = 0.9999e-5;  // enough for the lesser texture, but for few of its surfaces
    Traced t(scene);
    const Rgb light = t.look({1e-5, 0.3, -5}, ahead).rgb;
    EXPECT_NEAR(light.r, std::pow(1.0 - 1e-5, 9000), 2e-3);
    EXPECT_NEAR(light.b, 4.0 * light.r, exact);
}

/// Where their mirrors or bumps part them they still go on alone.
TEST(ShapeTextures, AMirrorAmongTheTexturesReflectsItsShare) {
    Finish mirror = plain();
    mirror.reflection.min = mirror.reflection.max = Rgb(0.5);
    const std::vector<TextureLayers> textures{layers(color({0, 0, 0}), mirror), layers(color({0, 0, 0}, 0.0, 0.5), plain())};
    Traced t(scene_with({face({0, 1, 1}, textures)}, {}, {1, 2, 4}));
    EXPECT_RGB_NEAR(t.look({1, 2, -5}, ahead).rgb, (0.25 * 0.5 + 0.75 * 0.5) * Rgb(1, 2, 4), exact);
}

/// Measured: what has too little weight neither lets light pass nor stops it, and the rest counts by the square of its weight.
TEST(ShapeTextures, AMixtureCastsAMixedShadow) {
    const std::vector<TextureLayers> textures{layers(color({0, 0, 0})), layers(color({0.5, 1, 0.5}, 1.0)),
                                              layers(color({0, 0, 0}, 0.0, 0.5))};
    Object mesh = face({0, 1, 2}, textures);
    mesh.no_image = true;
    Light sun = point_light({1, 2, -1e6});
    sun.parallel = true;
    sun.point_at = {1, 2, 0};
    Scene scene = scene_with({mesh, object(Plane{{0, 0, -1}, -2.0}, texture(color(Rgb(1.0)), plain(Rgb(0.0), 1.0)))}, {sun});
    const auto lit = [&] { return Traced(scene).look({1, 2, -5}, ahead).rgb; };
    EXPECT_RGB_NEAR(lit(), Rgb(0.25 * 0.5 + 0.5 * 0.5, 0.25 + 0.5 * 0.5, 0.25 * 0.5 + 0.5 * 0.5), exact);
    scene.settings.adc_bailout = 0.3;
    EXPECT_RGB_NEAR(lit(), Rgb(0.5 * 0.5 * 0.5), exact);
}

TEST(ShapeTextures, TheInteriorTextureHidesThem) {
    Object mesh = face({0, 1, 2}, red_green_blue);
    mesh.interior_texture = layers(color({0.25, 0.5, 0.75}));
    Traced t(scene_with({mesh}));
    EXPECT_RGB_NEAR(t.look({1, 2, -5}, ahead).rgb, Rgb(0.25, 0.25, 0.5), exact);
    EXPECT_RGB_NEAR(t.look({1, 2, 5}, -ahead).rgb, Rgb(0.25, 0.5, 0.75), exact);
    mesh.interior_texture.reset();
    EXPECT_RGB_NEAR(Traced(scene_with({mesh})).look({1, 2, 5}, -ahead).rgb, Rgb(0.25, 0.25, 0.5), exact);
}

TEST(ShapeTextures, APatternOfTexturesMayBeOneOfThem) {
    PatternTexture halves;
    halves.pattern.pattern = make_pattern(PatternKind::checker);
    halves.map = TextureMap{{0.0, 1.0}, {layers(color({1, 0, 0})), layers(color({0, 1, 0}))}};
    const std::vector<TextureLayers> textures{std::vector<Texture>{Texture{Shared<PatternTexture>(halves)}}, layers(color({0, 0, 1}))};
    Traced t(scene_with({face({0, 1, 1}, textures)}));
    const Rgb even = t.look({1.5, 1.5, -5}, ahead).rgb, odd = t.look({0.5, 1.5, -5}, ahead).rgb;
    EXPECT_DOUBLE_EQ(even.b, 0.75);
    EXPECT_DOUBLE_EQ(odd.b, 0.5);
    EXPECT_DOUBLE_EQ(std::fmax(even.r, even.g), 0.25);
    EXPECT_DOUBLE_EQ(std::fmax(odd.r, odd.g), 0.5);
    EXPECT_NE(even.r > 0.0, odd.r > 0.0);
}

TEST(ShapeTextures, PatternsSeeTheFacesOwnCoordinates) {
    PlainTexture along{checker(color({1, 0, 0}), color({0, 1, 0})), plain(Rgb(1.0))};
    along.uv_mapping = true;
    const TextureLayers mapped = std::vector<Texture>{Texture{along}};
    Object mesh = face({0}, {mapped});
    MeshData& data = std::get<Mesh>(mesh.shape).data.edit();
    data.uvs = {{0.5, 0.5}, {2.5, 0.5}, {0.5, 2.5}};
    data.uv_faces = {{0, 1, 2}};
    Traced t(scene_with({mesh}));
    const Rgb first = t.look({0.5, 0.5, -5}, ahead).rgb, second = t.look({1.5, 0.5, -5}, ahead).rgb,
              third = t.look({1.5, 1.5, -5}, ahead).rgb;
    EXPECT_RGB_NEAR(first, third, exact);
    EXPECT_GT(glm::length(first - second), 1.0);
}

}  // namespace
}  // namespace rt::shape_textures_test
