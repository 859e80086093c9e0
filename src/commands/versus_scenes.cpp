#include "commands/versus_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "commands/content_hash.h"
#include "commands/values.h"
#include "core/source.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) { return lower_case(path.extension().string()) == ".pov"; }

/// Whether a folder's content is nobody's scene: hidden, or the output of a comparison.
bool is_left_out(const fs::path& path, const fs::path& output) { return path.filename().string().starts_with('.') || path == output; }

std::vector<fs::path> scenes_below(const fs::path& folder, const fs::path& output) {
    std::vector<fs::path> scenes;
    std::error_code error, none;
    for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end; entry != end && !error;
         entry.increment(error)) {
        if (entry->is_directory(none) && is_left_out(entry->path(), output))
            entry.disable_recursion_pending();
        else if (entry->is_regular_file(none) && is_scene(entry->path()))
            scenes.push_back(entry->path());
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// Programs see the folder around an argument as well: files are often read from "../include".
fs::path around(const fs::path& folder) { return folder.parent_path() == folder.root_path() ? folder : folder.parent_path(); }

void add(const std::string& argument, const fs::path& output, std::vector<VersusScene>& scenes) {
    std::error_code error;
    fs::path path = fs::canonical(argument, error);
    if (error) path = fs::canonical(argument + ".pov", error);
    if (error) throw OptionError(fmt::format("there is no scene or folder '{}'", argument));
    if (!fs::is_directory(path)) {
        scenes.push_back({path.stem().string(), path.string(), around(path.parent_path()).string(), {}});
        return;
    }
    const std::vector<fs::path> below = scenes_below(path, output);
    if (below.empty()) throw OptionError(fmt::format("there is no scene (*.pov) in the folder '{}'", argument));
    for (const fs::path& scene : below) {
        const fs::path inner = scene.lexically_relative(path).replace_extension();
        scenes.push_back({(path.filename() / inner).string(), scene.string(), around(path).string(), {}});
    }
}

void name_apart(std::vector<VersusScene>& scenes) {
    std::set<std::string> taken;
    for (VersusScene& scene : scenes) {
        const std::string name = scene.name;
        for (int number = 2; !taken.insert(scene.name).second; ++number) scene.name = fmt::format("{}-{}", name, number);
    }
}

}  // namespace

std::vector<VersusScene> scenes_of(const std::vector<std::string>& arguments, const std::string& only, const std::string& output) {
    std::vector<VersusScene> scenes;
    for (const std::string& argument : arguments) add(argument, output, scenes);
    name_apart(scenes);
    if (!only.empty()) {
        const std::regex wanted = regular_expression("only", only);
        std::erase_if(scenes, [&](const VersusScene& scene) { return !std::regex_search(scene.name, wanted); });
        if (scenes.empty()) throw OptionError(fmt::format("--only: no scene's name matches '{}'", only));
    }
    std::map<std::string, std::string> known;
    const auto leave_out = [&](const std::string& path) { return is_scene(path) || is_left_out(path, output); };
    for (VersusScene& scene : scenes) {
        const std::string folder = fs::path(scene.path).parent_path().string();
        if (!known.contains(folder)) known[folder] = hash_of_folder(folder, leave_out);
        scene.surroundings = known[folder];
    }
    return scenes;
}

}  // namespace rt
