#include "grading/workers.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <vector>

#include "core/source.h"
#include "core/utf8.h"
#include "grading/child_process.h"
#include "grading/descriptor.h"

namespace rt {

namespace {

constexpr int status_done = 0, status_thrown = 1, status_not_written = 2;
constexpr std::size_t most_told = 4096;  ///< bytes that a pipe always has room for

/// A job's process. It holds the other end of the pipe, which closes when it ends.
struct Worker {
    pid_t process = 0;  ///< 0: the slot is free
    Descriptor pipe;
    std::size_t job = 0;
};

/// In the job's own process: its exit status.
int carry_out(const std::function<void()>& work, pid_t parent, const Descriptor& pipe) {
    setpgid(0, 0);  // a terminal's Ctrl-C is for the one that knows what to do
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) return status_thrown;
    std::string problem = "an unknown exception";
    int status = status_thrown;
    try {
        work();
        return status_done;
    } catch (const OutputError& error) {
        problem = error.what(), status = status_not_written;
    } catch (const std::exception& error) {
        problem = error.what();
    } catch (...) {
    }
    const std::string_view told = whole_characters(problem, most_told);
    write_all(pipe.get(), told.data(), told.size());
    return status;
}

Worker start(std::size_t job, int slot, const std::function<void(std::size_t, int)>& work) {
    Pipe pipe = make_pipe();
    const pid_t parent = getpid();
    const pid_t process = start_child([&] { return carry_out([&] { work(job, slot); }, parent, pipe.write); });
    return {process, std::move(pipe.read), job};
}

WorkerEnd wait_for(Worker& worker) {
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    std::string problem;
    read_some(worker.pipe.get(), problem);
    worker = {};
    const int exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return {exit_status == status_done, WIFSIGNALED(status) ? WTERMSIG(status) : 0, exit_status == status_not_written, problem};
}

/// Waits until one of them ends or a fifth of a second has passed. Returns the slots that ended.
std::vector<std::size_t> ended(const std::vector<Worker>& workers) {
    std::vector<pollfd> polls;
    for (const Worker& worker : workers) polls.push_back({worker.pipe.get(), 0, 0});
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
            try {
                workers.all[slot] = start(next, static_cast<int>(slot), calls.work);
            } catch (const std::system_error&) {  // no more processes for now: those that run will make room
                if (next == finished) throw;
                break;
            }
            if (calls.begin) calls.begin(next);
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
