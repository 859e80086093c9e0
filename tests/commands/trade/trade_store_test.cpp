// What is measured stays known by all that it depends on.
#include "commands/trade/trade_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/source.h"
#include "tests/commands/support.h"

namespace rt::trade_store_test {
namespace {

class TradeStoreTest : public testing::Test {
protected:
    test::Workplace here;
};

Measured some_measurement() {
    Measured m;
    m.runs = {{{0.0, 0.25, 1.5, 0.125}, {0.0, 0.5, 3.0, 0.125}}, {{0.0, 0.26, 1.6, 0.126}, {0.0, 0.6, 3.1, 0.126}}};
    m.rays = {1u << 20, 5'000'000'000u, 3, 4, 5};
    m.non_finite = 7;
    m.error = {0.0123456789012345, 0.5, 0.75, 0.0625};
    m.picture = "hash";
    return m;
}

TEST_F(TradeStoreTest, GivesBackWhatWasPut) {
    const TradeStore store("known", "content", false);
    EXPECT_FALSE(store.measured("--ss 2"));
    const Measured put = some_measurement();
    store.put_measured("--ss 2", put);
    const std::optional<Measured> got = TradeStore("known", "content", false).measured("--ss 2");
    ASSERT_TRUE(got);
    ASSERT_EQ(got->runs.size(), 2u);
    EXPECT_EQ(got->runs[1].wall.trace, 1.6);
    EXPECT_EQ(got->runs[1].cpu.build, 0.6);
    EXPECT_EQ(got->runs[0].wall.write, 0.125);
    EXPECT_EQ(got->rays.shadow, 5'000'000'000u);
    EXPECT_EQ(got->rays.edge, 5u);
    EXPECT_EQ(got->non_finite, 7u);
    EXPECT_EQ(got->error.rmse, put.error.rmse);
    EXPECT_EQ(got->error.flip, 0.0625);
    EXPECT_EQ(got->picture, "hash");
}

TEST_F(TradeStoreTest, KnowsNothingOfOtherContentOtherWordsOrAnotherKind) {
    TradeStore("known", "content", false).put_measured("--ss 2", some_measurement());
    EXPECT_FALSE(TradeStore("known", "other content", false).measured("--ss 2"));
    EXPECT_FALSE(TradeStore("known", "content", false).measured("--ss 3"));
    EXPECT_FALSE(TradeStore("known", "content", false).alone("--ss 2"));
}

TEST_F(TradeStoreTest, FreshKnowsOnlyWhatItPut) {
    TradeStore("known", "content", false).put_alone("a", 0.5);
    const TradeStore fresh("known", "content", true);
    EXPECT_FALSE(fresh.alone("a"));
    fresh.put_alone("a", 0.25);
    EXPECT_EQ(fresh.alone("a"), 0.25);
    EXPECT_EQ(TradeStore("known", "content", false).alone("a"), 0.25);
}

TEST_F(TradeStoreTest, KeepsTheSizeByTheTimeOfTheTrade) {
    TradeStore("known", "content", false).put_size("300", 0.75);
    const TradeStore store("known", "content", false);
    EXPECT_EQ(store.size("300"), 0.75);
    EXPECT_FALSE(store.size("60"));
    EXPECT_FALSE(store.alone("300"));
}

TEST_F(TradeStoreTest, KeepsTheReferenceWithEveryBit) {
    KnownReference reference{{74.0, 0.001, 0.0, 12.5, {5, 7}}, Film(2, 1)};
    reference.film.pixels = {{0.1f, 1e-30f, 1e30f, 0.5f}, {1.0f / 3.0f, 2.0f, 3.0f, 0.0f}};
    TradeStore("known", "content", false).put_reference("--ss 2", reference);
    const TradeStore store("known", "content", false);
    const std::optional<KnownReference> got = store.reference("--ss 2", 2, 1);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->film.pixels, reference.film.pixels);
    EXPECT_EQ(got->facts.grids, (std::vector<int>{5, 7}));
    EXPECT_EQ(got->facts.samples, 74.0);
    EXPECT_EQ(got->facts.error, 0.001);
    EXPECT_EQ(got->facts.seconds, 12.5);
    EXPECT_FALSE(store.reference("--ss 2", 1, 1)) << "of another size";
}

TEST_F(TradeStoreTest, ADamagedReferenceIsNotThere) {
    KnownReference reference{{74.0, 0.001, 0.0, 12.5, {5, 7}}, Film(2, 1)};
    const TradeStore store("known", "content", false);
    const auto spoil = [&](const std::string& name, const std::string& what, const std::string& instead) {
        store.put_reference("--ss 2", reference);
        ASSERT_TRUE(store.reference("--ss 2", 2, 1));
        for (const auto& entry : std::filesystem::recursive_directory_iterator("known")) {
            if (entry.path().filename() != name) continue;
            std::string text = here.read(entry.path().string());
            const std::size_t at = text.find(what);
            ASSERT_NE(at, std::string::npos) << what;
            std::ofstream(entry.path()) << text.replace(at, what.size(), instead);
        }
        EXPECT_FALSE(store.reference("--ss 2", 2, 1)) << what << " became " << instead;
    };
    spoil("film", std::string(1, '\0'), "\x40");
    spoil("record.json", "12.5", "-12.5");
    spoil("record.json", "12.5", "1e999");
    spoil("record.json", "12.5", "\"NaN\"");
    spoil("record.json", "0.001", "\"Infinity\"");
}

TEST_F(TradeStoreTest, ATimeBelowZeroIsNoMeasurement) {
    const TradeStore store("known", "content", false);
    Measured m = some_measurement();
    m.runs[0].wall.trace = -1.5;
    store.put_measured("--ss 2", m);
    EXPECT_FALSE(store.measured("--ss 2"));
    store.put_alone("--ss 2", -0.5);
    EXPECT_FALSE(store.alone("--ss 2"));
}

TEST_F(TradeStoreTest, KeepsWhichSettingsThereWere) {
    const std::vector<KnownSetting> put{{{{1, as_stated, 0}}, Origin::preset, false, 0.0}, {{{2, 0, 3}}, Origin::neighbour, true, 7.5}};
    TradeStore("known", "content", false).put_settings(put);
    const std::vector<KnownSetting> got = TradeStore("known", "content", false).settings();
    ASSERT_EQ(got.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(got[i].setting, put[i].setting);
        EXPECT_EQ(got[i].origin, put[i].origin);
        EXPECT_EQ(got[i].too_slow, put[i].too_slow);
        EXPECT_EQ(got[i].expected_seconds, put[i].expected_seconds);
    }
    EXPECT_TRUE(TradeStore("known", "other", false).settings().empty());
}

TEST_F(TradeStoreTest, KeepsWhatHangsByTheLastBitsByCause) {
    UnstableCount put{12, {}};
    put.by_cause[static_cast<std::size_t>(UnstableCause::depth)] = 12;
    TradeStore("known", "content", false).put_unstable("--ss 2", put);
    const std::optional<UnstableCount> got = TradeStore("known", "content", false).unstable("--ss 2");
    ASSERT_TRUE(got);
    EXPECT_EQ(got->pixels, 12u);
    EXPECT_EQ(got->by_cause, put.by_cause);
    EXPECT_EQ(unstable_text(*got), "12 pixels move with the rounding of numbers (12 depth)");
    EXPECT_EQ(unstable_text({}), "0 pixels move with the rounding of numbers");
}

TEST_F(TradeStoreTest, WhatCannotBeReadIsNotThere) {
    const TradeStore store("known", "content", false);
    store.put_measured("--ss 2", some_measurement());
    for (const auto& entry : std::filesystem::recursive_directory_iterator("known"))
        if (entry.is_regular_file()) std::ofstream(entry.path()) << "{\"runs\": 3}";
    EXPECT_FALSE(store.measured("--ss 2"));
    for (const auto& entry : std::filesystem::recursive_directory_iterator("known"))
        if (entry.is_regular_file()) std::ofstream(entry.path()) << "{";
    EXPECT_FALSE(store.measured("--ss 2"));
}

TEST_F(TradeStoreTest, AFolderThatCannotBeMadeIsTold) {
    here.write("known", "a file");
    EXPECT_THROW(TradeStore("known", "content", false), OutputError);
}

}  // namespace
}  // namespace rt::trade_store_test
