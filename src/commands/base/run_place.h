// The folder of one run of a program.
#pragma once

#include <string>

namespace rt {

/// A new, empty folder that is removed with all that is in it when this ends. To be made by a worker: the folder is its parent's.
class RunPlace {
public:
    /// Throws OutputError.
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
