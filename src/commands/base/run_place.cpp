#include "commands/base/run_place.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/source.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "raytrace-run-";  ///< behind it the parent's number

}  // namespace

RunPlace::RunPlace() : folder_((fs::temp_directory_path() / fmt::format("{}{}-XXXXXX", prefix, getppid())).string()) {
    if (!mkdtemp(folder_.data())) throw OutputError(fmt::format("cannot make a folder in '{}'", fs::temp_directory_path().string()));
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
