#include "core/source.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/utf8.h"

namespace rt {

namespace {

constexpr std::size_t excerpt_width = 160;  // longest piece of a source line that a message shows

/// The bytes of the line that holds `offset`, without its newline.
struct Line {
    std::size_t begin;
    std::size_t end;
};

Line line_around(std::string_view text, std::size_t offset) {
    const std::size_t at = std::min(offset, text.size());
    const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t after = text.find('\n', at);
    Line line{before == std::string_view::npos ? 0 : before + 1, after == std::string_view::npos ? text.size() : after};
    if (line.end > line.begin && text[line.end - 1] == '\r') --line.end;
    return line;
}

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
    const SourceFile& file = files_[span.file]->source;
    const std::size_t line_number = locate(span.file, span.begin).line;
    std::string message = fmt::format("File '{}' line {}: {}: {}", one_line(file.name), line_number, kind, text);

    const Line line = line_around(file.text, span.begin);
    const std::size_t caret = std::min<std::size_t>(span.begin, line.end);
    const std::size_t caret_end = std::clamp<std::size_t>(span.end, caret + 1, std::max(line.end, caret + 1));
    std::size_t first = line.begin;
    if (line.end - line.begin > excerpt_width && caret - line.begin > excerpt_width / 2) first = caret - excerpt_width / 2;
    const std::size_t last = std::min(line.end, first + excerpt_width);
    const std::size_t carets = std::min(caret_end, std::max(last, caret + 1)) - caret;

    const std::string number = fmt::format("{:>4}", line_number);
    message += fmt::format("\n{} | {}\n{} | {}{}", number, printable(std::string_view(file.text).substr(first, last - first)),
                           std::string(number.size(), ' '), std::string(caret - first, ' '), std::string(carets, '^'));
    return message;
}

}  // namespace rt
