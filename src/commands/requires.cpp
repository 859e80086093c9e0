// raytrace requires SCENE...: what each scene needs of the program.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/base/json_text.h"
#include "commands/base/program.h"
#include "commands/commands.h"
#include "commands/job/job_steps.h"
#include "commands/job/picture_files.h"
#include "commands/job/render_arguments.h"
#include "commands/job/requirements.h"
#include "core/source.h"
#include "syntax/parser.h"

namespace rt {

namespace {

std::string counts_text(const std::map<std::string, std::size_t>& counts) {
    std::string text;
    for (const auto& [name, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    return text.empty() ? "none" : text;
}

std::string text_of(const std::string& scene, const Requirements& needs) {
    std::string text = fmt::format("{}\n", scene);
    text += fmt::format("  objects:   {} ({})\n", needs.objects, counts_text(needs.shapes));
    text += fmt::format("  triangles: {}\n", needs.triangles);
    text += fmt::format("  lights:    {}\n", counts_text(needs.lights));
    text += fmt::format("  camera:    {}\n", needs.camera);
    text += fmt::format("  gamma:     {}\n", needs.gamma);
    text += fmt::format("  language:  {}\n", needs.language_version > 0.0 ? fmt::format("{}", needs.language_version) : "not stated");
    text += fmt::format("  features:  {}\n", needs.features.empty() ? "none" : fmt::format("{}", fmt::join(needs.features, ", ")));
    text += fmt::format("  includes:  {}\n", needs.includes.empty() ? "none" : fmt::format("{}", fmt::join(needs.includes, ", ")));
    if (needs.missing.empty()) return text + "  not modelled: nothing\n";
    text += "  not modelled:\n";
    for (const MissingFeature& missing : needs.missing)
        text += fmt::format("    {}:{}:{}: {}\n", missing.file, missing.line, missing.column, missing.name);
    return text;
}

nlohmann::ordered_json json_of(const std::string& scene, const Requirements& needs) {
    nlohmann::ordered_json missing = nlohmann::ordered_json::array();
    for (const MissingFeature& m : needs.missing)
        missing.push_back({{"name", m.name}, {"file", m.file}, {"line", m.line}, {"column", m.column}});
    return {{"scene", scene},
            {"objects", needs.objects},
            {"shapes", needs.shapes},
            {"triangles", needs.triangles},
            {"lights", needs.lights},
            {"camera", needs.camera},
            {"gamma", needs.gamma},
            {"language_version", needs.language_version},
            {"features", needs.features},
            {"includes", needs.includes},
            {"not_modelled", missing}};
}

}  // namespace

int run_requires(const Words& words) {
    std::string help;
    std::optional<RequiresArguments> arguments = parse_requires_arguments(words, help);
    if (!arguments) {
        write_stdout(help);
        return 0;
    }
    ParseOptions& options = arguments->parse;
    const bool as_json = arguments->json;
    for (std::string& path : default_library_paths()) options.library_paths.push_back(std::move(path));

    options.read_picture = read_picture_file;

    int status = 0;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& scene : arguments->scenes) {
        try {
            const Requirements needs = requirements_of(parse_file(scene, options, message_sink(true)));
            if (as_json)
                all.push_back(json_of(scene, needs));
            else
                write_stdout(text_of(scene, needs));
        } catch (const SceneError& error) {  // the other scenes still count
            write_stderr(fmt::format("{}\n", error.what()));
            status = 1;
        }
    }
    if (as_json) write_stdout(json_text(all, 2));
    return status;
}

}  // namespace rt
