// The room of one run: bubblewrap (https://github.com/containers/bubblewrap) makes its root folder, its processes and its network.
//
// Bubblewrap starts a `cat` in the room and nothing else. When that answers, the room is complete, and the keeper enters it (setns(2)) and
// starts the program there as its own child. So the program's end reaches the keeper as the kernel tells it (bubblewrap itself would make
// exit status 139 of a signal 11), so does the error of an execve that fails, and limits hold for the program alone.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "grading/descriptor.h"
#include "grading/sandbox.h"

namespace rt {

/// What bubblewrap is told, and the descriptors of the texts that become files in the room, which it inherits.
struct RoomPlan {
    std::vector<std::string> words;
    std::vector<Descriptor> texts;
};
/// `user` is whom the room's list of users names. Throws std::system_error for a folder or a readable path that is not there.
RoomPlan plan_room(const ContainedRun& run, uid_t user);

class Room {
public:
    /// Throws std::runtime_error with what bubblewrap said if it cannot make the room.
    Room(const std::string& bubblewrap, const ContainedRun& run, uid_t user);
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    ~Room();

    /// From now on this process sees the room's files, and its children are in the room. Throws std::system_error.
    void enter() const;
    /// Some process is in the room beside its own two. Only after enter().
    bool is_inhabited() const;
    /// Ends everything in the room. Its processes are gone when this process has no children any more.
    void end() const;

private:
    pid_t bubblewrap_ = -1;  ///< its process outside
    Descriptor first_;       ///< the room's process 1, whose end is the end of all others
    Descriptor question_, answer_;
};

}  // namespace rt
