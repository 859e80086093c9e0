#include "grading/run_folder.h"

#include <dirent.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <filesystem>
#include <functional>

#include "grading/descriptor.h"

namespace rt {
namespace {

constexpr int deepest = 64;
constexpr int to_folder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

/// Calls `visit(folder, name, status)` for everything below the folder, the outer first, until it says false.
bool walk(int folder, int depth, const std::function<bool(int, const char*, const struct stat&)>& visit) {
    DIR* entries = fdopendir(openat(folder, ".", to_folder));
    if (entries == nullptr) return true;
    bool more = true;
    while (const dirent* entry = more ? readdir(entries) : nullptr) {
        const std::string_view name = entry->d_name;
        struct stat status {};
        if (name == "." || name == ".." || fstatat(folder, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
        more = visit(folder, entry->d_name, status);
        if (!more || !S_ISDIR(status.st_mode) || depth == deepest) continue;
        const Descriptor inner(openat(folder, entry->d_name, to_folder));
        if (inner) more = walk(inner.get(), depth + 1, visit);
    }
    closedir(entries);
    return more;
}

std::string kind_of(mode_t mode) {
    if (S_ISLNK(mode)) return "a symbolic link";
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a named pipe";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

}  // namespace

void give_folder(const std::string& folder, uid_t user, gid_t group) {
    const auto give = [&](int in, const char* name, const struct stat& status) {
        if (geteuid() != 0 && status.st_uid != geteuid()) return true;  // not ours to give
        const bool second_name = !S_ISDIR(status.st_mode) && status.st_nlink > 1;
        if (S_ISDIR(status.st_mode) && (status.st_mode & S_IRWXU) != S_IRWXU && fchmodat(in, name, status.st_mode | S_IRWXU, 0) != 0)
            return false;
        return second_name || status.st_uid == user || fchownat(in, name, user, group, AT_SYMLINK_NOFOLLOW) == 0;
    };
    struct stat status {};
    if (lstat(folder.c_str(), &status) != 0 || !give(AT_FDCWD, folder.c_str(), status)) throw_errno(folder);
    const Descriptor top(open(folder.c_str(), to_folder));
    if (!top) throw_errno(folder);
    if (!walk(top.get(), 1, give)) throw_errno("a file in " + folder);
}

std::uint64_t folder_use(int folder, std::uint64_t enough) {
    constexpr std::uint64_t block = 4096, unit_of_blocks = 512;
    std::uint64_t sum = 0;
    walk(folder, 1, [&](int, const char*, const struct stat& status) {
        sum += block + (S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_blocks) * unit_of_blocks : 0);
        return sum <= enough;
    });
    return sum;
}

std::uint64_t disk_room(int folder) {
    struct statvfs disk {};
    if (fstatvfs(folder, &disk) != 0 || disk.f_blocks == 0) return ~std::uint64_t{0};
    const bool counts_files = disk.f_files > 0;
    return counts_files && disk.f_favail == 0 ? 0 : std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

TakenFile take_file(const std::string& folder, const std::string& name, std::uint64_t max_bytes) {
    const auto bad = [](std::string problem) { return TakenFile{std::nullopt, false, std::move(problem)}; };
    Descriptor here(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!here) return bad(fmt::format("{}: {}", folder, std::generic_category().message(errno)));
    if (name.empty() || name[0] == '/') return bad(fmt::format("'{}' is no name of a file in the run's folder", name));
    struct stat status {};
    // O_PATH opens nothing yet, so that a pipe does not wait and a device does not notice.
    for (const std::filesystem::path& part : std::filesystem::path(name)) {
        if (part == "..") return bad(fmt::format("'{}' leads out of the run's folder", name));
        here = Descriptor(openat(here.get(), part.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
        if (!here && errno == ENOENT) return {std::nullopt, true, fmt::format("there is no {}", name)};
        if (!here || fstat(here.get(), &status) != 0) return bad(fmt::format("{}: {}", name, std::generic_category().message(errno)));
    }
    if (!S_ISREG(status.st_mode)) return bad(fmt::format("{} is {}", name, kind_of(status.st_mode)));
    const std::string too_large = fmt::format("{} has more than {} bytes", name, max_bytes);
    if (static_cast<std::uint64_t>(status.st_size) > max_bytes) return bad(too_large);
    const Descriptor file(open(fmt::format("/proc/self/fd/{}", here.get()).c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) return bad(fmt::format("{}: {}", name, std::generic_category().message(errno)));
    std::string bytes;
    while (bytes.size() <= max_bytes && read_some(file.get(), bytes)) {
    }
    if (bytes.size() > max_bytes) return bad(too_large);
    return {std::move(bytes), false, ""};
}

}  // namespace rt
