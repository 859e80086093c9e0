#include "commands/job/render_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "commands/base/command_line.h"
#include "commands/base/names.h"
#include "commands/base/values.h"
#include "commands/help.h"
#include "commands/job/course_scene.h"
#include "commands/job/edge_choices.h"
#include "commands/job/povray_syntax.h"
#include "syntax/words.h"

namespace rt {

namespace {

constexpr int largest_side = 1'000'000;
constexpr double unbounded = HUGE_VAL;

/// What the options say before they are put together.
struct Draft {
    RenderJob job;
    RegionEdges edges;
    std::string input;
    std::optional<Region> crop;
    std::optional<int> grid;
    bool antialias = false;
    std::optional<bool> jitter;
    std::optional<double> jitter_amount;
    std::optional<int> initial_frame, final_frame;
    bool subset_frames = false;
    std::string dither_method;
};

void define_picture(CommandLine& line, Draft& d) {
    RenderJob& job = d.job;
    line.value("-o,--output,--outfile", "FILE", "picture; the ending chooses the type; - is stdout", [&](const std::string& v) {
        job.output.name = v;
        job.output.povray_rules = false;
    });
    line.value("--povray-output", "FILE", "", [&](const std::string& v) {
        job.output.name = v;
        job.output.povray_rules = true;
    });
    line.value("--format", "TYPE", "png, exr, hdr, tiff, jpeg, ppm, tga or bmp",
               [&](const std::string& v) { job.output.format = value_of_name(format_names, "picture format", v); });
    line.value("--povray-type", "TYPE", "", [&](const std::string& v) { job.output.format = povray_file_type(v, job.bits); });
    line.value("--bits", "N", "8 (default) or 16 per channel; exr 16 or 32",
               [&](const std::string& v) { job.bits = whole_number("bits per colour", v, 1, most_bits); });
    line.value("--output-to-file", "ON", "", [&](const std::string& v) { job.output.to_file = on_or_off("Output_to_File", v); });
    line.value("--output-alpha", "ON", "", [&](const std::string& v) { job.output_alpha = on_or_off("Output_Alpha", v); });
    line.value("-W,--width", "N", "columns (800)", [&](const std::string& v) { job.width = whole_number("width", v, 1, largest_side); });
    line.value("-H,--height", "N", "rows (600)", [&](const std::string& v) { job.height = whole_number("height", v, 1, largest_side); });
    line.value("--size", "WxH", "", [&](const std::string& v) {
        const std::vector<std::string> sides = split(lower_case(v), 'x');
        if (sides.size() != 2) throw OptionError(fmt::format("size: expected WIDTHxHEIGHT, not '{}'", v));
        job.width = whole_number("width", sides[0], 1, largest_side);
        job.height = whole_number("height", sides[1], 1, largest_side);
    });
    line.value("--crop", "X0,X1,Y0,Y1", "only columns X0 to X1-1, rows Y0 to Y1-1; from 0", [&](const std::string& v) {
        const std::vector<std::string> ends = split(v, ',');
        if (ends.size() != 4) throw OptionError(fmt::format("crop: expected X0,X1,Y0,Y1, not '{}'", v));
        const auto edge = [&](int i) { return whole_number("crop", ends[static_cast<std::size_t>(i)], 0, largest_side); };
        d.crop = Region{edge(0), edge(2), edge(1), edge(3)};
    });
    const auto edge = [&line](const char* name, std::optional<double>& place) {
        line.value(name, "N", "", [name, &place](const std::string& v) { place = real_number(name + 2, v, 0.0, largest_side); });
    };
    edge("--start-column", d.edges.start_column);
    edge("--end-column", d.edges.end_column);
    edge("--start-row", d.edges.start_row);
    edge("--end-row", d.edges.end_row);
    line.value("--file-gamma", "G", "", [&](const std::string& v) {
        const bool srgb = lower_case(v) == "srgb";
        job.file_gamma = srgb ? Curve{Curve::Kind::srgb, 1.0} : Curve{Curve::Kind::power, real_number("file gamma", v, 1e-3, 1e3)};
    });
    line.value("--dither", "ON", "", [&](const std::string& v) { job.dither = on_or_off("dither", v); });
    line.value("--dither-method", "NAME", "", [&](const std::string& v) {
        for (const char* known : {"FS", "B2", "B3", "B4", "D1", "D2"})
            if (lower_case(v) == lower_case(known)) return void(d.dither_method = known);
        throw OptionError(fmt::format("'{}' is no dithering method; expected one of FS, B2, B3, B4, D1, D2", v));
    });
}

void define_sampling(CommandLine& line, Draft& d) {
    Sampling& sampling = d.job.sampling;
    line.value("--ss", "N", "N x N samples in every pixel", [&](const std::string& v) { d.grid = whole_number("ss", v, 1, 64); });
    const auto method = [&d, &sampling](const std::string& v) {
        sampling.method = whole_number("anti-aliasing method", v, 1, 2) == 1 ? Sampling::Method::povray1 : Sampling::Method::povray2;
    };
    const auto threshold = [&sampling](const std::string& v) {
        sampling.threshold = std::clamp(real_number("anti-aliasing threshold", v, 0.0, unbounded), 0.0, 1.0);
    };
    const auto depth = [&sampling](const std::string& v) {
        sampling.depth = std::min(9, whole_number("anti-aliasing depth", v, 1, largest_side));
    };
    line.value("--aa", "M[,T[,R]]", "POV-Ray's method 1 or 2, threshold T, depth R", [=, &d](const std::string& v) {
        const std::vector<std::string> parts = split(v, ',');
        if (parts.size() > 3) throw OptionError(fmt::format("aa: expected METHOD,THRESHOLD,DEPTH, not '{}'", v));
        method(parts[0]);
        if (parts.size() > 1) threshold(parts[1]);
        if (parts.size() > 2) depth(parts[2]);
        d.antialias = true;
        if (!d.jitter) d.jitter = false;
    });
    line.value("--antialias", "ON", "", [&](const std::string& v) { d.antialias = on_or_off("Antialias", v); });
    line.value("--aa-method", "M", "", method);
    line.value("--aa-threshold", "T", "", threshold);
    line.value("--aa-depth", "R", "", depth);
    line.value("--aa-gamma", "G", "", [&](const std::string& v) { sampling.gamma = real_number("anti-aliasing gamma", v, 1e-3, 1e3); });
    line.value("--aa-block", "N", "",
               [&](const std::string& v) { sampling.block = std::max(4, whole_number("block size", v, 0, largest_side)); });
    line.value("--jitter", "ON", "", [&](const std::string& v) { d.jitter = on_or_off("Jitter", v); });
    line.value("--jitter-amount", "X", "",
               [&](const std::string& v) { d.jitter_amount = real_number("jitter amount", v, 0.0, unbounded); });
    line.value("--povray-quality", "N", "", [&](const std::string& v) {
        d.job.povray_quality = std::clamp(whole_number("quality", v, -largest_side, largest_side), 0, 11);
    });
}

void define_shading(CommandLine& line, RenderJob& job) {
    for (const ModelKey& key : model_keys()) {
        const std::string name(key.key);
        const std::string help = name == "shading" ? "general (default), povray, phong ...: help shading" : std::string(key.help);
        line.value("--" + name, std::string(key.values), help, [&job, name](const std::string& v) {
            const bool povray = name == "shading" && v == "povray";
            if (name == "shading") job.shading = povray ? ShadingModel::povray : ShadingModel::general;
            // A preset is a shading, too; a scene's own does not undo it.
            if (name == "preset" && !job.shading) job.shading = ShadingModel::general;
            if (povray) return;
            ModelChoice scratch;
            choose(scratch, name, v);
            job.model.push_back({name, v});
        });
    }
    for (const EdgeKey& key : edge_keys) {
        const std::string name(key.key);
        line.value("--" + name, std::string(key.values), "", [&job, name](const std::string& v) {
            EdgeOptions scratch;
            choose_edges(scratch, name, v);
            job.edge_options.push_back({name, v});
        });
    }
    line.value("--environment", "FILE", "", [&](const std::string& v) {
        job.environment = split(v, ',');
        if (job.environment.size() != 1 && job.environment.size() != 6)
            throw OptionError(fmt::format("environment: expected one picture or six separated by commas, not {}", job.environment.size()));
    });
    line.value("--distances", "NAME", "scaled (default) or povray",
               [&](const std::string& v) { job.distances = value_of_name(distances_names, "rule of distances", v); });
    line.value("--precision", "NAME", "fast or exact triangles",
               [&](const std::string& v) { job.precision = value_of_name(precision_names, "precision", v); });
    line.value("--index", "NAME", "", [&](const std::string& v) { job.index = value_of_name(index_names, "index", v); });
    line.value("--profile", "NAME", "povray (default) or csc473, the course's camera",
               [&](const std::string& v) { job.profile = value_of_name(profile_names, "profile", v); });
}

/// Whether a scene can refer to a declared value of that name.
bool is_name(std::string_view name) {
    constexpr std::string_view letters = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", digits = "0123456789";
    const bool starts = !name.empty() && letters.find(name[0]) != letters.npos;
    return starts && name.find_first_not_of(std::string(letters).append(digits)) == name.npos && find_word(name) == Word::none;
}

void define_scene(CommandLine& line, Draft& d) {
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
    line.value("--clock", "X", "", [&](const std::string& v) { job.parse.clock = real_number("clock", v, -unbounded, unbounded); });
    for (const char* name : {"--initial-clock", "--final-clock"})  // only frames of an animation use them
        line.value(name, "X", "", [name](const std::string& v) { real_number(name + 2, v, -unbounded, unbounded); });
    line.value("--initial-frame", "N", "", [&](const std::string& v) { d.initial_frame = whole_number("first frame", v, 0, 1 << 30); });
    line.value("--final-frame", "N", "", [&](const std::string& v) { d.final_frame = whole_number("last frame", v, 0, 1 << 30); });
    line.value("--subset-frame", "N", "", [&](const std::string&) { d.subset_frames = true; });
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

/// As POV-Ray does it, a name without ending gets its own.
std::string scene_path(const std::string& name) {
    if (name.empty()) throw OptionError("the scene's name is empty");
    std::error_code ignored;
    const bool bare = std::filesystem::path(name).extension().empty();
    return bare && !std::filesystem::exists(name, ignored) ? name + ".pov" : name;
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

void choose_scene(Draft& d, const std::vector<std::string>& others) {
    std::vector<std::string> scenes = others;
    if (!d.input.empty()) scenes.push_back(d.input);
    if (scenes.empty()) throw OptionError("no scene given; see raytrace --help");
    if (scenes.size() > 1)
        throw OptionError(fmt::format("one scene at a time: '{}' or '{}'?{}", scenes[0], scenes[1], meaning_of_further_words(scenes)));
    d.job.scene = scene_path(scenes[0]);
}

void choose_sampling(Draft& d) {
    Sampling& sampling = d.job.sampling;
    const Sampling::Method method = sampling.method == Sampling::Method::none ? Sampling::Method::povray1 : sampling.method;
    sampling.method = d.antialias ? method : Sampling::Method::none;
    if (d.grid) {
        if (d.antialias) throw OptionError("-ss and anti-aliasing (+A, --aa) both choose the samples of a pixel; give one of them");
        sampling.method = *d.grid > 1 ? Sampling::Method::grid : Sampling::Method::none;
        sampling.depth = *d.grid;
    }
    if (!d.antialias) return;
    if (!d.jitter && !d.jitter_amount)
        d.job.notes.emplace_back("anti-aliasing is rendered without jitter, as with -J");
    else if (d.jitter.value_or(true) && d.jitter_amount.value_or(1.0) > 0.0)
        d.job.notes.emplace_back("jitter is not available in this version: anti-aliasing is rendered as with -J");
}

void refuse_animation(const Draft& d) {
    const bool frames = d.final_frame.value_or(1) != 1 || d.initial_frame.value_or(1) != 1 || d.subset_frames;
    if (frames) throw OptionError("animation (frames) is not available in this version; render single pictures with Clock=VALUE (+KVALUE)");
}

void check_dithering(const Draft& d) {
    const std::string& method = d.dither_method;
    if (!d.job.dither || method.empty() || method == "FS") return;
    throw OptionError(fmt::format("dithering method {} is not available in this version; FS (Floyd-Steinberg) is", method));
}

void choose_region(Draft& d) {
    d.job.region = resolve_region(d.edges, d.job.width, d.job.height);
    if (!d.crop) return;
    if (d.job.region) throw OptionError("--crop and +SC +EC +SR +ER both choose the region; give one of them");
    const Region& r = *d.crop;
    if (r.x0 >= r.x1 || r.y0 >= r.y1 || r.x1 > d.job.width || r.y1 > d.job.height)
        throw OptionError(fmt::format("crop: columns {} to {} and rows {} to {} are no part of a {} x {} picture", r.x0, r.x1, r.y0, r.y1,
                                      d.job.width, d.job.height));
    d.job.region = r;
}

void define_render(CommandLine& line, Draft& d) {
    line.value("--input", "FILE", "", [&](const std::string& v) { d.input = v; });
    define_picture(line, d);
    define_sampling(line, d);
    define_shading(line, d.job);
    define_scene(line, d);
    define_run(line, d.job);
}

Translation translate(const std::vector<std::string>& words, const CommandLine& line) {
    Draft trial;
    CommandLine trial_line(render_usage, render_footer);
    define_render(trial_line, trial);
    return translate_povray_syntax(words, {.takes_value = [&](const std::string& word) { return line.takes_value(word); },
                                           .long_names = line.long_names(),
                                           .try_out = [&](const std::vector<std::string>& option) { trial_line.parse(option); }});
}

}  // namespace

bool render_option_takes_value(const std::string& word) {
    Draft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return line.takes_value(word);
}

std::vector<std::string> render_long_names() {
    Draft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return line.long_names();
}

std::string in_long_options(const std::string& povray_switch) {
    Draft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);
    return fmt::format("{}", fmt::join(translate({povray_switch}, line).words, " "));
}

std::optional<RequiresArguments> parse_requires_arguments(const std::vector<std::string>& words, std::string& help) {
    Draft draft;
    RequiresArguments arguments;
    CommandLine line(requires_usage, requires_footer);
    line.flag("--json", "one JSON array instead of text", [&] { arguments.json = true; });
    define_scene(line, draft);
    line.hide_from_help();  // of a picture that is not rendered
    define_picture(line, draft);
    define_sampling(line, draft);
    define_shading(line, draft.job);
    define_run(line, draft.job);
    line.values("--input", "FILE", "", [&](const std::string& v) { arguments.scenes.push_back(scene_path(v)); });

    const std::vector<std::string> others = line.parse(translate(words, line).words);
    if (line.help_asked()) {
        help = line.help();
        return std::nullopt;
    }
    for (const std::string& name : others) arguments.scenes.push_back(scene_path(name));
    refuse_animation(draft);
    if (arguments.scenes.empty()) throw OptionError("requires: no scene given; see raytrace requires --help");
    arguments.parse = std::move(draft.job.parse);
    arguments.parse.image_width = draft.job.width;
    arguments.parse.image_height = draft.job.height;
    if (draft.job.profile == Profile::csc473) read_as_course(arguments.parse);
    arguments.parse.collect_unmodelled = true;
    return arguments;
}

std::optional<RenderJob> parse_render_arguments(const std::vector<std::string>& words, std::string& help) {
    Draft draft;
    CommandLine line(render_usage, render_footer);
    define_render(line, draft);

    const Translation translation = translate(words, line);
    const std::vector<std::string> others = line.parse(translation.words);
    if (line.help_asked()) {
        help = line.help();
        return std::nullopt;
    }
    choose_scene(draft, others);
    refuse_animation(draft);
    choose_sampling(draft);
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

}  // namespace rt
