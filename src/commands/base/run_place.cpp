#include "commands/base/run_place.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "core/source.h"
#include "core/utf8.h"
#include "grading/descriptor.h"
#include "grading/run_folder.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "raytrace-run-";  ///< behind it the parent's number

std::string temporary_folder() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error) throw OutputError(fmt::format("TMPDIR names no folder: {}", error.message()));
    return folder.string();
}

}  // namespace

void expect_room(const std::string& folder) {
    const Descriptor place(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (place && disk_room(place.get()) < least_room)
        throw OutputError(fmt::format("the disk of '{}' is full, or nearly so: runs need {} MiB", one_line(folder), least_room >> 20));
}

RunPlace::RunPlace() {
    const std::string folder = temporary_folder();
    expect_room(folder);
    folder_ = (fs::path(folder) / fmt::format("{}{}-XXXXXX", prefix, getppid())).string();
    if (!mkdtemp(folder_.data()))
        throw OutputError(fmt::format("cannot make a folder in '{}': {}", one_line(folder), std::strerror(errno)));
}

RunPlace::~RunPlace() {
    std::error_code none;
    fs::remove_all(folder_, none);
}

void remove_left_places() {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::temp_directory_path(error), error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(prefix)) continue;
        const int process = std::atoi(name.c_str() + prefix.size());
        const bool ended = process > 0 && kill(process, 0) != 0 && errno == ESRCH;
        if (ended || process == getpid()) fs::remove_all(entry.path(), error);
    }
}

}  // namespace rt
