// What the program says to words that are almost right, and which of them it takes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "commands/base/output_name.h"
#include "commands/base/suggest.h"
#include "commands/job/render_arguments.h"
#include "core/source.h"
#include "film/image_file.h"
#include "tests/commands/support.h"

namespace rt::hints_test {
namespace {

using test::Outcome;
using test::run;
using Words = std::vector<std::string>;

struct Hint {
    Words words;
    std::string text;
};

void PrintTo(const Hint& hint, std::ostream* out) { *out << testing::PrintToString(hint.words); }

class Hints : public testing::TestWithParam<Hint> {
protected:
    Hints() { here.write("a.pov", test::small_scene); }
    test::Workplace here;
};

TEST_P(Hints, AreGiven) {
    const Outcome outcome = run(GetParam().words);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "raytrace: " + GetParam().text + "\n");
    EXPECT_EQ(here.files(), Words{"a.pov"});
}

INSTANTIATE_TEST_SUITE_P(
    Commands, Hints,
    testing::Values(Hint{{"requries", "a.pov"}, "'requries' is neither a command nor a scene; did you mean 'requires'?"},
                    Hint{{"comapre", "a", "b"}, "'comapre' is neither a command nor a scene; did you mean 'compare'?"},
                    Hint{{"rendr", "a.pov", "8", "6"}, "'rendr' is neither a command nor a scene; did you mean 'render'?"},
                    Hint{{"Render", "a.pov", "8", "6"}, "'Render' is neither a command nor a scene; did you mean 'render'?"},
                    Hint{{"a", "b"}, "one scene at a time: 'a' or 'b'?"}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, Hints,
    testing::Values(Hint{{"a.pov", "8", "6"},
                         "one scene at a time: 'a.pov' or '8'? A size is -W 8 -H 6; the course's way is: raytrace render a.pov 8 6"},
                    Hint{{"a.pov", "8x6"}, "one scene at a time: 'a.pov' or '8x6'? A size is --size 8x6"},
                    Hint{{"a.pov", "a.png"}, "one scene at a time: 'a.pov' or 'a.png'? The picture's name is -o a.png"},
                    Hint{{"a.pov", "-width", "8"}, "unknown option '-width'; did you mean '--width'?"},
                    Hint{{"a.pov", "-width=8"}, "unknown option '-width=8'; did you mean '--width'?"},
                    Hint{{"a.pov", "-help"}, "unknown option '-help'; did you mean '--help'?"},
                    Hint{{"a.pov", "--out", "b.png"}, "unknown option '--out'; did you mean '--output'?"}));

INSTANTIATE_TEST_SUITE_P(
    Course, Hints,
    testing::Values(
        Hint{{"render", "a.pov", "8", "6", "-W", "5"}, "'-W': the size stands behind the scene: raytrace render SCENE WIDTH HEIGHT"},
        Hint{{"render", "a.pov", "8", "6", "-H5"}, "'-H5': the size stands behind the scene: raytrace render SCENE WIDTH HEIGHT"},
        Hint{{"render", "a.pov", "8", "6", "--size=8x5"},
             "'--size=8x5': the size stands behind the scene: raytrace render SCENE WIDTH HEIGHT"},
        Hint{{"render", "a.pov", "8", "6", "--out", "foo.png"}, "unknown option '--out'; did you mean '--output'?"},
        Hint{{"render", "a.pov", "8", "6", "-shading=povray"}, "unknown option '-shading'; did you mean '--shading'?"},
        Hint{{"render", "a.pov", "8", "6", "+A0.3"},
             "POV-Ray's switch '+A0.3' does not go with the course's render; in our options it is --antialias=on "
             "--aa-threshold=0.3"},
        Hint{{"render", "a.pov", "8", "6", "+D"}, "POV-Ray's switch '+D' does not go with the course's render"}));

// POV-Ray 3.7 renders with +FNg, +FPG, +SR10 +ER5 and the dithering methods, and refuses the others.
INSTANTIATE_TEST_SUITE_P(
    Povray, Hints,
    testing::Values(Hint{{"a.pov", "+FNg"}, "grey pictures (file type 'Ng', Grayscale_Output) are not available in this version"},
                    Hint{{"a.pov", "+FPG"}, "grey pictures (file type 'PG', Grayscale_Output) are not available in this version"},
                    Hint{{"a.pov", "+FTg"}, "bits per colour: 'g' is no number"},
                    Hint{{"a.pov", "+H12", "+SR20", "+ER10"}, "region: rows 20 to 10 are no part of a picture of 12"},
                    Hint{{"a.pov", "+H12", "+SR10", "+ER5"}, "region: rows begin at 10 and end before, at 5"},
                    Hint{{"a.pov", "+UAx"}, "unknown switch '+UAx': nothing may stand behind '+UA'"},
                    Hint{{"a.pov", "-Vx"}, "unknown switch '-Vx': nothing may stand behind '-V'"},
                    Hint{{"a.pov", "+THB2"}, "dithering method B2 is not available in this version; FS (Floyd-Steinberg) is"},
                    Hint{{"a.pov", "Dither=on", "Dither_Method=d1"},
                         "dithering method D1 is not available in this version; FS (Floyd-Steinberg) is"},
                    Hint{{"a.pov", "+THXX"}, "'XX' is no dithering method; expected one of FS, B2, B3, B4, D1, D2"}));

RenderJob job_of(const Words& words) {
    std::string help;
    return parse_render_arguments(words, help).value();
}

// As POV-Ray 3.7 reports them.
TEST(Switches, OfDitheringAndQualityMeanWhatPovrayMakesOfThem) {
    EXPECT_TRUE(job_of({"a.pov", "+THFS"}).dither);
    EXPECT_TRUE(job_of({"a.pov", "+TH"}).dither);
    EXPECT_TRUE(job_of({"a.pov", "+thfs"}).dither);
    EXPECT_FALSE(job_of({"a.pov", "-THFS"}).dither);
    EXPECT_FALSE(job_of({"a.pov", "+TH", "-THB2"}).dither);
    EXPECT_EQ(job_of({"a.pov", "+Q-3"}).povray_quality, 0);
    EXPECT_EQ(job_of({"a.pov", "Quality=-3"}).povray_quality, 0);
    EXPECT_EQ(job_of({"a.pov", "+Q99"}).povray_quality, 11);
}

TEST(Switches, OfTheDisplayMayNameItsPalette) {
    EXPECT_EQ(job_of({"a.pov", "+D0G"}).notes, Words{"ignored, without a meaning here: +D0G"});
    EXPECT_EQ(job_of({"a.pov", "-D"}).notes, Words{});
}

TEST(Switches, OfTheVersionAnswersInEveryWayToWriteIt) {
    const Outcome outcome = run({"version"});
    EXPECT_EQ(run({"--version"}).out, outcome.out);
    EXPECT_EQ(run({"-version"}).out, outcome.out);
}

TEST(ShortOptions, TakeAValueBehindAnEqualsSign) {
    const RenderJob job = job_of({"-W=8", "a.pov", "-H=6", "-t=2", "-o=b.png", "-L=c=d"});
    EXPECT_EQ(job.width, 8);
    EXPECT_EQ(job.height, 6);
    EXPECT_EQ(job.threads, 2);
    EXPECT_EQ(job.output.name, "b.png");
    EXPECT_EQ(job.parse.library_paths, Words{"c=d"});
    EXPECT_EQ(job_of({"a.pov", "-o", "-W=8"}).output.name, "-W=8");
    EXPECT_EQ(job_of({"--", "-W=8"}).scene, "-W=8.pov");
}

TEST(ShortOptions, ThatNoCourseOptionResemblesAreTakenThereToo) {
    const test::Workplace here;
    here.write("a.pov", test::small_scene);
    for (const Words& options :
         {Words{"-o", "x.png", "-t", "2", "-q"}, Words{"-o=x.png", "-t2", "-L", "."}, Words{"--output=x.png", "-t=2", "-L=."}}) {
        Words words{"render", "a.pov", "8", "6"};
        words.insert(words.end(), options.begin(), options.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(here.files(), (Words{"a.pov", "x.png"}));
        EXPECT_EQ(read_image("x.png").width, 8);
    }
}

TEST(OutputNotes, SayWhatWasAppendedToANameThatLooksComplete) {
    const test::Workplace here;
    here.write("a.pov", test::small_scene);
    const auto notes = [](const Words& output) {
        Words words{"a.pov", "--size=8x6"};
        words.insert(words.end(), output.begin(), output.end());
        return run(words).err;
    };
    const std::string xyz = "raytrace: note: '.xyz' is not the ending of the picture's type: 'out.xyz.png' is written\n";
    EXPECT_EQ(notes({"-o", "out.xyz"}), xyz);
    EXPECT_EQ(notes({"+Oout.xyz"}), xyz);
    EXPECT_EQ(notes({"-o", "out.ppm", "--format=png"}),
              "raytrace: note: '.ppm' is not the ending of the picture's type: 'out.ppm.png' is written\n");
    EXPECT_EQ(notes({"-o", "out.xyz", "-q"}), "");
    EXPECT_EQ(notes({"-o", "out"}), "");
    EXPECT_EQ(notes({"-o", "out.PNG"}), "");
    EXPECT_EQ(notes({"-o", "./"}), "");
    const Outcome outcome = run({"compare", "out.png", "out.png", "-o", "d.xyz"});
    EXPECT_EQ(outcome.err, "raytrace: note: '.xyz' is not the ending of the picture's type: 'd.xyz.png' is written\n");
}

TEST(Suggestions, PreferTheNearestAndElseTheShortestWithThisBeginning) {
    const Words words{"--outfile", "--output-alpha", "--output", "--over"};
    EXPECT_EQ(nearest_word("--outp", words), "--output");
    EXPECT_EQ(nearest_word("--oveq", words), "--over");
    EXPECT_EQ(nearest_word("--o", words), "");
    EXPECT_EQ(nearest_word("--output-al", words), "--output-alpha");
}

/// POV-Ray takes such declarations, too, and they are as useless there.
TEST(Hints, NamesThatNoSceneCanReadAreANote) {
    const test::Workplace here;
    here.write("a.pov", test::small_scene);
    for (const char* name : {"3", "X Y", "camera", "x", "a-b"}) {
        const test::Outcome outcome = test::run({"a.pov", "--size=4x3", "--define", std::string(name) + "=4"});
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.err, fmt::format("raytrace: note: --define {}=4: no scene can read this; a name is letters, digits and _, and no "
                                           "reserved word\n",
                                           name));
    }
    EXPECT_EQ(test::run({"a.pov", "--size=4x3", "--define", "_x9=4"}).err, "");
    EXPECT_EQ(test::run({"a.pov", "--size=4x3", "--define", "X=4"}).err, "");
}

}  // namespace
}  // namespace rt::hints_test
