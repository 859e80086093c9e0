#include "grading/workers.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <vector>

namespace rt {

namespace {

constexpr int status_done = 0, status_thrown = 1;
constexpr std::size_t most_told = 4096;  ///< bytes that a pipe always has room for

/// A job's process, seen from here: the pipe's other end is its own and closes when it ends.
struct Worker {
    pid_t process = 0;  ///< 0: the slot is free
    int pipe = -1;
    std::size_t job = 0;
};

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

Worker start(std::size_t job, int slot, const std::function<void(std::size_t, int)>& work) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail("pipe");
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0) {
        close(ends[0]), close(ends[1]);
        fail("fork");
    }
    if (process > 0) {
        close(ends[1]);
        return {process, ends[0], job};
    }
    close(ends[0]);
    setpgid(0, 0);  // a terminal's Ctrl-C is for the one that knows what to do
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(status_thrown);
    std::string problem;
    try {
        work(job, slot);
        _exit(status_done);
    } catch (const std::exception& error) {
        problem = error.what();
    } catch (...) {
        problem = "an unknown exception";
    }
    if (write(ends[1], problem.data(), std::min(problem.size(), most_told)) < 0) problem.clear();
    _exit(status_thrown);
}

WorkerEnd wait_for(Worker& worker) {
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    std::string problem(most_told, '\0');
    const ssize_t told = read(worker.pipe, problem.data(), problem.size());
    problem.resize(told > 0 ? static_cast<std::size_t>(told) : 0);
    close(worker.pipe);
    worker = {};
    return {WIFEXITED(status) && WEXITSTATUS(status) == status_done, WIFSIGNALED(status) ? WTERMSIG(status) : 0, problem};
}

/// Waits until one of them ends or a fifth of a second has passed. Returns the slots that ended.
std::vector<std::size_t> ended(const std::vector<Worker>& workers) {
    std::vector<pollfd> polls;
    for (const Worker& worker : workers) polls.push_back({worker.pipe, 0, 0});
    constexpr int milliseconds = 200;
    std::vector<std::size_t> slots;
    if (poll(polls.data(), polls.size(), milliseconds) <= 0) return slots;
    for (std::size_t slot = 0; slot < polls.size(); ++slot)
        if (polls[slot].revents != 0) slots.push_back(slot);
    return slots;
}

/// Ends what is still running, whatever makes us leave.
class Workers {
public:
    explicit Workers(int count) : all(static_cast<std::size_t>(count)) {}
    ~Workers() {
        for (Worker& worker : all)
            if (worker.process > 0) {
                kill(worker.process, SIGKILL);
                wait_for(worker);
            }
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::vector<Worker> all;
};

}  // namespace

void run_jobs(std::size_t count, int parallel, const JobCalls& calls, const std::atomic<bool>& stop) {
    Workers workers(parallel);
    std::size_t next = 0, finished = 0;
    while (finished < count && !stop) {
        for (std::size_t slot = 0; slot < workers.all.size() && next < count; ++slot) {
            if (workers.all[slot].process != 0) continue;
            if (calls.begin) calls.begin(next);
            workers.all[slot] = start(next, static_cast<int>(slot), calls.work);
            ++next;
        }
        for (const std::size_t slot : ended(workers.all)) {
            const std::size_t job = workers.all[slot].job;
            const WorkerEnd end = wait_for(workers.all[slot]);
            ++finished;
            if (calls.done) calls.done(job, end);
        }
        if (calls.idle) calls.idle();
    }
}

}  // namespace rt
