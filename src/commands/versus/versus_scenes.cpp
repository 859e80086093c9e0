#include "commands/versus/versus_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "commands/base/name_pattern.h"
#include "commands/base/scene_folder.h"
#include "commands/base/values.h"
#include "core/source.h"
#include "core/utf8.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

std::string shown(const fs::path& name) {
    if (is_utf8(name.string())) return name.string();
    std::string text;
    for (const char c : name.string())
        text += static_cast<unsigned char>(c) < 0x80 ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return text;
}

void add(const std::string& argument, const fs::path& output, std::vector<VersusScene>& scenes) {
    std::error_code error;
    fs::path path = fs::canonical(argument, error);
    if (error) path = fs::canonical(argument + ".pov", error);
    if (error) throw OptionError(fmt::format("there is no scene or folder '{}'", printable(argument)));
    if (fs::is_regular_file(path)) {
        scenes.push_back({shown(path.stem()), path.string()});
        return;
    }
    if (!fs::is_directory(path)) throw OptionError(fmt::format("'{}' is neither a scene nor a folder", printable(argument)));
    const std::vector<std::string> below = scenes_below(path.string(), output.string());
    if (below.empty()) throw OptionError(fmt::format("there is no scene (*.pov) in the folder '{}'", printable(argument)));
    for (const std::string& scene : below) {
        const fs::path inner = fs::path(scene).lexically_relative(path).replace_extension();
        scenes.push_back({shown(path.filename() / inner), scene});
    }
}

/// The last `parts` of a path, without its ending; all of it, with the ending, if it has no more.
std::string last_parts(const fs::path& path, std::ptrdiff_t parts) {
    const fs::path inner = path.relative_path();
    const std::ptrdiff_t all = std::distance(inner.begin(), inner.end());
    fs::path name;
    for (auto part = std::next(inner.begin(), std::max<std::ptrdiff_t>(0, all - parts)); part != inner.end(); ++part) name /= *part;
    return shown(parts > all ? name : name.replace_extension());
}

/// Names that more than one scene has begin with one more of the folders around it, until each has its own.
void name_apart(std::vector<VersusScene>& scenes) {
    for (bool apart = false; !apart;) {
        std::map<std::string, int> count;
        for (const VersusScene& scene : scenes) ++count[scene.name];
        apart = true;
        for (VersusScene& scene : scenes) {
            if (count[scene.name] == 1) continue;
            const fs::path name = scene.name;
            const std::string longer = last_parts(scene.path, std::distance(name.begin(), name.end()) + 1);
            apart = apart && longer == scene.name;
            scene.name = longer;
        }
    }
}

}  // namespace

std::vector<VersusScene> scenes_of(const std::vector<std::string>& arguments, const std::string& only, const std::string& output) {
    std::vector<VersusScene> scenes;
    for (const std::string& argument : arguments) add(argument, output, scenes);
    std::set<std::string> seen;
    std::erase_if(scenes, [&](const VersusScene& scene) { return !seen.insert(scene.path).second; });
    name_apart(scenes);
    if (!only.empty()) {
        const auto wanted = name_pattern("only", only);
        std::erase_if(scenes, [&](const VersusScene& scene) { return !wanted(scene.name); });
        if (scenes.empty()) throw OptionError(fmt::format("--only: no scene's name matches '{}'", printable(only)));
    }
    return scenes;
}

}  // namespace rt
