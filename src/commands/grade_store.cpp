#include "commands/grade_store.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>

#include "commands/result_json.h"
#include "commands/write_bytes.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 1u << 26;

/// Behind the name of an entry that is being written. Machines may share the folder, so only the machine of a process can say it has ended.
std::string unfinished_by(const std::string& process) {
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    return fmt::format(".unfinished-{}-{}", host, process);
}

bool is_alive(const std::string& process) {
    const int id = std::atoi(process.c_str());
    return id > 0 && kill(id, 0) == 0;
}

}  // namespace

GradeStore::GradeStore(std::string folder) : folder_(std::move(folder)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", folder_, error.message()));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        const std::string mark = unfinished_by("");
        const std::size_t at = name.find(mark);
        if (at != std::string::npos && !is_alive(name.substr(at + mark.size()))) fs::remove_all(entry.path(), error);
    }
}

std::optional<Result> GradeStore::find(const std::string& key) const {
    std::optional<std::string> text = read_file_text((fs::path(folder_) / key / "result.json").string(), most_bytes);
    if (!text) return std::nullopt;
    Sources sources;
    sources.add({key, std::move(*text)});
    try {
        const nlohmann::json content = parse_json(sources);
        const JsonValue value(sources, content);
        Result result = result_of_json(value["result"]);
        read_times(value["times"], result);
        return result;
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

void GradeStore::put(const std::string& key, const Result& result, const std::string& picture) const {
    const fs::path place = fs::path(folder_) / key, beside = place.string() + unfinished_by(std::to_string(getpid()));
    std::error_code error;
    fs::remove_all(beside, error);
    fs::create_directories(beside, error);
    if (error) throw OutputError(fmt::format("cannot make the folder '{}': {}", beside.string(), error.message()));
    if (!picture.empty()) write_bytes((beside / "picture").string(), picture);
    write_bytes((beside / "result.json").string(), json_text({{"result", result_json(result)}, {"times", times_json(result)}}, 1));
    constexpr int attempts = 10;  // another grading may put the same entry there in between
    for (int i = 0; i < attempts; ++i) {
        fs::remove_all(place, error);
        fs::rename(beside, place, error);
        if (!error) return;
    }
    throw OutputError(fmt::format("cannot write '{}': {}", place.string(), error.message()));
}

std::string GradeStore::picture_path(const std::string& key) const {
    const fs::path path = fs::path(folder_) / key / "picture";
    std::error_code none;
    return fs::is_regular_file(path, none) ? path.string() : std::string();
}

}  // namespace rt
