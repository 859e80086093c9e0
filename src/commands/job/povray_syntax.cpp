#include "commands/job/povray_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "commands/base/suggest.h"
#include "commands/base/values.h"
#include "commands/job/povray_settings.h"
#include "core/source.h"

namespace rt {

namespace {

constexpr int max_ini_files = 64;
constexpr std::uintmax_t max_ini_bytes = 1 << 20;
constexpr std::size_t most_shown = 400;  ///< of a message: a line of a file that is no text may be long

/// "Name=value": a key is letters, digits and underscores and begins with a letter.
bool is_setting(std::string_view word) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string_view::npos || std::isalpha(static_cast<unsigned char>(word[0])) == 0) return false;
    for (const char c : word.substr(0, equals))
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') return false;
    return true;
}

bool is_file(const std::string& name) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(name, ignored);
}

/// The INI file that `word` names: "file.ini" or "file.ini[section]", or the same without the ending where there is such a file and no
/// scene that the word could mean. Empty if it names none.
std::string ini_file_of(const std::string& word) {
    const std::size_t open = word.ends_with(']') ? word.rfind('[') : std::string::npos;
    const std::string name = word.substr(0, open), section = open == std::string::npos ? "" : word.substr(open);
    if (name.size() > 4 && lower_case(name.substr(name.size() - 4)) == ".ini") return word;
    const bool plain = !name.empty() && !std::filesystem::path(name).has_extension() && is_file(name + ".ini");
    return plain && !is_file(word) && !is_file(word + ".pov") ? name + ".ini" + section : "";
}

bool is_gnu_short(const std::string& word, const std::vector<std::string>& more) {
    const auto is_word = [&](const std::string& ours) { return word == ours || (ours.size() == 2 && word.starts_with(ours + '=')); };
    for (const char* ours : {"-h", "-o", "-q", "-t", "-L", "-W", "-H", "-"})
        if (is_word(ours)) return true;
    return std::any_of(more.begin(), more.end(), is_word);
}

std::vector<std::string> known_keys() {
    std::vector<std::string> keys;
    for (const PovraySetting& setting : povray_settings()) keys.emplace_back(setting.key);
    return keys;
}

/// Calls `f` with the index of every character of `line` that is outside of quotes, until it says true.
void outside_quotes(std::string_view line, const std::function<bool(std::size_t)>& f) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote == 0 && f(i)) return;
        if (quote != 0 ? line[i] == quote : line[i] == '"') quote = quote != 0 ? '\0' : line[i];
    }
}

/// `line` up to a ; or # that is not in quotes.
std::string_view without_comment(std::string_view line) {
    std::size_t end = line.size();
    outside_quotes(line, [&](std::size_t i) {
        if (line[i] == ';' || line[i] == '#') end = std::min(end, i);
        return end < line.size();
    });
    return line.substr(0, end);
}

/// The words of a line of an INI file, where blanks in quotes are no ends.
std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    const auto take = [&](std::size_t end) {
        const std::string_view word = unquoted(line.substr(begin, end - begin));
        if (!word.empty()) words.emplace_back(word);
        begin = end;
        return false;
    };
    outside_quotes(line, [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(line[i])) != 0 && take(i); });
    take(line.size());
    return words;
}

class Translator {
public:
    Translator(const OwnOptions& own) : own_(own) {}

    void defaults();
    void command_line(const std::vector<std::string>& words);
    Translation result;

private:
    const OwnOptions& own_;
    std::vector<std::string> open_;         ///< INI files that are being read, each with its section
    int files_ = 0;                         ///< INI files read so far
    std::optional<std::size_t> ini_scene_;  ///< which of the words is the last scene that an INI file's Input_File_Name named
    std::size_t tried_ = 0;                 ///< words up to here come from lines that have been tried out
    bool placed_ = false;                   ///< the mistake on its way out names its line already

    bool our_option(const std::vector<std::string>& words, std::size_t& i);
    bool povray_word(const std::string& word);
    bool switch_word(const std::string& word);
    void other_word(const std::string& word);
    std::string without_fraction(std::string_view value, const std::string& written);
    void setting(const std::string& key, std::string_view value, const std::string& written);
    void ini_file(std::string_view word);
    void ini_lines(std::istream& in, const std::string& name, const std::string& wanted);
    void ini_line(std::string_view line);
    void ini_word(const std::string& word);
};

void Translator::command_line(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") {
            result.words.insert(result.words.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
            return;
        }
        if (!our_option(words, i) && !povray_word(word)) other_word(word);
    }
}

/// $POVINI, else povray.ini in the current folder, as POV-Ray looks for them.
void Translator::defaults() {
    std::string name = "povray.ini";
    if (const char* named = std::getenv("POVINI"); named && *named != '\0') {
        if (is_file(named))
            name = named;
        else
            result.notes.push_back(fmt::format("POVINI: there is no file '{}'", printable(named)));
    }
    if (!is_file(name)) return;
    result.notes.push_back(fmt::format("defaults are those of '{}'", printable(name)));
    ini_file(name);
}

/// Perhaps a scene: that of an INI file before it counts no more.
void Translator::other_word(const std::string& word) {
    if (ini_scene_ && !word.starts_with('-')) {
        result.words.erase(result.words.begin() + static_cast<std::ptrdiff_t>(*ini_scene_));
        ini_scene_.reset();
        --tried_;
    }
    result.words.push_back(word);
}

/// Takes words[i] if it is an option in our own syntax, with its value if that is the next word.
bool Translator::our_option(const std::vector<std::string>& words, std::size_t& i) {
    const std::string& word = words[i];
    const bool grid = word == "-ss" || word.starts_with("-ss=");  // the course's way to write it, welcome everywhere
    if (!grid && !word.starts_with("--") && !is_gnu_short(word, own_.short_names)) return false;
    result.words.push_back(grid ? "-" + word : word);
    if (i + 1 < words.size() && own_.takes_value(result.words.back())) result.words.push_back(words[++i]);
    return true;
}

bool Translator::povray_word(const std::string& word) {
    if (word.starts_with('+') || word.starts_with('-')) return switch_word(word);
    if (is_setting(word)) {
        const std::size_t equals = word.find('=');
        setting(word.substr(0, equals), unquoted(std::string_view(word).substr(equals + 1)), word);
        return true;
    }
    const std::string file = ini_file_of(word);
    if (!file.empty()) ini_file(file);
    return !file.empty();
}

bool Translator::switch_word(const std::string& word) {
    const std::string name = "--" + word.substr(1, word.find('=') - 1);
    // One letter is a switch: -D is POV-Ray's, --D ours.
    if (name.size() > 3 && std::find(own_.long_names.begin(), own_.long_names.end(), name) != own_.long_names.end())
        throw OptionError(fmt::format("unknown option '{}'; did you mean '{}'?", word, name));
    const PovraySwitch* found = find_povray_switch(std::string_view(word).substr(1));
    if (!found) {
        if (word[0] == '-') return false;  // perhaps one of our short options
        throw OptionError(fmt::format("unknown switch '{}'; see raytrace help povray", word));
    }
    const std::string_view rest = unquoted(std::string_view(word).substr(1 + found->letters.size()));
    const std::string_view items = word[0] == '+' ? found->plus : found->minus;
    if (!rest.empty() && items.find_first_of("!?") == std::string_view::npos)
        throw OptionError(fmt::format("unknown switch '{}': nothing may stand behind '{}{}'", word, word[0], found->letters));
    for (const std::string& item : split(items, ' ')) {
        const std::size_t equals = item.find('=');
        const std::string key = item.substr(0, equals);
        const std::string value = item.substr(equals + 1);
        if (value == "!" && rest.empty())
            throw OptionError(fmt::format("switch '{}' needs a value: {} ({}=value)", word, word + "value", key));
        if (value == "?" && rest.empty()) continue;
        setting(key, value == "!" || value == "?" ? rest : std::string_view(value), word);
    }
    return true;
}

/// As POV-Ray does it. What is no number stays, for the option to refuse.
std::string Translator::without_fraction(std::string_view value, const std::string& written) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool whole = error != std::errc() || end != value.data() + value.size() || number == std::trunc(number) || !std::isfinite(number);
    if (whole) return std::string(value);
    result.notes.push_back(fmt::format("{}: the fraction is cut off, as in POV-Ray", written));
    return fmt::format("{:.0f}", std::trunc(number));
}

void Translator::setting(const std::string& key, std::string_view value, const std::string& written) {
    using Kind = PovraySetting::Kind;
    const PovraySetting* found = find_povray_setting(key);
    if (!found) {
        if (lower_case(key) == "include_ini") return ini_file(value);
        throw OptionError(fmt::format("unknown setting '{}'{}", key, did_you_mean(key, known_keys())));
    }
    const auto ignore = [&] {
        if (result.ignored.empty() || result.ignored.back() != written) result.ignored.push_back(written);
    };
    switch (found->kind) {
        case Kind::value:
            if (value.empty()) throw OptionError(fmt::format("setting '{}' needs a value", key));
            if (!open_.empty() && found->option == "--input") ini_scene_ = result.words.size();
            result.words.push_back(fmt::format("{}={}", found->option, value));
            break;
        case Kind::whole:
            if (value.empty()) throw OptionError(fmt::format("setting '{}' needs a value", key));
            result.words.push_back(fmt::format("{}={}", found->option, without_fraction(value, written)));
            break;
        case Kind::boolean:
            result.words.push_back(fmt::format("{}={}", found->option, on_or_off(key, value) ? "on" : "off"));
            break;
        case Kind::unavailable:
            if (on_or_off(key, value)) ignore();
            break;
        case Kind::always_on:
            if (!on_or_off(key, value)) ignore();
            break;
        case Kind::ignored:
            ignore();
            break;
        case Kind::command:
            if (!value.empty()) result.notes.push_back(fmt::format("{}: no command is ever started", printable(written, most_shown)));
            break;
        case Kind::settled:
            break;
        case Kind::unmodelled:
            if (on_or_off(key, value))
                throw OptionError(fmt::format("{} (from '{}') is not available in this version", found->key, written));
            break;
    }
}

void Translator::ini_file(std::string_view word) {
    std::string wanted;
    if (word.ends_with(']')) {
        const std::size_t open = word.rfind('[');
        wanted = lower_case(word.substr(open + 1, word.size() - open - 2));
        word = word.substr(0, open);
    }
    const std::string name(word);
    std::error_code ignored;
    std::ifstream in(name, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(name, ignored)) throw OptionError(fmt::format("cannot open INI file '{}'", name));
    if (std::filesystem::file_size(name, ignored) > max_ini_bytes)
        throw OptionError(fmt::format("INI file '{}' is longer than 1 MB", name));
    if (++files_ > max_ini_files) throw OptionError(fmt::format("INI file '{}' is one more than {} to be read", name, max_ini_files));
    const std::string identity = std::filesystem::weakly_canonical(name, ignored).string() + '[' + wanted;
    if (std::find(open_.begin(), open_.end(), identity) != open_.end())
        throw OptionError(fmt::format("INI file '{}' includes itself", name));
    open_.push_back(identity);
    ini_lines(in, name, wanted);
    open_.pop_back();
}

void Translator::ini_lines(std::istream& in, const std::string& name, const std::string& wanted) {
    bool active = true;  // lines before the first section always count
    bool found = wanted.empty();
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::replace(line.begin(), line.end(), '\0', '\x01');  // no text has either, but a message would end at the one
        std::string_view text = trimmed(number == 1 ? without_byte_order_mark(line) : line);
        if (const std::size_t close = text.find(']'); text.starts_with('[') && close != std::string_view::npos) {
            active = !wanted.empty() && lower_case(text.substr(1, close - 1)) == wanted;
            found = found || active;
            text.remove_prefix(close + 1);
        }
        if (!active) continue;
        try {
            ini_line(text);
        } catch (const OptionError& error) {
            if (placed_) throw;  // an included file knows its line better
            placed_ = true;
            throw OptionError(fmt::format("File '{}' line {}: {}", name, number, printable(error.what(), most_shown)));
        }
    }
    if (!found) throw OptionError(fmt::format("INI file '{}' has no section [{}]", name, wanted));
}

/// One line: a comment, one Name=value, or several switches and file names.
void Translator::ini_line(std::string_view line) {
    const std::string text(trimmed(without_comment(line)));
    if (text.empty()) return;
    std::size_t next = result.words.size();
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && text[0] != '+' && text[0] != '-' && text[0] != '"') {
        setting(std::string(trimmed(std::string_view(text).substr(0, equals))), unquoted(std::string_view(text).substr(equals + 1)), text);
    } else {
        const std::vector<std::string> words = words_of(text);
        for (std::size_t i = 0; i < words.size(); ++i)
            if (!our_option(words, i)) ini_word(words[i]);
    }
    // What is wrong with a value is found here, where its place is known; an included file has done so for its own lines.
    for (next = std::max(next, tried_); next < result.words.size(); ++next) {
        const std::string& word = result.words[next];
        if (!word.starts_with('-')) continue;
        const bool separate = next + 1 < result.words.size() && own_.takes_value(word);
        own_.try_out(separate ? std::vector{word, result.words[++next]} : std::vector{word});
    }
    tried_ = next;
}

/// A word of a line that is no setting.
void Translator::ini_word(const std::string& word) {
    if (povray_word(word)) return;
    std::error_code ignored;
    const bool scene = lower_case(word).ends_with(".pov") || std::filesystem::is_regular_file(word, ignored);
    if (!scene && !word.starts_with('-')) {
        if (const PovraySetting* key = find_povray_setting(word))
            throw OptionError(fmt::format("no '=' behind '{}': expected {}=value", word, key->key));
        throw OptionError(
            fmt::format("expected Name=value, a switch (+W640) or a scene (NAME.pov), not '{}'{}", word, did_you_mean(word, known_keys())));
    }
    result.words.push_back(word);
}

}  // namespace

Translation translate_povray_syntax(const std::vector<std::string>& words, const OwnOptions& own, Defaults defaults) {
    Translator translator(own);
    if (defaults == Defaults::of_povray) translator.defaults();
    translator.command_line(words);
    return std::move(translator.result);
}

}  // namespace rt
