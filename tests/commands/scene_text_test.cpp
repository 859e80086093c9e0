// What is printed about a scene: sceneinfo, requires, choices in comments, metadata.
#include <gtest/gtest.h>

#include "commands/base/progress.h"
#include "commands/job/requirements.h"
#include "commands/job/scene_choices.h"
#include "commands/job/stats.h"
#include "commands/job/text.h"
#include "commands/pixel/course_text.h"
#include "core/source.h"
#include "tests/scene/checkers.h"

namespace rt::scene_text_test {
namespace {

TextureLayers plain(const Rgb& color, double ambient, double diffuse) {
    PlainTexture texture;
    texture.pigment.content = PigmentColor{color, 0.0, 0.0};
    texture.finish.ambient = Rgb(ambient);
    texture.finish.diffuse = diffuse;
    return std::vector<Texture>{Texture{texture}};
}

Object object(Shape shape, const TextureLayers& texture) {
    Object o;
    o.shape = std::move(shape);
    o.texture = texture;
    return o;
}

TEST(SceneInfo, FourDecimalsAsTheCoursePrintsThem) {
    Scene scene;
    scene.camera.location = Vec3(0, 0.00005, 14);
    scene.camera.right = Vec3(4.0 / 3.0, 0, 0);
    scene.camera.look_at = Vec3(0, -1, 0);
    scene.lights.emplace_back();
    scene.lights[0].location = Vec3(-100, 100, 100);
    scene.lights[0].color = Rgb(1.5);
    scene.objects.push_back(object(Sphere{Vec3(1, 2, 3), 2.0}, plain(Rgb(1, 0, 0.12345), 0.2, 0.4)));
    scene.objects.push_back(object(Plane{Vec3(0, 1, 0), -4.0}, plain(Rgb(0.2), 0.4, 0.8)));
    EXPECT_EQ(sceneinfo_text(scene),
              "Camera:\n"
              "- Location: {0.0000 0.0001 14.0000}\n"
              "- Up: {0.0000 1.0000 0.0000}\n"
              "- Right: {1.3333 0.0000 0.0000}\n"
              "- Look at: {0.0000 -1.0000 0.0000}\n"
              "\n---\n\n"
              "1 light(s)\n\n"
              "Light[0]:\n"
              "- Location: {-100.0000 100.0000 100.0000}\n"
              "- Color: {1.5000 1.5000 1.5000}\n"
              "\n---\n\n"
              "2 object(s)\n\n"
              "Object[0]:\n"
              "- Type: Sphere\n"
              "- Center: {1.0000 2.0000 3.0000}\n"
              "- Radius: 2.0000\n"
              "- Color: {1.0000 0.0000 0.1235}\n"
              "- Material:\n"
              "  - Ambient: 0.2000\n"
              "  - Diffuse: 0.4000\n"
              "\n"
              "Object[1]:\n"
              "- Type: Plane\n"
              "- Normal: {0.0000 1.0000 0.0000}\n"
              "- Distance: -4.0000\n"
              "- Color: {0.2000 0.2000 0.2000}\n"
              "- Material:\n"
              "  - Ambient: 0.4000\n"
              "  - Diffuse: 0.8000\n");
}

TEST(Requirements, CountShapesTrianglesAndLights) {
    Scene scene;
    MeshData mesh;
    mesh.faces.resize(5);
    const TextureLayers grey = plain(Rgb(0.5), 0.1, 0.6);
    scene.objects.push_back(object(Sphere{}, grey));
    scene.objects.push_back(object(Sphere{}, grey));
    scene.objects.push_back(object(Mesh{mesh}, grey));
    scene.objects.push_back(object(Triangle{}, grey));
    scene.lights.resize(3);
    scene.lights[1].type = Light::Type::spotlight;
    scene.lights[2].area = AreaLight{};
    scene.lights[2].shadowless = true;
    const Requirements needs = requirements_of(scene);
    EXPECT_EQ(needs.shapes, (std::map<std::string, std::size_t>{{"sphere", 2}, {"mesh", 1}, {"triangle", 1}}));
    EXPECT_EQ(needs.objects, 4u);
    EXPECT_EQ(needs.triangles, 6u);
    EXPECT_EQ(needs.lights, (std::map<std::string, std::size_t>{{"point", 1}, {"spotlight", 1}, {"shadowless area", 1}}));
    EXPECT_EQ(needs.features, (std::vector<std::string>{"area lights"}));
    EXPECT_EQ(needs.gamma, "none");
}

TEST(Requirements, NameEveryFeatureOfTexturesAndInteriors) {
    Scene scene;
    PlainTexture glass;
    glass.pigment.content = PigmentColor{Rgb(1.0), 0.9, 0.0};
    glass.finish.reflection.max = Rgb(0.2);
    glass.finish.reflection.fresnel = true;
    glass.finish.phong = 1.0;
    PlainTexture floor;
    floor.pigment = checker_of(Pigment{}, Pigment{});
    floor.finish.specular = 0.5;
    Object o = object(Sphere{}, std::vector<Texture>{Texture{floor}, Texture{glass}});
    Interior interior;
    interior.ior = 1.5;
    interior.fade_power = 2.0;
    o.interior = Shared<Interior>(interior);
    o.no_image = true;
    o.transform = Transform::translate(Vec3(1.0));
    scene.objects.push_back(o);
    EXPECT_EQ(requirements_of(scene).features,
              (std::vector<std::string>{"checker", "distance fading", "fresnel reflection", "layers", "no_image", "object transforms",
                                        "phong highlights", "reflection", "refraction", "specular highlights", "transparency"}));
}

TEST(Requirements, FollowTheChoicesOfTheScene) {
    const auto features = [](const std::vector<SceneOption>& options, double reflection) {
        Scene scene;
        scene.options = options;
        PlainTexture shiny;
        shiny.finish.specular = 0.5;
        shiny.finish.reflection.min = shiny.finish.reflection.max = Rgb(reflection);
        scene.objects.push_back(object(Sphere{}, std::vector<Texture>{Texture{shiny}}));
        return requirements_of(scene).features;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(features({}, 0.0), (Names{"specular highlights"}));
    EXPECT_EQ(features({{"env", "fresnel", {}}}, 0.0), (Names{"reflection", "specular highlights"}));
    EXPECT_EQ(features({{"env", "fresnel", {}}, {"s", "0", {}}}, 0.7), (Names{"specular highlights"}))
        << "replaced by a mirror of no weight";
    EXPECT_EQ(features({{"env", "fresnel", {}}, {"shading", "povray", {}}}, 0.0), (Names{"specular highlights"}));
    EXPECT_EQ(features({{"edges", "crease", {}}}, 0.0), (Names{"edge lines", "specular highlights"}));
}

TEST(Requirements, PlaceWhatIsNotModelled) {
    Scene scene;
    scene.sources.add({"main.pov", "camera {}\n  fog { distance 3 }\n"});
    scene.sources.add({"extra.inc", ""});
    scene.unmodelled.push_back({"fog", {0, 12, 15}});
    const Requirements needs = requirements_of(scene);
    ASSERT_EQ(needs.missing.size(), 1u);
    EXPECT_EQ(needs.missing[0].name, "fog");
    EXPECT_EQ(needs.missing[0].file, "main.pov");
    EXPECT_EQ(needs.missing[0].line, 2u);
    EXPECT_EQ(needs.missing[0].column, 3u);
    EXPECT_EQ(needs.includes, (std::vector<std::string>{"extra.inc"}));
}

class Choices : public testing::Test {
protected:
    Scene scene;
    RenderJob job;

    /// A scene whose whole text is one comment; each option stands at its own word.
    void state(const std::string& text, const std::vector<std::pair<std::string, std::string>>& options) {
        scene.sources.add({"a.pov", text});
        for (const auto& [key, value] : options) scene.options.push_back({key, value, span_of(text, key + "=" + value)});
    }
    static Span span_of(const std::string& text, const std::string& word) {
        const std::size_t at = text.find(word);
        return {0, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + word.size())};
    }
    void apply() { apply_scene_choices(scene, job); }
    std::string error() {
        try {
            apply();
        } catch (const SceneError& e) {
            return e.what();
        }
        return "accepted";
    }
};

TEST_F(Choices, AreDefaultsOfTheFile) {
    state("//! raytrace: shading=povray distances=scaled precision=fast",
          {{"shading", "povray"}, {"distances", "scaled"}, {"precision", "fast"}});
    apply();
    EXPECT_EQ(job.shading, ShadingModel::povray);
    EXPECT_EQ(job.distances, Distances::scaled);
    EXPECT_EQ(job.precision, Precision::fast);
}

TEST_F(Choices, TheCommandLineWins) {
    state("//! raytrace: shading=povray", {{"shading", "povray"}});
    job.shading = ShadingModel::general;
    apply();
    EXPECT_EQ(job.shading, ShadingModel::general);
}

TEST_F(Choices, WrongValuesAreNamedWithTheirPlace) {
    state("//! raytrace: shading=phongg", {{"shading", "phongg"}});
    EXPECT_EQ(error(),
              "File 'a.pov' line 1: Parse Error: shading: 'phongg' is unknown; expected one of povray, general, cook-torrance, phong, "
              "blinn-phong, ct-effects, ct-effects-linear, lecture, none\n"
              "   1 | //! raytrace: shading=phongg\n"
              "     |               ^^^^^^^^^^^^^^");
}

TEST_F(Choices, OfAFinishAreCheckedWithTheirPlace) {
    const auto finish = [&](const std::string& key, const std::string& value) {
        const std::string text = "finish { //! raytrace: " + key + "=" + value;
        scene = Scene();
        state(text, {});
        scene.finish_options = {{{key, value, span_of(text, key + "=" + value)}}};
        return error().substr(0, error().find('\n'));
    };
    const std::string place = "File 'a.pov' line 1: Parse Error: ";
    EXPECT_EQ(finish("alpha", "direct"), "accepted");
    EXPECT_EQ(finish("shading", "phong"), "accepted");
    EXPECT_EQ(finish("G", "smith"), place +
                                        "G: 'smith' is unknown; expected one of ggx, ggx-hc, cook-torrance, beckmann, beckmann-hc, "
                                        "beckmann-rational, none");
    EXPECT_EQ(finish("k", "-1"), place + "k: -1 is less than 0");
    EXPECT_EQ(finish("eta", "0"), place + "eta: expected an index of refraction above 0, not '0'");
    EXPECT_EQ(finish("eta", "1,2"), place + "eta: expected one number or three, not '1,2'");
    EXPECT_EQ(finish("alpha", "nan"), place + "alpha: 'nan' is unknown; expected roughness2, povray, direct or a number");
    EXPECT_EQ(finish("s", "1.5"), place + "s: 1.5 is outside 0 to 1");
    EXPECT_EQ(finish("preset", "gooch-ct"), "accepted");
    EXPECT_EQ(finish("preset", "phong-lights"),
              place + "preset: 'phong-lights' is for the whole picture, not for one finish: att=1+d+d2 is about all lamps");
    EXPECT_EQ(finish("precision", "fast"), place + "'precision' is for the whole picture, not for one finish");
    EXPECT_EQ(finish("shading", "povray"), place + "shading: 'povray' is for the whole picture, not for one finish");
}

TEST(Metadata, NamesProgramSceneAndOptionsButNotTheMachine) {
    RenderJob job;
    job.scene = "a.pov";
    job.shading = ShadingModel::povray;
    job.distances = Distances::povray;
    job.precision = Precision::exact;
    job.model = {{"alpha", "direct"}};
    job.region = Region{1, 2, 3, 4};
    job.threads = 7;
    const ImageMetadata metadata = picture_metadata(job, Scene());
    ASSERT_EQ(metadata.text.size(), 3u);
    EXPECT_EQ(metadata.text[0].first, "Software");
    EXPECT_EQ(metadata.text[0].second.find("raytrace "), 0u);
    EXPECT_EQ(metadata.text[1], (std::pair<std::string, std::string>{"Scene", "a.pov"}));
    EXPECT_EQ(metadata.text[2].second,
              "size=800x600 profile=povray shading=povray distances=povray precision=exact aa=none gamma=none alpha=direct crop=1,3,2,4");
    RenderJob other = job;
    other.threads = 1;
    EXPECT_EQ(picture_metadata(other, Scene()).text, metadata.text);
}

TEST(Progress, TellsShareRateAndTimeLeft) {
    EXPECT_EQ(progress_text(0.25, 5.0, 4e6), " 25 %  0.20 M pixels/s  0:15 left");
    EXPECT_EQ(progress_text(0.999, 1.0, 1e6), " 99 %  1.00 M pixels/s  0:01 left");
    EXPECT_EQ(progress_text(0.0, 0.0, 1e6), "  0 %  0.00 M pixels/s");
    EXPECT_EQ(progress_text(0.5, 3725.0, 1e6), " 50 %  0.00 M pixels/s  1:02:05 left");
}

}  // namespace
}  // namespace rt::scene_text_test
