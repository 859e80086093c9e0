#include "commands/job/render_arguments.h"

#include <fmt/format.h>

#include "commands/base/command_line.h"
#include "commands/base/values.h"
#include "commands/help.h"
#include "commands/job/course_scene.h"
#include "commands/job/povray_syntax.h"
#include "commands/job/quality.h"
#include "commands/job/render_draft.h"
#include "core/source.h"

namespace rt {

namespace {

void define_render(CommandLine& line, RenderDraft& d) {
    line.value("--input", "FILE", "", [&](const std::string& v) { d.input = v; });
    define_picture(line, d);
    define_sampling(line, d);
    define_shading(line, d.job);
    define_knobs(line, d.job);
    define_quality(line, d);
    define_scene(line, d);
    define_run(line, d.job);
}

Translation translate(const std::vector<std::string>& words, const CommandLine& line, Defaults defaults = Defaults::none) {
    RenderDraft trial;
    CommandLine trial_line(render_usage, render_footer);
    define_render(trial_line, trial);
    return translate_povray_syntax(words,
                                   {.takes_value = [&](const std::string& word) { return line.takes_value(word); },
                                    .long_names = line.long_names(),
                                    .try_out = [&](const std::vector<std::string>& option) { trial_line.parse(option); }},
                                   defaults);
}

}  // namespace

bool render_option_takes_value(const std::string& word) {
    RenderDraft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return line.takes_value(word);
}

std::vector<std::string> render_long_names() {
    RenderDraft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return line.long_names();
}

std::string in_long_options(const std::string& povray_switch) {
    RenderDraft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return fmt::format("{}", fmt::join(translate({povray_switch}, line).words, " "));
}

std::optional<RequiresArguments> parse_requires_arguments(const std::vector<std::string>& words, std::string& help) {
    RenderDraft draft;
    RequiresArguments arguments;
    CommandLine line(requires_usage, requires_footer);
    line.flag("--json", "JSON instead of text", [&] { arguments.json = true; });
    line.value("--timeout", "S", "for reading each scene (60)",
               [&](const std::string& v) { arguments.seconds = real_number("timeout", v, 0.01, 1e6); });
    define_scene(line, draft);
    line.hide_from_help();  // of a picture that is not rendered
    define_picture(line, draft);
    define_sampling(line, draft);
    define_shading(line, draft.job);
    define_knobs(line, draft.job);
    define_quality(line, draft);
    define_run(line, draft.job);
    line.values("--input", "FILE", "", [&](const std::string& v) { arguments.scenes.push_back(scene_path(v)); });

    const std::vector<std::string> others = line.parse(translate(words, line, Defaults::of_povray).words);
    if (line.help_asked()) {
        help = line.help();
        return std::nullopt;
    }
    for (const std::string& name : others) arguments.scenes.push_back(scene_path(name));
    choose_animation(draft);
    if (arguments.scenes.empty()) throw OptionError("requires: no scene given; see raytrace requires --help");
    arguments.parse = std::move(draft.job.parse);
    arguments.parse.image_width = draft.job.width;
    arguments.parse.image_height = draft.job.height;
    if (draft.job.profile == Profile::csc473) read_as_course(arguments.parse);
    arguments.parse.collect_unmodelled = true;
    return arguments;
}

std::optional<RenderJob> parse_render_arguments(const std::vector<std::string>& words, std::string& help) {
    RenderDraft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);

    const Translation translation = translate(words, line, Defaults::of_povray);
    const std::vector<std::string> others = line.parse(translation.words);
    if (line.help_asked()) {
        help = line.help();
        return std::nullopt;
    }
    choose_scene(draft, others);
    choose_animation(draft);
    choose_sampling(draft);
    choose_quality(draft, translation.words);
    check_dithering(draft);
    choose_region(draft);
    RenderJob& job = draft.job;
    check_together(job.model);
    job.parse.image_width = job.width;
    job.parse.image_height = job.height;
    if (job.profile == Profile::csc473) read_as_course(job.parse);
    job.notes.insert(job.notes.end(), translation.notes.begin(), translation.notes.end());
    if (!translation.ignored.empty())
        job.notes.push_back(fmt::format("ignored, without a meaning here: {}", fmt::join(translation.ignored, " ")));
    return job;
}

std::optional<RenderJob> parse_picture_arguments(const std::vector<std::string>& words, std::string& help) {
    std::optional<RenderJob> job = parse_render_arguments(words, help);
    if (job && job->animation)
        throw OptionError("an animation's frames are rendered by raytrace SCENE alone; elsewhere +Kx sets the clock");
    return job;
}

}  // namespace rt
