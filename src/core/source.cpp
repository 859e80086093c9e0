#include "core/source.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/utf8.h"

namespace rt {

namespace {

constexpr std::size_t excerpt_width = 160;  // longest piece of a source line that a message shows

/// One column a byte: a tab becomes a blank, other control and non-ASCII bytes a '?', so that the caret stands right.
std::string printable(std::string_view piece) {
    std::string shown(piece);
    for (char& c : shown) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\t')
            c = ' ';
        else if (byte < 32 || byte > 126)
            c = '?';
    }
    return shown;
}

}  // namespace

std::uint32_t Sources::add(SourceFile file) {
    auto entry = std::make_shared<Entry>();
    entry->source = std::move(file);
    files_.push_back(std::move(entry));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

LineColumn Sources::locate(std::uint32_t file, std::size_t offset) const {
    const Entry& entry = *files_[file];
    const std::string_view text = entry.source.text;
    std::call_once(entry.lines_counted, [&] {
        entry.line_begins.push_back(0);
        for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
            entry.line_begins.push_back(at + 1);
    });
    const std::size_t at = std::min(offset, text.size());
    const auto next = std::upper_bound(entry.line_begins.begin(), entry.line_begins.end(), at);
    return {static_cast<std::size_t>(next - entry.line_begins.begin()), at - *(next - 1) + 1};
}

std::string Sources::describe(const Span& span, std::string_view kind, std::string_view text) const {
    if (span.file >= files_.size()) return fmt::format("{}: {}", kind, text);
    const Entry& entry = *files_[span.file];
    const SourceFile& file = entry.source;
    const std::size_t line_number = locate(span.file, span.begin).line;
    std::string message = fmt::format("File '{}' line {}: {}: {}", one_line(file.name), line_number, kind, text);

    const bool is_last = line_number == entry.line_begins.size();
    const std::size_t line_begin = entry.line_begins[line_number - 1];
    std::size_t line_end = is_last ? file.text.size() : entry.line_begins[line_number] - 1;
    if (line_end > line_begin && file.text[line_end - 1] == '\r') --line_end;
    const std::size_t caret = std::min<std::size_t>(span.begin, line_end);
    const std::size_t caret_end = std::clamp<std::size_t>(span.end, caret + 1, std::max(line_end, caret + 1));
    std::size_t first = line_begin;
    if (line_end - line_begin > excerpt_width && caret - line_begin > excerpt_width / 2) first = caret - excerpt_width / 2;
    const std::size_t last = std::min(line_end, first + excerpt_width);
    const std::size_t carets = std::min(caret_end, std::max(last, caret + 1)) - caret;

    const std::string number = fmt::format("{:>4}", line_number);
    message += fmt::format("\n{} | {}\n{} | {}{}", number, printable(std::string_view(file.text).substr(first, last - first)),
                           std::string(number.size(), ' '), std::string(caret - first, ' '), std::string(carets, '^'));
    return message;
}

}  // namespace rt
