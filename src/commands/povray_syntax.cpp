#include "commands/povray_syntax.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "commands/povray_settings.h"
#include "commands/suggest.h"
#include "commands/values.h"
#include "core/source.h"

namespace rt {

namespace {

constexpr int max_ini_depth = 16;
constexpr std::uintmax_t max_ini_bytes = 1 << 20;

/// "Name=value": a key is letters, digits and underscores and begins with a letter.
bool is_setting(std::string_view word) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string_view::npos || std::isalpha(static_cast<unsigned char>(word[0])) == 0) return false;
    for (const char c : word.substr(0, equals))
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') return false;
    return true;
}

/// "file.ini" or "file.ini[section]".
bool is_ini_file(std::string_view word) {
    if (word.ends_with(']')) word = word.substr(0, word.rfind('['));
    return word.size() > 4 && lower_case(word.substr(word.size() - 4)) == ".ini";
}

bool is_gnu_short(const std::string& word) {
    for (const char* ours : {"-h", "-o", "-q", "-t", "-L", "-W", "-H", "-"})
        if (word == ours) return true;
    return false;
}

class Translator {
public:
    Translator(const std::function<bool(const std::string&)>& takes_value) : takes_value_(takes_value) {}

    void command_line(const std::vector<std::string>& words);
    Translation result;

private:
    const std::function<bool(const std::string&)>& takes_value_;
    int depth_ = 0;

    bool povray_word(const std::string& word);
    bool switch_word(const std::string& word);
    std::string without_fraction(std::string_view value, const std::string& written);
    void setting(const std::string& key, std::string_view value, const std::string& written);
    void ini_file(std::string_view word);
    void ini_line(std::string_view line);
};

void Translator::command_line(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--") {
            result.words.insert(result.words.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
            return;
        }
        const bool grid = word == "-ss" || word.starts_with("-ss=");  // the course's way to write it, welcome everywhere
        const bool gnu = grid || word.starts_with("--") || is_gnu_short(word);
        if (!gnu && povray_word(word)) continue;
        result.words.push_back(grid ? "-" + word : word);
        if (gnu && i + 1 < words.size() && takes_value_(result.words.back())) result.words.push_back(words[++i]);
    }
}

bool Translator::povray_word(const std::string& word) {
    if (word.starts_with('+') || word.starts_with('-')) return switch_word(word);
    if (is_setting(word)) {
        const std::size_t equals = word.find('=');
        setting(word.substr(0, equals), unquoted(std::string_view(word).substr(equals + 1)), word);
        return true;
    }
    if (is_ini_file(word)) {
        ini_file(word);
        return true;
    }
    return false;
}

bool Translator::switch_word(const std::string& word) {
    const PovraySwitch* found = find_povray_switch(std::string_view(word).substr(1));
    if (!found) {
        if (word[0] == '-') return false;  // perhaps one of our short options
        throw OptionError(fmt::format("unknown switch '{}'; see raytrace help povray", word));
    }
    const std::string_view rest = unquoted(std::string_view(word).substr(1 + found->letters.size()));
    for (const std::string& item : split(word[0] == '+' ? found->plus : found->minus, ' ')) {
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
        std::vector<std::string> known;
        for (const PovraySetting& s : povray_settings()) known.emplace_back(s.key);
        throw OptionError(fmt::format("unknown setting '{}'{}", key, did_you_mean(key, known)));
    }
    const auto ignore = [&] {
        if (result.ignored.empty() || result.ignored.back() != written) result.ignored.push_back(written);
    };
    switch (found->kind) {
        case Kind::value:
            if (value.empty()) throw OptionError(fmt::format("setting '{}' needs a value", key));
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
    if (++depth_ > max_ini_depth) throw OptionError(fmt::format("INI file '{}' is nested too deeply", name));
    std::error_code ignored;
    std::ifstream in(name, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(name, ignored)) throw OptionError(fmt::format("cannot open INI file '{}'", name));
    if (std::filesystem::file_size(name, ignored) > max_ini_bytes)
        throw OptionError(fmt::format("INI file '{}' is longer than 1 MB", name));
    bool active = true;  // lines before the first section always count
    bool found = wanted.empty();
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string_view text = unquoted(line);
        if (text.starts_with('[') && text.ends_with(']')) {
            active = !wanted.empty() && lower_case(text.substr(1, text.size() - 2)) == wanted;
            found = found || active;
            continue;
        }
        if (!active) continue;
        try {
            ini_line(text);
        } catch (const OptionError& error) {
            throw OptionError(fmt::format("File '{}' line {}: {}", name, number, error.what()));
        }
    }
    if (!found) throw OptionError(fmt::format("INI file '{}' has no section [{}]", name, wanted));
    --depth_;
}

/// One line: a comment, one Name=value, or several switches and file names.
void Translator::ini_line(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote != 0 ? line[i] == quote : line[i] == '"') quote = quote != 0 ? '\0' : line[i];
        if (quote == 0 && line[i] == ';') line = line.substr(0, i);
    }
    const std::string text(unquoted(line));
    if (text.empty()) return;
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && text[0] != '+' && text[0] != '-') {
        setting(std::string(unquoted(std::string_view(text).substr(0, equals))), unquoted(std::string_view(text).substr(equals + 1)), text);
        return;
    }
    std::istringstream pieces(text);
    for (std::string piece; pieces >> piece;)
        if (!povray_word(piece)) result.words.push_back(piece);
}

}  // namespace

Translation translate_povray_syntax(const std::vector<std::string>& words, const std::function<bool(const std::string&)>& takes_value) {
    Translator translator(takes_value);
    translator.command_line(words);
    return std::move(translator.result);
}

}  // namespace rt
