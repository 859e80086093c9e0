#include "tests/commands/support.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace rt::test {

namespace fs = std::filesystem;

const char* const small_scene =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1 }\n"
    "camera { location <0, 0, -5> look_at <0, 0, 0> }\n"
    "light_source { <10, 10, -10> rgb 1 }\n"
    "sphere { <0, 0, 0>, 1 pigment { rgb <1, 0.5, 0.25> } }\n";

const char* const glass_scene =
    "camera { location <0, 0.5, 6> up <0, 1, 0> right <1.25, 0, 0> look_at <0, 0, 0> }\n"
    "light_source { <-4, 9, 7> color rgb <0.9, 0.8, 0.7> }\n"
    "light_source { <5, 3, 2> color rgb 0.5 }\n"
    "sphere { <0, 0, 0>, 1 pigment { color rgbf <1, 0.5, 0.25, 0.75> }\n"
    "  finish { ambient 0.2 diffuse 0.4 specular 0.3 roughness 0.1 reflection 0.25 ior 1.5 } scale <1, 1.5, 1> }\n"
    "plane { <0, 1, 0>, -2 pigment { color rgb <0.2, 0.7, 0.8> } finish { ambient 0.4 diffuse 0.6 reflection 0.3 } }\n";

Workplace::Workplace() : before_(fs::current_path().string()) {
    std::string pattern = (fs::temp_directory_path() / "raytrace_test_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder for tests");
    path_ = pattern;
    fs::current_path(path_);
}

Workplace::~Workplace() {
    std::error_code ignored;
    fs::current_path(before_, ignored);
    fs::remove_all(path_, ignored);
}

void Workplace::write(const std::string& name, const std::string& text) const { std::ofstream(name, std::ios::binary) << text; }

bool Workplace::has(const std::string& name) const { return fs::exists(name); }

std::string Workplace::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(name, std::ios::binary).rdbuf();
    return text.str();
}

std::vector<std::string> Workplace::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(".")) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

namespace {

pid_t start(const std::vector<std::string>& words, const std::string& out_file, const std::string& err_file) {
    std::vector<char*> arguments;
    std::string program = PROGRAM;
    std::vector<std::string> copies = words;
    arguments.push_back(program.data());
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    const int out = open(out_file.c_str(), O_WRONLY | O_CREAT, 0600);
    const int err = open(err_file.c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    execv(PROGRAM, arguments.data());
    _exit(127);
}

/// Until the process has two workers beside its first thread, or has ended. The thread sanitizer has a thread of its own from the start.
void wait_for_workers(pid_t child) {
    const fs::path tasks = fmt::format("/proc/{}/task", child);
    std::error_code gone;
    siginfo_t ended{};
    while (ended.si_pid == 0) {
        const auto count = std::distance(fs::directory_iterator(tasks, gone), fs::directory_iterator());
        if (gone || count > 2) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
}

/// A file in the current folder whose name contains `part` and that is not empty.
bool has_content(const std::string& part) {
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(".", gone))
        if (entry.path().filename().string().find(part) != std::string::npos && entry.file_size(gone) > 0 && !gone) return true;
    return false;
}

/// False if the process has ended before, or goes on so fast that the file is gone when it stands still.
bool stop_at_file(pid_t child, const std::string& part) {
    siginfo_t ended{};
    while (!has_content(part)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
        if (ended.si_pid != 0) return false;
    }
    kill(child, SIGSTOP);
    waitid(P_PID, static_cast<id_t>(child), &ended, WSTOPPED | WEXITED | WNOWAIT);
    return has_content(part);
}

int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string take_file(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(name, std::ios::binary).rdbuf();
    fs::remove(name);
    return text.str();
}

/// Tests that run at the same time in one folder must not share it.
std::string stream_name(const char* kind) { return fmt::format("{}_{}_{}", fs::current_path().string(), getpid(), kind); }

}  // namespace

Outcome run(const std::vector<std::string>& words, const std::string& out_file) {
    const std::string out = out_file.empty() ? stream_name("out") : out_file;
    const std::string err = stream_name("err");
    Outcome outcome;
    outcome.status = wait_for(start(words, out, err));
    if (out_file.empty()) outcome.out = take_file(out);
    outcome.err = take_file(err);
    return outcome;
}

Outcome run_and_interrupt_at_file(const std::vector<std::string>& words, const std::string& part, const std::vector<int>& signals) {
    const std::string out = stream_name("out");
    const std::string err = stream_name("err");
    const pid_t child = start(words, out, err);
    const bool stopped = stop_at_file(child, part);
    for (const int signal : signals) kill(child, signal);
    kill(child, SIGCONT);
    Outcome outcome;
    outcome.status = wait_for(child);
    outcome.out = take_file(out);
    outcome.err = take_file(err);
    if (!stopped) throw std::runtime_error("the program ended before it wrote a file with '" + part + "' in its name: " + outcome.err);
    return outcome;
}

Outcome run_and_interrupt(const std::vector<std::string>& words, const std::vector<int>& signals) {
    const std::string out = stream_name("out");
    const std::string err = stream_name("err");
    const pid_t child = start(words, out, err);
    wait_for_workers(child);
    for (const int signal : signals) kill(child, signal);
    Outcome outcome;
    outcome.status = wait_for(child);
    outcome.out = take_file(out);
    outcome.err = take_file(err);
    return outcome;
}

}  // namespace rt::test
