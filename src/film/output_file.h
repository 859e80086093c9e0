// A file that appears whole or not at all.
#pragma once

#include <cstdio>
#include <string>

namespace rt {

/// Written beside its target under a temporary name and renamed by `commit`; unless committed it vanishes with the object (a signal that
/// ends the program removes it too, which makes it the main thread's, see temporary_files.h), and a file that
/// stood there stays as it was. A symbolic link keeps pointing where it points: its target is replaced. "-" is standard output; it and
/// anything else that is no regular file (a device, a pipe) is written directly. Errors are OutputError with path and system's reason.
class OutputFile {
public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    std::FILE* stream() const { return stream_; }
    /// Throws an OutputError for `path` with `reason`, or with the text of errno `code` when it is empty.
    [[noreturn]] void fail(int code, const std::string& reason = "") const;
    void write(const void* data, std::size_t size);
    /// Flushes, waits until the bytes are on the disk, and gives the file its name.
    void commit();

private:
    void open_temporary();

    std::string path_;       ///< as the user wrote it
    std::string target_;     ///< where links lead to; empty when written directly
    std::string temporary_;  ///< empty when there is none
    std::FILE* stream_ = nullptr;
};

/// Would a file written to `path` take the place of `input`, by whatever names both go?
bool same_file(const std::string& path, const std::string& input);

/// A file name in the system's folder for temporary files that vanishes with the object.
class ScratchFile {
public:
    ScratchFile();
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace rt
