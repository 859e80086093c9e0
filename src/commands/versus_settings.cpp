#include "commands/versus_settings.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "commands/render_arguments.h"
#include "commands/values.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// POV-Ray tells numbers and strings apart by quotes, we by whether they are numbers.
std::string declared(const std::string& value) {
    char* end = nullptr;
    std::strtod(value.c_str(), &end);
    return !value.empty() && *end == '\0' ? value : fmt::format("\"{}\"", value);
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

std::vector<std::string> povray_command(const VersusSettings& settings, const std::string& scene, const std::string& picture) {
    const RenderJob& job = settings.job;
    std::vector<std::string> words = {
        settings.povray, "+I" + scene, "+O" + picture, fmt::format("+W{}", job.width),        fmt::format("+H{}", job.height),
        "+FN8",          "-D",         "-V",           fmt::format("+WT{}", settings.threads)};
    add_sampling(job.sampling, words);
    words.push_back("+L" + fs::path(scene).parent_path().string());
    for (const std::string& path : job.parse.library_paths) words.push_back("+L" + path);
    for (const auto& [name, value] : job.parse.declares) words.push_back(fmt::format("Declare={}={}", name, declared(value)));
    if (job.parse.clock != 0.0) words.push_back(fmt::format("+K{}", job.parse.clock));
    if (job.parse.version != 0.0) words.push_back(fmt::format("+MV{}", job.parse.version));
    return words;
}

std::vector<std::string> our_command(const VersusSettings& settings, const std::string& scene, Maker maker, const std::string& picture) {
    std::vector<std::string> words = {settings.program, scene};
    words.insert(words.end(), settings.words.begin(), settings.words.end());
    words.push_back(fmt::format("--threads={}", settings.threads));
    if (maker == Maker::same) words.emplace_back("--shading=povray");
    words.insert(words.end(), {"--stats", "-o", picture});
    return words;
}

std::string picture_name(Maker maker) { return fmt::format("{}.png", name_of(maker_names, maker)); }

std::string find_povray(const std::string& named) {
    if (!named.empty()) {
        if (!is_program(named)) throw OptionError(fmt::format("--povray: '{}' is no program", named));
        return fs::absolute(named).lexically_normal().string();
    }
    const char* path = std::getenv("PATH");
    for (const std::string& folder : split(path ? path : "", ':'))
        if (const std::string program = folder + "/povray"; !folder.empty() && is_program(program)) return fs::absolute(program).string();
    throw OptionError(
        "POV-Ray is not installed, so there is nothing to compare with. On Debian:\n"
        "    sudo apt-get install povray povray-includes\n"
        "A program that is not in $PATH is named by --povray PROGRAM");
}

Ending run_program_for(const VersusSettings& settings, const std::vector<std::string>& command, const VersusPlace& place, int slot) {
    ContainedRun run;
    run.command = command;
    run.folder = place.folder, run.working_folder = place.working_folder;
    run.readable = place.visible;
    run.readable.push_back(command.front());
    run.readable.insert(run.readable.end(), settings.job.parse.library_paths.begin(), settings.job.parse.library_paths.end());
    std::error_code none;
    for (const char* place : {"/etc/povray", "/usr/share/povray-3.7", "/usr/local/share/povray-3.7"})
        if (fs::exists(place, none)) run.readable.emplace_back(place);
    return run_contained(run, settings.limits, settings.containment, slot);
}

}  // namespace rt
