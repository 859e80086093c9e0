// Jobs in processes of their own: order, number at a time, and whatever may end them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "core/source.h"
#include "grading/workers.h"

namespace rt::workers_test {
namespace {

const std::atomic<bool> never{false};

TEST(Workers, EveryJobOnceAndNoMoreThanAllowedAtATime) {
    std::set<std::size_t> begun, done;
    std::size_t most = 0;
    JobCalls calls;
    calls.begin = [&](std::size_t job) {
        EXPECT_EQ(begun.size(), job) << "in their order";
        begun.insert(job);
        most = std::max(most, begun.size() - done.size());
    };
    calls.work = [](std::size_t, int) {};
    calls.done = [&](std::size_t job, const WorkerEnd& end) {
        EXPECT_TRUE(end.done);
        EXPECT_TRUE(done.insert(job).second);
    };
    run_jobs(50, 3, calls, never);
    EXPECT_EQ(done.size(), 50u);
    EXPECT_EQ(most, 3u);
}

TEST(Workers, JobsAtTheSameTimeHaveDifferentSlots) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("workers_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    JobCalls calls;
    calls.work = [&](std::size_t, int slot) {
        const std::string lock = (folder / std::to_string(slot)).string();
        if (!std::filesystem::create_directory(lock)) throw 1;
        usleep(2000);
        std::filesystem::remove(lock);
    };
    calls.done = [](std::size_t, const WorkerEnd& end) { EXPECT_TRUE(end.done); };
    run_jobs(40, 4, calls, never);
    std::filesystem::remove_all(folder);
}

TEST(Workers, WhatEndsOneLeavesTheOthers) {
    std::map<std::size_t, WorkerEnd> ends;
    JobCalls calls;
    calls.work = [](std::size_t job, int) {
        if (job == 1) throw std::runtime_error("no");
        if (job == 2) raise(SIGKILL);
    };
    calls.done = [&](std::size_t job, const WorkerEnd& end) { ends[job] = end; };
    run_jobs(4, 2, calls, never);
    EXPECT_TRUE(ends.at(0).done && ends.at(3).done);
    EXPECT_FALSE(ends.at(1).done);
    EXPECT_EQ(ends.at(1).signal, 0);
    EXPECT_EQ(ends.at(2).signal, SIGKILL);
}

TEST(Workers, WhatCannotBeWrittenIsToldApart) {
    std::map<std::size_t, WorkerEnd> ends;
    JobCalls calls;
    calls.work = [](std::size_t job, int) {
        if (job == 0) throw OutputError("no room");
        throw OptionError("no such file");
    };
    calls.done = [&](std::size_t job, const WorkerEnd& end) { ends[job] = end; };
    run_jobs(2, 2, calls, never);
    EXPECT_TRUE(ends.at(0).not_written);
    EXPECT_EQ(ends.at(0).problem, "no room");
    EXPECT_FALSE(ends.at(0).done || ends.at(1).done || ends.at(1).not_written);
}

TEST(Workers, StopEndsWhatRuns) {
    std::atomic<bool> stop{false};
    std::size_t done = 0;
    JobCalls calls;
    calls.work = [](std::size_t, int) {
        while (true) pause();
    };
    calls.done = [&](std::size_t, const WorkerEnd&) { ++done; };
    calls.idle = [&] { stop = true; };
    run_jobs(10, 2, calls, stop);
    EXPECT_EQ(done, 0u);
}

TEST(Workers, ALongComplaintEndsWithAWholeCharacter) {
    WorkerEnd told;
    JobCalls calls;
    calls.work = [](std::size_t, int) { throw std::runtime_error(std::string(4095, 'x') + "\xC3\xA4"); };
    calls.done = [&](std::size_t, const WorkerEnd& end) { told = end; };
    run_jobs(1, 1, calls, never);
    EXPECT_EQ(told.problem, std::string(4095, 'x'));
}

}  // namespace
}  // namespace rt::workers_test
