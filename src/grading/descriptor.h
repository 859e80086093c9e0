// File descriptors that close themselves, for the files of this room that talk to the system.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace rt {

[[noreturn]] inline void throw_errno(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

/// Owns a file descriptor. None is ever inherited by a program unless somebody asks for it, and none is one of the standard three.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {
        if (number < 0 || number > 2) return;
        number_ = fcntl(number, F_DUPFD_CLOEXEC, 3);
        ::close(number);
    }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    int get() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    int number_ = -1;
};

/// A descriptor that means a process, whatever becomes of its number; readable when the process has ended. None if it is not there.
/// (Debian 12's <sys/pidfd.h> cannot be linked from C++.)
inline Descriptor process_descriptor(pid_t process) { return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, process, 0))); }
inline void end_process(const Descriptor& process) { syscall(SYS_pidfd_send_signal, process.get(), SIGKILL, nullptr, 0); }

struct Pipe {
    Descriptor read, write;
};

inline Pipe make_pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw_errno("a pipe");
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Appends what can be read in one go; false at the end of the data, on an error, or when a non-blocking one has nothing.
inline bool read_some(int from, std::string& to) {
    char buffer[65536];
    ssize_t count = 0;
    do count = read(from, buffer, sizeof buffer);
    while (count < 0 && errno == EINTR);
    if (count > 0) to.append(buffer, static_cast<std::size_t>(count));
    return count > 0;
}

inline void write_all(int to, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t count = write(to, data, size);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;  // nobody listens any more
        data += count;
        size -= static_cast<std::size_t>(count);
    }
}

}  // namespace rt
