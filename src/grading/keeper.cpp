#include "grading/keeper.h"

#include <dirent.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>

#include "core/utf8.h"
#include "grading/bubblewrap_room.h"
#include "grading/child_process.h"
#include "grading/program_start.h"
#include "grading/run_folder.h"

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }
double seconds_of(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }
double cpu_seconds_of(const rusage& use) { return seconds_of(use.ru_utime) + seconds_of(use.ru_stime); }
std::uint64_t bytes_of(const rusage& use) { return static_cast<std::uint64_t>(use.ru_maxrss) << 10; }

/// What /proc tells of a process; the parent's id is the fourth word, the second is a name in brackets with anything in it.
pid_t parent_of(const std::string& stat) {
    const std::size_t name_end = stat.rfind(')');
    return name_end == std::string::npos || name_end + 4 > stat.size() ? 0 : std::atoi(stat.c_str() + name_end + 4);
}

/// Threads of a process that run or wait for a processor.
int busy_threads_of(pid_t process) {
    int busy = 0;
    const std::string folder = fmt::format("/proc/{}/task", process);
    DIR* threads = opendir(folder.c_str());
    while (const dirent* entry = threads ? readdir(threads) : nullptr) {
        std::string stat;
        const Descriptor file(
            std::atoi(entry->d_name) > 0 ? open(fmt::format("{}/{}/stat", folder, entry->d_name).c_str(), O_RDONLY | O_CLOEXEC) : -1);
        if (file && read_some(file.get(), stat)) busy += stat.find(") R ") != std::string::npos;
    }
    if (threads) closedir(threads);
    return busy;
}

/// Ids of all processes, with their parents'.
std::map<pid_t, pid_t> parents() {
    std::map<pid_t, pid_t> found;
    DIR* processes = opendir("/proc");
    while (const dirent* entry = processes ? readdir(processes) : nullptr) {
        const pid_t process = std::atoi(entry->d_name);
        std::string stat;
        const Descriptor file(process > 0 ? open(fmt::format("/proc/{}/stat", process).c_str(), O_RDONLY | O_CLOEXEC) : -1);
        if (file && read_some(file.get(), stat)) found[process] = parent_of(stat);
    }
    if (processes) closedir(processes);
    return found;
}

/// Processes and threads that our user has now, for a limit that counts them all.
long threads_of_our_user() {
    long threads = 0;
    for (const auto& [process, parent] : parents()) {
        struct stat owner {};
        const std::string folder = fmt::format("/proc/{}/task", process);
        if (stat(folder.c_str(), &owner) != 0 || owner.st_uid != geteuid()) continue;
        threads += static_cast<long>(owner.st_nlink) - 2;  // a folder for each thread
    }
    return threads;
}

class Keeper {
public:
    explicit Keeper(const Keeping& keeping) : keeping_(keeping) {}

    /// Throws what std::exception there is if the program cannot be started.
    Ending run() {
        const ContainedRun& run = keeping_.run;
        folder_ = Descriptor(open(run.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (!folder_) throw_errno(run.folder);
        if (!keeping_.containment.bubblewrap.empty()) {
            room_.emplace(keeping_.containment.bubblewrap, run, keeping_.user.value_or(geteuid()));
            room_->enter();
        }
        Pipe output = make_pipe();
        fcntl(output.read.get(), F_SETFL, O_NONBLOCK);
        output_ = std::move(output.read);
        start(output.write.get());
        output.write.close();
        watch();
        finish();
        return std::move(ending_);
    }

    /// Ends everything that is still there. The keeper adopts what loses its parent, so that no children means no descendants.
    void end_all() {
        constexpr int patience = 10'000;  // in milliseconds, against what forks faster than it is found
        if (room_) {
            room_->end();
            while (reap_one(-1, 0) > 0) {
            }
            return;
        }
        keeping_.group.end_members();
        if (keeping_.user) end_processes_of(*keeping_.user);
        for (int attempt = 0; attempt < patience && has_children(); ++attempt) {
            end_children();
            poll(nullptr, 0, 1);
        }
    }

private:
    void start(int output) {
        const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
        if (!nothing) throw_errno("/dev/null");
        ProgramStart start;
        start.command = keeping_.run.command;
        start.home = keeping_.run.folder;
        start.scratch = !keeping_.run.scratch.empty() ? keeping_.run.scratch : room_ ? "/tmp" : keeping_.run.folder;
        start.working_folder = keeping_.run.working_folder;
        start.user = keeping_.user;
        start.entrances = keeping_.group.entrances();
        start.input = nothing.get();
        start.output = output;
        start.limits = keeping_.limits;
        start.limit_addresses = keeping_.containment.memory_group.empty();
        start.users_processes = processes_of_user();
        begin_ = Clock::now();
        program_ = start_program(start);
    }

    /// The bound for the user's processes, where one means something.
    std::optional<long> processes_of_user() const {
        constexpr int bubblewraps_own = 2;
        if (keeping_.user) return keeping_.limits.processes;
        if (geteuid() == 0) return std::nullopt;                            // root has none
        if (room_) return keeping_.limits.processes + bubblewraps_own;      // counted in the room alone
        if (!keeping_.containment.pids_group.empty()) return std::nullopt;  // the group counts better
        return keeping_.limits.processes + threads_of_our_user();
    }

    /// Until the program has ended or must be ended.
    void watch() {
        constexpr double between_looks = 0.25;  // at the folder, in seconds
        const Descriptor program = process_descriptor(program_);
        if (!program) throw_errno("watching the program (Linux 5.3 is needed)");
        pollfd events[] = {{program.get(), POLLIN, 0}, {output_.get(), POLLIN, 0}, {keeping_.grader, 0, 0}};
        for (double next_look = between_looks; !exceeded_;) {
            const double wait = std::min(next_look, keeping_.limits.wall_seconds) - seconds_since(begin_);
            poll(events, std::size(events), static_cast<int>(std::max(std::ceil(1e3 * wait), 0.0)));
            const bool more = read_some(output_.get(), ending_.output);
            if (!more && errno != EAGAIN) events[1].fd = -1;  // closed by all who had it
            if (events[0].revents != 0) return;
            if (events[2].revents != 0) exceed(Ending::Kind::not_started, "the grader has ended");
            judge_output();
            if (seconds_since(begin_) >= next_look) {
                judge_folder();
                next_look = seconds_since(begin_) + between_looks;
            }
            if (seconds_since(begin_) >= keeping_.limits.wall_seconds) {
                exceed(Ending::Kind::time_out, fmt::format("more than {} seconds", keeping_.limits.wall_seconds));
                ending_.busy_threads = busy_threads();
            }
        }
    }

    void finish() {
        ending_.wall_seconds = seconds_since(begin_);
        if (!exceeded_) {
            reap_one(program_, 0);
            ending_.left_processes = room_ ? room_->is_inhabited() : has_children();
        }
        const bool by_itself = !exceeded_ && !ending_.left_processes;
        end_all();
        rusage all{};
        getrusage(RUSAGE_CHILDREN, &all);
        // Of what was ended with the room only the sum is known, with bubblewrap's own few milliseconds in it.
        ending_.cpu_seconds = cpu_seconds_of(by_itself ? use_ : all);
        ending_.peak_memory_bytes = peak_memory();
        while (ending_.output.size() <= keeping_.limits.output_bytes && read_some(output_.get(), ending_.output)) {
        }
        judge_output();
        judge_folder();
        conclude();
    }

    std::uint64_t peak_memory() const {
        const std::uint64_t of_group = keeping_.group.peak_memory();
        if (of_group > 0) return of_group;
        rusage ours{};
        getrusage(RUSAGE_SELF, &ours);
        // Between fork and execve the program was as large as we are, or a little larger, and the system counts that.
        return bytes_of(use_) > 2 * bytes_of(ours) ? bytes_of(use_) : 0;
    }

    void exceed(Ending::Kind kind, std::string reason) {
        if (!exceeded_) ending_.reason = std::move(reason);
        if (!exceeded_) exceeded_ = kind;
    }

    void judge_output() {
        const std::uint64_t most = keeping_.limits.output_bytes;
        if (ending_.output.size() <= most) return;
        ending_.output.resize(whole_characters(ending_.output, most).size());
        exceed(Ending::Kind::too_much_output, fmt::format("more than {} bytes on standard output and error", most));
    }

    void judge_folder() {
        ending_.least_room_bytes = std::min(ending_.least_room_bytes, disk_room(folder_.get()));
        const std::uint64_t most = keeping_.limits.folder_bytes;
        if (folder_use(folder_.get(), most) <= most) return;
        exceed(Ending::Kind::too_much_output, fmt::format("more than {} bytes in its folder", most));
    }

    void conclude() {
        const int signal = WIFSIGNALED(status_.value_or(0)) ? WTERMSIG(*status_) : 0;
        const Limits& limits = keeping_.limits;
        const bool no_memory = signal == SIGABRT && ending_.output.find("std::bad_alloc") != std::string::npos;  // as libstdc++ says it
        if (keeping_.group.was_out_of_memory() || (!exceeded_ && no_memory)) {
            exceeded_ = Ending::Kind::out_of_memory;
            ending_.reason = fmt::format("more than {} bytes of memory", limits.memory_bytes);
        } else if (signal == SIGXCPU) {
            exceed(Ending::Kind::time_out, "all the processor time there is in that time");
        } else if (signal == SIGXFSZ) {
            exceed(Ending::Kind::too_much_output, fmt::format("a file of more than {} bytes", limits.file_bytes));
        }
        ending_.kind = exceeded_.value_or(signal != 0 ? Ending::Kind::signalled : Ending::Kind::exited);
        ending_.status = ending_.kind == Ending::Kind::exited ? WEXITSTATUS(status_.value_or(0)) : signal;
    }

    /// Waits for one child (-1: any); the program's status is kept. What wait4 returns.
    pid_t reap_one(pid_t child, int options) {
        int status = 0;
        rusage use{};
        const pid_t ended = wait4(child, &status, options, &use);
        if (ended == program_ && ended > 0) {
            status_ = status;
            use_ = use;
        }
        return ended;
    }

    /// Of the run: in a room nothing else can be seen, without one we are an ancestor of all.
    int busy_threads() const {
        int busy = 0;
        const std::map<pid_t, pid_t> all = parents();
        for (const auto& [process, parent] : all) {
            pid_t ancestor = parent;
            for (auto outer = all.find(ancestor); !room_ && ancestor != getpid() && outer != all.end(); outer = all.find(ancestor))
                ancestor = outer->second;
            if (room_ || ancestor == getpid()) busy += busy_threads_of(process);
        }
        return busy;
    }

    /// Some child is still alive.
    bool has_children() {
        pid_t ended = 0;
        do ended = reap_one(-1, WNOHANG);
        while (ended > 0);
        return ended == 0;
    }

    /// Children's children become ours when their parents end. Only a child's number is sure to mean what it did when it was read, since we
    /// have not waited for it.
    static void end_children() {
        for (const auto& [process, parent] : parents()) {
            if (parent == getpid()) kill(process, SIGKILL);
        }
    }

    const Keeping& keeping_;
    Descriptor folder_, output_;
    std::optional<Room> room_;
    Clock::time_point begin_;
    pid_t program_ = -1;
    std::optional<int> status_;  ///< of the program, as wait(2) gives it
    rusage use_{};               ///< of the program and those of its children that it waited for
    std::optional<Ending::Kind> exceeded_;
    Ending ending_;
};

}  // namespace

Ending keep(const Keeping& keeping) {
    reset_signals();
    signal(SIGPIPE, SIG_IGN);
    setsid();
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    Keeper keeper(keeping);
    Ending ending;
    try {
        ending = keeper.run();
    } catch (const std::exception& error) {
        ending = {};
        ending.reason = error.what();
        keeper.end_all();
    }
    pollfd grader{keeping.grader, 0, 0};
    if (poll(&grader, 1, 0) > 0) keeping.group.remove();
    return ending;
}

void end_processes_of(uid_t user) {
    holds_in_child([&] { return setresuid(user, user, user) == 0 && kill(-1, SIGKILL) == 0; });
}

}  // namespace rt
