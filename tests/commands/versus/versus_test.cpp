// What a comparison with POV-Ray comes to: verdicts and reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/versus/versus_json.h"
#include "commands/versus/versus_judge.h"
#include "commands/versus/versus_reports.h"

namespace rt::versus_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using State = VersusRun::State;

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
    both.run(Maker::same).message = "File '/x/a.pov' line 1: Parse Error: in other words";
    EXPECT_EQ(cause(both), VersusCause::both_refuse);
    both.run(Maker::same).message = "File 'a.pov' line 2: Parse Error: no";
    EXPECT_EQ(cause(both), VersusCause::refused_elsewhere);
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
    const auto like = [](int count, int step, double seconds) {
        VersusResult r = result(State::done, State::done, State::done);
        r.like(Maker::same) = likeness_of(picture(0, 0), picture(count, step), {});
        r.like(Maker::general) = likeness_of(picture(0, 0), picture(100, 50), {});
        for (VersusRun& run : r.runs)
            run = {State::done, {"a", "b c"}, "", 100, 50, true, 2, 1.25, 1.5, 1u << 20, {0.25, 0.5, 0.125, 0.0625}};
        r.run(Maker::same).wall_seconds = seconds, r.run(Maker::general).wall_seconds = 2.0;
        return r;
    };
    const auto missing = [](const std::vector<std::string>& names) {
        VersusResult r = result(State::done, State::refused, State::refused);
        r.path = "/scenes/s.pov";
        for (const std::string& name : names) r.missing.push_back({name, names.size() == 1 ? r.path : "/other/scenes/s.inc", 3, 4});
        r.run(Maker::same).message = r.run(Maker::general).message = "/s.pov:3:4: " + names[0] + " is not modelled";
        return r;
    };
    add("=good", like(0, 0, 1.0));
    add("bad", like(10, 90, 0.5));
    add("worse", like(20, 30, 1.5));
    add("blob", missing({"blob"}));
    add("both", missing({"blob", "media"}));
    add("media", missing({"media"}));
    add("more", missing({"media", "fog"}));
    VersusResult refused = result(State::refused, State::done, State::done);
    refused.path = "/scenes/s.pov", refused.run(Maker::povray).message = "File '/scenes/s.pov' line 1: Parse Error: no, <really>";
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
    EXPECT_THAT(text, HasSubstr("\"File '/scenes/s.pov' line 1: Parse Error: no, <really>\""));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(VersusReports, TheTableIsGroupedByCause) {
    EXPECT_EQ(versus_table_text(record()), R"(         with POV-Ray's shading                       general            wall clock, s
  scene     within  rmse    p99     flip    3x3        within POV-Ray    same general
differs (2)
  worse    80.00 %  0.0526  0.1176  0.1186  0.0235     0.00 %    1.25    1.50    2.00
      20 pixels in (0, 0) to (9, 1); at (0, 0) POV-Ray has 100 100 100, we 130 130 130
  bad      90.00 %  0.1116  0.3529  0.1915  0.0353     0.00 %    1.25    0.50    2.00
      10 pixels in (0, 0) to (9, 0); at (0, 0) POV-Ray has 100 100 100, we 190 190 190
not modelled (4)
  blob   blob (s.pov:3:4)
  both   blob, media (/other/scenes/s.inc:3:4)
  media  media (s.pov:3:4)
  more   media, fog (/other/scenes/s.inc:3:4)
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
  =good   100.00 %  0.0000  0.0000  0.0000  0.0000     0.00 %    1.25    1.00    2.00
seconds of the 3 scenes that all rendered
                wall     parse     build     trace     write
  POV-Ray       3.75      0.75      1.50      0.38
  same          3.00      0.75      1.50      0.38      0.19
  general       6.00      0.75      1.50      0.38      0.19
  same / POV-Ray: median 0.80, at most 1.20 (worse)
  general / POV-Ray: median 1.60, at most 1.60 (worse)
2 of 9 scenes agree: 2 differs, 4 not modelled, 1 refused by POV-Ray alone, 1 refused by both, 1 agrees
)");
}

}  // namespace
}  // namespace rt::versus_test
