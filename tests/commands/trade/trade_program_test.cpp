// raytrace trade end to end, at a tiny size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "grading/file_lock.h"
#include "tests/commands/support.h"

namespace rt::trade_program_test {
namespace {

using nlohmann::json;
using test::Outcome;
using test::run;
using testing::HasSubstr;

constexpr const char* mirrors = R"(#version 3.7;
#include "tone.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <5, 5, -5>, 1 }
sphere { 0, 1 pigment { rgb Tone } finish { specular 0.9 roughness 0.1 reflection 0.4 } }
plane { y, -1 pigment { checker rgb 1, rgb 0.2 } finish { reflection 0.3 } }
)";

class Trade : public testing::Test {
protected:
    Trade() {
        here.write("a.pov", mirrors);
        here.write("tone.inc", "#declare Tone = <1, 0.2, 0.2>;\n");
    }

    test::Workplace here;

    static Outcome trade(std::vector<std::string> words) {
        words.insert(words.begin(), {"trade", "-W", "20", "-H", "15", "--runs", "1", "--reference-error", "0.01"});
        return run(words);
    }
    json results(const std::string& folder = "trade-results") const { return json::parse(here.read(folder + "/results.json")); }
};

const json* setting_of(const json& results, const std::string& name) {
    for (const json& setting : results["settings"])
        if (setting["name"] == name) return &setting;
    return nullptr;
}

/// One trade that several tests read.
class WholeTrade : public testing::Test {
protected:
    static void SetUpTestSuite() {
        here = std::make_unique<test::Workplace>();
        here->write("a.pov", mirrors);
        here->write("tone.inc", "#declare Tone = <1, 0.2, 0.2>;\n");
        outcome = run({"trade", "-W", "20", "-H", "15", "--runs", "1", "--reference-error", "0.01", "--settings", "30", "a.pov"});
        if (outcome.status == 0) results = json::parse(here->read("trade-results/results.json"));
    }
    static void TearDownTestSuite() { here.reset(); }
    void SetUp() override { ASSERT_EQ(outcome.status, 0) << outcome.err; }

    static inline std::unique_ptr<test::Workplace> here;
    static inline Outcome outcome;
    static inline json results;
};

TEST_F(WholeTrade, MeasuresManySettingsAgainstAConvergedReference) {
    EXPECT_EQ(outcome.err, "raytrace: reports are in trade-results\n");
    EXPECT_THAT(outcome.out, HasSubstr("a.pov, 20 x 15, "));
    EXPECT_THAT(outcome.out, HasSubstr("what no other setting beats\n"));
    const json& r = results;
    EXPECT_EQ(r["format"], "raytrace trade 1");
    EXPECT_TRUE(r["complete"]);
    EXPECT_LE(r["reference"]["rmse_estimated"].get<double>(), 0.01);
    EXPECT_GE(r["settings"].size(), 25u);
    for (const char* preset : {"draft", "fast", "good", "exact"}) EXPECT_TRUE(setting_of(r, preset)) << preset;
    for (const json& setting : r["settings"]) {
        EXPECT_EQ(setting["state"], "measured") << setting["name"];
        EXPECT_GT(setting["wall"]["trace"].get<double>(), 0.0);
        const std::string name = setting["name"];
        const bool by_share = setting["command"].get<std::string>().find("--scale 1") == std::string::npos;
        EXPECT_GE(setting["rays"]["camera"].get<std::uint64_t>(), by_share ? 20u : 300u) << name;
        EXPECT_TRUE(here->has("trade-results/" + setting["picture"].get<std::string>())) << setting["name"];
    }
    const double draft = (*setting_of(r, "draft"))["error"]["rmse"], exact = (*setting_of(r, "exact"))["error"]["rmse"];
    EXPECT_GT(draft, 3.0 * exact);
    for (const char* file : {"results.csv", "trade.html", "pictures/reference.png"})
        EXPECT_TRUE(here->has(std::string("trade-results/") + file)) << file;
}

/// The sum of the squares of what each value is off alone is the square of what all are off together.
TEST_F(WholeTrade, TellsWhichPartOfTheErrorComesFromWhere) {
    const json& r = results;
    std::size_t near = 0, all = 0;
    for (const json& setting : r["settings"]) {
        if (!setting["comparable"]) continue;
        double square = 0.0;
        for (const auto& [source, error] : setting["alone"]["by_source"].items()) square += error.get<double>() * error.get<double>();
        const double measured = setting["error"]["rmse"];
        near += std::abs(std::sqrt(square) - measured) < 0.25 * measured;
        ++all;
    }
    EXPECT_GT(near, all * 9 / 10) << near << " of " << all;
}

TEST_F(WholeTrade, TheCommandOfASettingMakesItsPicture) {
    const json& r = results;
    for (const char* name : {"good", "fast", "good: precision fast"}) {
        const json* setting = setting_of(r, name);
        if (!setting) continue;
        std::istringstream command((*setting)["command"].get<std::string>());
        std::vector<std::string> words;
        for (std::string word; command >> word;) words.push_back(word);
        ASSERT_EQ(words.front(), "raytrace");
        words.erase(words.begin());
        words.back() = "made.png";
        ASSERT_EQ(run(words).status, 0);
        EXPECT_EQ(run({"compare", "made.png", "trade-results/" + (*setting)["picture"].get<std::string>()}).status, 0) << name;
    }
}

TEST_F(WholeTrade, TheTableOfValuesHasALineForEachSetting) {
    std::istringstream csv(here->read("trade-results/results.csv"));
    std::string head, line;
    std::getline(csv, head);
    EXPECT_THAT(head, HasSubstr("setting,origin,state,front,comparable,samples,scale,max-trace-level"));
    std::size_t lines = 0;
    const auto columns = std::count(head.begin(), head.end(), ',');
    while (std::getline(csv, line)) {
        ++lines;
        bool quoted = false;
        long commas = 0;
        for (const char c : line) quoted ^= c == '"', commas += !quoted && c == ',';
        EXPECT_EQ(commas, columns) << line;
    }
    EXPECT_EQ(lines, results["settings"].size());
}

TEST_F(Trade, WhatIsMeasuredIsNotMeasuredAgain) {
    ASSERT_EQ(trade({"a.pov", "--settings", "12"}).status, 0);
    const json first = results();
    ASSERT_EQ(trade({"a.pov", "--settings", "12", "-q"}).status, 0);
    const json second = results();
    ASSERT_EQ(first["settings"].size(), second["settings"].size());
    for (std::size_t i = 0; i < first["settings"].size(); ++i) {
        const json &a = first["settings"][i], &b = second["settings"][i];
        EXPECT_EQ(a["name"], b["name"]);
        EXPECT_EQ(a["wall"]["trace"], b["wall"]["trace"]) << a["name"];
        EXPECT_EQ(a["error"], b["error"]);
    }
    EXPECT_EQ(first["reference"], second["reference"]);
    // A picture that has gone is made again, with its times.
    std::filesystem::remove("trade-results/" + first["settings"][0]["picture"].get<std::string>());
    ASSERT_EQ(trade({"a.pov", "--settings", "12", "-q"}).status, 0);
    EXPECT_TRUE(here.has("trade-results/" + first["settings"][0]["picture"].get<std::string>()));
    EXPECT_NE(results()["settings"][0]["wall"]["trace"], first["settings"][0]["wall"]["trace"]);
    // Nothing is taken for another scene's, of which only an include is another.
    here.write("tone.inc", "#declare Tone = <0.2, 0.2, 1>;\n");
    ASSERT_EQ(trade({"a.pov", "--settings", "12", "-q"}).status, 0);
    EXPECT_NE(results()["settings"][1]["error"], first["settings"][1]["error"]);
}

TEST_F(Trade, ABetterReferenceJudgesAllAgain) {
    ASSERT_EQ(trade({"a.pov", "--settings", "4", "--reference-error", "0.05"}).status, 0);
    const json first = results();
    ASSERT_EQ(trade({"a.pov", "--settings", "4", "--reference-error", "0.002"}).status, 0);
    const json second = results();
    EXPECT_GT(second["reference"]["samples"], first["reference"]["samples"]);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NE(second["settings"][i]["error"], first["settings"][i]["error"]);
}

/// However short the time: the presets are measured, and nothing is begun that there is no time for.
TEST_F(Trade, WhenTheTimeIsOverItEndsWithThePresets) {
    const std::vector<std::string> words{
        "a.pov", "-W", "160", "-H", "120", "--seconds", "0.1", "--run-seconds", "60", "--reference-seconds", "60"};
    const Outcome outcome = trade(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(" not run; the time was over before all was done as often as wanted: the same command goes on\n"));
    const json r = results();
    EXPECT_TRUE(r["out_of_time"]);
    EXPECT_TRUE(r["complete"]);
    for (const json& setting : r["settings"])
        EXPECT_EQ(setting["state"], setting["origin"] == "preset" ? "measured" : "not run") << setting["name"];
    EXPECT_THAT(here.read("trade-results/trade.html"), HasSubstr("The time was over before everything was measured"));
}

TEST_F(Trade, ASlowSceneGetsASmallerPictureUnlessASizeIsAsked) {
    const std::vector<std::string> words{
        "trade", "a.pov", "--runs", "1", "--seconds", "0.1", "--reference-error", "0.05", "--reference-seconds", "60"};
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, testing::StartsWith("raytrace: note: pictures of 160 x 120 instead of 640 x 480, to end in about 0.1 s; "
                                                 "--seconds, -W and -H choose\n"));
    EXPECT_EQ(results()["size"], "160 x 120");
    EXPECT_EQ(results()["words"], (json{"--width=160", "--height=120"}));
    EXPECT_THAT((*setting_of(results(), "plain"))["command"].get<std::string>(), HasSubstr("--width=160 --height=120"));
    const json first = results();
    EXPECT_EQ(run(words).status, 0);
    EXPECT_EQ(results()["size"], "160 x 120");
    EXPECT_EQ(trade({"a.pov", "--settings", "2"}).err, "raytrace: reports are in trade-results\n");
}

TEST_F(Trade, FreshMeasuresAllAgain) {
    ASSERT_EQ(trade({"a.pov", "--settings", "5"}).status, 0);
    const json first = results();
    EXPECT_EQ(first["settings"].size(), 5u);
    ASSERT_EQ(trade({"a.pov", "--settings", "5", "--fresh"}).status, 0);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NE(results()["settings"][i]["wall"]["trace"], first["settings"][i]["wall"]["trace"]);
        EXPECT_EQ(results()["settings"][i]["error"], first["settings"][i]["error"]);
    }
}

TEST_F(Trade, AnOptionThatTurnsAKnobFixesIt) {
    ASSERT_EQ(trade({"a.pov", "--settings", "6", "--max-trace-level", "2", "--F", "schlick"}).status, 0);
    const json r = results();
    for (const json& knob : r["knobs"]) {
        EXPECT_NE(knob["name"], "max-trace-level");
        EXPECT_NE(knob["name"], "fresnel");
    }
    EXPECT_THAT(r["settings"][0]["command"].get<std::string>(), HasSubstr("--max-trace-level=2"));
}

TEST_F(Trade, WhatTheSceneChoosesIsNotTurned) {
    here.write("b.pov", std::string(mirrors) + "sphere { 2*y, 0.2 finish { specular 0.5 //! raytrace: D=beckmann\n } }\n");
    ASSERT_EQ(trade({"b.pov", "--settings", "3"}).status, 0);
    const json r = results();
    std::vector<std::string> names;
    for (const json& knob : r["knobs"]) names.push_back(knob["name"]);
    EXPECT_THAT(names, testing::Contains("masking"));
    EXPECT_THAT(names, testing::Not(testing::Contains("distribution")));
}

TEST_F(Trade, SettingsThatAreTooSlowAreLeftOut) {
    const Outcome outcome =
        trade({"a.pov", "-W", "200", "-H", "150", "--settings", "4", "--run-seconds", "0.001", "--reference-error", "0.1"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("too slow"));
    const json r = results();
    EXPECT_EQ((*setting_of(r, "exact"))["state"], "too slow");
    EXPECT_GT((*setting_of(r, "exact"))["expected_seconds"].get<double>(), 0.001);
}

TEST_F(Trade, AnInterruptionKeepsWhatIsMeasuredAndReportsIt) {
    const std::vector<std::string> words{"trade", "a.pov",      "-W", "160", "-H", "120", "--runs", "1", "--reference-error",
                                         "0.05",  "--settings", "12"};
    const Outcome outcome = test::run_and_interrupt(words, {SIGINT});
    ASSERT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.err, "raytrace: interrupted; reports are in trade-results\n");
    EXPECT_FALSE(results()["complete"]);
    EXPECT_TRUE(here.has("trade-results/trade.html"));
    EXPECT_EQ(run(words).status, 0);
    EXPECT_TRUE(results()["complete"]);
    EXPECT_EQ(results()["settings"].size(), 12u);
    // What was reported once is reported after an interruption as well, however early that comes.
    std::vector<std::string> further = words;
    further.insert(further.end(), {"--reference-error", "0.0001", "--reference-seconds", "600"});
    ASSERT_EQ(test::run_and_interrupt(further, {SIGINT}).status, 2);
    EXPECT_EQ(results()["settings"].size(), 12u);
    std::filesystem::remove("trade-results/" + results()["settings"][3]["picture"].get<std::string>());
    further = words;
    further.insert(further.end(), {"--runs", "1000"});
    ASSERT_EQ(test::run_and_interrupt(further, {SIGINT}).status, 2);
    const json last = results();
    std::size_t measured = 0;
    for (const json& setting : last["settings"]) measured += setting["state"] == "measured";
    EXPECT_FALSE(last["complete"]);
    EXPECT_EQ(last["settings"].size(), 12u);
    EXPECT_GE(measured, 11u);
}

TEST_F(Trade, TwoInOneFolderAreRefused) {
    ASSERT_EQ(trade({"a.pov", "--settings", "2"}).status, 0);
    const std::string before = here.read("trade-results/results.json");
    LockFile other("trade-results/lock");
    ASSERT_TRUE(other.try_lock(0, LockFile::Kind::exclusive));
    const Outcome outcome = trade({"a.pov", "--settings", "3"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "raytrace: another trade is at work in 'trade-results'; give this one a folder of its own with -o\n");
    EXPECT_EQ(here.read("trade-results/results.json"), before);
    other.unlock(0);
    EXPECT_EQ(trade({"a.pov", "--settings", "3"}).status, 0);
}

TEST_F(Trade, ADamagedPictureOfTheReferenceIsMadeAgain) {
    ASSERT_EQ(trade({"a.pov", "--settings", "3"}).status, 0);
    const json first = results();
    for (const auto& entry : std::filesystem::recursive_directory_iterator("trade-results/known"))
        if (entry.path().filename() == "film") {
            std::fstream film(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
            film.seekp(16);
            film.write("\x00\x00\x80\x3f", 4);
        }
    ASSERT_EQ(trade({"a.pov", "--settings", "3"}).status, 0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(results()["settings"][i]["error"], first["settings"][i]["error"]);
}

TEST_F(Trade, MistakesAreToldInFull) {
    const auto message = [](std::vector<std::string> words, int status) {
        words.insert(words.begin(), "trade");
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_EQ(message({}, 1), "raytrace: trade: expected a scene; see raytrace trade --help\n");
    EXPECT_EQ(message({"a.pov", "b.pov"}, 1), "raytrace: trade: one scene at a time: 'a.pov' or 'b.pov'?\n");
    EXPECT_EQ(message({"none.pov"}, 1), "File 'none.pov': Parse Error: Cannot open input file.\n");
    EXPECT_EQ(message({"a.pov", "--setings", "3"}, 1), "raytrace: unknown option '--setings'; did you mean '--settings'?\n");
    EXPECT_EQ(message({"a.pov", "--ss", "3"}, 1), "raytrace: trade: without --ss: it varies the samples and qualities itself\n");
    EXPECT_EQ(message({"a.pov", "+A0.3"}, 1), "raytrace: trade: without --antialias: it varies the samples and qualities itself\n");
    EXPECT_EQ(message({"a.pov", "--scale", "2"}, 1), "raytrace: trade: without --scale: it varies the samples and qualities itself\n");
    EXPECT_EQ(message({"a.pov", "--bits", "16"}, 1),
              "raytrace: trade: without --bits: it names its pictures itself and shows all of them\n");
    EXPECT_EQ(message({"a.pov", "--stats"}, 1), "raytrace: trade: without --stats: it names its pictures itself and shows all of them\n");
    EXPECT_EQ(message({"a.pov", "--cost", "money"}, 1), "raytrace: 'money' is no cost; expected one of wall, cpu\n");
    EXPECT_EQ(message({"a.pov", "--runs", "3,2"}, 1), "raytrace: runs: 2 is outside 3 to 1000\n");
    EXPECT_EQ(message({"a.pov", "--runs", "1,2,3"}, 1), "raytrace: runs: expected LEAST,MOST, not '1,2,3'\n");
    EXPECT_EQ(message({"a.pov", "-W", "0"}, 1), "raytrace: width: 0 is outside 1 to 1000000\n");
    EXPECT_EQ(message({"a.pov", "-W", "100000", "-H", "100000"}, 1),
              "raytrace: 100000 x 100000 pixels are too many to compare; at most 33554432 are\n");
    here.write("file", "");
    EXPECT_EQ(message({"a.pov", "-o", "file/x"}, 3), "raytrace: cannot make the folder 'file/x': Not a directory\n");
    EXPECT_FALSE(here.has("trade-results"));
}

TEST_F(Trade, AFullOutputIsToldAndKeepsTheReports) {
    std::vector<std::string> words{"trade", "a.pov", "-W", "8", "-H", "6", "--runs", "1", "--reference-error", "0.1", "--settings", "3"};
    EXPECT_EQ(run(words, "/dev/full").status, 3);
    EXPECT_TRUE(here.has("trade-results/results.json"));
}

}  // namespace
}  // namespace rt::trade_program_test
