// A place on the disk for the sandbox's tests: a program, a suite with an expected result, and a folder for the run.
#pragma once

#include <fmt/format.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "grading/sandbox.h"

namespace rt::test {

struct Place {
    std::string root, program, suite, expected, folder;

    Place() : root("/tmp/raytrace-sandbox-XXXXXX") {
        if (mkdtemp(root.data()) == nullptr) throw std::runtime_error(root);
        chmod(root.c_str(), 0755);
        program = root + "/bin/hostile";
        suite = root + "/suite";
        expected = suite + "/expected.png";
        folder = root + "/run";
        for (const std::string& path : {root + "/bin", suite, folder}) std::filesystem::create_directory(path);
        std::filesystem::copy_file(HOSTILE, program);
        std::ofstream(expected) << "the right answer";
        std::ofstream(suite + "/scene.pov") << "sphere { 0, 1 }";
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { std::filesystem::remove_all(root); }

    /// The hostile program's deed, or a command of the shell.
    ContainedRun deed(std::vector<std::string> words) const {
        words.insert(words.begin(), program);
        return {std::move(words), folder, folder, {root + "/bin", suite}, {expected}};
    }
    ContainedRun shell(const std::string& text) const {
        ContainedRun run = deed({});
        run.command = {"/bin/sh", "-c", text};
        return run;
    }
};

/// Limits that a test waits for without getting old; the clock's are far from what a loaded machine needs for starting something.
inline Limits short_limits() {
    Limits limits;
    limits.wall_seconds = 30.0;
    limits.memory_bytes = 256u << 20;
    limits.output_bytes = 100'000;
    limits.file_bytes = 4u << 20;
    limits.folder_bytes = 16u << 20;
    limits.processes = 16;
    return limits;
}

inline std::string described(const Ending& ending) {
    switch (ending.kind) {
        case Ending::Kind::exited:
            return fmt::format("exited {}", ending.status);
        case Ending::Kind::signalled:
            return fmt::format("signal {}", ending.status);
        case Ending::Kind::time_out:
            return "time out";
        case Ending::Kind::out_of_memory:
            return "out of memory";
        case Ending::Kind::too_much_output:
            return "too much output";
        case Ending::Kind::not_started:
            return "not started: " + ending.reason;
    }
    return "";
}

/// run_contained as another user would call it, for good: in a process that becomes that user and sends the ending back.
inline Ending run_as(uid_t user, const ContainedRun& run, const Limits& limits, const Containment& containment) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        if (setgroups(0, nullptr) != 0 || setresgid(user, user, user) != 0 || setresuid(user, user, user) != 0) _exit(1);
        prctl(PR_SET_DUMPABLE, 1);  // as it is after a login
        const Ending e = run_contained(run, limits, containment, 0);
        const std::string text =
            fmt::format("{} {} {} {} {} {} {} {} {} {}{}", static_cast<int>(e.kind), e.status, int{e.left_processes}, e.busy_threads,
                        e.wall_seconds, e.cpu_seconds, e.peak_memory_bytes, e.least_room_bytes, e.reason.size(), e.reason, e.output);
        for (std::size_t done = 0; done < text.size();)
            done += static_cast<std::size_t>(write(ends[1], text.data() + done, text.size() - done));
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[65536];
    for (ssize_t count = 0; (count = read(ends[0], buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(count));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    std::istringstream words(text);
    Ending ending;
    int kind = 0;
    std::size_t reason_size = 0;
    words >> kind >> ending.status >> ending.left_processes >> ending.busy_threads >> ending.wall_seconds >> ending.cpu_seconds >>
        ending.peak_memory_bytes >> ending.least_room_bytes >> reason_size;
    const std::size_t at = static_cast<std::size_t>(words.tellg()) + 1;
    ending.kind = static_cast<Ending::Kind>(kind);
    ending.reason = text.substr(at, reason_size);
    ending.output = text.substr(at + reason_size);
    return ending;
}

/// Processes on this machine with a word in their command line, this one left out.
inline int processes_with(const std::string& word) {
    int count = 0;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
        if (std::atoi(entry.path().filename().c_str()) == getpid()) continue;
        std::stringstream words;
        words << std::ifstream(entry.path() / "cmdline").rdbuf();
        count += words.str().find(word) != std::string::npos;
    }
    return count;
}

}  // namespace rt::test
