// Turns of graders: what is together, what is alone, and that the dead are not waited for.
#include <gtest/gtest.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include "grading/turn.h"

namespace rt::turn_test {
namespace {

namespace fs = std::filesystem;
using Kind = Turn::Kind;

class Turns : public testing::Test {
protected:
    Turns() : folder_(fs::temp_directory_path() / ("turns_" + std::to_string(getpid()))) { fs::create_directory(folder_); }
    ~Turns() override { fs::remove_all(folder_); }
    std::string place() const { return (folder_ / "turns").string(); }
    std::unique_ptr<Turn> turn(Kind kind) const { return std::make_unique<Turn>(place(), kind); }

    /// A process that has such a turn, and ends it when told to.
    class Other {
    public:
        Other(const std::string& place, Kind kind) {
            if (pipe(told_) != 0 || pipe(tells_) != 0) throw std::runtime_error("pipe");
            process_ = fork();
            if (process_ != 0) {
                close(told_[1]), close(tells_[0]);
                return;
            }
            close(told_[0]), close(tells_[1]);
            const Turn turn(place, kind);
            char sign = 0;
            _exit(write(told_[1], &sign, 1) == 1 && read(tells_[0], &sign, 1) == 1 ? 0 : 1);
        }
        ~Other() {
            kill();
            close(tells_[1]), close(told_[0]);
        }
        /// Waits until it has its turn.
        void await() {
            char sign = 0;
            ASSERT_EQ(read(told_[0], &sign, 1), 1);
        }
        bool has_turn() const {
            fd_set set;
            FD_ZERO(&set);
            FD_SET(told_[0], &set);
            timeval now{0, 0};
            return select(told_[0] + 1, &set, nullptr, nullptr, &now) == 1;
        }
        /// Waits until it waits itself: for its turn, or with it.
        void settle() const {
            std::string state;
            while (state != "S") {
                std::ifstream stat("/proc/" + std::to_string(process_) + "/stat");
                std::string number, name;
                if (!(stat >> number >> name >> state)) throw std::runtime_error("the process has ended");
            }
        }
        void end() {
            ASSERT_EQ(write(tells_[1], "", 1), 1);
            waitpid(process_, nullptr, 0), process_ = 0;
        }
        void kill() {
            if (process_ > 0) ::kill(process_, SIGKILL), waitpid(process_, nullptr, 0), process_ = 0;
        }

    private:
        int told_[2], tells_[2];
        pid_t process_ = -1;
    };

    fs::path folder_;
};

TEST_F(Turns, OneWithNothingBesideItWasAlone) {
    for (const Kind kind : {Kind::together, Kind::alone, Kind::together}) EXPECT_TRUE(turn(kind)->was_alone());
}

TEST_F(Turns, ThoseTogetherWereNot) {
    const auto first = turn(Kind::together);
    EXPECT_TRUE(first->was_alone());
    const auto second = turn(Kind::together);
    EXPECT_FALSE(first->was_alone()) << "since then";
    EXPECT_FALSE(second->was_alone());
}

TEST_F(Turns, WhatHasEndedMeanwhileCounts) {
    const auto first = turn(Kind::together);
    turn(Kind::together).reset();
    EXPECT_FALSE(first->was_alone());
    auto second = turn(Kind::together);
    const auto third = turn(Kind::together);
    second.reset();
    EXPECT_FALSE(third->was_alone());
}

TEST_F(Turns, OneAloneWaitsForThoseBeforeAndIsNotPassed) {
    Other before(place(), Kind::together);
    before.await();
    Other alone(place(), Kind::alone);
    alone.settle();
    EXPECT_FALSE(alone.has_turn());
    Other after(place(), Kind::together);
    after.settle();
    EXPECT_FALSE(after.has_turn()) << "it has come later";
    before.end();
    alone.await();
    after.settle();
    EXPECT_FALSE(after.has_turn());
    alone.end();
    after.await();
}

TEST_F(Turns, TheDeadAreNotWaitedFor) {
    for (const Kind kind : {Kind::together, Kind::alone}) {
        Other other(place(), kind);
        other.await();
        other.kill();
        EXPECT_TRUE(turn(Kind::alone)->was_alone());
    }
}

TEST_F(Turns, WithoutAPlaceNothingIsKnown) {
    EXPECT_FALSE(Turn("", Kind::together).was_alone());
    EXPECT_FALSE(Turn("", Kind::alone).was_alone());
}

TEST_F(Turns, NothingButAFileOfOurOwnIsAPlace) {
    fs::create_symlink(folder_ / "elsewhere", place());
    EXPECT_THROW(turn(Kind::together), std::system_error);
    EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
    fs::remove(place());
    ASSERT_EQ(mkfifo(place().c_str(), 0600), 0);
    EXPECT_THROW(turn(Kind::together), std::system_error);
}

}  // namespace
}  // namespace rt::turn_test
