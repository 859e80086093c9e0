#include "commands/job/render_draft.h"

#include <fmt/format.h>

#include <filesystem>

#include "commands/base/values.h"
#include "commands/job/limit_options.h"
#include "core/source.h"
#include "syntax/words.h"

namespace rt {

namespace {

constexpr int most_frames = 1 << 30;

/// Whether a scene can refer to a declared value of that name.
bool is_name(std::string_view name) {
    constexpr std::string_view letters = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", digits = "0123456789";
    const bool starts = !name.empty() && letters.find(name[0]) != letters.npos;
    return starts && name.find_first_not_of(std::string(letters).append(digits)) == name.npos && find_word(name) == Word::none;
}

bool is_number(std::string_view word) { return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos; }

/// What the second word was perhaps meant to be, and how to say so.
std::string meaning_of_further_words(const std::vector<std::string>& words) {
    const std::size_t x = lower_case(words[1]).find('x');
    if (words.size() == 3 && is_number(words[1]) && is_number(words[2]))
        return fmt::format(" A size is -W {1} -H {2}; the course's way is: raytrace render {0} {1} {2}", words[0], words[1], words[2]);
    if (words.size() == 2 && x != std::string::npos && is_number(words[1].substr(0, x)) && is_number(words[1].substr(x + 1)))
        return fmt::format(" A size is --size {}", words[1]);
    ImageFormat format = ImageFormat::png;
    return words.size() == 2 && format_of(words[1], format) ? fmt::format(" The picture's name is -o {}", words[1]) : "";
}

void define_animation(CommandLine& line, AnimationDraft& d) {
    const auto clock = [&line](const char* name, std::optional<double>& value) {
        line.value(name, "X", "", [&value, name](const std::string& v) { value = real_number(name + 2, v, -unbounded, unbounded); });
    };
    const auto subset = [&line](const char* name, std::optional<double>& value) {
        line.value(name, "N", "", [&value, name](const std::string& v) { value = real_number(name + 2, v, 0.0, most_frames); });
    };
    line.value("--initial-frame", "N", "", [&](const std::string& v) { d.initial_frame = whole_number("first frame", v, 0, most_frames); });
    line.value("--final-frame", "N", "", [&](const std::string& v) { d.final_frame = whole_number("last frame", v, 0, most_frames); });
    clock("--initial-clock", d.initial_clock);
    clock("--final-clock", d.final_clock);
    subset("--subset-start-frame", d.subset_start);
    subset("--subset-end-frame", d.subset_end);
    line.value("--frame-step", "N", "", [&](const std::string& v) { d.step = whole_number("frame step", v, 1, most_frames); });
    line.value("--cyclic-animation", "ON", "", [&](const std::string& v) { d.cyclic = on_or_off("Cyclic_Animation", v); });
}

}  // namespace

void define_scene(CommandLine& line, RenderDraft& d) {
    RenderJob& job = d.job;
    line.values("-L,--library", "DIR", "search includes there too", [&](const std::string& v) { job.parse.library_paths.push_back(v); });
    line.values("--define", "NAME=VALUE", "declare a number or a string for the scene", [&](const std::string& v) {
        const std::size_t equals = v.find('=');
        if (equals == 0 || equals == std::string::npos) throw OptionError(fmt::format("define: expected NAME=VALUE, not '{}'", v));
        if (!is_name(v.substr(0, equals)))
            job.notes.push_back(
                fmt::format("--define {}: no scene can read this; a name is letters, digits and _, and no reserved word", v));
        job.parse.declares.emplace_back(v.substr(0, equals), std::string(unquoted(std::string_view(v).substr(equals + 1))));
    });
    line.value("--language", "V", "", [&](const std::string& v) { job.parse.version = real_number("language version", v, 0.0, 99.0); });
    line.values("--limit", "NAME=N", "", [&](const std::string& v) { set_limit(job.parse, v); });
    line.value("--header", "FILE", "", [&](const std::string& v) { job.parse.header = v; });
    line.value("--clock", "X", "", [&](const std::string& v) {
        job.parse.clock = real_number("clock", v, -unbounded, unbounded);
        job.parse.frame.clock_on = true;
    });
    define_animation(line, d.animation);
}

void define_run(CommandLine& line, RenderJob& job) {
    line.flag("--lenient", "what is not modelled is a warning, not an error", [&] { job.parse.lenient = true; });
    line.value("-t,--threads", "N", "worker threads; 0 is one per core",
               [&](const std::string& v) { job.threads = whole_number("threads", v, 0, 4096); });
    line.flag("-q,--quiet", "no warnings, notes or progress", [&] { job.quiet = true; });
    line.flag("--stats", "times, counts and rates on stderr", [&] { job.stats = true; });
    line.value("--progress", "ON", "", [&](const std::string& v) { job.progress = on_or_off("Verbose", v); });
    line.value("--all-console", "ON", "", [&](const std::string& v) { job.quiet = !on_or_off("All_Console", v); });
    line.value("--seed", "N", "", [&](const std::string& v) {
        real_number("seed", v, 0.0, unbounded);
        job.notes.emplace_back("--seed has no effect: what is random follows from the pixel");
    });
}

std::string scene_path(const std::string& name) {
    if (name.empty()) throw OptionError("the scene's name is empty");
    std::error_code ignored;
    const bool bare = std::filesystem::path(name).extension().empty();
    return bare && !std::filesystem::exists(name, ignored) ? name + ".pov" : name;
}

void choose_scene(RenderDraft& d, const std::vector<std::string>& others) {
    std::vector<std::string> scenes = others;
    if (!d.input.empty()) scenes.push_back(d.input);
    if (scenes.empty()) throw OptionError("no scene given; see raytrace --help");
    if (scenes.size() > 1)
        throw OptionError(fmt::format("one scene at a time: '{}' or '{}'?{}", scenes[0], scenes[1], meaning_of_further_words(scenes)));
    d.job.scene = scene_path(scenes[0]);
}

void choose_animation(RenderDraft& d) {
    d.job.animation = chosen_animation(d.animation);
    if (!d.job.animation) return;
    if (d.job.time) throw OptionError("--time is for one picture, not for an animation");
    set_frame(d.job.parse, *d.job.animation, d.job.animation->first);
}

}  // namespace rt
