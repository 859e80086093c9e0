#include "grading/file_lock.h"

#include <sys/stat.h>

namespace rt {

namespace {

bool set(int file, int command, short type, off_t byte) {
    struct flock lock {};
    lock.l_type = type, lock.l_whence = SEEK_SET, lock.l_start = byte, lock.l_len = 1;
    while (fcntl(file, command, &lock) != 0) {
        if (errno == EAGAIN || errno == EACCES) return false;
        if (errno != EINTR) throw_errno("locking a file");
    }
    return true;
}

short type_of(LockFile::Kind kind) { return kind == LockFile::Kind::shared ? F_RDLCK : F_WRLCK; }

}  // namespace

LockFile::LockFile(const std::string& path) : file_(open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY, 0600)) {
    struct stat status {};
    if (!file_ || fstat(file_.get(), &status) != 0) throw_errno(path);
    if (S_ISREG(status.st_mode) && status.st_uid == geteuid()) return;
    errno = EEXIST;
    throw_errno(path);
}

void LockFile::lock(off_t byte, Kind kind) { set(file_.get(), F_OFD_SETLKW, type_of(kind), byte); }

bool LockFile::try_lock(off_t byte, Kind kind) { return set(file_.get(), F_OFD_SETLK, type_of(kind), byte); }

void LockFile::unlock(off_t byte) { set(file_.get(), F_OFD_SETLK, F_UNLCK, byte); }

}  // namespace rt
