#include "commands/versus/versus_settings.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "commands/base/content_hash.h"
#include "commands/base/shell_words.h"
#include "commands/base/values.h"
#include "commands/job/render_arguments.h"
#include "core/utf8.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// POV-Ray tells numbers and strings apart by quotes, we by whether they are numbers. The whole has to be quoted for its command line.
std::string declared(const std::string& name, const std::string& value) {
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (!value.empty() && *end == '\0') {
        if (!std::isfinite(number))
            throw OptionError(fmt::format("--define {}: expected a finite number, not '{}'", name, printable(value)));
        return fmt::format("Declare={}={}", name, value);
    }
    const auto is_sayable = [](char c) { return c >= ' ' && c <= '~' && c != '\'' && c != '"' && c != '\\'; };
    if (!std::all_of(value.begin(), value.end(), is_sayable))
        throw OptionError(fmt::format("--define {}: POV-Ray's command line takes printable ASCII without quotes and \\ in a string", name));
    return fmt::format("Declare='{}=\"{}\"'", name, value);
}

void add_sampling(const Sampling& sampling, std::vector<std::string>& words) {
    if (sampling.method == Sampling::Method::none) {
        words.emplace_back("-A");
        return;
    }
    words.push_back(fmt::format("+A{}", sampling.threshold));
    words.push_back(fmt::format("+AM{}", sampling.method == Sampling::Method::povray1 ? 1 : 2));
    words.push_back(fmt::format("+R{}", sampling.depth));
    words.emplace_back("-J");
    if (sampling.gamma != Sampling{}.gamma) words.push_back(fmt::format("+AG{}", sampling.gamma));
}

/// What a scene may read: all that the user may, but for the system's own folders, which a room has of its own; people's files in those
/// are seen. POV-Ray's settings in /etc are not, so that they change no picture.
std::vector<std::string> all_folders() {
    constexpr std::array<std::string_view, 12> systems = {"proc", "dev",   "sys",   "usr",    "bin", "sbin",
                                                          "lib",  "lib32", "lib64", "libx32", "etc", "run"};
    std::vector<std::string> folders;
    std::error_code error, none;
    for (const fs::directory_entry& entry : fs::directory_iterator("/", error)) {
        const std::string path = entry.path().string();
        const bool is_systems = std::find(systems.begin(), systems.end(), path.substr(1)) != systems.end();
        if (!is_systems && entry.is_directory(none) && access(path.c_str(), R_OK | X_OK) == 0) folders.push_back(path);
    }
    for (const char* path : {"/run/media", "/run/user", "/dev/shm"})
        if (fs::is_directory(path, none)) folders.emplace_back(path);
    return folders;
}

bool is_program(const std::string& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

RenderJob job_of_words(const std::vector<std::string>& words) {
    std::vector<std::string> line = {"scene.pov"};
    line.insert(line.end(), words.begin(), words.end());
    std::string help;
    return parse_render_arguments(line, help).value();
}

std::vector<std::string> povray_picture_words(const RenderJob& job) {
    std::vector<std::string> words = {fmt::format("+W{}", job.width), fmt::format("+H{}", job.height), "+FN8", "-D", "-V"};
    add_sampling(job.sampling, words);
    for (const auto& [name, value] : job.parse.declares) words.push_back(declared(name, value));
    if (job.parse.frame.clock_on) words.push_back(fmt::format("+K{}", job.parse.clock));
    if (job.parse.version != 0.0) words.push_back(fmt::format("+MV{}", job.parse.version));
    return words;
}

std::vector<std::string> povray_command(const VersusSettings& settings, const std::string& scene, const std::string& picture,
                                        PovrayNames& names) {
    std::vector<std::string> words = {"/usr/bin/env", "POVINI=" + no_settings_file(settings), settings.povray,
                                      fmt::format("+I{}", names.word(scene, "scene.pov")),
                                      fmt::format("+O{}", names.word(picture, "picture.png"))};
    const std::vector<std::string> picture_words = povray_picture_words(settings.job);
    words.insert(words.end(), picture_words.begin(), picture_words.end());
    words.push_back(fmt::format("+WT{}", settings.threads));
    words.push_back(fmt::format("+L{}", names.word(fs::path(scene).parent_path().string(), "folder")));
    int number = 0;
    for (const std::vector<std::string>& paths : {settings.job.parse.library_paths, settings.installed})
        for (const std::string& path : paths) words.push_back(fmt::format("+L{}", names.word(path, fmt::format("library{}", ++number))));
    return words;
}

std::vector<std::string> povray_command_to_copy(const VersusSettings& settings, const std::string& scene, const std::string& picture) {
    PovrayNames names((fs::path("/tmp") / ("raytrace-names-" + hash_of(scene + "\n" + picture).substr(0, 16))).string());
    const std::vector<std::string> words = povray_command(settings, scene, picture, names);
    if (names.links().empty()) return words;
    const std::string folder = fs::path(names.links().front().first).parent_path().string();
    std::string script = fmt::format("rm -rf {0} && mkdir -m 700 {0} && trap 'rm -r {0}' EXIT", folder);
    for (const auto& [link, path] : names.links()) script += fmt::format(" && ln -s -- {} {}", shell_word(path), link);
    return {"/bin/bash", "-c", fmt::format("{} && {}", script, shell_words(words))};
}

std::string no_settings_file(const VersusSettings& settings) { return (fs::path(settings.folder) / "povray.ini").string(); }

std::vector<std::string> installed_includes(const std::string& povray) {
    std::error_code none;
    const fs::path program = fs::canonical(povray, none);
    const std::string beside = (program.parent_path().parent_path() / "share" / "povray-3.7" / "include").string();
    if (fs::is_directory(beside, none)) return {beside};
    std::vector<std::string> paths;
    for (const char* path : {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include"})
        if (fs::is_directory(path, none)) paths.emplace_back(path);
    return paths;
}

std::vector<std::string> our_command(const VersusSettings& settings, const std::string& scene, Maker maker, const std::string& picture) {
    std::vector<std::string> words = {"/usr/bin/env", "POVINI=" + no_settings_file(settings), settings.program, scene};
    words.insert(words.end(), settings.words.begin(), settings.words.end());
    words.push_back(fmt::format("--threads={}", settings.threads));
    if (maker == Maker::same) words.emplace_back("--shading=povray");
    words.insert(words.end(), {"--stats", "-o", picture});
    return words;
}

std::vector<std::string> command_as_text(std::vector<std::string> command) {
    if (std::all_of(command.begin(), command.end(), is_utf8)) return command;
    return {"/bin/bash", "-c", shell_words(command)};
}

std::string picture_name(Maker maker) { return fmt::format("{}.png", name_of(maker_names, maker)); }

std::string find_povray(const std::string& named) {
    constexpr const char* how_to_install = "On Debian:\n    sudo apt-get install povray povray-includes";
    if (!named.empty()) {
        if (!is_program(named)) throw OptionError(fmt::format("--povray: '{}' is no program. {}", printable(named), how_to_install));
        return fs::absolute(named).lexically_normal().string();
    }
    const char* path = std::getenv("PATH");
    for (const std::string& folder : split(path ? path : "", ':'))
        if (const std::string program = folder + "/povray"; !folder.empty() && is_program(program)) return fs::absolute(program).string();
    throw OptionError(fmt::format(
        "POV-Ray is not installed, so there is nothing to compare with. {}\nA program that is not in $PATH is named by --povray PROGRAM",
        how_to_install));
}

Ending run_program_for(const VersusSettings& settings, const std::vector<std::string>& command, const VersusPlace& place, int slot) {
    ContainedRun run;
    run.command = {"/usr/bin/env", "TMPDIR=" + place.folder};  // it may write nowhere else
    run.command.insert(run.command.end(), command.begin(), command.end());
    run.folder = place.folder, run.working_folder = place.working_folder;
    run.readable = all_folders();
    run.readable.push_back(place.working_folder);
    return run_contained(run, settings.limits, settings.containment, slot);
}

}  // namespace rt
