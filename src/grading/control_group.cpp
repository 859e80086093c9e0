#include "grading/control_group.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "grading/child_process.h"

namespace rt {
namespace {

constexpr const char* name_prefix = "raytrace-";

std::string text_of(int folder, const char* name) {
    std::string text;
    const Descriptor file(openat(folder, name, O_RDONLY | O_CLOEXEC));
    while (file && read_some(file.get(), text)) {
    }
    return text;
}

/// Writes into a control file; false if there is none of that name.
bool write_control(int folder, const char* name, const std::string& value) {
    const Descriptor file(openat(folder, name, O_WRONLY | O_CLOEXEC));
    if (!file && errno == ENOENT) return false;
    if (!file || write(file.get(), value.data(), value.size()) < 0) throw_errno(fmt::format("{} of a control group", name));
    return true;
}

std::uint64_t number_in(const std::string& text) {
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// The number behind `key ` at the beginning of a line.
std::uint64_t number_of(const std::string& text, const std::string& key) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(key + " ")) return number_in(line.substr(key.size() + 1));
    }
    return 0;
}

void wait_a_millisecond() {
    const timespec time{0, 1'000'000};
    nanosleep(&time, nullptr);
}

bool can_enter(const ControlGroup& group) {
    return holds_in_child([&] {
        const std::vector<int> entrances = group.entrances();
        return std::ranges::all_of(entrances, [](int entrance) { return write(entrance, "0", 1) == 1; });
    });
}

}  // namespace

std::string group_name(int slot) { return fmt::format("{}{}-{}", name_prefix, getpid(), slot); }

void write_limits(int folder, const Limits& limits) {
    const std::string bytes = std::to_string(limits.memory_bytes);
    if (write_control(folder, "memory.limit_in_bytes", bytes)) write_control(folder, "memory.memsw.limit_in_bytes", bytes);
    if (write_control(folder, "memory.max", bytes)) {
        write_control(folder, "memory.swap.max", "0");
        write_control(folder, "memory.oom.group", "1");
    }
    write_control(folder, "pids.max", std::to_string(limits.processes));
}

ControlGroup::ControlGroup(const Containment& containment, const std::string& name, const Limits& limits) : name_(name) {
    try {
        if (!containment.memory_group.empty()) add(containment.memory_group, limits);
        if (!containment.pids_group.empty() && containment.pids_group != containment.memory_group) add(containment.pids_group, limits);
    } catch (...) {
        remove();
        throw;
    }
}

void ControlGroup::add(const std::string& path, const Limits& limits) {
    Descriptor parent(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!parent) throw_errno(path);
    unlinkat(parent.get(), name_.c_str(), AT_REMOVEDIR);  // of an earlier process with our number
    if (mkdirat(parent.get(), name_.c_str(), 0755) != 0 && errno != EEXIST) throw_errno(path + "/" + name_);
    Folder& folder = folders_.emplace_back();
    folder.parent = std::move(parent);
    folder.self = Descriptor(openat(folder.parent.get(), name_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.self) throw_errno(path + "/" + name_);
    folder.entrance = Descriptor(openat(folder.self.get(), "cgroup.procs", O_WRONLY | O_CLOEXEC));
    if (!folder.entrance) throw_errno(path + "/" + name_ + "/cgroup.procs");
    write_limits(folder.self.get(), limits);
}

std::vector<int> ControlGroup::entrances() const {
    std::vector<int> numbers;
    for (const Folder& folder : folders_) numbers.push_back(folder.entrance.get());
    return numbers;
}

bool ControlGroup::was_out_of_memory() const {
    for (const Folder& folder : folders_) {
        const std::string version_1 = text_of(folder.self.get(), "memory.oom_control"),
                          version_2 = text_of(folder.self.get(), "memory.events");
        if (number_of(version_1, "oom_kill") > 0 || number_of(version_2, "oom_kill") > 0) return true;
    }
    return false;
}

std::uint64_t ControlGroup::peak_memory() const {
    std::uint64_t peak = 0;
    for (const Folder& folder : folders_) {
        for (const char* file : {"memory.max_usage_in_bytes", "memory.peak"})
            peak = std::max(peak, number_in(text_of(folder.self.get(), file)));
    }
    return peak;
}

void ControlGroup::end_members() const {
    for (const Folder& folder : folders_) {
        const int self = folder.self.get();
        try {
            write_control(self, "pids.max", "0");
            write_control(self, "cgroup.kill", "1");
        } catch (const std::system_error&) {  // the group is gone
        }
    }
    for (const Folder& folder : folders_) {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            std::istringstream members(text_of(folder.self.get(), "cgroup.procs"));
            bool any = false;
            for (pid_t member = 0; members >> member;) any = kill(member, SIGKILL) == 0 || any;
            if (!any) break;
            wait_a_millisecond();
        }
    }
}

void ControlGroup::remove() {
    end_members();
    for (const Folder& folder : folders_) {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            if (unlinkat(folder.parent.get(), name_.c_str(), AT_REMOVEDIR) == 0 || errno != EBUSY) break;
            wait_a_millisecond();
        }
    }
    folders_.clear();
}

std::string find_group_folder(const std::string& controller, const std::string& mounts, const std::string& own) {
    // /proc/self/cgroup: "4:memory:/path" in version 1, "0::/path" in version 2.
    const std::string wanted = fmt::format(",{},", controller);
    std::string path_1, path_2;
    std::istringstream groups(own);
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1));
        if (controllers == ",,") path_2 = line.substr(second + 1);
        if (controllers.find(wanted) != std::string::npos) path_1 = line.substr(second + 1);
    }
    std::istringstream lines(mounts);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string device, place, type, options;
        words >> device >> place >> type >> options;
        const bool version_1 = type == "cgroup" && fmt::format(",{},", options).find(wanted) != std::string::npos;
        if (!version_1 && type != "cgroup2") continue;
        for (std::filesystem::path path = version_1 ? path_1 : path_2; !path.empty(); path = path.parent_path()) {
            const std::string folder = place + (path == "/" ? "" : path.string());
            Containment trial;
            (controller == "memory" ? trial.memory_group : trial.pids_group) = folder;
            try {
                const ControlGroup group(trial, group_name(0) + "-trial", Limits{});
                const std::string limit = controller + (version_1 && controller == "memory" ? ".limit_in_bytes" : ".max");
                const std::string file = folder + "/" + group_name(0) + "-trial/" + limit;
                if (access(file.c_str(), W_OK) == 0 && can_enter(group)) return folder;
            } catch (const std::system_error&) {  // not here
            }
            if (path == "/") break;
        }
    }
    return "";
}

void remove_stale_groups(const std::string& folder) {
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename();
        if (!name.starts_with(name_prefix)) continue;
        const auto owner = static_cast<pid_t>(number_in(name.substr(std::string(name_prefix).size())));
        if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH) rmdir(entry->path().c_str());
    }
}

}  // namespace rt
