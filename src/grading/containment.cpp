// What this machine lets us contain, found by trying.
#include <fmt/format.h>
#include <grp.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/source.h"
#include "core/utf8.h"
#include "grading/child_process.h"
#include "grading/control_group.h"
#include "grading/descriptor.h"
#include "grading/sandbox.h"

namespace rt {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

bool can_change_user() {
    if (geteuid() != 0) return false;
    constexpr uid_t somebody = 61000;
    return holds_in_child([] {
        return setgroups(0, nullptr) == 0 && setresgid(somebody, somebody, somebody) == 0 && setresuid(somebody, somebody, somebody) == 0;
    });
}

std::string find_program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (folder.starts_with('/') && access((folder + "/" + name).c_str(), X_OK) == 0) return folder + "/" + name;
    }
    return "";
}

/// Why a run of `true` fails; empty if it does not.
std::string trial(const Containment& containment) {
    std::error_code error;
    std::string folder = (fs::temp_directory_path(error) / "raytrace-trial-XXXXXX").string();
    if (error) throw OutputError(fmt::format("TMPDIR names no folder: {}", error.message()));
    if (mkdtemp(folder.data()) == nullptr)
        throw OutputError(fmt::format("cannot make the folder '{}': {}", one_line(folder), std::generic_category().message(errno)));
    Limits limits;
    limits.wall_seconds = 10.0;
    const Ending ending = run_contained({{"/usr/bin/true"}, folder, folder, {}, {}}, limits, containment, 0);
    fs::remove_all(folder);
    if (ending.kind == Ending::Kind::exited && ending.status == 0) return "";
    return ending.reason.empty() ? fmt::format("'true' ended there with {}", ending.status) : ending.reason;
}

}  // namespace

Containment find_containment() {
    Containment found;
    found.own_user = can_change_user();
    const std::string mounts = text_of("/proc/self/mounts"), own = text_of("/proc/self/cgroup");
    found.memory_group = find_group_folder("memory", mounts, own);
    found.pids_group = find_group_folder("pids", mounts, own);
    for (const std::string& folder : {found.memory_group, found.pids_group}) remove_stale_groups(folder);
    found.bubblewrap = find_program("bwrap");
    found.bubblewrap_problem = found.bubblewrap.empty() ? "it is not installed" : trial(found);
    if (!found.bubblewrap_problem.empty()) found.bubblewrap.clear();
    return found;
}

std::vector<std::string> holes(const Containment& containment) {
    std::vector<std::string> sentences;
    const bool alone = !containment.bubblewrap.empty();
    if (!alone) {
        const std::string why = containment.bubblewrap_problem.empty() ? "" : fmt::format(" ({})", containment.bubblewrap_problem);
        const std::string who = containment.own_user ? "everybody" : "you";
        sentences = {
            fmt::format("Without bubblewrap{} programs read every file that {} may read, expected results among them.", why, who),
            fmt::format("They write wherever {} may write.", who),
            "They reach the network, and services of this machine.",
        };
        if (!containment.own_user) sentences.push_back("They can end your other processes and look into them, the grader's among them.");
    }
    if (containment.memory_group.empty()) {
        sentences.push_back(
            "Memory is limited for each process, not for all of a program's together: no control group for it can be made here.");
    }
    if (containment.pids_group.empty() && geteuid() == 0 && !containment.own_user) {
        sentences.push_back("The number of processes is not limited: you are root, and no control group for it can be made here.");
    }
    return sentences;
}

}  // namespace rt
