#include "grading/program_start.h"

#include <grp.h>
#include <linux/capability.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>

#include "grading/child_process.h"
#include "grading/descriptor.h"

namespace rt {
namespace {

/// What went wrong in the new process, told through a pipe that a successful execve closes.
struct Failure {
    int error = 0;
    char step[60] = {};
};

void must(bool done, const char* step) {
    if (done) return;
    Failure failure;
    failure.error = errno;
    std::copy_n(step, std::min(std::char_traits<char>::length(step), sizeof failure.step - 1), failure.step);
    throw failure;
}

/// Where the inherited bound is lower than what is asked for, it stays. `beyond`: the hard limit is above by that.
void limit(__rlimit_resource resource, rlim_t most, const char* name, rlim_t beyond = 0) {
    rlimit now{};
    must(getrlimit(resource, &now) == 0, name);
    const rlimit wanted{std::min(most, now.rlim_max), std::min(most + beyond, now.rlim_max)};
    must(setrlimit(resource, &wanted) == 0, name);
}

void set_limits(const ProgramStart& start) {
    constexpr rlim_t open_files = 256;
    const auto processors = static_cast<double>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
    // All processors busy for the whole time, which ends by the clock: this one is for who watches no clock any more.
    const auto cpu_seconds = static_cast<rlim_t>(std::ceil(start.limits.wall_seconds) * processors) + 1;
    limit(RLIMIT_CORE, 0, "the limit of core files");
    limit(RLIMIT_CPU, cpu_seconds, "the limit of processor time", 1);  // first SIGXCPU, a second later SIGKILL
    limit(RLIMIT_FSIZE, start.limits.file_bytes, "the limit of a file's size");
    limit(RLIMIT_NOFILE, open_files, "the limit of open files");
    limit(RLIMIT_MSGQUEUE, 0, "the limit of message queues");
    if (start.users_processes) limit(RLIMIT_NPROC, static_cast<rlim_t>(*start.users_processes), "the limit of processes");
    if (start.limit_addresses) limit(RLIMIT_AS, start.limits.memory_bytes, "the limit of memory");
}

void drop_rights(const ProgramStart& start) {
    must(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "giving up new privileges");
    // Fails where we have no right to; then there is none to lose.
    for (int capability = 0; prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) == 0; ++capability) {
    }
    if (start.user) {
        must(setgroups(0, nullptr) == 0, "leaving our groups");
        must(setresgid(*start.user, *start.user, *start.user) == 0, "a group of its own");
        must(setresuid(*start.user, *start.user, *start.user) == 0, "a user of its own");
    }
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct none[2] = {};
    must(syscall(SYS_capset, &header, none) == 0, "giving up capabilities");
}

/// Does not return unless by a Failure.
void become_program(const ProgramStart& start) {
    const std::vector<std::string> environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "HOME=" + start.home, "LANG=C.UTF-8",
                                                  "TMPDIR=" + start.scratch};
    const std::vector<char*> arguments = pointers_to(start.command), variables = pointers_to(environment);
    for (int entrance : start.entrances) must(write(entrance, "0", 1) == 1, "joining the control group");
    must(setsid() >= 0, "a session of its own");
    must(dup2(start.input, 0) == 0 && dup2(start.output, 1) == 1 && dup2(start.output, 2) == 2, "its standard files");
    must(close_range(3, ~0u, CLOSE_RANGE_CLOEXEC) == 0, "closing files (Linux 5.11 is needed)");
    umask(022);
    set_limits(start);
    drop_rights(start);
    must(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, "dying with the grader");
    must(chdir(start.working_folder.c_str()) == 0, "entering the working folder");
    reset_signals();
    execve(arguments[0], arguments.data(), variables.data());
    must(false, "executing the program");
}

}  // namespace

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

void reset_signals() {
    for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);  // fails for the two that nobody can change
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

pid_t start_program(const ProgramStart& start) {
    Pipe report = make_pipe();
    const pid_t program = start_child([&] {
        try {
            become_program(start);
        } catch (const Failure& failure) {
            write_all(report.write.get(), reinterpret_cast<const char*>(&failure), sizeof failure);
        }
        return 127;
    });
    report.write.close();
    std::string told;
    while (read_some(report.read.get(), told)) {
    }
    if (told.empty()) return program;
    waitpid(program, nullptr, 0);
    Failure failure;
    std::copy_n(told.data(), std::min(told.size(), sizeof failure), reinterpret_cast<char*>(&failure));
    throw std::system_error(failure.error, std::generic_category(), failure.step);
}

}  // namespace rt
