#include "commands/job/course_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands/base/suggest.h"
#include "commands/base/values.h"
#include "commands/job/render_arguments.h"

namespace rt {

namespace {

using Words = std::vector<std::string>;
using ValuedOptions = std::vector<std::pair<std::string, std::string>>;

constexpr std::array<std::string_view, 6> flags{"-fresnel", "-altbrdf", "-beers", "-sds", "-normals", "-gi"};
/// Ours that no course option resembles.
constexpr std::array<std::string_view, 4> short_options{"-o", "-q", "-t", "-L"};
constexpr std::array<std::string_view, 3> size_options{"--width", "--height", "--size"};
constexpr std::array<std::string_view, 6> picture_options{"-o", "--output", "--max-error", "--time", "--preview", "--scale"};
constexpr std::array<std::string_view, 3> page_options{"--html", "--grid", "--pixel"};
constexpr int most_gi_samples = 1 << 20;
constexpr int most_bounces = 16;

bool is_one_of(const auto& names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

std::string usage_text(const CourseUsage& usage) {
    return fmt::format("expected: raytrace {} SCENE{}{}{}", usage.command, usage.size ? " WIDTH HEIGHT" : "", usage.pixel ? " X Y" : "",
                       usage.size ? " [options]" : "");
}

/// The course's own options as they stand on the line.
struct CourseOptions {
    CourseRules rules;
    bool any = false;
    bool indirect = false;
    std::vector<int> samples{64, 16};
    std::optional<int> bounces;
    std::string about_indirect;  ///< an option that only says how -gi is done
};

/// Takes `word` if it is one of the course's options that we have in no other form.
bool accept(CourseOptions& options, const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals), value = equals == word.npos ? "" : word.substr(equals + 1);
    if (is_one_of(flags, name)) {
        if (equals != word.npos) throw OptionError(fmt::format("option '{}' takes no value", name));
        options.any |= name != "-sds";  // a spatial data structure: there always is one
        options.rules.fresnel |= name == "-fresnel";
        options.rules.cook_torrance |= name == "-altbrdf";
        options.rules.beers |= name == "-beers";
        options.indirect |= name == "-gi";
        if (name == "-normals") options.rules.show = CourseShow::normals;
        return true;
    }
    if (name != "-gi_samples" && name != "-gi_bounces") return false;
    options.about_indirect = name;
    if (name == "-gi_bounces") {
        options.bounces = whole_number(name, value, 1, most_bounces);
        return true;
    }
    options.samples = indirect_samples_of(value);
    return true;
}

/// Throws OptionError for an option that we do not have either, or that contradicts the words around it.
void check_option(const CourseUsage& usage, const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    const bool short_size = name.size() > 1 && (name[1] == 'W' || name[1] == 'H') && name.find_first_not_of("0123456789", 2) == name.npos;
    if (short_size || is_one_of(size_options, name))
        throw OptionError(fmt::format("'{}': the size stands behind the scene: raytrace {} SCENE WIDTH HEIGHT", word, usage.command));
    if (word.starts_with('+')) {
        const std::string ours = in_long_options(word);
        throw OptionError(fmt::format("POV-Ray's switch '{}' does not go with the course's {}{}{}", word, usage.command,
                                      ours.empty() ? "" : "; in our options it is ", ours));
    }
    const bool threads = name.size() > 2 && name.starts_with("-t") && name.find_first_not_of("0123456789", 2) == name.npos;
    if (is_one_of(picture_options, name) && !usage.writes_picture())
        throw OptionError(fmt::format("option '{}' goes with render and raycast: {} writes no picture", name, usage.command));
    if (threads || name == "-ss" || is_one_of(short_options, name)) return;
    std::vector<std::string> known = render_long_names();
    if (is_one_of(known, name)) return;
    known.insert(known.end(), {"-ss", "-gi_samples", "-gi_bounces"});
    if (name == "--json") throw OptionError("option '--json' goes with printrays and pixeltrace");
    if (is_one_of(page_options, name) && !usage.page) throw OptionError(fmt::format("option '{}' goes with pixeltrace", name));
    if (usage.tree) known.emplace_back("--json");
    if (usage.page) known.insert(known.end(), page_options.begin(), page_options.end());
    known.insert(known.end(), flags.begin(), flags.end());
    throw OptionError(fmt::format("unknown option '{}'{}", name, did_you_mean(name, known)));
}

/// The words in three kinds: positions, the course's options, ours.
struct Sorted {
    Words positions, ours;
    CourseOptions course;
    bool json = false;
    ValuedOptions page;
    Words again;                      ///< all but what is in `page`
    std::vector<std::size_t> places;  ///< of the positions in `again`

    void take_position(const std::string& word) {
        positions.push_back(word);
        places.push_back(again.size());
        again.push_back(word);
    }
};

/// Takes the option at `i` and its value if it is one about the page.
bool accept_page(const CourseUsage& usage, const Words& words, std::size_t& i, ValuedOptions& page) {
    const std::size_t equals = words[i].find('=');
    const std::string name = words[i].substr(0, equals);
    if (!usage.page || !is_one_of(page_options, name)) return false;
    if (equals == std::string::npos && i + 1 == words.size()) throw OptionError(fmt::format("option '{}' needs a value", name));
    if (equals == std::string::npos && words[i + 1].starts_with("--"))
        throw OptionError(
            fmt::format("option '{0}' needs a value, found the option '{1}' (a value of that name: {0}={1})", name, words[i + 1]));
    const bool again = std::any_of(page.begin(), page.end(), [&](const auto& option) { return option.first == name; });
    if (again && name != "--pixel") throw OptionError(fmt::format("option '{}' is given twice", name));
    page.emplace_back(name, equals == std::string::npos ? words[++i] : words[i].substr(equals + 1));
    if (page.back().second.empty()) throw OptionError(fmt::format("option '{}' needs a value", name));
    return true;
}

Sorted sort_words(const CourseUsage& usage, const Words& words) {
    Sorted sorted;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (accept_page(usage, words, i, sorted.page)) continue;
        if (word == "--") {
            sorted.again.push_back(word);
            while (++i < words.size()) sorted.take_position(words[i]);
            break;
        }
        const bool number = word.size() > 1 && word.find_first_not_of("0123456789.", 1) == word.npos;  // -3 is a pixel outside
        const bool option = word.size() > 1 && (word[0] == '-' || word[0] == '+') && !number;
        if (!option) {
            sorted.take_position(word);
            continue;
        }
        sorted.again.push_back(word);
        if (accept(sorted.course, word)) continue;
        if (word == "--json" && usage.tree) {
            sorted.json = true;
            continue;
        }
        check_option(usage, word);
        sorted.ours.push_back(word);
        const bool separate = word == "-ss" || render_option_takes_value(word);
        if (!separate || i + 1 == words.size()) continue;
        sorted.ours.push_back(words[++i]);
        sorted.again.push_back(words[i]);
    }
    return sorted;
}

CourseRules rules_of(const CourseOptions& options) {
    CourseRules rules = options.rules;
    if (!options.indirect) {
        if (!options.about_indirect.empty()) throw OptionError(fmt::format("option '{}' goes with -gi", options.about_indirect));
        return rules;
    }
    rules.indirect_samples = options.samples;
    if (options.bounces) rules.indirect_samples.resize(static_cast<std::size_t>(*options.bounces), options.samples.back());
    return rules;
}

/// What stands behind --pixel, as numbers inside of the picture.
std::pair<int, int> pixel_of(const std::string& text, const RenderJob& job) {
    const std::vector<std::string> numbers = split(text, ',');
    if (numbers.size() != 2) throw OptionError(fmt::format("--pixel: expected X,Y, found '{}'", printable(text, 40)));
    return {whole_number("--pixel: x", numbers[0], 0, job.width - 1), whole_number("--pixel: y", numbers[1], 0, job.height - 1)};
}

std::optional<PixelPageRequest> page_of(const Sorted& sorted, const CourseArguments& arguments) {
    if (sorted.page.empty()) return {};
    PixelPageRequest page;
    page.pixels.emplace_back(arguments.x, arguments.y);
    for (const auto& [name, value] : sorted.page) {
        if (name == "--html") page.file = value;
        if (name == "--grid") page.grid = whole_number(name, value, 0, std::max(arguments.job.width, arguments.job.height));
        if (name == "--pixel") page.pixels.push_back(pixel_of(value, arguments.job));
    }
    if (page.file.empty()) throw OptionError(fmt::format("option '{}' goes with --html FILE", sorted.page[0].first));
    if (sorted.json) throw OptionError("--html and --json are two forms of one answer: choose one");
    page.words = sorted.again;
    page.x_word = sorted.places[3], page.y_word = sorted.places[4];
    return page;
}

}  // namespace

std::vector<int> indirect_samples_of(std::string_view text) {
    std::vector<int> samples;
    for (const std::string& number : split(text, ',')) samples.push_back(whole_number("-gi_samples", number, 1, most_gi_samples));
    return samples;
}

CourseArguments parse_course_arguments(const CourseUsage& usage, const Words& words) {
    const Sorted sorted = sort_words(usage, words);
    const Words& at = sorted.positions;
    if (at.size() != 1u + (usage.size ? 2u : 0u) + (usage.pixel ? 2u : 0u)) throw OptionError(usage_text(usage));
    Words ours{"--profile=csc473", "--output=output.png", "--quiet", "--input=" + at[0]};
    if (usage.size) ours.insert(ours.end(), {"--width=" + at[1], "--height=" + at[2]});
    ours.insert(ours.end(), sorted.ours.begin(), sorted.ours.end());
    std::string help;
    CourseArguments arguments{.job = std::move(*parse_picture_arguments(ours, help))};
    arguments.json = sorted.json;
    if (arguments.job.profile == Profile::csc473 && !arguments.job.max_trace_level)
        arguments.job.max_trace_level = 1 + CourseRules().further_rays;  // with any shading
    if (sorted.course.any || sorted.course.indirect || !sorted.course.about_indirect.empty())
        arguments.job.course = rules_of(sorted.course);
    if (usage.pixel) {
        arguments.x = whole_number("x", at[3], 0, arguments.job.width - 1);
        arguments.y = whole_number("y", at[4], 0, arguments.job.height - 1);
    }
    arguments.page = page_of(sorted, arguments);
    return arguments;
}

}  // namespace rt
