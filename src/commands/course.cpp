// The course's dialect: positional arguments, single-dash options, no word on any stream when all is well.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/commands.h"
#include "commands/help.h"
#include "commands/render_arguments.h"
#include "commands/scene_choices.h"
#include "commands/session.h"
#include "commands/suggest.h"
#include "commands/text.h"
#include "core/source.h"
#include "syntax/parser.h"

namespace rt {

namespace {

constexpr std::array<std::string_view, 4> later_options{"-fresnel", "-altbrdf", "-beers", "-gi"};
/// Ours that no course option resembles.
constexpr std::array<std::string_view, 4> short_options{"-o", "-q", "-t", "-L"};
constexpr std::array<std::string_view, 3> size_options{"--width", "--height", "--size"};
/// Rays after the camera's in the course's pictures.
constexpr int further_rays = 6;

bool is_one_of(const auto& names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

/// Throws OptionError for an option that neither the course nor we have, or that contradicts the words around it.
void check_option(const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    if (is_one_of(later_options, name) || name.starts_with("-gi_"))
        throw OptionError(fmt::format("option '{}' is not available in this version", name));
    const bool short_size = name.size() > 1 && (name[1] == 'W' || name[1] == 'H') && name.find_first_not_of("0123456789", 2) == name.npos;
    if (short_size || is_one_of(size_options, name))
        throw OptionError(fmt::format("'{}': the size stands behind the scene: raytrace render SCENE WIDTH HEIGHT", word));
    if (word.starts_with('+')) {
        const std::string ours = in_long_options(word);
        throw OptionError(fmt::format("POV-Ray's switch '{}' does not go with the course's render{}{}", word,
                                      ours.empty() ? "" : "; in our options it is ", ours));
    }
    const bool threads = name.size() > 2 && name.starts_with("-t") && name.find_first_not_of("0123456789", 2) == name.npos;
    if (threads || name == "-ss" || is_one_of(short_options, name)) return;
    std::vector<std::string> known = render_long_names();
    if (is_one_of(known, name)) return;
    known.insert(known.end(), {"-ss", "-fresnel", "-altbrdf", "-beers", "-gi", "-sds"});
    throw OptionError(fmt::format("unknown option '{}'{}", name, did_you_mean(name, known)));
}

/// The course's words as ours: FILE WIDTH HEIGHT and options in any order.
Words render_words(const Words& words) {
    Words options, positional;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") {
            positional.insert(positional.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
            break;
        }
        const std::string name = word.substr(0, word.find('='));
        if (name == "-sds") continue;  // a spatial data structure: there is always one
        const bool option = word.size() > 1 && (word[0] == '-' || word[0] == '+');
        if (option) check_option(word);
        (option ? options : positional).push_back(word);
        const bool separate = word == "-ss" || (option && render_option_takes_value(word));
        if (separate && i + 1 < words.size()) options.push_back(words[++i]);
    }
    if (positional.size() != 3) throw OptionError("expected: raytrace render SCENE WIDTH HEIGHT [options]");
    Words result{"--profile=csc473",         "--output=output.png",      "--quiet",
                 "--input=" + positional[0], "--width=" + positional[1], "--height=" + positional[2]};
    result.insert(result.end(), options.begin(), options.end());
    return result;
}

int course_render(const Words& words) {
    std::string help;
    std::optional<RenderJob> job = parse_render_arguments(render_words(words), help);
    job->max_trace_level = 1 + further_rays;
    return run_session(std::move(*job));
}

int sceneinfo(const Words& words) {
    if (words.size() != 1) throw OptionError("expected: raytrace sceneinfo SCENE");
    ParseOptions options;
    options.rotation = Rotation::csc473;
    options.library_paths = default_library_paths();
    const Scene scene = parse_file(words[0], options, message_sink(true));
    (void)choices_of(scene);  // a mistake in them is one here too
    write_stdout(sceneinfo_text(scene));
    return 0;
}

}  // namespace

int run_course(const std::string& command, const Words& words) {
    const bool help = std::any_of(words.begin(), words.end(), [](const std::string& w) { return w == "--help" || w == "-h"; });
    if (help) {
        write_stdout(help_topic("course"));
        return 0;
    }
    if (command == "render") return course_render(words);
    if (command == "sceneinfo") return sceneinfo(words);
    throw OptionError(fmt::format("'{}' is not available in this version", command));
}

}  // namespace rt
