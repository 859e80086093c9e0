// The folder of one run of a program.
#pragma once

#include <cstdint>
#include <string>

namespace rt {

/// Runs that fail where the disk has less than this left may have failed for want of it, so none is begun there: 16 MiB.
inline constexpr std::uint64_t least_room = 16ull << 20;
/// Throws OutputError if the disk of `folder` has less than `least_room` left.
void expect_room(const std::string& folder);

/// A new, empty folder that is removed with all that is in it when this ends. To be made by a worker: the folder is its parent's.
class RunPlace {
public:
    /// Throws OutputError, also if the disk is nearly full.
    RunPlace();
    ~RunPlace();
    RunPlace(const RunPlace&) = delete;
    RunPlace& operator=(const RunPlace&) = delete;

    const std::string& folder() const { return folder_; }

private:
    std::string folder_;
};

/// Removes the folders of parents that have ended on this machine without removing them, and of workers of ours: none may be running.
void remove_left_places();

}  // namespace rt
