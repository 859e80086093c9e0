#include "film/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/source.h"
#include "core/utf8.h"
#include "film/temporary_files.h"

namespace rt {
namespace {

namespace fs = std::filesystem;

/// Where writing to `path` would end up: symbolic links followed, also one whose target does not exist yet.
std::string follow_links(std::string path) {
    for (int links = 0; links < 40; ++links) {
        std::error_code error;
        const fs::path next = fs::read_symlink(path, error);
        if (error) break;
        path = next.is_absolute() ? next.string() : (fs::path(path).parent_path() / next).string();
    }
    return path;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
    if (path == "-") {
        stream_ = stdout;
        return;
    }
    const std::string end = follow_links(path);
    struct stat info {};
    const bool exists = stat(end.c_str(), &info) == 0;
    if (!exists && errno == ELOOP) fail(ELOOP);
    if (exists && S_ISDIR(info.st_mode)) fail(EISDIR);
    if (exists && access(end.c_str(), W_OK) != 0) fail(errno);
    if (exists && !S_ISREG(info.st_mode)) {
        stream_ = std::fopen(end.c_str(), "wbe");
        if (!stream_) fail(errno);
        return;
    }
    target_ = end;
    open_temporary();
    if (exists) (void)fchmod(fileno(stream_), info.st_mode & 07777);
}

void OutputFile::open_temporary() {
    const fs::path target(target_);
    // The target's name may already be as long as names can be.
    const std::string stem(whole_characters(target.filename().string(), 64));
    for (int attempt = 0;; ++attempt) {
        temporary_ = (target.parent_path() / fmt::format(".{}.{}.{}.tmp", stem, getpid(), attempt)).string();
        const HoldSignals until_registered;
        const int descriptor = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        const int code = errno;
        if (descriptor >= 0) {
            remember_temporary(temporary_);
            stream_ = fdopen(descriptor, "wb");
            return;
        }
        if (code == EEXIST && attempt < 100) continue;
        temporary_.clear();
        fail(code);
    }
}

OutputFile::~OutputFile() {
    if (stream_ && stream_ != stdout) std::fclose(stream_);
    if (temporary_.empty()) return;
    unlink(temporary_.c_str());
    forget_temporary(temporary_);
}

void OutputFile::fail(int code, const std::string& reason) const {
    const std::string name = path_ == "-" ? "standard output" : fmt::format("'{}'", one_line(path_));
    throw OutputError(fmt::format("Cannot write {}: {}", name, reason.empty() ? std::strerror(code) : reason));
}

void OutputFile::write(const void* data, std::size_t size) {
    if (std::fwrite(data, 1, size, stream_) != size) fail(errno);
}

void OutputFile::commit() {
    if (std::fflush(stream_) != 0) fail(errno);
    if (temporary_.empty()) return;
    if (fsync(fileno(stream_)) != 0) fail(errno);
    const int closed = std::fclose(stream_);
    stream_ = nullptr;
    if (closed != 0) fail(errno);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    forget_temporary(temporary_);
    temporary_.clear();
}

bool same_file(const std::string& path, const std::string& input) {
    struct stat a {
    }, b{};
    if (path == "-" || stat(path.c_str(), &a) != 0 || stat(input.c_str(), &b) != 0) return false;
    return S_ISREG(a.st_mode) && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

ScratchFile::ScratchFile() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    path_ = ((error ? fs::path("/tmp") : folder) / "raytrace.XXXXXX").string();
    const HoldSignals until_registered;
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) throw OutputError(fmt::format("Cannot write a temporary file '{}': {}", path_, std::strerror(errno)));
    remember_temporary(path_);
    close(descriptor);
}

ScratchFile::~ScratchFile() {
    unlink(path_.c_str());
    forget_temporary(path_);
}

}  // namespace rt
