#include "commands/versus/program_told.h"

#include <fmt/format.h>

#include <charconv>

#include "commands/base/values.h"
#include "core/utf8.h"

namespace rt {

namespace {

/// The number behind `label`, blanks and `opening`, all on one line; `otherwise` if there is none. The last
/// such label counts: what a scene prints comes before.
double number_behind(std::string_view text, std::string_view label, std::string_view opening, double otherwise) {
    const std::size_t at = text.rfind(label);
    if (at == text.npos) return otherwise;
    std::string_view line = text.substr(at + label.size());
    line = line.substr(0, line.find('\n'));
    const std::size_t open = line.find(opening);
    if (open == line.npos) return otherwise;
    const std::string_view digits = trimmed(line.substr(open + opening.size()));
    double value = otherwise;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

double povray_seconds(std::string_view output, std::string_view label) { return number_behind(output, label, "seconds (", 0.0); }

std::uint64_t count_behind(std::string_view output, std::string_view label) {
    return static_cast<std::uint64_t>(number_behind(output, label, "", 0.0));
}

constexpr std::size_t longest_message = 1000;

std::string cut(const std::string& message) {
    return message.size() <= longest_message ? message : std::string(whole_characters(message, longest_message)) + "...";
}

bool is_rule(std::string_view line) { return line.starts_with("----") || line.starts_with("===="); }

}  // namespace

void read_povray_statistics(std::string_view output, VersusRun& run) {
    run.phases.parse = povray_seconds(output, "Parse Time:");
    run.phases.build = povray_seconds(output, "Bounding Time:");
    run.phases.trace = 0.0;
    for (const char* part : {"Photon Time:", "Radiosity Time:", "Trace Time:"}) run.phases.trace += povray_seconds(output, part);
    run.rays = count_behind(output, "\nRays:");
    run.shadow_tests = count_behind(output, "\nShadow Ray Tests:");
}

std::string povray_lines(std::string_view output) {
    constexpr std::size_t width = 80;
    std::string text;
    std::size_t length = 0;  // of the line before
    for (const std::string& line : split(output, '\n')) {
        // As long may be a line that was not cut; what comes behind an error's is known.
        const bool goes_on = length == width && !line.starts_with("Fatal error") && !line.starts_with("Render failed");
        if (length > 0 && !goes_on) text += '\n';
        text += line, length = line.size();
    }
    return text;
}

std::string povray_message(std::string_view output) {
    const std::vector<std::string> lines = split(output, '\n');
    std::string last, last_error;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = trimmed(lines[i]);
        if (!line.empty() && !is_rule(line)) last = line;
        if (line.find("Error: ") == line.npos) continue;
        std::string message(line);
        // POV-Ray breaks lines at the width of a terminal and begins what goes on with a blank.
        for (std::size_t next = i + 1; next < lines.size() && lines[next].starts_with(' '); ++next)
            message.append(" ").append(trimmed(lines[next]));
        last_error = message;
    }
    return cut(last_error.empty() ? last : last_error);
}

std::string our_message(std::string_view output) {
    std::string last, last_error;
    for (const std::string& line : split(output, '\n')) {
        if (!trimmed(line).empty()) last = line;
        const bool is_possible = line.find("Possible ") != line.npos;
        if (line.find("Error: ") != line.npos && !is_possible) last_error = line;
        if (line.starts_with("raytrace: ") && !line.starts_with("raytrace: note: ") && !line.starts_with("raytrace: warning: "))
            last_error = line;
    }
    return cut(last_error.empty() ? last : last_error);
}

std::string refused_place(std::string_view message) {
    constexpr std::string_view opening = "File '", number = "' line ", closing = ": Parse Error: ";
    // A file's name may hold any of them; a message behind it, too.
    const std::size_t end = message.find(closing), line = message.substr(0, end).rfind(number);
    if (!message.starts_with(opening) || end == message.npos || line == message.npos) return {};
    std::string_view file = message.substr(opening.size(), line - opening.size());
    file.remove_prefix(file.rfind('/') + 1);
    return fmt::format("{}{}", printable(file, longest_message), message.substr(line + 1, end - line - 1));
}

std::string povray_version(std::string_view output) {
    for (const std::string& line : split(output, '\n'))
        if (line.starts_with("POV-Ray ")) return std::string(trimmed(line));
    return {};
}

void read_our_statistics(std::string_view output, VersusRun& run) {
    const std::size_t at = output.rfind("time: parse ");
    if (at == output.npos) return;
    const std::string_view text = output.substr(at);
    run.phases.parse = number_behind(text, "parse ", "", 0.0);
    run.phases.build = number_behind(text, "build ", "", 0.0);
    run.phases.trace = number_behind(text, "trace ", "", 0.0);
    run.phases.write = number_behind(text, "write ", "", 0.0);
    run.rays = 0;
    for (const char* kind : {"\n  camera", "\n  reflected", "\n  refracted"}) run.rays += count_behind(text, kind);
    run.shadow_tests = count_behind(text, "\n  shadow");
}

}  // namespace rt
