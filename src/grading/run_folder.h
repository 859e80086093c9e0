// The folder of a run, in which an unknown program may have put anything: links to other places, pipes, devices, folders without end.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace rt {

/// Makes `user` the owner of the folder (absolute path) and what is in it, down to 64 folders deep, and lets its owner enter and change all
/// folders in it. Links are not followed; files with a second name somewhere are left alone, and so are those of others unless we are root.
/// Throws std::system_error for the first thing that cannot be given.
void give_folder(const std::string& folder, uid_t user, gid_t group);

/// What all in the folder takes on the disk, in bytes, entries counted as a block each; stops counting beyond `enough`.
std::uint64_t folder_use(int folder, std::uint64_t enough);

/// Bytes that the folder's disk has left for those who are not root; 0 if it has no room for another file, all ones if it does not say.
std::uint64_t disk_room(int folder);

/// A file that a run should have written: its bytes, or what there is instead.
struct TakenFile {
    std::optional<std::string> bytes;
    bool missing = false;  ///< there is nothing of that name
    std::string problem;   ///< "there is no output.png", "output.png is a symbolic link", ...; empty with `bytes`
};
/// Reads `name` (relative, may lie in folders below) if it is a regular file of at most `max_bytes`. Follows no link on the way, and
/// neither waits for nor touches what is not a regular file.
TakenFile take_file(const std::string& folder, const std::string& name, std::uint64_t max_bytes);

}  // namespace rt
