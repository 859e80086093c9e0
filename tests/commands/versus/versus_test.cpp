// What a comparison with POV-Ray is made of: what programs print, command lines, verdicts, and reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/versus/program_told.h"
#include "commands/versus/scene_files.h"
#include "commands/versus/versus_json.h"
#include "commands/versus/versus_judge.h"
#include "commands/versus/versus_reports.h"
#include "commands/versus/versus_scenes.h"
#include "commands/versus/versus_settings.h"
#include "tests/commands/support.h"

namespace rt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using State = VersusRun::State;

// Laid out as POV-Ray 3.7 does.
constexpr const char* statistics = R"(Parser Time
  Parse Time:       0 hours  1 minutes  2 seconds (62.125 seconds)
              using 1 thread(s) with 61.000 CPU-seconds total
  Bounding Time:    0 hours  0 minutes  0 seconds (0.250 seconds)
Pixels:            81840   Samples:           26786   Smpls/Pxl: 0.33
Rays:             108626   Saved:                 0   Max Level: 1/5
Shadow Ray Tests:            101838   Succeeded:                  8930
  Photon Time:      0 hours  0 minutes  1 seconds (1.500 seconds)
  Radiosity Time:   No radiosity
  Trace Time:       0 hours  0 minutes  0 seconds (0.052 seconds)
              using 2 thread(s) with 0.038 CPU-seconds total
)";

TEST(ProgramTold, TimesAndCountsOfPovray) {
    VersusRun run;
    read_povray_statistics(statistics, run);
    EXPECT_EQ(run.phases.parse, 62.125);
    EXPECT_EQ(run.phases.build, 0.25);
    EXPECT_EQ(run.phases.trace, 1.552);
    EXPECT_EQ(run.phases.write, 0.0);
    EXPECT_EQ(run.rays, 108626u);
    EXPECT_EQ(run.shadow_tests, 101838u);
    read_povray_statistics("\nRays: 5\n  Parse Time: (seconds (7 seconds)\n" + std::string(statistics), run);  // printed by a scene
    EXPECT_EQ(run.rays, 108626u);
    EXPECT_EQ(run.phases.parse, 62.125);
    read_povray_statistics("nothing of the kind", run);
    EXPECT_EQ(run.phases.trace, 0.0);
    EXPECT_EQ(run.rays, 0u);
}

TEST(ProgramTold, AMessageOverSeveralLinesIsOne) {
    EXPECT_EQ(povray_message("==== [Parsing...] ====\nFile 'bad.pov' line 1: Parse Error: No matching } in 'sphere', undeclared\n"
                             " identifier 'pigmnt' found instead\nFatal error in parser: Cannot parse input.\nRender failed\n\n"),
              "File 'bad.pov' line 1: Parse Error: No matching } in 'sphere', undeclared identifier 'pigmnt' found instead");
    EXPECT_EQ(povray_message("one\ntwo\n-----------\n\n"), "two");
    EXPECT_EQ(povray_message(""), "");
    // Warnings look like errors; the one that ended it is the last.
    EXPECT_EQ(
        povray_message("File 'a.pov' line 1: Possible Parse Error: gamma\nFile 'a.pov' line 9: Parse Error: this\nFatal error in parser\n"),
        "File 'a.pov' line 9: Parse Error: this");
    EXPECT_EQ(our_message("a.pov:1: Parse Warning: w\nFile 'a.pov' line 2: Possible Parse Error: no file\n   2 | #include\n"
                          "File 'a.pov' line 2: Parse Error: this\n   2 | #include\n     | ^^^\n"),
              "File 'a.pov' line 2: Parse Error: this");
    EXPECT_LT(our_message(std::string(1u << 20, 'x')).size(), 1100u);
}

TEST(ProgramTold, VersionsOfPovrayAndOfOthers) {
    EXPECT_EQ(povray_version("povray: cannot open something\nPOV-Ray 3.7.0.10.unofficial\n\nCopyright\n"), "POV-Ray 3.7.0.10.unofficial");
    EXPECT_EQ(povray_version("GNU bash, version 5"), "");
}

TEST(ProgramTold, OurOwnStatistics) {
    VersusRun run;
    read_our_statistics(
        "a warning\ntime: parse 0.0001 s, build 0.0009 s, trace 0.1336 s, write 0.0023 s\nrays:\n  camera            104839     0.785 M/s\n"
        "  shadow             98583     0.738 M/s\n  reflected             20     0.000 M/s\n  refracted              3     0.000 M/s\n"
        "  all               203422     1.523 M/s\n",
        run);
    EXPECT_EQ(run.phases.parse, 0.0001);
    EXPECT_EQ(run.phases.build, 0.0009);
    EXPECT_EQ(run.phases.trace, 0.1336);
    EXPECT_EQ(run.phases.write, 0.0023);
    EXPECT_EQ(run.rays, 104862u);
    EXPECT_EQ(run.shadow_tests, 98583u);
}

VersusSettings settings(const std::vector<std::string>& words) {
    VersusSettings s;
    s.words = words, s.job = job_of_words(words), s.threads = 2, s.povray = "/usr/bin/povray", s.program = "/p/raytrace";
    return s;
}

TEST(VersusCommands, BothSayTheSame) {
    VersusSettings s = settings({"--width=64", "--height=48", "--aa=2,0.1,4", "--library=/lib dir", "--define=N=3", "--define=T=3a",
                                 "--clock=0.5", "--language=3.6"});
    s.folder = "/out", s.installed = {"/share/include"};
    PovrayNames names("/links");
    EXPECT_THAT(povray_command(s, "/a/b.pov", "/out/povray.png", names),
                ElementsAre("/usr/bin/env", "POVINI=/out/povray.ini", "/usr/bin/povray", "+I/a/b.pov", "+O/out/povray.png", "+W64", "+H48",
                            "+FN8", "-D", "-V", "+A0.1", "+AM2", "+R4", "-J", "Declare=N=3", "Declare='T=\"3a\"'", "+K0.5", "+MV3.6",
                            "+WT2", "+L/a", "+L\"/lib dir\"", "+L/share/include"));
    EXPECT_TRUE(names.links().empty());
    EXPECT_THAT(
        our_command(s, "/a/b.pov", Maker::same, "same.png"),
        ElementsAre("/p/raytrace", "/a/b.pov", "--width=64", "--height=48", "--aa=2,0.1,4", "--library=/lib dir", "--define=N=3",
                    "--define=T=3a", "--clock=0.5", "--language=3.6", "--threads=2", "--shading=povray", "--stats", "-o", "same.png"));
    EXPECT_THAT(our_command(settings({}), "/b.pov", Maker::general, "general.png"),
                ElementsAre("/p/raytrace", "/b.pov", "--threads=2", "--stats", "-o", "general.png"));
    EXPECT_THAT(povray_picture_words(settings({"--width=8"}).job), testing::Contains("-A"));
}

TEST(VersusCommands, NamesThatPovrayCannotReadGetALink) {
    PovrayNames names("/links");
    EXPECT_EQ(names.word("/a/b;[c] d'.pov", "scene.pov"), "\"/a/b;[c] d'.pov\"");
    EXPECT_EQ(names.word("/a/b\"c.pov", "scene.pov"), "'/a/b\"c.pov'");
    EXPECT_EQ(names.word("/a/\u00e9", "folder"), "/links/folder");
    EXPECT_EQ(names.word("/a/'\"", "library1"), "/links/library1");
    EXPECT_EQ(names.word("/a\n", "library2"), "/links/library2");
    EXPECT_EQ(names.links().size(), 3u);
    EXPECT_EQ(names.without_links("File '/links/folder/x.inc' line 3"), "File '/a/\u00e9/x.inc' line 3");
}

TEST(VersusCommands, ValuesThatPovrayCannotTakeAreMistakes) {
    for (const char* word : {"--define=N=nan", "--define=N=inf", "--define=T=a'b", "--define=T=a\\b", "--define=T=\u00e9"})
        EXPECT_THROW(povray_picture_words(settings({word}).job), OptionError) << word;
    EXPECT_THAT(povray_picture_words(settings({"--define=T=a b;[c]"}).job), testing::Contains("Declare='T=\"a b;[c]\"'"));
}

/// 10 x 10 grey pixels, the first `count` of them brighter by `step`.
StoredImage picture(int count, int step) {
    StoredImage image;
    image.width = image.height = 10, image.channels = 3;
    for (int i = 0; i < 100; ++i)
        for (int c = 0; c < 3; ++c) image.values.push_back(static_cast<float>(100 + (i < count ? step : 0)));
    return image;
}

TEST(VersusJudge, PixelsWithinTheStepCount) {
    const VersusLimits limits;
    const Likeness same = likeness_of(picture(0, 0), picture(100, 2), limits);
    EXPECT_EQ(same.beyond, 0u);
    EXPECT_TRUE(same.agrees);
    EXPECT_FALSE(same.region);
    const Likeness two = likeness_of(picture(0, 0), picture(2, 3), limits);
    EXPECT_EQ(two.beyond, 2u);
    EXPECT_DOUBLE_EQ(two.percent_within(), 98.0);
    EXPECT_TRUE(two.agrees);
    ASSERT_TRUE(two.region);
    EXPECT_EQ(two.region->pixels, 2u);
    EXPECT_THAT(two.theirs, ElementsAre(100, 100, 100));
    EXPECT_THAT(two.ours, ElementsAre(103, 103, 103));
    EXPECT_FALSE(likeness_of(picture(0, 0), picture(3, 3), limits).agrees);
}

TEST(VersusJudge, AFewPixelsFarOffAreTooMuch) {
    const Likeness one = likeness_of(picture(0, 0), picture(1, 100), {});  // RMSE 0.039
    EXPECT_DOUBLE_EQ(one.percent_within(), 99.0);
    EXPECT_FALSE(one.agrees);
    EXPECT_TRUE(likeness_of(picture(0, 0), picture(1, 100), {.rmse = 0.04}).agrees);
}

VersusResult result(State povray, State same, State general) {
    VersusResult r;
    r.name = "s", r.path = "/s.pov";
    r.run(Maker::povray).state = povray, r.run(Maker::same).state = same, r.run(Maker::general).state = general;
    return r;
}

TEST(VersusJudge, EveryEndHasItsCause) {
    const State done = State::done, refused = State::refused, failed = State::failed, none = State::not_run;
    const auto cause = [](VersusResult r, Maker judged = Maker::same) { return cause_of(r, {.judged = judged}); };
    EXPECT_EQ(cause(result(none, none, none)), VersusCause::not_run);
    EXPECT_EQ(cause(result(failed, done, done)), VersusCause::failed);
    EXPECT_EQ(cause(result(done, done, failed)), VersusCause::failed);
    VersusResult both = result(refused, refused, refused);
    EXPECT_EQ(cause(both), VersusCause::failed);  // neither says that it is the scene's mistake
    for (VersusRun& run : both.runs) run.message = "File 'a.pov' line 1: Parse Error: no";
    EXPECT_EQ(cause(both), VersusCause::both_refuse);
    both.run(Maker::same).message = "a limit of ours";
    EXPECT_EQ(cause(both), VersusCause::failed);
    EXPECT_EQ(cause(result(refused, done, done)), VersusCause::povray_refuses);
    EXPECT_EQ(cause(result(done, refused, refused)), VersusCause::refused);
    VersusResult missing = result(done, refused, refused);
    missing.missing.push_back({"media", "/s.pov", 1, 2});
    EXPECT_EQ(cause(missing), VersusCause::not_modelled);
    VersusResult like = result(done, done, done);
    like.like(Maker::same) = like.like(Maker::general) = Likeness();
    like.like(Maker::same)->agrees = true;
    EXPECT_EQ(cause(like), VersusCause::agrees);
    EXPECT_EQ(cause(like, Maker::general), VersusCause::differs);
}

VersusRecord record() {
    VersusRecord record{"POV-Ray 3.7", {"--width=10", "--height=10"}, {}, {}};
    const auto add = [&](const std::string& name, VersusResult r) {
        r.name = name, r.cause = cause_of(r, record.limits);
        record.results.push_back(std::move(r));
    };
    const auto like = [](int count, int step) {
        VersusResult r = result(State::done, State::done, State::done);
        r.like(Maker::same) = likeness_of(picture(0, 0), picture(count, step), {});
        r.like(Maker::general) = likeness_of(picture(0, 0), picture(100, 50), {});
        for (VersusRun& run : r.runs)
            run = {State::done, {"a", "b c"}, "", 100, 50, true, 2, 1.25, 1.5, 1u << 20, {0.25, 0.5, 0.125, 0.0625}};
        return r;
    };
    const auto missing = [](const std::vector<std::string>& names) {
        VersusResult r = result(State::done, State::refused, State::refused);
        for (const std::string& name : names) r.missing.push_back({name, "/s.pov", 3, 4});
        r.run(Maker::same).message = r.run(Maker::general).message = "/s.pov:3:4: " + names[0] + " is not modelled";
        return r;
    };
    add("=good", like(0, 0));
    add("bad", like(10, 90));
    add("worse", like(20, 30));
    add("blob", missing({"blob", "blob"}));
    add("both", missing({"blob", "media"}));
    add("media", missing({"media"}));
    add("more", missing({"media", "fog"}));
    VersusResult refused = result(State::refused, State::done, State::done);
    refused.run(Maker::povray).message = "File 's.pov' line 1: Parse Error: no, <really>";
    add("theirs", refused);
    refused.run(Maker::same) = refused.run(Maker::general) = refused.run(Maker::povray);
    add("none", refused);
    return record;
}

TEST(VersusReports, FeaturesAreRankedByWhatTheyGain) {
    const std::vector<MissingCount> counts = missing_counts(record().results);
    ASSERT_EQ(counts.size(), 3u);
    EXPECT_EQ(counts[0].name, "media");
    EXPECT_EQ(counts[0].scenes, 3u);
    EXPECT_EQ(counts[0].only_this, 1u);
    EXPECT_EQ(counts[1].name, "blob");
    EXPECT_EQ(counts[1].scenes, 2u);
    EXPECT_EQ(counts[1].only_this, 1u);
    EXPECT_EQ(counts[2].name, "fog");
    EXPECT_EQ(counts[2].only_this, 0u);
}

TEST(VersusReports, PercentagesAreRoundedDown) {
    Likeness like;
    like.figures.pixels = 1'000'000, like.beyond = 1;
    EXPECT_EQ(percent_text(like, 3), "99.999");
    like.beyond = 20'001;
    EXPECT_EQ(percent_text(like, 2), "97.99");
    like.beyond = 20'000;
    EXPECT_EQ(percent_text(like, 2), "98.00");
    like.beyond = 0;
    EXPECT_EQ(percent_text(like, 3), "100.000");
    EXPECT_EQ(percent_text({}, 2), "0.00");
}

TEST(VersusReports, WorstComeFirst) {
    const VersusRecord all = record();
    std::vector<std::string> names;
    for (const VersusResult* r : worst_first(all)) names.push_back(r->name);
    EXPECT_THAT(names, ElementsAre("worse", "bad", "blob", "both", "media", "more", "theirs", "none", "=good"));
}

TEST(VersusReports, ResultsComeBackAsTheyWere) {
    for (const VersusResult& before : record().results) {
        Sources sources;
        sources.add({"both", nlohmann::ordered_json{{"r", versus_json(before)}, {"t", versus_times_json(before)}}.dump()});
        const nlohmann::json content = parse_json(sources);
        const JsonValue value(sources, content);
        const VersusResult after = versus_of_json(value["r"], value["t"]);
        EXPECT_EQ(versus_json(after), versus_json(before));
        EXPECT_EQ(versus_times_json(after), versus_times_json(before));
        EXPECT_EQ(cause_of(after, {}), before.cause);
    }
}

TEST(VersusReports, ResultsHoldNoTimes) {
    VersusRecord one = record();
    const std::string before = versus_results_text(one);
    for (VersusResult& r : one.results)
        for (VersusRun& run : r.runs) run.wall_seconds += 1.0, run.phases.trace += 1.0, run.alone = false, run.threads = 9;
    EXPECT_EQ(versus_results_text(one), before);
    EXPECT_NE(versus_times_text(one), versus_times_text(record()));
    const nlohmann::json json = nlohmann::json::parse(before);
    EXPECT_EQ(json["summary"]["differs"], 2);
    EXPECT_EQ(json["summary"]["not modelled"], 4);
    EXPECT_EQ(json["missing"][0]["name"], "media");
    EXPECT_EQ(json["scenes"][1]["same"]["likeness"]["beyond"], 10);
}

TEST(VersusReports, ALineOfCsvForEachScene) {
    const std::string text = versus_csv_text(record());
    const auto columns = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
    std::istringstream lines(text);
    std::string head, line;
    std::getline(lines, head);
    std::getline(lines, line);
    EXPECT_EQ(columns(head), columns(line));
    EXPECT_EQ(line.substr(0, 25), "'=good,agrees,yes,0,0,0,0");
    EXPECT_THAT(text, HasSubstr("\"File 's.pov' line 1: Parse Error: no, <really>\""));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(VersusReports, TheTableIsGroupedByCause) {
    EXPECT_EQ(versus_table_text(record()), R"(         with POV-Ray's shading                       general            wall clock, s
  scene     within  rmse    p99     flip    3x3        within POV-Ray    same general
differs (2)
  worse    80.00 %  0.0526  0.1176  0.1186  0.0235     0.00 %    1.25    1.25    1.25
      20 pixels in (0, 0) to (9, 1); at (0, 0) POV-Ray has 100 100 100, we 130 130 130
  bad      90.00 %  0.1116  0.3529  0.1915  0.0353     0.00 %    1.25    1.25    1.25
      10 pixels in (0, 0) to (9, 0); at (0, 0) POV-Ray has 100 100 100, we 190 190 190
not modelled (4)
  blob   blob (/s.pov:3:4)
  both   blob, media (/s.pov:3:4)
  media  media (/s.pov:3:4)
  more   media, fog (/s.pov:3:4)
what is not modelled, by gain         scenes that ask for it    for nothing else
  media                                                     3                   1
  blob                                                      2                   1
  fog                                                       1                   0
refused by POV-Ray alone (1)
  theirs                                                                 0.00    0.00
      POV-Ray: File 's.pov' line 1: Parse Error: no, <really>
refused by both (1)
  none
      both: File 's.pov' line 1: Parse Error: no, <really>
agrees (1)
  =good   100.00 %  0.0000  0.0000  0.0000  0.0000     0.00 %    1.25    1.25    1.25
wall clock of scenes that all rendered: POV-Ray 3.8 s, we 3.8 s with its shading, 3.8 s with ours
2 of 9 scenes agree: 2 differs, 4 not modelled, 1 refused by POV-Ray alone, 1 refused by both, 1 agrees
)");
}

TEST(VersusScenes, NamesAndWhatIsLeftOut) {
    const test::Workplace here;
    std::filesystem::create_directories("a/inner"), std::filesystem::create_directories("a/.hidden"),
        std::filesystem::create_directories("a/out");
    std::filesystem::create_directories("b/a");
    for (const char* name : {"a/x.pov", "a/inner/y.POV", "a/.hidden/z.pov", "a/out/w.pov", "a/n.inc", "b/a/x.pov"}) here.write(name, "x");
    const std::string out = std::filesystem::canonical("a/out").string();
    const auto names = [&](const std::vector<std::string>& arguments, const std::string& only = "") {
        std::vector<std::string> list;
        for (const VersusScene& scene : scenes_of(arguments, only, out)) list.push_back(scene.name);
        return list;
    };
    EXPECT_THAT(names({"a"}), ElementsAre("a/inner/y", "a/x"));
    EXPECT_THAT(names({"a/x.pov", "a/x", "b/a", "a/"}), ElementsAre("x", "a/x", "a/inner/y"));
    EXPECT_THAT(names({"a/x.pov", "b/a/x.pov", "a/inner/y.POV"}), ElementsAre(testing::EndsWith("/a/x"), "b/a/x", "y"));
    EXPECT_THAT(names({"a"}, "^a/x"), ElementsAre("a/x"));
    const auto message = [&](const std::vector<std::string>& arguments, const std::string& only) {
        try {
            names(arguments, only);
        } catch (const OptionError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message({"nowhere"}, ""), "there is no scene or folder 'nowhere'");
    EXPECT_EQ(message({"a/.hidden/.."}, "q"), "--only: no scene's name matches 'q'");
    EXPECT_EQ(message({"a"}, "("), "--only: '(' is no regular expression");
    std::filesystem::create_directory("empty");
    EXPECT_EQ(message({"empty"}, ""), "there is no scene (*.pov) in the folder 'empty'");
}

TEST(SceneFiles, WhatASceneNamesCountsWhereverItLies) {
    const test::Workplace here;
    std::filesystem::create_directories("a/inner"), std::filesystem::create_directory("lib");
    here.write("a/inner/x.pov", "// it isn\"t\n#include \"../n\"\nimage_map { png \"map\" } // \"not/there\"\n");
    here.write("a/n.inc", "#fopen F \"data.txt\" read"), here.write("a/data.txt", "1"), here.write("lib/map.png", "p");
    const std::string scene = std::filesystem::canonical("a/inner/x.pov").string(), lib = std::filesystem::canonical("lib").string();
    const auto files = [&] { return files_of_scene(scene, {lib}, {}, {}); };
    std::string before = files().fingerprint;
    EXPECT_TRUE(files().complete);
    const auto changes = [&](const std::string& name, const std::string& text) {
        here.write(name, text);
        const std::string after = files().fingerprint;
        const bool changed = after != before;
        before = after;
        return changed;
    };
    EXPECT_FALSE(changes("a/inner/other.txt", "nobody reads it"));
    EXPECT_TRUE(changes("a/data.txt", "2"));
    EXPECT_TRUE(changes("lib/map.png", "q"));
    EXPECT_TRUE(changes("a/inner/map.png", "found first"));
    std::filesystem::create_directory("a/inner/not");
    EXPECT_TRUE(changes("a/inner/not/there", "now it is"));
    EXPECT_TRUE(changes("a/n.inc", "#fopen F concat(\"da\", \"ta.txt\") read"));
    EXPECT_FALSE(files().complete);
}

}  // namespace
}  // namespace rt
