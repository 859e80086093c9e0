#include "commands/base/scene_folder.h"

#include <algorithm>
#include <filesystem>

#include "commands/base/values.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) { return lower_case(path.extension().string()) == ".pov"; }

/// Whether a folder's content is nobody's scene.
bool is_left_out(const fs::path& path, const fs::path& left_out) { return path.filename().string().starts_with('.') || path == left_out; }

}  // namespace

std::vector<std::string> scenes_below(const std::string& folder, const std::string& left_out) {
    std::vector<fs::path> scenes;
    std::error_code error, none;
    for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end; entry != end && !error;
         entry.increment(error)) {
        if (entry->is_directory(none) && is_left_out(entry->path(), left_out))
            entry.disable_recursion_pending();
        else if (entry->is_regular_file(none) && is_scene(entry->path()))
            scenes.push_back(entry->path());
    }
    std::sort(scenes.begin(), scenes.end());
    return {scenes.begin(), scenes.end()};
}

}  // namespace rt
