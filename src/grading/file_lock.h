// Locks that processes share by the bytes of a file.
#pragma once

#include <string>

#include "grading/descriptor.h"

namespace rt {

/// Open file description locks (fcntl(2)): each byte of a file is one. A lock is held by this object and by processes forked from ours
/// meanwhile, and is gone with the last of them, whatever they die of.
class LockFile {
public:
    enum class Kind { shared, exclusive };

    /// Opens the file, or makes one that is only ours. Throws std::system_error, also if there is no regular file of ours but something
    /// else, a link for instance.
    explicit LockFile(const std::string& path);

    /// Waits until it is ours; a lock that we have changes its kind. Throws std::system_error if the file's system has no locks.
    void lock(off_t byte, Kind kind);
    /// False at once if others have it. Then what we have stays.
    bool try_lock(off_t byte, Kind kind);
    void unlock(off_t byte);

    int descriptor() const { return file_.get(); }

private:
    Descriptor file_;
};

}  // namespace rt
