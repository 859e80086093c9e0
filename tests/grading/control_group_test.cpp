// Control groups: the machine's own where it lets us make some, and files that look like those of each version.
#include "grading/control_group.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/grading/place.h"

namespace rt::control_group_test {
namespace {

namespace fs = std::filesystem;

class GroupFiles : public testing::Test {
protected:
    void write(const std::string& name, const std::string& text) { std::ofstream(folder_ + "/" + name) << text; }
    std::string read(const std::string& name) const {
        std::stringstream text;
        text << std::ifstream(folder_ + "/" + name).rdbuf();
        return text.str();
    }
    void limit() {
        Limits limits;
        limits.memory_bytes = 12345;
        limits.processes = 7;
        const Descriptor folder(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        write_limits(folder.get(), limits);
    }

    test::Place place_;
    std::string folder_ = place_.folder;
};

TEST_F(GroupFiles, Version1TakesItsLimits) {
    for (const char* name : {"memory.limit_in_bytes", "memory.memsw.limit_in_bytes", "pids.max"}) write(name, "");
    limit();
    EXPECT_EQ(read("memory.limit_in_bytes"), "12345");
    EXPECT_EQ(read("memory.memsw.limit_in_bytes"), "12345");
    EXPECT_EQ(read("pids.max"), "7");
    EXPECT_FALSE(fs::exists(folder_ + "/memory.max"));
}

TEST_F(GroupFiles, Version2TakesItsLimits) {
    for (const char* name : {"memory.max", "memory.swap.max", "memory.oom.group", "pids.max"}) write(name, "");
    limit();
    EXPECT_EQ(read("memory.max"), "12345");
    EXPECT_EQ(read("memory.swap.max"), "0");
    EXPECT_EQ(read("memory.oom.group"), "1");
    EXPECT_EQ(read("pids.max"), "7");
}

TEST_F(GroupFiles, WhatTheKernelCountedIsReadInBothVersions) {
    // A group whose folder is there already, as a file system would have made it.
    folder_ = place_.folder + "/group";
    fs::create_directory(folder_);
    write("cgroup.procs", "");
    Containment containment;
    containment.memory_group = containment.pids_group = place_.folder;
    const ControlGroup group(containment, "group", Limits{});
    EXPECT_EQ(group.entrances().size(), 1u);
    EXPECT_FALSE(group.was_out_of_memory());
    EXPECT_EQ(group.peak_memory(), 0u);
    write("memory.oom_control", "oom_kill_disable 0\nunder_oom 0\noom_kill 0\n");
    write("memory.events", "low 0\nhigh 0\nmax 17\noom 0\noom_kill 0\noom_group_kill 0\n");
    EXPECT_FALSE(group.was_out_of_memory());
    write("memory.events", "low 0\nhigh 0\nmax 17\noom 2\noom_kill 1\noom_group_kill 1\n");
    EXPECT_TRUE(group.was_out_of_memory());
    write("memory.events", "");
    write("memory.oom_control", "oom_kill_disable 0\nunder_oom 0\noom_kill 3\n");
    EXPECT_TRUE(group.was_out_of_memory());
    write("memory.peak", "4096\n");
    EXPECT_EQ(group.peak_memory(), 4096u);
    write("memory.max_usage_in_bytes", "8192\n");
    EXPECT_EQ(group.peak_memory(), 8192u);
}

TEST_F(GroupFiles, TheNearestFolderUpwardsIsTakenInWhichAGroupWorks) {
    // Folders that take groups, but have no control files in them, are none.
    const std::string mounts = "none " + folder_ + " cgroup2 rw 0 0\n";
    fs::create_directories(folder_ + "/user/session");
    EXPECT_EQ(find_group_folder("memory", mounts, "0::/user/session\n"), "");
    EXPECT_EQ(find_group_folder("memory", "", ""), "");
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) EXPECT_EQ(entry.path().string().find("trial"), std::string::npos);
}

class Groups : public testing::Test {
protected:
    void SetUp() override {
        if (containment_.memory_group.empty() || containment_.pids_group.empty()) GTEST_SKIP() << "no control groups can be made here";
    }
    Containment containment_ = find_containment();
};

TEST_F(Groups, MembersEndWithTheGroup) {
    const std::string name = group_name(7);
    pid_t child = 0;
    {
        const ControlGroup group(containment_, name, Limits{});
        EXPECT_TRUE(fs::exists(containment_.memory_group + "/" + name));
        child = fork();
        if (child == 0) {
            bool inside = true;
            for (int entrance : group.entrances()) inside = ::write(entrance, "0", 1) == 1 && inside;
            if (!inside) _exit(1);
            for (;;) pause();
        }
        for (std::string members; members.empty();)
            std::getline(std::ifstream(containment_.pids_group + "/" + name + "/cgroup.procs"), members);
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    EXPECT_FALSE(fs::exists(containment_.memory_group + "/" + name));
    EXPECT_FALSE(fs::exists(containment_.pids_group + "/" + name));
}

TEST_F(Groups, WhatADeadGraderLeftIsRemoved) {
    const pid_t dead = fork();
    if (dead == 0) _exit(0);
    waitpid(dead, nullptr, 0);
    const std::string left = fmt::format("{}/raytrace-{}-0", containment_.pids_group, dead),
                      ours = containment_.pids_group + "/" + group_name(9);
    for (const std::string& path : {left, ours}) ASSERT_TRUE(fs::create_directory(path));
    remove_stale_groups(containment_.pids_group);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(ours));
    // One of our own name that was left by an earlier process is taken over.
    { const ControlGroup group(containment_, group_name(9), Limits{}); }
    EXPECT_FALSE(fs::exists(ours));
}

}  // namespace
}  // namespace rt::control_group_test
