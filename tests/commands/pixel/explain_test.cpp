// raytrace explain: faults planted by tracing changed scenes, and by editing what was traced, are called by their names.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "core/vec.h"
#include "tests/commands/support.h"

namespace rt::explain_test {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

std::string scene_text(const std::string& name) {
    if (name.empty()) return test::glass_scene;
    std::ostringstream text;
    text << std::ifstream(std::string(PROJECT_ROOT) + "/pov/" + name).rdbuf();
    return text.str();
}

std::string likely_cause(const std::string& out) {
    const std::string mark = "likely cause: ";
    const std::size_t begin = out.find(mark);
    return begin == out.npos ? out : out.substr(begin + mark.size(), out.find('\n', begin) - begin - mark.size());
}

/// A fault in a scene: its own text with `from` written as `to`, traced with further options.
struct Planted {
    std::string scene;  ///< of pov/; none: the course's, by its rules
    std::string from, to;
    int x, y;  ///< of 20 x 15
    std::string cause;
    Words options_a = {}, options_b = {};
    bool in_text = true;  ///< four decimals and no colours of surfaces still tell it
    friend std::ostream& operator<<(std::ostream& out, const Planted& p) { return out << p.cause << " in " << p.scene << ": " << p.to; }
};

class PlantedFaults : public testing::TestWithParam<Planted> {};

TEST_P(PlantedFaults, AreNamed) {
    const Planted& p = GetParam();
    test::Workplace here;
    const std::string right = scene_text(p.scene);
    std::string wrong = right;
    if (!p.from.empty()) {
        ASSERT_NE(right.find(p.from), std::string::npos);
        for (std::size_t at = wrong.find(p.from); at != wrong.npos; at = wrong.find(p.from, at + p.to.size()))
            wrong.replace(at, p.from.size(), p.to);
    }
    here.write("a.pov", right);
    here.write("b.pov", wrong);
    for (const Words& form : {Words{"printrays", "--json"}, Words{"pixeltrace", "--json"}, Words{"printrays"}, Words{"pixeltrace"}}) {
        if (form.size() == 1 && !p.in_text) continue;
        const auto trace = [&](const std::string& scene, const Words& options) {
            Words words{form[0], scene + ".pov", "20", "15", std::to_string(p.x), std::to_string(p.y)};
            words.insert(words.end(), form.begin() + 1, form.end());
            if (!p.scene.empty()) words.insert(words.end(), {"--profile=povray", "--shading=povray"});
            words.insert(words.end(), options.begin(), options.end());
            const Outcome outcome = run(words, scene + ".txt");
            EXPECT_EQ(outcome.status, 0) << outcome.err;
        };
        trace("a", p.options_a);
        trace("b", p.options_b);
        const Outcome outcome = run({"explain", "a.txt", "b.txt"});
        EXPECT_EQ(outcome.status, 1) << outcome.err;
        EXPECT_EQ(likely_cause(outcome.out), p.cause) << form[0] << form.size() << "\n" << outcome.out;
        EXPECT_EQ(run({"explain", "a.txt", "a.txt"}).out, "the same\n");
        std::filesystem::remove("a.txt");
        std::filesystem::remove("b.txt");
    }
}

INSTANTIATE_TEST_SUITE_P(
    InPovraysProfile, PlantedFaults,
    testing::Values(
        Planted{"trace_level.pov", "max_trace_level 4", "max_trace_level 3", 0, 0, "depth"},
        Planted{"transparency.pov", "rgbf <0.9, 0.3, 0.2, 0.8>", "rgb <0.9, 0.3, 0.2>", 0, 5, "missing or wrong filter"},
        Planted{
            "transparency.pov", "rgbf <0.9, 0.3, 0.2, 0.8>", "rgbt <0.9, 0.3, 0.2, 0.8>", 0, 5, "missing or wrong filter", {}, {}, false},
        Planted{"shadows.pov", "pigment { rgb <0.4, 0.5, 0.8> }", "pigment { rgb <0.4, 0.5, 0.8> } no_shadow", 18, 8, "missing shadow"},
        Planted{"finish_specular.pov", "light_source { <-6, 4, -3>, rgb <0.2, 0.3, 0.6> }", "", 1, 1, "missing light"},
        Planted{"finish_specular.pov", "roughness 0.2", "roughness 0.1", 9, 1, "wrong exponent"},
        Planted{"finish_phong.pov", "phong 0.7 phong_size 8", "", 8, 2, "missing highlight"},
        Planted{"finish_reflection.pov", "finish { reflection 0.6 }", "", 1, 1, "missing reflection"},
        Planted{"finish_reflection.pov", "ambient 0.05", "ambient 0", 2, 6, "missing or wrong ambient"},
        Planted{"texture_layers.pov", "ambient 0.1", "ambient 0", 5, 3, "missing or wrong ambient", {}, {}, false},
        Planted{"finish_reflection.pov", "diffuse 0.2", "diffuse 0.4", 2, 6, "wrong diffuse light"},
        Planted{"finish_reflection.pov", "rgb <0.9, 0.6, 0.2>", "rgb <0.9, 0.2, 0.6>", 2, 6, "wrong pigment"},
        Planted{"glass.pov", "ior 1.5", "ior 1.3", 18, 3, "wrong refraction ratio"},
        Planted{"total_reflection.pov", "ior 1.33", "ior 1", 0, 0, "total reflection", {}, {}, false},
        Planted{"camera_perspective.pov", "right x*4/3", "right -x*4/3", 0, 0, "mirrored", {}, {}, false},
        Planted{"camera_perspective.pov", "angle 48", "angle 50", 0, 0, "another camera"},
        Planted{"shape_transforms.pov", "object { Peg transform { Lean } translate <-0.9, -0.2, 0> }", "", 9, 1, "wrong object"},
        Planted{"shape_transforms.pov", "scale <0.6, -1.1, 1.5> rotate <0, 40, 15>", "rotate <0, 40, 15> scale <0.6, -1.1, 1.5>", 15, 6,
                "placement"},
        Planted{"glass_nested.pov", "background { rgb <0.5, 0.65, 0.9> }", "", 3, 4, "background"},
        Planted{"interior_fade.pov", "pigment { rgbf 1 }", "pigment { rgb 1 }", 1, 7, "missing or wrong filter"},
        Planted{"camera_perspective.pov", "", "", 3, 4, "gamma", {}, {"--file-gamma=1"}},
        Planted{"camera_perspective.pov", "", "", 3, 4, "another number of samples", {}, {"--ss=2"}}));

INSTANTIATE_TEST_SUITE_P(InTheCoursesProfile, PlantedFaults,
                         testing::Values(Planted{"", "plane { <0, 1, 0>, -2", "plane { <0, -1, 0>, 2", 0, 0, "wrong normal side"},
                                         Planted{"", "rgbf <1, 0.5, 0.25, 0.75>", "rgb <1, 0.5, 0.25>", 8, 0, "missing or wrong filter"},
                                         Planted{"", "", "", 8, 0, "missing or wrong filter", {}, {"-beers"}},
                                         Planted{"", "", "", 8, 0, "missing or wrong Fresnel reflectance", {"-fresnel"}, {}},
                                         Planted{"", "reflection 0.25", "", 8, 0, "missing reflection"},
                                         Planted{"", "ior 1.5", "ior 0.66666667", 9, 6, "wrong refraction ratio"},
                                         Planted{"", "light_source { <5, 3, 2> color rgb 0.5 }", "", 0, 0, "missing light"},
                                         Planted{"", "roughness 0.1", "roughness 0.3", 11, 8, "wrong exponent"}));

/// A fault that no scene can have: what was traced, edited.
struct Edit {
    std::string cause;
    std::function<void(json&)> change;
    friend std::ostream& operator<<(std::ostream& out, const Edit& e) { return out << e.cause; }
};

json scaled(const json& v, double k) { return {v[0].get<double>() * k, v[1].get<double>() * k, v[2].get<double>() * k}; }

json& ray(json& tree, std::size_t i) { return tree["samples"][0][i]; }

/// The ray that goes on through the first surface.
json& transmitted(json& tree) {
    for (json& candidate : tree["samples"][0])
        if (candidate["parent"] == 0 && candidate["kind"] == "refracted") return candidate;
    throw std::runtime_error("no transmitted ray");
}

/// Through the point of the picture that is (dx, dy) pixels away.
void shift(json& tree, double dx, double dy, double sign_x = 1.0, double sign_y = 1.0) {
    const auto vector = [](const json& v) { return Vec3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>()); };
    const json& camera = tree["camera"];
    const double u = sign_x * ((tree["pixel"]["x"].get<double>() + 0.5 + dx) / 20.0 - 0.5);
    const double v = sign_y * ((tree["pixel"]["y"].get<double>() + 0.5 + dy) / 15.0 - 0.5);
    const Vec3 d = unit(vector(camera["direction"]) + u * vector(camera["right"]) + v * vector(camera["up"]));
    ray(tree, 0)["direction"] = {d.x, d.y, d.z};
}

class EditedTrees : public testing::TestWithParam<Edit> {};

TEST_P(EditedTrees, AreExplained) {
    test::Workplace here;
    here.write("a.pov", test::glass_scene);
    ASSERT_EQ(run({"pixeltrace", "a.pov", "20", "15", "9", "6", "--json"}, "a.json").status, 0);
    json tree = json::parse(here.read("a.json"));
    GetParam().change(tree);
    here.write("b.json", tree.dump());
    const Outcome outcome = run({"explain", "a.json", "b.json"});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(likely_cause(outcome.out), GetParam().cause) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(
    OfRays, EditedTrees,
    testing::Values(Edit{"half a pixel off", [](json& t) { shift(t, -0.5, -0.5); }},
                    Edit{"mirrored", [](json& t) { shift(t, 0, 0, -1.0); }},
                    Edit{"upside down", [](json& t) { shift(t, 0, 0, 1.0, -1.0); }},
                    Edit{"mirrored",
                         [](json& t) {  // without a camera, by the sign of one coordinate
                             ray(t, 0)["direction"][0] = -ray(t, 0)["direction"][0].get<double>();
                         }},
                    Edit{"missing normalisation", [](json& t) { ray(t, 0)["direction"] = scaled(ray(t, 0)["direction"], 1.25); }},
                    Edit{"offset", [](json& t) { transmitted(t)["origin"] = ray(t, 0)["hit"]["point"]; }},
                    Edit{"offset",
                         [](json& t) {  // the mirrored ray meets the surface that it comes from
                             json hit = ray(t, 0)["hit"];
                             hit["t"] = 1e-7;
                             ray(t, 1)["end"] = "surface";
                             ray(t, 1)["hit"] = hit;
                         }},
                    Edit{"wrong mirror direction", [](json& t) { ray(t, 1)["direction"] = scaled(ray(t, 1)["direction"], -1.0); }},
                    Edit{"missed object",
                         [](json& t) {
                             ray(t, 0)["end"] = "background";
                             t["samples"][0] = {ray(t, 0)};
                         }},
                    Edit{"distance in object space", [](json& t) { ray(t, 0)["hit"]["t"] = ray(t, 0)["hit"]["t"].get<double>() * 1.5; }},
                    Edit{"far intersection", [](json& t) {
                             for (const char* name : {"t", "point", "normal"}) ray(t, 0)["hit"][name] = transmitted(t)["hit"][name];
                             ray(t, 0)["hit"]["t"] = 8.0;
                         }}));

INSTANTIATE_TEST_SUITE_P(
    OfSurfacesAndLight, EditedTrees,
    testing::Values(Edit{"missing normalisation", [](json& t) { ray(t, 0)["hit"]["normal"] = scaled(ray(t, 0)["hit"]["normal"], 0.5); }},
                    Edit{"wrong normal side",
                         [](json& t) { transmitted(t)["hit"]["normal"] = scaled(transmitted(t)["hit"]["normal"], -1.0); }},
                    Edit{"wrong normal",
                         [](json& t) {
                             ray(t, 0)["hit"]["normal"] = {1, 0, 0};
                         }},
                    Edit{"false shadow",
                         [](json& t) {
                             ray(t, 0)["hit"]["shadows"][0]["transmitted"] = {0, 0, 0};
                         }},
                    Edit{"background",
                         [](json& t) {
                             ray(t, 1)["background"] = {0.5, 0.5, 0.5};
                         }},
                    Edit{"clamp",
                         [](json& t) {
                             ray(t, 0)["radiance"] = {1.5, 0.5, 0.5};
                             std::ofstream("a.json") << t.dump();
                             ray(t, 0)["radiance"] = {1.0, 0.5, 0.5};
                         }},
                    Edit{"missing part of the sum",
                         [](json& t) {
                             for (std::size_t c = 0; c < 3; ++c)
                                 ray(t, 0)["radiance"][c] =
                                     ray(t, 0)["radiance"][c].get<double>() - ray(t, 0)["refraction"][c].get<double>();
                         }},
                    Edit{"missing or wrong filter",
                         [](json& t) {
                             transmitted(t)["factor"] = {0.75, 0.75, 0.75};
                         }},
                    Edit{"rounding", [](json& t) { t["pixel"]["color"][0] = t["pixel"]["color"][0].get<int>() - 1; }},
                    Edit{"another pixel", [](json& t) { t["pixel"]["x"] = 10; }}));

class Explain : public testing::Test {
protected:
    Explain() {
        here.write("a.pov", test::glass_scene);
        EXPECT_EQ(run({"pixeltrace", "a.pov", "20", "15", "9", "6", "--json"}, "a.json").status, 0);
        EXPECT_EQ(run({"printrays", "a.pov", "20", "15", "9", "6"}, "list.txt").status, 0);
        EXPECT_EQ(run({"pixeltrace", "a.pov", "20", "15", "9", "6"}, "tree.txt").status, 0);
    }
    /// The first line of the complaint about a file with `text`.
    std::string complaint(const std::string& name, const std::string& text) const {
        here.write(name, text);
        const Outcome outcome = run({"explain", "a.json", name});
        EXPECT_EQ(outcome.status, 4);
        EXPECT_EQ(outcome.out, "");
        return outcome.err.substr(0, outcome.err.find('\n'));
    }
    std::string replaced(const std::string& file, const std::string& from, const std::string& to) const {
        std::string text = here.read(file);
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return text.replace(text.find(from), from.size(), to);
    }
    test::Workplace here;
};

TEST_F(Explain, AllFormsOfOneRecordAreTheSame) {
    for (const char* a : {"a.json", "list.txt", "tree.txt"}) {
        for (const char* b : {"a.json", "list.txt", "tree.txt"}) {
            const Outcome outcome = run({"explain", a, b});
            EXPECT_EQ(outcome.status, 0) << a << " " << b << outcome.out << outcome.err;
            EXPECT_EQ(outcome.out, "the same\n");
        }
    }
}

TEST_F(Explain, NamesTheFieldAndTheRay) {
    here.write("b.txt", replaced("list.txt", "0.7500 Transmission", "0.0000 Transmission"));
    EXPECT_EQ(run({"explain", "list.txt", "b.txt"}).out,
              "first difference: contributions of sample 1, ray 1 (camera)\n"
              "  A  0.1875 local, 0.0625 reflection, 0.75 transmission\n"
              "  B  0.1875 local, 0.0625 reflection, 0 transmission\n"
              "likely cause: missing or wrong filter\n"
              "B lacks what a transparent surface lets through: the filter's share, or the colour that it puts on the light.\n");
    EXPECT_EQ(run({"explain", "-q", "list.txt", "b.txt"}).out, "");
    EXPECT_EQ(run({"explain", "-q", "list.txt", "b.txt"}).status, 1);
}

TEST_F(Explain, TheToleranceDecides) {
    here.write("b.txt", replaced("list.txt", "0.1875 Local", "0.1885 Local"));
    EXPECT_EQ(run({"explain", "list.txt", "b.txt"}).status, 1);
    EXPECT_EQ(run({"explain", "--tolerance", "0.002", "list.txt", "b.txt"}).status, 0);
    EXPECT_EQ(run({"explain", "--tolerance", "-1", "list.txt", "b.txt"}).status, 4);
}

TEST_F(Explain, MistakesInTextsHaveLineAndColumn) {
    EXPECT_EQ(complaint("b.txt", "Pixel: [9, 6] Color: (1, 2, x)\n"),
              "File 'b.txt' line 1: Parse Error: Expected a whole number, 'x)' found instead.");
    EXPECT_EQ(complaint("b.txt", ""), "File 'b.txt' line 1: Parse Error: Expected 'Pixel:', the end of the text found instead.");
    EXPECT_EQ(complaint("b.txt", "Pixel: [9, 6] Color: (1, 2, 3)\n----\n  Iteration type: Tertiary\n"),
              "File 'b.txt' line 3: Parse Error: Expected 'Primary', 'Tertiary' found instead.");
    EXPECT_EQ(complaint("b.txt", replaced("list.txt", "Specular:", "Speculum:")).substr(0, 80),
              "File 'b.txt' line 12: Parse Error: Expected a line of printrays or pixeltrace, '");
    EXPECT_EQ(complaint("b.txt", replaced("tree.txt", "Light[0] arrives", "Light[0] maybe")).substr(18),
              "15: Parse Error: Expected 'arrives' or 'is hidden', 'maybe' found instead.");
    const std::string begin = "Pixel: [9, 6] Color: (1, 2, 3)\n----\n  Iteration type: Primary\n";
    EXPECT_EQ(complaint("b.txt", begin + "  Ray: {0 0 0} -> {0 0 1}\n"),
              "File 'b.txt' line 5: Parse Error: Expected 'Intersection' or 'No intersection.' in the ray above, the end of the text found "
              "instead.");
    EXPECT_EQ(complaint("b.txt", begin + "  No intersection.\n"),
              "File 'b.txt' line 5: Parse Error: Expected 'Ray' in the ray above, the end of the text found instead.");
    EXPECT_EQ(complaint("b.txt", begin + "  Normal: {0 1 0}\n"),
              "File 'b.txt' line 4: Parse Error: Expected 'Hit Object' before this, ' {0 1 0}' found instead.");
    here.write("b.txt", replaced("list.txt", "0.1875 Local", "much Local"));
    EXPECT_NE(run({"explain", "a.json", "b.txt"}).err.find("|    Contributions: much Local"), std::string::npos)
        << run({"explain", "a.json", "b.txt"}).err;
}

TEST_F(Explain, MistakesInJsonHaveLineAndColumn) {
    EXPECT_EQ(complaint("b.json", "{\n  \"format\": ,\n"),
              "File 'b.json' line 2: Parse Error: syntax error while parsing value - unexpected ','; expected '[', '{', or a literal");
    EXPECT_EQ(complaint("b.json", "{\n  \"format\": 1e999 }"),
              "File 'b.json' line 2: Parse Error: Expected a number of double precision, 1e999 found instead.");
    EXPECT_EQ(complaint("b.json", "{\n  \"format\": \"other\" }"),
              "File 'b.json' line 2: Parse Error: Expected \"raytrace ray tree 1\", \"other\" found instead.");
    EXPECT_EQ(complaint("b.json", "{\n  \"format\": \"raytrace ray tree 1\" }").substr(0, 62),
              "File 'b.json' line 1: Parse Error: Expected a member \"pixel\", ");
    EXPECT_EQ(complaint("b.json", replaced("a.json", "\"kind\":\"refracted\"", "\"kind\":\"bent\"")),
              "File 'b.json' line 15: Parse Error: Expected a kind of ray, \"bent\" found instead.");
    EXPECT_EQ(complaint("b.json", replaced("a.json", "\"parent\":0", "\"parent\":7")),
              "File 'b.json' line 13: Parse Error: Expected the place of a ray before that meets a surface, 7 found instead.");
    EXPECT_EQ(complaint("b.json", replaced("a.json", "\"level\":1,\"weight\":1.0,\"origin\":[0.0", "\"origin\":[\"Infinite\"")),
              "File 'b.json' line 12: Parse Error: Expected a number, \"Infinity\", \"-Infinity\" or \"NaN\", \"Infinite\" found instead.");
}

TEST_F(Explain, WrongCommandLinesAreFour) {
    EXPECT_EQ(run({"explain", "a.json"}).status, 4);
    EXPECT_EQ(run({"explain", "a.json"}).err, "raytrace: explain: expected two records of a pixel; see raytrace explain --help\n");
    EXPECT_EQ(run({"explain", "a.json", "none.json"}).err, "raytrace: cannot read 'none.json'\n");
    EXPECT_EQ(run({"explain", "--tolerence=1", "a.json", "a.json"}).err,
              "raytrace: unknown option '--tolerence'; did you mean '--tolerance'?\n");
}

}  // namespace
}  // namespace rt::explain_test
