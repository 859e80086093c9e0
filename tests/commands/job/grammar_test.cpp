// Command lines in every dialect and the jobs they mean.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "commands/base/names.h"
#include "commands/job/render_arguments.h"
#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::grammar_test {
namespace {

using Words = std::vector<std::string>;

RenderJob job_of(const Words& words) {
    std::string help;
    std::optional<RenderJob> job = parse_render_arguments(words, help);
    if (!job) throw std::runtime_error("asked for help");
    return *job;
}

std::string error_of(const Words& words) {
    try {
        job_of(words);
    } catch (const OptionError& error) {
        return error.what();
    }
    return "accepted";
}

/// What differs from a plain `raytrace scene.pov`, in a fixed order.
std::string summary(const RenderJob& job) {
    std::string text = job.scene;
    const RenderJob plain;
    const auto add = [&](bool differs, const std::string& words) {
        if (differs) text += " " + words;
    };
    add(job.width != 800 || job.height != 600, fmt::format("{}x{}", job.width, job.height));
    add(!job.output.name.empty(), fmt::format("{}={}", job.output.povray_rules ? "+O" : "-o", job.output.name));
    add(job.output.format.has_value(), "format=" + std::string(name_of(format_names, job.output.format.value_or(ImageFormat::png))));
    add(!job.output.to_file, "nofile");
    add(job.bits.has_value(), fmt::format("bits={}", job.bits.value_or(0)));
    if (job.region) text += fmt::format(" region={},{},{},{}", job.region->x0, job.region->x1, job.region->y0, job.region->y1);
    add(job.threads != 0, fmt::format("threads={}", job.threads));
    const Sampling& s = job.sampling;
    if (s.method == Sampling::Method::grid) text += fmt::format(" grid={}", s.depth);
    if (s.method == Sampling::Method::povray1 || s.method == Sampling::Method::povray2)
        text += fmt::format(" aa={},{},{}", s.method == Sampling::Method::povray1 ? 1 : 2, s.threshold, s.depth);
    add(s.gamma != 2.5, fmt::format("aagamma={}", s.gamma));
    add(s.block != 32, fmt::format("block={}", s.block));
    if (job.povray_quality) text += fmt::format(" quality={}", *job.povray_quality);
    if (job.shading) text += fmt::format(" shading={}", name_of(shading_names, *job.shading));
    if (job.distances) text += fmt::format(" distances={}", name_of(distances_names, *job.distances));
    if (job.precision) text += fmt::format(" precision={}", name_of(precision_names, *job.precision));
    for (const ModelOption& option : job.model) text += fmt::format(" {}={}", option.key, option.value);
    add(job.index != IndexKind::automatic, fmt::format("index={}", name_of(index_names, job.index)));
    add(job.profile != Profile::povray, fmt::format("profile={}", name_of(profile_names, job.profile)));
    add(job.file_gamma.kind != Curve::Kind::srgb, fmt::format("gamma={}", job.file_gamma.power));
    add(job.output_alpha, "alphachannel");
    add(job.dither, "dither");
    for (const std::string& path : job.parse.library_paths) text += " L=" + path;
    for (const auto& [name, value] : job.parse.declares) text += " " + name + ":=" + value;
    add(job.parse.frame.clock_on, fmt::format("clock={}", job.parse.clock));
    if (job.animation) text += fmt::format(" frames={}-{}", job.animation->first, job.animation->last);
    add(job.parse.version != 0.0, fmt::format("version={}", job.parse.version));
    add(job.parse.lenient, "lenient");
    add(job.quiet, "quiet");
    add(job.stats, "stats");
    add(!job.progress, "noprogress");
    for (const std::string& note : job.notes) text += " (" + note + ")";
    return text;
}

const std::string as_minus_j = "(anti-aliasing is rendered without jitter, as with -J)";
const std::string no_jitter = "(jitter is not available in this version: anti-aliasing is rendered as with -J)";

struct Line {
    Words words;
    std::string meaning;
};

class Grammar : public testing::TestWithParam<Line> {};

TEST_P(Grammar, Means) { EXPECT_EQ(summary(job_of(GetParam().words)), GetParam().meaning); }

INSTANTIATE_TEST_SUITE_P(
    Gnu, Grammar,
    testing::Values(Line{{"a.pov"}, "a.pov"},                                                          //
                    Line{{"./render"}, "./render.pov"},                                                //
                    Line{{"dir/a"}, "dir/a.pov"},                                                      //
                    Line{{"a.pov", "-W", "64", "-H", "48"}, "a.pov 64x48"},                            //
                    Line{{"-W", "64", "a.pov", "--height=48"}, "a.pov 64x48"},                         //
                    Line{{"--size", "64x48", "a.pov"}, "a.pov 64x48"},                                 //
                    Line{{"--size=64X48", "a.pov"}, "a.pov 64x48"},                                    //
                    Line{{"-W", "64", "-W", "32", "a.pov"}, "a.pov 32x600"},                           //
                    Line{{"a.pov", "-o", "b.exr"}, "a.pov -o=b.exr"},                                  //
                    Line{{"a.pov", "--outfile=b.png"}, "a.pov -o=b.png"},                              //
                    Line{{"a.pov", "-o", "+W64"}, "a.pov -o=+W64"},                                    //
                    Line{{"a.pov", "--format", "tiff", "--bits", "16"}, "a.pov format=tiff bits=16"},  //
                    Line{{"a.pov", "-t", "2"}, "a.pov threads=2"},                                     //
                    Line{{"a.pov", "-t2", "-q"}, "a.pov threads=2 quiet"},                             //
                    Line{{"a.pov", "--stats", "--lenient"}, "a.pov lenient stats"},                    //
                    Line{{"a.pov", "-ss=3"}, "a.pov grid=3"},                                          //
                    Line{{"a.pov", "-ss", "2"}, "a.pov grid=2"},                                       //
                    Line{{"a.pov", "--ss=1"}, "a.pov"},                                                //
                    Line{{"a.pov", "--aa", "2,0.1,4"}, "a.pov aa=2,0.1,4"},                            //
                    Line{{"a.pov", "--aa=1"}, "a.pov aa=1,0.3,3"},                                     //
                    Line{{"a.pov", "--shading", "povray"}, "a.pov shading=povray"},                    //
                    Line{{"a.pov", "--distances=scaled", "--precision=fast"}, "a.pov distances=scaled precision=fast"},
                    Line{{"a.pov", "--alpha", "direct", "--index", "brute_force"}, "a.pov alpha=direct index=brute_force"},
                    Line{{"a.pov", "--profile", "csc473"}, "a.pov profile=csc473"},                      //
                    Line{{"a.pov", "--define", "N=3", "--define", "S=\"x y\""}, "a.pov N:=3 S:=x y"},    //
                    Line{{"a.pov", "--define=N=3"}, "a.pov N:=3"},                                       //
                    Line{{"a.pov", "-L", "one", "--library=two"}, "a.pov L=one L=two"},                  //
                    Line{{"a.pov", "--clock", "-0.5"}, "a.pov clock=-0.5"},                              //
                    Line{{"a.pov", "--file-gamma", "2.2", "--dither", "on"}, "a.pov gamma=2.2 dither"},  //
                    Line{{"a.pov", "--crop", "1,3,0,2"}, "a.pov region=1,3,0,2"},                        //
                    Line{{"--", "-W64"}, "-W64.pov"},                                                    //
                    Line{{"--", "+odd=name.pov"}, "+odd=name.pov"},                                      //
                    Line{{"a.pov", "--seed", "7"}, "a.pov (--seed has no effect: what is random follows from the pixel)"}));

INSTANTIATE_TEST_SUITE_P(
    Povray, Grammar,
    testing::Values(
        Line{{"+Ia.pov", "+W64", "+H48"}, "a.pov 64x48"},                   //
        Line{{"+ia", "+w64", "-h48"}, "a.pov 64x48"},                       //
        Line{{"-W64", "-Ia.pov", "-Obig.png"}, "a.pov 64x600 +O=big.png"},  //
        Line{{"+I\"a b.pov\"", "+O\"x y.png\""}, "a b.pov +O=x y.png"},     //
        Line{{"a.pov", "+O-"}, "a.pov +O=-"},                               //
        Line{{"a.pov", "-O-", "+FP"}, "a.pov +O=- format=ppm"},             //
        Line{{"a.pov", "+Odir/"}, "a.pov +O=dir/"},                         //
        Line{{"a.pov", "+FN16"}, "a.pov format=png bits=16"},               //
        Line{{"a.pov", "+FN8"}, "a.pov format=png bits=8"}, Line{{"a.pov", "+FE32"}, "a.pov format=exr bits=32"},
        Line{{"a.pov", "Bits_Per_Color=12.5"}, "a.pov bits=12 (Bits_Per_Color=12.5: the fraction is cut off, as in POV-Ray)"},  //
        Line{{"a.pov", "Output_File_Type=C"}, "a.pov format=tga"},                                                              //
        Line{{"a.pov", "+FE"}, "a.pov format=exr"},                                                                             //
        Line{{"a.pov", "-F"}, "a.pov nofile"},                                                                                  //
        Line{{"a.pov", "-F", "+F"}, "a.pov"},                                                                                   //
        Line{{"a.pov", "+A"}, "a.pov aa=1,0.3,3 " + as_minus_j},                                                                //
        Line{{"a.pov", "+A0.1", "+AM2", "+R2", "-J"}, "a.pov aa=2,0.1,2"},                                                      //
        Line{{"-J", "+R2", "+AM2", "+A0.1", "a.pov"}, "a.pov aa=2,0.1,2"},                                                      //
        Line{{"a.pov", "+A0.1", "+J0.5"}, "a.pov aa=1,0.1,3 " + no_jitter},                                                     //
        Line{{"a.pov", "+A0.1", "+J0.0"}, "a.pov aa=1,0.1,3"},                                                                  //
        Line{{"a.pov", "+A0.1", "-A"}, "a.pov"},                                                                                //
        Line{{"a.pov", "+R4", "+AM2"}, "a.pov"},                                                                                //
        Line{{"a.pov", "+A7", "-J", "+R12"}, "a.pov aa=1,1,9"},                                                                 //
        Line{{"a.pov", "+A", "-J", "+AG1", "+BS2"}, "a.pov aa=1,0.3,3 aagamma=1 block=4"},                                      //
        Line{{"a.pov", "+Q5"}, "a.pov quality=5"},                                                                              //
        Line{{"a.pov", "+Q12"}, "a.pov quality=11"},                                                                            //
        Line{{"a.pov", "+UA", "Dither=on"}, "a.pov alphachannel dither"},                                                       //
        Line{{"a.pov", "+UA", "-UA"}, "a.pov"},                                                                                 //
        Line{{"a.pov", "+Lone", "+Ltwo"}, "a.pov L=one L=two"},                                                                 //
        Line{{"a.pov", "+MV3.5", "+WT2"}, "a.pov threads=2 version=3.5"},                                                       //
        Line{{"a.pov", "+K0.25"}, "a.pov clock=0.25"},                                                                          //
        Line{{"a.pov", "+KI1", "+KF2"}, "a.pov"},                                                                               //
        Line{{"a.pov", "+K0"}, "a.pov clock=0"},                                                                                //
        Line{{"a.pov", "+KFI1", "+KFF1"}, "a.pov"},                                                                             //
        Line{{"a.pov", "+KFF9", "+KI1", "+KF2"}, "a.pov clock=1 frames=1-9"},                                                   //
        Line{{"a.pov", "Initial_Frame=3", "Final_Frame=9", "Subset_Start_Frame=5"}, "a.pov clock=0.3333333333333333 frames=5-9"},
        Line{{"a.pov", "Declare=N=3", "File_Gamma=srgb"}, "a.pov N:=3"},  //
        Line{{"a.pov", "file_gamma=1.0"}, "a.pov gamma=1"},               //
        Line{{"a.pov", "+W100", "+H8", "+SC3", "+EC5", "+SR2", "+ER8"}, "a.pov 100x8 region=2,5,1,8"},
        Line{{"a.pov", "+W16.5", "+H8"}, "a.pov 16x8 (+W16.5: the fraction is cut off, as in POV-Ray)"},
        Line{{"a.pov", "+W16.0", "Height=8e0"}, "a.pov 16x8"},               //
        Line{{"a.pov", "-D", "-P", "-V", "-GA"}, "a.pov quiet noprogress"},  //
        Line{{"a.pov", "+X", "+W8", "+D", "Bounding_Threshold=3", "Display_Gamma=2.2", "-MB"},
             "a.pov 8x600 (ignored, without a meaning here: +X +D Bounding_Threshold=3 Display_Gamma=2.2 -MB)"},
        Line{{"+Ia.pov", "+W64", "--shading", "povray", "-q"}, "a.pov 64x600 shading=povray quiet"},
        Line{{"+Ia.pov", "--define", "Width=3"}, "a.pov Width:=3"},                     //
        Line{{"a.pov", "All_Console=off", "Work_Threads=1"}, "a.pov threads=1 quiet"},  //
        Line{{"a.pov", "Antialias=on", "Antialias_Threshold=0.1", "Jitter=off"}, "a.pov aa=1,0.1,3"}));

struct Mistake {
    Words words;
    std::string text;
};

class GrammarMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(GrammarMistakes, AreNamed) { EXPECT_EQ(error_of(GetParam().words), GetParam().text); }

INSTANTIATE_TEST_SUITE_P(
    All, GrammarMistakes,
    testing::Values(
        Mistake{{}, "no scene given; see raytrace --help"}, Mistake{{"-q"}, "no scene given; see raytrace --help"},
        Mistake{{""}, "the scene's name is empty"}, Mistake{{"a.pov", "b.pov"}, "one scene at a time: 'a.pov' or 'b.pov'?"},
        Mistake{{"a.pov", "--shadng", "povray"}, "unknown option '--shadng'; did you mean '--shading'?"},
        Mistake{{"a.pov", "--xyzzy"}, "unknown option '--xyzzy'"},
        Mistake{{"a.pov", "--widht=3"}, "unknown option '--widht'; did you mean '--width'?"},
        Mistake{{"a.pov", "+Y7"}, "unknown switch '+Y7'; see raytrace help povray"},
        Mistake{{"a.pov", "+W"}, "switch '+W' needs a value: +Wvalue (Width=value)"},
        Mistake{{"a.pov", "Widht=3"}, "unknown setting 'Widht'; did you mean 'Width'?"},
        Mistake{{"a.pov", "Width="}, "setting 'Width' needs a value"}, Mistake{{"a.pov", "+W0"}, "width: 0 is outside 1 to 1000000"},
        Mistake{{"a.pov", "-W", "-5"}, "width: -5 is outside 1 to 1000000"},
        Mistake{{"a.pov", "--height=-5"}, "height: -5 is outside 1 to 1000000"},
        Mistake{{"a.pov", "+H99999999999"}, "height: 99999999999 is outside 1 to 1000000"},
        Mistake{{"a.pov", "+Wabc"}, "width: 'abc' is no number"}, Mistake{{"a.pov", "+W1e999"}, "width: '1e999' is no number"},
        Mistake{{"a.pov", "+Wnan"}, "width: 'nan' is no number"}, Mistake{{"a.pov", "--width"}, "option '--width' needs a value"},
        Mistake{{"a.pov", "--range"}, "option '--range' needs a value"}, Mistake{{"a.pov", "--range="}, "option '--range' needs a value"},
        Mistake{{"--range=", "a.pov"}, "option '--range' needs a value"}, Mistake{{"--width=", "a.pov"}, "option '--width' needs a value"},
        Mistake{{"--dither=", "a.pov"}, "option '--dither' needs a value"},
        Mistake{{"a.pov", "--size=64"}, "size: expected WIDTHxHEIGHT, not '64'"},
        Mistake{{"a.pov", "--shading", "gouraud"},
                "shading: 'gouraud' is unknown; expected one of povray, general, cook-torrance, phong, blinn-phong, ct-effects, "
                "ct-effects-linear, lecture, none"},
        Mistake{{"a.pov", "--distances=far"}, "'far' is no rule of distances; expected one of scaled, povray"},
        Mistake{{"a.pov", "--precision=half"}, "'half' is no precision; expected one of fast, exact"},
        Mistake{{"a.pov", "--index=kd"}, "'kd' is no index; expected one of automatic, embree, brute_force"},
        Mistake{{"a.pov", "--alpha=wide"}, "alpha: 'wide' is unknown; expected roughness2, povray, direct or a number"},
        Mistake{{"a.pov", "--alpha=-1"}, "alpha: -1 is outside 0 to 1000000"},
        Mistake{{"a.pov", "--profile=x"}, "'x' is no profile; expected one of povray, csc473"},
        Mistake{{"a.pov", "--format=gif"}, "'gif' is no picture format; expected one of png, exr, hdr, tiff, jpeg, ppm, tga, bmp"},
        Mistake{{"a.pov", "+FX"},
                "'X' is no output file type; expected one of N (png), P (ppm), T or C (tga), J (jpeg), E (exr), H (hdr), B (bmp)"},
        Mistake{{"a.pov", "Antialias=maybe"}, "Antialias: 'maybe' is neither on nor off"},
        Mistake{{"a.pov", "+A0.3", "+AM3"}, "anti-aliasing method: 3 is outside 1 to 2"},
        Mistake{{"a.pov", "+A0.3", "-ss=2"}, "-ss and anti-aliasing (+A, --aa) both choose the samples of a pixel; give one of them"},
        Mistake{{"a.pov", "-ss=0"}, "ss: 0 is outside 1 to 64"}, Mistake{{"a.pov", "-ss=2.7"}, "ss: expected a whole number, not '2.7'"},
        Mistake{{"a.pov", "-W", "20.9"}, "width: expected a whole number, not '20.9'"},
        Mistake{{"a.pov", "--size=20x8.5"}, "height: expected a whole number, not '8.5'"},
        Mistake{{"a.pov", "--crop=0,1.5,0,2"}, "crop: expected a whole number, not '1.5'"},
        Mistake{{"a.pov", "+FN12.5"}, "bits per colour: expected a whole number, not '12.5'"},
        Mistake{{"a.pov", "--bits=33"}, "bits per colour: 33 is outside 1 to 32"},
        Mistake{{"a.pov", "+KFI3", "+KFF2"}, "the last frame, 2, comes before the first, 3"},
        Mistake{{"a.pov", "+KFI5"}, "the last frame, 1, comes before the first, 5"},
        Mistake{{"a.pov", "+KFI-1", "+KFF2"}, "first frame: -1 is outside 0 to 1073741824"},
        Mistake{{"a.pov", "+KFF3", "+EF4"}, "frame 4 is not among the frames 1 to 3"},
        Mistake{{"a.pov", "+KFF3", "+SF3", "+EF2"}, "the subset's last frame, 2, comes before its first, 3"},
        Mistake{{"a.pov", "+KFF3", "--time=1"}, "--time is for one picture, not for an animation"},
        Mistake{{"a.pov", "Grayscale_Output=on"}, "Grayscale_Output (from 'Grayscale_Output=on') is not available in this version"},
        Mistake{{"a.pov", "--crop=0,9,0,900"}, "crop: columns 0 to 9 and rows 0 to 900 are no part of a 800 x 600 picture"},
        Mistake{{"a.pov", "--crop=5,5,0,9"}, "crop: columns 5 to 5 and rows 0 to 9 are no part of a 800 x 600 picture"},
        Mistake{{"a.pov", "--crop=0,9"}, "crop: expected X0,X1,Y0,Y1, not '0,9'"},
        Mistake{{"a.pov", "+SC10", "+EC4"}, "region: columns begin at 10 and end before, at 4"},
        Mistake{{"a.pov", "--define", "N"}, "define: expected NAME=VALUE, not 'N'"},
        Mistake{{"a.pov", "--define", "=3"}, "define: expected NAME=VALUE, not '=3'"},
        Mistake{{"nowhere.ini"}, "cannot open INI file 'nowhere.ini'"}));

TEST(Grammar, HelpWinsOverMistakesInValues) {
    std::string help;
    EXPECT_FALSE(parse_render_arguments({"--width=0", "--help"}, help).has_value());
    EXPECT_NE(help.find("Usage: raytrace"), std::string::npos);
}

TEST(Grammar, TheOrderOfOptionsDoesNotMatter) {
    Words words{"a.pov", "+W64", "--shading=povray", "-q", "+A0.1", "-J", "Declare=N=3", "--crop=0,8,0,8"};
    const std::string meaning = summary(job_of(words));
    std::sort(words.begin(), words.end());
    int checked = 0;
    do {
        ASSERT_EQ(summary(job_of(words)), meaning);
    } while (++checked < 200 && std::next_permutation(words.begin(), words.end()));
}

TEST(Grammar, CourseProfileChoosesItsRotation) {
    EXPECT_EQ(job_of({"a.pov", "--profile=csc473"}).parse.rotation, Rotation::csc473);
    EXPECT_EQ(job_of({"a.pov"}).parse.rotation, Rotation::povray);
}

TEST(Grammar, TheSceneLearnsThePicturesSize) {
    const RenderJob job = job_of({"a.pov", "+W64", "+H48"});
    EXPECT_EQ(job.parse.image_width, 64);
    EXPECT_EQ(job.parse.image_height, 48);
}

TEST(Grammar, AnExistingSceneWithoutEndingIsTakenAsItIs) {
    const test::Workplace here;
    here.write("plain", test::small_scene);
    EXPECT_EQ(job_of({"plain"}).scene, "plain");
    EXPECT_EQ(job_of({"other"}).scene, "other.pov");
}

}  // namespace
}  // namespace rt::grammar_test
