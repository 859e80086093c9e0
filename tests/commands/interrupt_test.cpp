// Signals to the program itself: what it keeps, what it leaves behind.
#include <gtest/gtest.h>

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "commands/base/interrupt.h"
#include "film/image_file.h"
#include "film/temporary_files.h"
#include "tests/commands/support.h"

namespace rt::interrupt_test {
namespace {

using test::Outcome;
using test::run_and_interrupt;
using test::run_and_interrupt_at_file;
using Files = std::vector<std::string>;

class Interrupts : public testing::Test {
protected:
    Interrupts() {
        here.write("a.pov", test::small_scene);
        here.write("b.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 1 }\nsphere { -9*z, 1 }\n");
    }
    test::Workplace here;
};

/// Ignores a signal, as nohup does for the programs it starts.
class Ignored {
public:
    explicit Ignored(int signal) : signal_(signal), before_(std::signal(signal, SIG_IGN)) {}
    ~Ignored() { std::signal(signal_, before_); }
    Ignored(const Ignored&) = delete;
    Ignored& operator=(const Ignored&) = delete;

private:
    int signal_;
    void (*before_)(int);
};

const std::vector<std::string> long_run{"a.pov", "--size=4000x4000", "-ss=16", "-t2", "--index=brute_force", "-o", "out.png"};
const std::vector<std::string> short_run{"a.pov", "--size=1200x900", "-ss=2", "-t2", "--index=brute_force", "-o", "out.png"};

TEST_F(Interrupts, ALostTerminalKeepsWhatIsFinished) {
    const Outcome outcome = run_and_interrupt(long_run, {SIGHUP});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "raytrace: interrupted; what was finished is in 'out.partial.png'\n");
    EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov", "out.partial.png"}));
}

TEST_F(Interrupts, ASecondOneEndsAtOnceWhateverItsKind) {
    for (const std::vector<int>& pair : {std::vector<int>{SIGINT, SIGHUP}, std::vector<int>{SIGTERM, SIGHUP}}) {
        const Outcome outcome = run_and_interrupt(long_run, pair);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.err, "\nraytrace: interrupted\n");
        EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov"}));
    }
}

TEST_F(Interrupts, WhatWasIgnoredWhenTheProgramStartedStaysIgnored) {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
        const Ignored ignored(signal);
        const Outcome outcome = run_and_interrupt(short_run, {signal});
        EXPECT_EQ(outcome.status, 0) << signal;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov", "out.png"}));
    }
}

TEST_F(Interrupts, OneWhileThePictureIsWrittenLetsItBeFinished) {
    const Outcome outcome = run_and_interrupt_at_file({"b.pov", "--size=3000x3000", "-o", "out.png"}, ".tmp", {SIGINT});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov", "out.png"}));
    EXPECT_EQ(read_image("out.png").height, 3000);
}

TEST_F(Interrupts, ASecondOneWhileThePictureIsWrittenLeavesNoTemporaryFile) {
    here.write("out.png", "old");
    const Outcome outcome = run_and_interrupt_at_file({"b.pov", "--size=3000x3000", "-o", "out.png"}, ".tmp", {SIGINT, SIGTERM});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "\nraytrace: interrupted\n");
    EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov", "out.png"}));
    EXPECT_EQ(here.read("out.png"), "old");
}

TEST_F(Interrupts, NorTheScratchFileOfAnotherFormat) {
    ASSERT_EQ(setenv("TMPDIR", ".", 1), 0);
    const Outcome outcome = run_and_interrupt_at_file({"b.pov", "--size=3000x3000", "-o", "out.tif"}, "raytrace.", {SIGINT, SIGTERM});
    unsetenv("TMPDIR");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(here.files(), (Files{"a.pov", "b.pov"}));
}

void raise_in_another_thread(int signal) {
    std::thread([signal] {
        sigset_t none;
        sigemptyset(&none);
        pthread_sigmask(SIG_SETMASK, &none, nullptr);
        raise(signal);
    }).join();
}

/// Makes a file as the program makes its temporary ones, while other threads take the program's signals.
[[noreturn]] void make_a_file_among_signals() {
    install_signal_handlers();
    const StopOnSignal signals;
    {
        const HoldSignals until_registered;
        std::ofstream("half.tmp") << "half";
        raise_in_another_thread(SIGINT);
        if (!signals.stop()) _exit(101);
        raise_in_another_thread(SIGTERM);
        remember_temporary("half.tmp");
    }
    _exit(102);
}

TEST(SignalsDeathTest, ThatAnotherThreadTakesWaitUntilATemporaryFileIsRegistered) {
    const test::Workplace here;
    EXPECT_EXIT(make_a_file_among_signals(), testing::ExitedWithCode(exit_interrupted), "raytrace: interrupted");
    EXPECT_EQ(here.files(), Files{});
}

}  // namespace
}  // namespace rt::interrupt_test
