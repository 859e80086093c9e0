// The manners that every command's options share: the last value wins, long options also after one dash where a command wants that,
// unknown options are errors with a suggestion, help fits a screen.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rt {

class CommandLine {
public:
    /// `usage` is printed above the options, `footer` below them.
    CommandLine(std::string usage, std::string footer);
    ~CommandLine();

    /// Option with a value; `names` as in "-o,--output"; `use` gets the last value given. An empty `help` keeps it out of --help.
    void value(const std::string& names, const std::string& type, const std::string& help, std::function<void(const std::string&)> use);
    /// The same, but `use` gets every value in order.
    void values(const std::string& names, const std::string& type, const std::string& help, std::function<void(const std::string&)> use);
    void flag(const std::string& names, const std::string& help, std::function<void()> use);
    /// Options defined from now on are not in --help.
    void hide_from_help();

    /// Is `word` (without any "=value") an option that takes its value from the next word?
    bool takes_value(const std::string& word) const;
    /// Every "--name" known.
    std::vector<std::string> long_names() const;

    /// Carries out the options in `words`, in any order, and returns the other words. Throws OptionError.
    std::vector<std::string> parse(const std::vector<std::string>& words);
    /// True after a parse that met -h or --help; no option was carried out then.
    bool help_asked() const;
    std::string help() const;

private:
    void refuse_empty_values(const std::vector<std::string>& words) const;
    std::vector<std::string> with_values_apart(const std::vector<std::string>& words) const;

    struct State;
    std::unique_ptr<State> state_;
};

/// `-name` and `-name=value` become `--name...` where `line` knows `--name`; words behind `--` stay.
std::vector<std::string> with_two_dashes(const std::vector<std::string>& words, const CommandLine& line);

}  // namespace rt
