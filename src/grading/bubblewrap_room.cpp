#include "grading/bubblewrap_room.h"

#include <dirent.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>

#include "grading/child_process.h"
#include "grading/program_start.h"

namespace rt {
namespace {

namespace fs = std::filesystem;

constexpr const char* scratch_bytes = "67108864";                                                // of /tmp, and of /dev/shm
constexpr std::array system_folders = {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"};  // beside /usr; today links into it

enum class Sight { read, write, empty };

class Planner {
public:
    explicit Planner(uid_t user) : user_(user) {}

    RoomPlan plan(const ContainedRun& run) {
        say({"--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--die-with-parent", "--cap-drop", "ALL"});
        show_system();
        for (const std::string& path : run.readable) show(path, Sight::read);
        for (const std::string& path : run.hidden) show(path, Sight::empty);
        show(run.folder, Sight::write);
        // Outer folders come before those in them, since text that continues another sorts after it.
        for (const auto& [path, sight] : sights_) mount(path, sight);
        for (const auto& [name, target] : links_) {
            if (is_there(name)) continue;
            lead_to(fs::path(name).parent_path());
            say({"--symlink", target, name});
        }
        for (const auto& [path, sight] : sights_) {
            if (sight == Sight::empty && fs::is_directory(path)) say({"--remount-ro", path});
        }
        say({"--remount-ro", "/dev", "--remount-ro", "/"});
        return std::move(plan_);
    }

private:
    void say(std::initializer_list<std::string> words) { plan_.words.insert(plan_.words.end(), words); }

    /// What programs need to start: the system's programs and libraries, and of its settings none that tell of this machine.
    void show_system() {
        say({"--ro-bind", "/usr", "/usr"});
        for (const char* name : system_folders) {
            std::error_code error;
            if (fs::is_symlink(name, error))
                say({"--symlink", fs::read_symlink(name), name});
            else
                say({"--ro-bind-try", name, name});
        }
        lead_to("/etc");
        for (const char* name : {"ld.so.cache", "alternatives", "localtime"}) {
            const std::string path = fmt::format("/etc/{}", name);
            say({"--ro-bind-try", path, path});
        }
        text("/etc/passwd", fmt::format("root:x:0:0::/:/bin/false\nrunner:x:{0}:{0}::/tmp:/bin/sh\n", user_));
        say({"--proc", "/proc", "--dev", "/dev"});
        for (const char* path : {"/tmp", "/dev/shm"}) say({"--perms", "1777", "--size", scratch_bytes, "--tmpfs", path});
    }

    void text(const std::string& path, const std::string& content) {
        Descriptor file(memfd_create("text", MFD_CLOEXEC));
        if (!file) throw_errno("a file in memory");
        write_all(file.get(), content.data(), content.size());
        lseek(file.get(), 0, SEEK_SET);
        say({"--perms", "0444", "--ro-bind-data", std::to_string(file.get()), path});
        plan_.texts.push_back(std::move(file));
    }

    /// Whatever leads to a path by links is one place; the name that was given leads there, too.
    void show(const std::string& given, Sight sight) {
        std::error_code error;
        const std::string path = fs::canonical(given, error);
        if (error && sight == Sight::empty) return;  // what is not there is hidden enough
        if (error) throw std::system_error(error, given);
        const auto [place, is_new] = sights_.try_emplace(path, sight);
        if (!is_new && place->second == Sight::read) place->second = sight;
        const std::string name = fs::path(given).lexically_normal();
        if (name != path && sight != Sight::empty) links_[name] = path;
    }

    /// The sight of the nearest folder around a path that has one.
    std::optional<Sight> sight_around(const fs::path& path) const {
        for (fs::path outer = path.parent_path(); outer != outer.root_path(); outer = outer.parent_path()) {
            const auto found = sights_.find(outer);
            if (found != sights_.end()) return found->second;
        }
        return std::nullopt;
    }

    bool is_in_hidden(const fs::path& path) const { return sight_around(path) == Sight::empty; }

    /// A link need not be made in what is shown, nor beyond another link.
    bool is_there(const fs::path& link) const {
        for (fs::path outer = link.parent_path(); outer != outer.root_path(); outer = outer.parent_path()) {
            if (links_.contains(outer)) return true;
        }
        const std::string top = fmt::format("/{}", link.relative_path().begin()->string());
        const bool in_system = top == "/usr" || std::ranges::find(system_folders, top) != system_folders.end();
        return in_system || sight_around(link).value_or(Sight::empty) != Sight::empty;
    }

    /// Folders that lead somewhere; bubblewrap's own would be for root alone.
    void lead_to(const fs::path& path) {
        if (path == path.root_path() || !ways_.insert(path).second) return;
        lead_to(path.parent_path());
        say({"--perms", "0755", "--dir", path});
    }

    void mount(const std::string& path, Sight sight) {
        lead_to(fs::path(path).parent_path());
        if (sight == Sight::write)
            say({"--bind", path, path});
        else if (sight == Sight::read && !is_in_hidden(path))
            say({"--ro-bind", path, path});
        else if (sight == Sight::empty && fs::is_directory(path))
            say({"--tmpfs", path});
        else if (sight == Sight::empty && !is_in_hidden(path))
            text(path, "");
    }

    uid_t user_;
    RoomPlan plan_;
    std::map<std::string, Sight> sights_;
    std::map<std::string, std::string> links_;
    std::set<fs::path> ways_;
};

/// Becomes bubblewrap, with the three standard descriptors and those of the plan.
int become_bubblewrap(const std::string& path, const RoomPlan& plan, int input, int output) {
    std::vector<std::string> words = {path};
    words.insert(words.end(), plan.words.begin(), plan.words.end());
    const std::vector<std::string> environment = {"PATH=/usr/local/bin:/usr/bin:/bin"};
    const std::vector<char*> arguments = pointers_to(words), variables = pointers_to(environment);
    dup2(input, 0);
    dup2(output, 1);
    dup2(output, 2);
    for (const Descriptor& text : plan.texts) fcntl(text.get(), F_SETFD, 0);
    execve(path.c_str(), arguments.data(), variables.data());
    const std::string complaint = std::generic_category().message(errno);
    write_all(2, complaint.data(), complaint.size());
    return 127;
}

}  // namespace

RoomPlan plan_room(const ContainedRun& run, uid_t user) { return Planner(user).plan(run); }

Room::Room(const std::string& bubblewrap, const ContainedRun& run, uid_t user) {
    RoomPlan plan = plan_room(run, user);
    Pipe question = make_pipe(), answer = make_pipe(), status = make_pipe();
    plan.words.insert(plan.words.end(), {"--json-status-fd", std::to_string(status.write.get()), "--", "cat"});
    plan.texts.push_back(std::move(status.write));
    bubblewrap_ = start_child([&] { return become_bubblewrap(bubblewrap, plan, question.read.get(), answer.write.get()); });
    answer.write.close();
    plan.texts.clear();
    constexpr char sign = '\0';
    write_all(question.write.get(), &sign, 1);
    std::string said, told;
    while (said.find(sign) == std::string::npos && read_some(answer.read.get(), said)) {
    }
    const std::string key = "\"child-pid\": ";
    while (told.find('\n') == std::string::npos && read_some(status.read.get(), told)) {
    }
    const std::size_t at = told.find(key);
    if (said.find(sign) != std::string::npos && at != std::string::npos) {
        first_ = process_descriptor(std::atoi(told.c_str() + at + key.size()));
    }
    if (!first_) {
        kill(bubblewrap_, SIGKILL);
        waitpid(bubblewrap_, nullptr, 0);
        throw std::runtime_error(said.empty() ? "bubblewrap ended without a word" : said);
    }
    question_ = std::move(question.write);
    answer_ = std::move(answer.read);
}

Room::~Room() {
    end();
    waitpid(bubblewrap_, nullptr, 0);
}

void Room::enter() const {
    const int own_users = geteuid() == 0 ? 0 : CLONE_NEWUSER;  // bubblewrap asks for these unless root starts it
    if (setns(first_.get(), CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS | own_users) != 0) {
        throw_errno("entering the room that bubblewrap made");
    }
}

bool Room::is_inhabited() const {
    const std::unique_ptr<DIR, int (*)(DIR*)> processes(opendir("/proc"), &closedir);
    while (const dirent* entry = processes ? readdir(processes.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (!std::isdigit(static_cast<unsigned char>(name[0])) || name == "1" || name == "2") continue;
        std::string stat;  // "3 (name) S ..."
        const Descriptor file(open(fmt::format("/proc/{}/stat", name).c_str(), O_RDONLY | O_CLOEXEC));
        if (!file || !read_some(file.get(), stat)) continue;
        const std::size_t state = stat.rfind(')') + 2;
        if (state < stat.size() && stat[state] != 'Z' && stat[state] != 'X') return true;
    }
    return false;
}

void Room::end() const { end_process(first_); }

}  // namespace rt
