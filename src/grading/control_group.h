// A control group for one run (Linux's cgroups, version 1 or 2): what all its processes together may use, and what they have used.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grading/descriptor.h"
#include "grading/sandbox.h"

namespace rt {

/// The group's folders: one for memory and one for the number of processes, in version 2 a single one for both, or none.
class ControlGroup {
public:
    /// Makes the group `name` in the folders that `containment` names, with the limits. A group of that name that nobody is in any more
    /// is removed before. Throws std::system_error.
    ControlGroup(const Containment& containment, const std::string& name, const Limits& limits);
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;
    ~ControlGroup() { remove(); }

    /// Descriptors through which a process that writes "0" becomes a member.
    std::vector<int> entrances() const;
    /// The kernel has ended a member because the group's memory was used up.
    bool was_out_of_memory() const;
    /// The most that the members have used together, in bytes; 0 if the kernel does not tell.
    std::uint64_t peak_memory() const;
    /// Ends every member; first none may start another where the number of processes is limited.
    void end_members() const;
    /// Ends the members and removes the folders, as soon as the kernel has let go of them.
    void remove();

private:
    struct Folder {
        Descriptor parent, self, entrance;  ///< descriptors: after the keeper has entered a room no path leads here any more
    };
    void add(const std::string& parent, const Limits& limits);

    std::string name_;
    std::vector<Folder> folders_;
};

/// Writes the limits into the files of a group's folder that are there: those of version 1 or 2, memory or pids. Throws std::system_error.
void write_limits(int folder, const Limits& limits);

/// The folder to make groups in, for `controller` ("memory", "pids"): the nearest to our own group, upwards, in which a trial group can be
/// made, limited and entered; empty if none. `mounts` and `own` are the texts of /proc/self/mounts and /proc/self/cgroup.
std::string find_group_folder(const std::string& controller, const std::string& mounts, const std::string& own);

/// Removes groups of runs whose grading process is gone, which only a SIGKILL of it and its keepers leaves behind.
void remove_stale_groups(const std::string& folder);

/// The group's name for a run: "raytrace-PID-SLOT" with the grading process's id.
std::string group_name(int slot);

}  // namespace rt
