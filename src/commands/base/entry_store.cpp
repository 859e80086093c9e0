#include "commands/base/entry_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "commands/base/write_bytes.h"
#include "core/source.h"
#include "core/utf8.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// Behind the name of an entry that is being written. Machines may share the folder, so only the machine of a process can say it has ended.
std::string unfinished_by(const std::string& process) {
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    return fmt::format(".unfinished-{}-{}", host, process);
}

bool is_alive(const std::string& process) {
    const int id = std::atoi(process.c_str());
    return id > 0 && (kill(id, 0) == 0 || errno == EPERM);
}

/// Of a folder, at the end of its life.
struct Removal {
    fs::path folder;
    ~Removal() {
        std::error_code none;
        fs::remove_all(folder, none);
    }
};

}  // namespace

EntryStore::EntryStore(std::string folder) : folder_(std::move(folder)) {
    make_folder(folder_);
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        const std::string mark = unfinished_by("");
        const std::size_t at = name.find(mark);
        if (at != std::string::npos && !is_alive(name.substr(at + mark.size()))) fs::remove_all(entry.path(), error);
    }
}

void EntryStore::put(const std::string& key, const std::vector<std::pair<std::string, std::string>>& files) const {
    const fs::path place = fs::path(folder_) / key, beside = place.string() + unfinished_by(std::to_string(getpid()));
    std::error_code error;
    fs::remove_all(beside, error);
    const Removal whatever_is_left{beside};
    make_folder(beside.string());
    for (const auto& [name, bytes] : files) write_bytes((beside / name).string(), bytes);
    fs::rename(beside, place, error);
    if (!error) return;
    // There is one already: they change places in one step, so that whoever looks finds one of them whole.
    const bool exchanged = renameat2(AT_FDCWD, beside.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) == 0;
    if (!exchanged) throw OutputError(fmt::format("cannot write '{}': {}", one_line(place.string()), std::strerror(errno)));
}

std::string EntryStore::path(const std::string& key, const std::string& name) const {
    const fs::path path = fs::path(folder_) / key / name;
    std::error_code none;
    return fs::is_regular_file(path, none) ? path.string() : std::string();
}

}  // namespace rt
