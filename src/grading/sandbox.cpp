#include "grading/sandbox.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>

#include <cstring>
#include <filesystem>
#include <optional>

#include "grading/child_process.h"
#include "grading/control_group.h"
#include "grading/descriptor.h"
#include "grading/keeper.h"
#include "grading/run_folder.h"

namespace rt {
namespace {

/// A user that nobody else runs anything as, lent for one run. Users have no names and no lists here; what makes one taken is a socket with
/// a name in no folder, which the system takes away with the last process that holds it, whatever that process dies of.
class LentUser {
public:
    explicit LentUser(int slot) {
        constexpr uid_t first = 61000, count = 184;  // systemd's own users begin at 61184
        for (uid_t i = 0; i < count; ++i) {
            number_ = first + (static_cast<uid_t>(slot) + i) % count;
            mark_ = Descriptor(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
            sockaddr_un name{AF_UNIX, {}};
            const std::string text = fmt::format("raytrace-user-{}", number_);
            std::memcpy(name.sun_path + 1, text.data(), text.size());  // a first byte of 0 means: in no folder
            const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + text.size());
            if (bind(mark_.get(), reinterpret_cast<const sockaddr*>(&name), size) == 0) return;
        }
        throw_errno(fmt::format("a user for the program: all from {} to {} are taken", first, first + count - 1));
    }
    uid_t number() const { return number_; }

private:
    uid_t number_ = 0;
    Descriptor mark_;
};

/// The ending without its texts, as it goes through the pipe, followed by them.
struct Record {
    Ending::Kind kind;
    int status, busy_threads;
    bool left_processes;
    double wall_seconds, cpu_seconds;
    std::uint64_t peak_memory_bytes, least_room_bytes, reason_size;
};

void send(int to, const Ending& e) {
    const Record record{e.kind,         e.status,      e.busy_threads,      e.left_processes,
                        e.wall_seconds, e.cpu_seconds, e.peak_memory_bytes, e.least_room_bytes,
                        e.reason.size()};
    const std::string text = std::string(reinterpret_cast<const char*>(&record), sizeof record) + e.reason + e.output;
    write_all(to, text.data(), text.size());
}

std::optional<Ending> received(const std::string& text) {
    Record record{};
    if (text.size() < sizeof record) return std::nullopt;
    std::memcpy(&record, text.data(), sizeof record);
    Ending ending{record.kind, record.status, text.substr(sizeof record, record.reason_size),
                  text.substr(sizeof record + record.reason_size)};
    ending.busy_threads = record.busy_threads;
    ending.left_processes = record.left_processes;
    ending.wall_seconds = record.wall_seconds;
    ending.cpu_seconds = record.cpu_seconds;
    ending.peak_memory_bytes = record.peak_memory_bytes;
    ending.least_room_bytes = record.least_room_bytes;
    return ending;
}

/// Runs `keep` in a new process and hands on what it says. No signal reaches the new process before it has its own handlers.
std::optional<Ending> in_keeper(Keeping keeping) {
    Pipe report = make_pipe();
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before);
    pid_t keeper = -1;
    try {
        keeper = start_child([&] {
            report.read.close();
            keeping.grader = report.write.get();
            send(report.write.get(), keep(keeping));
            return 0;
        });
    } catch (...) {
        sigprocmask(SIG_SETMASK, &before, nullptr);
        throw;
    }
    sigprocmask(SIG_SETMASK, &before, nullptr);
    report.write.close();
    std::string text;
    while (read_some(report.read.get(), text)) {
    }
    while (waitpid(keeper, nullptr, 0) < 0 && errno == EINTR) {
    }
    return received(text);
}

}  // namespace

Ending run_contained(const ContainedRun& run, const Limits& limits, const Containment& containment, int slot) {
    Ending ending;
    try {
        if (run.command.empty()) throw std::runtime_error("there is no program to run");
        const std::string folder = std::filesystem::canonical(run.folder);
        ControlGroup group(containment, group_name(slot), limits);
        std::optional<LentUser> user;
        std::optional<uid_t> number;
        if (containment.own_user) {
            user.emplace(slot);
            number = user->number();
            give_folder(folder, *number, *number);
        }
        const std::optional<Ending> told = in_keeper({run, limits, containment, group, number});
        if (!told && number) end_processes_of(*number);
        ending = told.value_or(Ending{});
        if (!told) ending.reason = "the process that watched the program was ended from outside";
        give_folder(folder, geteuid(), getegid());
    } catch (const std::exception& error) {
        ending.kind = Ending::Kind::not_started;
        ending.reason = error.what();
    }
    return ending;
}

}  // namespace rt
