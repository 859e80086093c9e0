#include "commands/base/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "commands/base/suggest.h"
#include "core/source.h"

namespace rt {

namespace {

/// Of options that the help leaves out. CLI11's own group for them, "", would take their names from its messages.
constexpr const char* hidden = "hidden";

/// Options in two columns; the usage and the footer as they are.
class ScreenFormatter : public CLI::Formatter {
public:
    explicit ScreenFormatter(std::string usage) : usage_(std::move(usage)) { column_width(26); }
    std::string make_usage(const CLI::App*, std::string) const override { return usage_ + "\n"; }
    std::string make_group(std::string group, bool, std::vector<const CLI::Option*> options) const override {
        if (group == hidden) return "";
        std::string text;
        for (const CLI::Option* option : options) text += make_option(option, false);
        return text;
    }
    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_items_expected_max() == 0 ? "" : " " + option->get_type_name();
    }
    std::string make_option_name(const CLI::Option* option, bool) const override {
        std::string names;
        for (const std::string& s : option->get_snames()) names += "-" + s + ", ";
        for (const std::string& l : option->get_lnames()) return names + "--" + l;
        return names.substr(0, names.size() - 2);
    }

private:
    std::string usage_;
};

}  // namespace

struct CommandLine::State {
    CLI::App app;
    std::vector<std::string> others;
    bool help_asked = false;
    bool hide = false;
};

CommandLine::CommandLine(std::string usage, std::string footer) : state_(std::make_unique<State>()) {
    state_->app.formatter(std::make_shared<ScreenFormatter>(std::move(usage)));
    state_->app.footer(std::move(footer));
    state_->app.set_help_flag("");
    state_->app.add_flag("-h,--help", state_->help_asked, "this text");
    state_->app.allow_extras();
}

CommandLine::~CommandLine() = default;

void CommandLine::value(const std::string& names, const std::string& type, const std::string& help,
                        std::function<void(const std::string&)> use) {
    CLI::Option* option = state_->app.add_option(
        names,
        [use = std::move(use), this](const CLI::results_t& results) {
            if (!state_->help_asked) use(results.back());
            return true;
        },
        help);
    option->type_name(type)->type_size(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    if (help.empty() || state_->hide) option->group(hidden);
}

void CommandLine::values(const std::string& names, const std::string& type, const std::string& help,
                         std::function<void(const std::string&)> use) {
    CLI::Option* option = state_->app.add_option(
        names,
        [use = std::move(use), this](const CLI::results_t& results) {
            if (!state_->help_asked)
                for (const std::string& result : results) use(result);
            return true;
        },
        help);
    option->type_name(type)->type_size(1)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (help.empty() || state_->hide) option->group(hidden);
}

void CommandLine::flag(const std::string& names, const std::string& help, std::function<void()> use) {
    CLI::Option* option = state_->app.add_flag_function(
        names,
        [use = std::move(use), this](std::int64_t count) {
            if (!state_->help_asked && count > 0) use();
        },
        help);
    if (help.empty() || state_->hide) option->group(hidden);
}

void CommandLine::hide_from_help() { state_->hide = true; }

bool CommandLine::takes_value(const std::string& word) const {
    const CLI::Option* option = state_->app.get_option_no_throw(word);
    return option && option->get_items_expected_max() > 0;
}

std::vector<std::string> CommandLine::long_names() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : state_->app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// CLI11 would take the word behind `--range=` for its value.
void CommandLine::refuse_empty_values(const std::vector<std::string>& words) const {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        const bool value = i > 0 && takes_value(words[i - 1]);
        if (!value && words[i].starts_with("--") && words[i] == name + "=" && takes_value(name))
            throw OptionError("option '" + name + "' needs a value");
    }
}

/// `-W=8` in two words, as CLI11 knows it; the value of another option stays.
std::vector<std::string> CommandLine::with_values_apart(const std::vector<std::string>& words) const {
    std::vector<std::string> result;
    for (const std::string& word : words) {
        const bool value = !result.empty() && takes_value(result.back());
        const bool joined = !value && word.size() > 2 && word[0] == '-' && word[1] != '-' && word[2] == '=';
        if (!joined || !takes_value(word.substr(0, 2))) {
            result.push_back(word);
            continue;
        }
        result.push_back(word.substr(0, 2));
        result.push_back(word.substr(3));
    }
    return result;
}

std::vector<std::string> CommandLine::parse(const std::vector<std::string>& words) {
    // Words behind `--` are kept from CLI11, which would not tell them from misspelt options.
    const auto end_of_options = std::find(words.begin(), words.end(), "--");
    std::vector<std::string> reversed = with_values_apart({words.begin(), end_of_options});
    refuse_empty_values(reversed);
    std::reverse(reversed.begin(), reversed.end());
    try {
        state_->app.parse(reversed);
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string text = error.what();  // begins with the option's name
        throw OptionError("option '" + text.substr(0, text.find_first_of(": ")) + "' needs a value");
    } catch (const CLI::ParseError& error) {
        throw OptionError(error.what());
    }
    if (state_->help_asked) return {};
    std::vector<std::string> others = state_->app.remaining();
    for (const std::string& word : others) {
        if (!word.starts_with('-') || word == "-") continue;
        const std::string name = word.substr(0, word.find('='));
        throw OptionError("unknown option '" + name + "'" + did_you_mean(name, long_names()));
    }
    if (end_of_options != words.end()) others.insert(others.end(), end_of_options + 1, words.end());
    return others;
}

bool CommandLine::help_asked() const { return state_->help_asked; }

std::string CommandLine::help() const {
    std::string text = state_->app.help();
    // Groups without a visible option leave blank lines.
    for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) text.erase(at, 1);
    return text;
}

std::vector<std::string> with_two_dashes(const std::vector<std::string>& words, const CommandLine& line) {
    const std::vector<std::string> known = line.long_names();
    std::vector<std::string> result;
    bool options = true;
    for (const std::string& word : words) {
        options = options && word != "--";
        const std::string longer = "-" + word;
        const bool is_long = std::find(known.begin(), known.end(), longer.substr(0, longer.find('='))) != known.end();
        result.push_back(options && word.size() > 2 && word[0] == '-' && word[1] != '-' && is_long ? longer : word);
    }
    return result;
}

}  // namespace rt
