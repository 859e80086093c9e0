// What a program can do in the sandbox, by programs that try: once for each way in which machines can contain them.
#include "grading/sandbox.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <functional>

#include "grading/run_folder.h"
#include "tests/grading/place.h"

namespace rt::sandbox_test {
namespace {

using test::described;
using test::Place;
using test::processes_with;
using test::short_limits;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

const Containment& here() {
    static const Containment found = find_containment();
    return found;
}

/// A machine of some kind, as this one can be used: less of what it has, or by somebody who is not root.
struct Machine {
    const char* name;
    bool bubblewrap, groups, own_user, root;
};

class Sandbox : public testing::TestWithParam<Machine> {
protected:
    const uid_t somebody = 1'000'000 + static_cast<uid_t>(getpid());  // nobody else's processes count as theirs

    void SetUp() override {
        containment_ = here();
        const Machine& machine = GetParam();
        if (machine.bubblewrap && containment_.bubblewrap.empty()) GTEST_SKIP() << "bubblewrap: " << containment_.bubblewrap_problem;
        if (machine.groups && containment_.memory_group.empty()) GTEST_SKIP() << "no control groups can be made here";
        if (machine.own_user && !containment_.own_user) GTEST_SKIP() << "only root can give runs a user";
        if (!machine.root && geteuid() == 0 && !containment_.own_user) GTEST_SKIP() << "we cannot become somebody else here";
        if (!machine.bubblewrap) containment_.bubblewrap.clear();
        if (!machine.groups) containment_.memory_group = containment_.pids_group = "";
        containment_.own_user = machine.own_user;
    }

    Ending run(const ContainedRun& what, const Limits& limits = short_limits()) {
        if (GetParam().root || geteuid() != 0) return run_contained(what, limits, containment_, 3);
        if (chown(what.folder.c_str(), somebody, somebody) != 0 && errno != ENOENT) throw std::runtime_error("chown");
        return test::run_as(somebody, what, limits, containment_);
    }
    /// What the hostile program prints of its deed.
    std::string said(std::vector<std::string> words) {
        const Ending ending = run(place_.deed(std::move(words)));
        return ending.kind == Ending::Kind::exited ? ending.output : described(ending);
    }
    bool has_room() const { return !containment_.bubblewrap.empty(); }

    Place place_;
    Containment containment_;
};

TEST_P(Sandbox, TellsHowAProgramEnded) {
    for (int status : {0, 1, 42, 126, 127, 139, 255}) {
        EXPECT_EQ(described(run(place_.deed({"exit", std::to_string(status)}))), fmt::format("exited {}", status));
    }
    for (int signal : {SIGABRT, SIGFPE, SIGKILL, SIGTERM, SIGSEGV}) {
        EXPECT_EQ(described(run(place_.deed({"signal", std::to_string(signal)}))), fmt::format("signal {}", signal));
    }
    EXPECT_EQ(described(run(place_.deed({"crash"}))), "signal 11");
}

TEST_P(Sandbox, ProgramsThatCannotBeExecutedHaveNotStarted) {
#ifdef __SANITIZE_ADDRESS__
    if (!GetParam().groups) GTEST_SKIP() << "a limit of addresses leaves none for the sanitizer's own stacks";
#endif
    ContainedRun absent = place_.deed({});
    absent.command = {place_.folder + "/absent"};
    EXPECT_THAT(described(run(absent)), StartsWith("not started: executing the program: No such file"));
    std::ofstream(place_.folder + "/text") << "no program\n";
    ASSERT_EQ(chmod((place_.folder + "/text").c_str(), 0755), 0);
    absent.command = {place_.folder + "/text"};
    EXPECT_THAT(described(run(absent)), StartsWith("not started: executing the program: Exec format error"));
    ContainedRun elsewhere = place_.deed({"exit", "0"});
    elsewhere.working_folder = place_.folder + "/absent";
    EXPECT_THAT(described(run(elsewhere)), StartsWith("not started: entering the working folder: No such file"));
    elsewhere.folder = place_.folder + "/absent";
    EXPECT_THAT(described(run(elsewhere)), StartsWith("not started: "));
}

TEST_P(Sandbox, WhatWasWrittenBeforeACrashIsThere) {
    const Ending ending =
        run(place_.shell("echo half >output.png; printf 'out\\n'; printf 'err\\000\\377\\n' >&2; printf out; kill -SEGV $$"));
    EXPECT_EQ(described(ending), "signal 11");
    EXPECT_EQ(ending.output, std::string("out\nerr\0\xff\nout", 13));
    std::ifstream written(place_.folder + "/output.png");
    std::string text;
    EXPECT_TRUE(written >> text && text == "half");
    struct stat status {};
    ASSERT_EQ(stat((place_.folder + "/output.png").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, GetParam().root ? geteuid() : somebody);
}

TEST_P(Sandbox, ItsScratchIsInItsFolderIfAskedFor) {
    ContainedRun with_scratch = place_.shell("echo $TMPDIR; echo x > $TMPDIR/file");
    with_scratch.scratch = place_.folder + "/scratch";
    std::filesystem::create_directory(with_scratch.scratch);
    std::filesystem::permissions(with_scratch.scratch, std::filesystem::perms::all);
    EXPECT_EQ(run(with_scratch).output, with_scratch.scratch + "\n");
    EXPECT_TRUE(std::filesystem::exists(with_scratch.scratch + "/file"));
    EXPECT_EQ(run(place_.shell("echo $TMPDIR")).output, (has_room() ? "/tmp" : place_.folder) + "\n");
}

TEST_P(Sandbox, TimeEnds) {
    Limits limits = short_limits();
    limits.wall_seconds = 0.3;
    const std::string marker = fmt::format("marker-{}", place_.root.substr(place_.root.size() - 6));
    for (const char* deed : {"busy", "sleep", "deaf"}) {
        const Ending ending = run(place_.deed({deed, marker}), limits);
        EXPECT_EQ(described(ending), "time out") << deed;
        EXPECT_EQ(ending.reason, "more than 0.3 seconds");
        EXPECT_GE(ending.wall_seconds, 0.3);
        EXPECT_EQ(processes_with(marker), 0) << deed;
        EXPECT_TRUE(ending.cpu_seconds > 0.01 || deed != std::string("busy")) << ending.cpu_seconds;
        EXPECT_EQ(ending.busy_threads, deed == std::string("busy") ? 1 : 0) << deed;
    }
    limits.wall_seconds = 1.0;
    const Ending three = run(place_.shell("for i in 1 2 3; do (while :; do :; done) & done; wait"), limits);
    EXPECT_GE(three.busy_threads, 2);
}

TEST_P(Sandbox, NoProcessOutlivesTheProgram) {
    const std::string marker = fmt::format("marker-{}", place_.root.substr(place_.root.size() - 6));
    const Ending ending = run(place_.deed({"daemon", marker}));
    EXPECT_EQ(described(ending), "exited 0");
    EXPECT_TRUE(ending.left_processes);
    EXPECT_EQ(processes_with(marker), 0);
    EXPECT_FALSE(run(place_.shell("/bin/true; /bin/true | /bin/true")).left_processes);
}

TEST_P(Sandbox, AForkBombIsSmallAndEnds) {
    const std::string marker = fmt::format("marker-{}", place_.root.substr(place_.root.size() - 6));
    const bool limited = GetParam().groups || GetParam().own_user || geteuid() != 0 || !GetParam().root;
    if (!limited) {
        EXPECT_THAT(holes(containment_), testing::Contains(HasSubstr("The number of processes is not limited")));
        return;
    }
    const Ending ending = run(place_.deed({"bomb", marker}));
    EXPECT_EQ(described(ending), "exited 0");
    EXPECT_GE(std::atoi(ending.output.c_str()), 10);
    EXPECT_LT(std::atoi(ending.output.c_str()), 16);
    EXPECT_TRUE(ending.left_processes);
    Limits limits = short_limits();
    limits.wall_seconds = 0.3;
    EXPECT_THAT(described(run(place_.deed({"chain", marker}), limits)), AnyOf("time out", "exited 0"));
    EXPECT_EQ(processes_with(marker), 0);
}

TEST_P(Sandbox, EndlessOutputIsCut) {
    const Ending ending = run(place_.deed({"flood"}));
    EXPECT_EQ(described(ending), "too much output");
    EXPECT_EQ(ending.output.size(), short_limits().output_bytes);
    EXPECT_EQ(described(run(place_.shell("head -c 100001 /dev/zero"))), "too much output");
    EXPECT_EQ(described(run(place_.shell("head -c 100000 /dev/zero"))), "exited 0");
    const Ending in_a_character = run(place_.shell("head -c 99999 /dev/zero; printf '\\303\\244'"));
    EXPECT_EQ(described(in_a_character), "too much output");
    EXPECT_EQ(in_a_character.output.size(), 99999u);
}

TEST_P(Sandbox, FilesHaveABound) {
    EXPECT_EQ(described(run(place_.deed({"endless-file", "picture"}))), "too much output");
    EXPECT_EQ(std::filesystem::file_size(place_.folder + "/picture"), short_limits().file_bytes);
    const Ending filled = run(place_.deed({"fill", "."}));
    EXPECT_LE(filled.least_room_bytes, std::filesystem::space(place_.folder).capacity) << "what the disk had left is told";
    EXPECT_EQ(described(filled), "too much output");
    EXPECT_THAT(filled.reason, HasSubstr("in its folder"));
}

TEST_P(Sandbox, MemoryHasABound) {
    const Ending ending = run(place_.deed({"allocate", "20"}));
    EXPECT_EQ(described(ending), "out of memory");
    EXPECT_THAT(ending.reason, StartsWith("more than 268435456 bytes"));
    const Ending fine = run(place_.deed({"allocate", "0.0625"}));
    EXPECT_EQ(described(fine), "exited 0");
    const bool is_known = GetParam().groups || fine.peak_memory_bytes != 0;  // else only of programs much larger than this one
    EXPECT_THAT(fine.peak_memory_bytes, testing::AllOf(testing::Ge(is_known ? 64u << 20 : 0u), testing::Lt(90u << 20)));
}

TEST_P(Sandbox, OnlyTheRunsFolderCanBeWritten) {
    EXPECT_EQ(said({"write", place_.folder + "/here"}), "done\n");
    EXPECT_EQ(said({"write", "here-too"}), "done\n");
    EXPECT_TRUE(std::filesystem::exists(place_.folder + "/here-too"));
    if (!has_room() && GetParam().root && !GetParam().own_user) {
        EXPECT_THAT(holes(containment_), testing::Contains("They write wherever you may write."));
        EXPECT_EQ(said({"write", place_.suite + "/new"}), "done\n");
        return;
    }
    for (const std::string& path :
         {place_.root + "/bin/new", place_.program, place_.suite + "/new", std::string("/usr/new"), std::string("/new"),
          std::string("/etc/new"), std::string("/proc/new"), std::string("/sys/new"), std::string("/var/new")}) {
        EXPECT_THAT(said({"write", path}), testing::Not("done\n")) << path;
        EXPECT_TRUE(path == place_.program || !std::filesystem::exists(path)) << path;
    }
    if (!has_room()) return;
    // There are a /tmp and a /dev/shm, but not the machine's.
    for (const std::string& path : {place_.root + "-new", "/dev/shm" + place_.root.substr(4)}) {
        EXPECT_EQ(said({"write", path}), "done\n") << path;
        EXPECT_FALSE(std::filesystem::exists(path)) << path;
    }
    EXPECT_THAT(said({"write", "/dev/new"}), testing::Not("done\n"));
}

TEST_P(Sandbox, OnlyWhatIsShownCanBeRead) {
    EXPECT_EQ(said({"size", place_.suite + "/scene.pov"}), "done\n");
    if (!has_room()) {
        EXPECT_THAT(holes(containment_), testing::Contains(HasSubstr("programs read every file")));
        EXPECT_EQ(said({"size", place_.expected}), "done\n");
        return;
    }
    const std::string secret = place_.root + "/secret", link = place_.root + "/link";
    std::ofstream(secret) << "secret";
    EXPECT_EQ(said({"size", place_.expected}), "No data available\n");
    for (const std::string& path : {secret, std::string("/etc/shadow"), std::string("/root"), std::string("/home"), std::string("/sys"),
                                    std::string("/proc/1/root/etc/shadow"), std::string(PROJECT_ROOT)}) {
        EXPECT_THAT(said({"read", path}), AnyOf("No such file or directory\n", "Permission denied\n")) << path;
    }
    // A hidden folder is empty by whatever way one comes to it, and may hold the run's own.
    std::filesystem::create_directory_symlink(place_.suite, link);
    ContainedRun run_there = place_.shell("ls -A " + place_.suite + " " + link + "; cat scene.pov 2>&1; echo mine >mine && cat mine");
    run_there.readable = {link, place_.suite + "/scene.pov"};
    run_there.hidden = {place_.suite};
    std::filesystem::create_directory(place_.suite + "/run");
    run_there.folder = run_there.working_folder = link + "/run";
    EXPECT_EQ(run(run_there).output,
              fmt::format("{0}:\nrun\n\n{1}:\nrun\ncat: scene.pov: No such file or directory\nmine\n", link, place_.suite));
}

TEST_P(Sandbox, AFolderThatTheProgramClosesCanBeReadAndRemoved) {
    const Ending ending = run(place_.shell("mkdir -p a/b && echo 1 >a/b/output.png && chmod 0 a/b a ."));
    EXPECT_EQ(ending.kind, Ending::Kind::exited) << described(ending);
    EXPECT_EQ(take_file(place_.folder, "a/b/output.png", 10).bytes, "1\n");
    EXPECT_GT(std::filesystem::remove_all(place_.folder), 0u);
}

TEST_P(Sandbox, TheNetworkIsNotThere) {
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    ASSERT_EQ(listen(listener, 5), 0);
    ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(said({"reach", std::to_string(ntohs(address.sin_port))}), has_room() ? "Connection refused\n" : "done\n");
    close(listener);
}

TEST_P(Sandbox, NothingOfOursLeaks) {
    setenv("SECRET_TOKEN", "secret", 1);
    const int open_file = open("/dev/null", O_RDONLY);  // without O_CLOEXEC
    Ending ending = run(place_.shell("env | grep -v ^PWD= | sort"));
    EXPECT_EQ(ending.output, fmt::format("HOME={0}\nLANG=C.UTF-8\nPATH=/usr/local/bin:/usr/bin:/bin\nTMPDIR={1}\n", place_.folder,
                                         has_room() ? "/tmp" : place_.folder));
    EXPECT_EQ(said({"descriptors"}), "0 1 2 ");
    ending =
        run(place_.shell("cat; ulimit -c; read pid name state parent group session rest </proc/self/stat; [ $session = $$ ] && echo leads; "
                         "grep -hE 'NoNewPrivs|Cap(Eff|Prm|Amb)' /proc/self/status"));
    EXPECT_EQ(ending.output, "0\nleads\nCapPrm:\t0000000000000000\nCapEff:\t0000000000000000\nCapAmb:\t0000000000000000\nNoNewPrivs:\t1\n");
    if (has_room()) {
        EXPECT_THAT(run(place_.shell("cat /proc/*/environ")).output, testing::Not(HasSubstr("secret")));
        EXPECT_EQ(run(place_.shell("set -- /proc/[0-9]*; echo $#")).output, "3\n");  // bubblewrap's two and the shell
    }
    close(open_file);
}

constexpr Machine machines[] = {
    {"All", true, true, true, true},
    {"NoGroups", true, false, true, true},
    {"NoBubblewrap", false, true, true, true},
    {"OwnUserOnly", false, false, true, true},
    {"RootAlone", false, false, false, true},
    {"Somebody", true, false, false, false},
    {"SomebodyAlone", false, false, false, false},
};
INSTANTIATE_TEST_SUITE_P(On, Sandbox, testing::ValuesIn(machines), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace rt::sandbox_test
