// Runs and their grader: whatever it does with signals, and when it is killed in the middle.
#include "grading/keeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cerrno>
#include <functional>

#include "tests/grading/place.h"

namespace rt::keeper_test {
namespace {

using test::described;
using test::Place;
using test::short_limits;
using testing::HasSubstr;

const Containment& here() {
    static const Containment found = find_containment();
    return found;
}

bool eventually(const std::function<bool()>& holds) {
    for (int i = 0; i < 10'000; ++i) {
        if (holds()) return true;
        usleep(1000);
    }
    return false;
}

std::vector<std::string> groups_of(pid_t grader) {
    std::vector<std::string> found;
    for (const std::string& folder : {here().memory_group, here().pids_group}) {
        if (folder.empty()) continue;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().filename().string().starts_with(fmt::format("raytrace-{}-", grader))) found.push_back(entry.path());
        }
    }
    return found;
}

class Grader : public testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        if (!GetParam()) containment_.bubblewrap.clear();
        if (GetParam() && containment_.bubblewrap.empty()) GTEST_SKIP() << "bubblewrap: " << containment_.bubblewrap_problem;
    }
    Containment containment_ = here();
    Place place_;
};

TEST_P(Grader, NothingIsLeftWhenItIsKilled) {
    const std::string marker = "marker-" + place_.root.substr(place_.root.size() - 6);
    const pid_t grader = fork();
    if (grader == 0) {
        run_contained(place_.deed({"deaf", marker}), short_limits(), containment_, 0);
        _exit(0);
    }
    EXPECT_TRUE(eventually([&] { return test::processes_with(marker) >= 2; }));
    kill(grader, SIGKILL);
    waitpid(grader, nullptr, 0);
    EXPECT_TRUE(eventually([&] { return test::processes_with(marker) == 0; }));
    EXPECT_TRUE(eventually([&] { return groups_of(grader).empty(); }));
    EXPECT_EQ(described(run_contained(place_.deed({"exit", "3"}), short_limits(), containment_, 0)), "exited 3");
}

TEST_P(Grader, ItsSignalsDoNotMatterAndStay) {
    const auto ends_well = [&] {
        const Ending ending = run_contained(place_.shell("yes | head -n 1; trap '' PIPE; exit 5"), short_limits(), containment_, 0);
        return described(ending) == "exited 5" && ending.output == "y\n";
    };
    void (*const reap)(int) = [](int) {
        const int kept = errno;
        waitpid(-1, nullptr, WNOHANG);
        errno = kept;
    };
    sigset_t all, before, after;
    sigfillset(&all);
    for (const auto& [number, handler] :
         {std::pair{SIGCHLD, SIG_IGN}, std::pair{SIGCHLD, reap}, std::pair{SIGPIPE, SIG_DFL}, std::pair{SIGPIPE, SIG_IGN}}) {
        const auto old = signal(number, handler);
        EXPECT_TRUE(ends_well()) << number;
        EXPECT_EQ(signal(number, old), handler) << number;
    }
    sigprocmask(SIG_SETMASK, &all, &before);
    EXPECT_TRUE(ends_well());
    sigprocmask(SIG_SETMASK, &before, &after);
    EXPECT_TRUE(sigismember(&after, SIGTERM));
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a zombie is left";
}

TEST_P(Grader, RunsAtTheSameTimeDoNotMeet) {
    // All take the first slot: as graders do that know nothing of each other.
    constexpr int many = 6;
    Place places[many];
    std::vector<pid_t> graders;
    for (const Place& place : places) {
        graders.push_back(fork());
        if (graders.back() != 0) continue;
        const Ending ending = run_contained(place.shell("sleep 0.2; echo $$ >mine; id -u"), short_limits(), containment_, 0);
        const std::string user = containment_.own_user ? "610" : std::to_string(geteuid());
        _exit(described(ending) == "exited 0" && ending.output.starts_with(user) && !ending.left_processes ? 0 : 1);
    }
    for (pid_t grader : graders) {
        int status = 1;
        waitpid(grader, &status, 0);
        EXPECT_EQ(status, 0);
    }
    for (const Place& place : places) EXPECT_TRUE(std::filesystem::exists(place.folder + "/mine"));
}

INSTANTIATE_TEST_SUITE_P(With, Grader, testing::Bool(), [](const auto& info) { return info.param ? "Bubblewrap" : "Limits"; });

TEST(Containment, HolesSayWhatIsNotContained) {
    Containment full;
    full.bubblewrap = "/usr/bin/bwrap";
    full.memory_group = full.pids_group = "/sys/fs/cgroup/x";
    full.own_user = true;
    EXPECT_THAT(holes(full), testing::IsEmpty());
    Containment bare;
    bare.bubblewrap_problem = "it is not installed";
    const std::vector<std::string> sentences = holes(bare);
    ASSERT_GE(sentences.size(), 5u);
    EXPECT_EQ(sentences[0],
              "Without bubblewrap (it is not installed) programs read every file that you may read, expected results among them.");
    EXPECT_THAT(sentences, testing::Contains(HasSubstr("Memory is limited for each process")));
    for (const std::string& sentence : sentences) EXPECT_TRUE(sentence.ends_with('.')) << sentence;
}

TEST(Containment, ABubblewrapThatFailsIsNoneAndSaysWhy) {
    const Place place;
    std::filesystem::create_directory(place.root + "/path");
    std::ofstream(place.root + "/path/bwrap") << "#!/bin/sh\necho 'No permissions to create a new namespace' >&2; exit 1\n";
    ASSERT_EQ(chmod((place.root + "/path/bwrap").c_str(), 0755), 0);
    const std::string path = std::getenv("PATH");
    setenv("PATH", (place.root + "/path").c_str(), 1);
    const Containment broken = find_containment();
    setenv("PATH", place.root.c_str(), 1);
    const Containment absent = find_containment();
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(broken.bubblewrap, "");
    EXPECT_THAT(broken.bubblewrap_problem, HasSubstr("No permissions to create a new namespace"));
    EXPECT_EQ(absent.bubblewrap_problem, "it is not installed");
}

}  // namespace
}  // namespace rt::keeper_test
