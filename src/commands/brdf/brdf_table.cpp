#include "commands/brdf/brdf_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "commands/base/suggest.h"
#include "commands/base/values.h"
#include "core/source.h"

namespace rt {

namespace {

constexpr std::size_t most_lines = 1'000'000, most_columns = 1000;

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// What a message shows of a cell.
std::string readable(std::string_view cell) { return printable(cell, 40); }

}  // namespace

BrdfTable::BrdfTable(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
    std::string_view rest = without_byte_order_mark(text_);
    for (std::size_t number = 1; !rest.empty(); ++number) {
        if (number > most_lines) throw LimitError(fmt::format("{}: more than {} lines", name_, most_lines));
        const std::size_t end = rest.find('\n');
        add(split(rest.substr(0, end), number));
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    if (header_ == none) throw OptionError(fmt::format("{}: no header line with the names of the columns", name_));
}

BrdfTable::Line BrdfTable::split(std::string_view text, std::size_t number) const {
    if (text.ends_with('\r')) text.remove_suffix(1);
    Line line{Line::Kind::comment, text, {}, number};
    if (without_blanks(text).empty() || text.front() == '#') return line;
    line.kind = header_ == none ? Line::Kind::header : Line::Kind::row;
    for (;;) {
        const std::size_t comma = text.find(',');
        line.cells.push_back(without_blanks(text.substr(0, comma)));
        if (comma == std::string_view::npos) return line;
        text.remove_prefix(comma + 1);
    }
}

void BrdfTable::add(Line line) {
    if (line.kind == Line::Kind::header) {
        header_ = lines_.size();
        if (line.cells.size() > most_columns) throw LimitError(fmt::format("{}: more than {} columns", name_, most_columns));
        for (auto cell = line.cells.begin(); cell != line.cells.end(); ++cell)
            if (std::find(line.cells.begin(), cell, *cell) != cell) fail(line, fmt::format("column '{}' appears twice", readable(*cell)));
    } else if (line.kind == Line::Kind::row && line.cells.size() != header().cells.size()) {
        fail(line, fmt::format("{} cells under a header of {}", line.cells.size(), header().cells.size()));
    }
    lines_.push_back(std::move(line));
}

std::size_t BrdfTable::column(std::string_view column) const {
    const auto& names = header().cells;
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end()) {
        std::vector<std::string> known;
        for (const std::string_view name : names) known.push_back(readable(name));
        fail(header(), fmt::format("no column '{}'{}", column, did_you_mean(column, known)));
    }
    return static_cast<std::size_t>(found - names.begin());
}

void BrdfTable::fail(const Line& line, std::string_view text) const {
    throw OptionError(fmt::format("{}:{}: {}", name_, line.number, text));
}

double BrdfRow::any_double(std::string_view column) const {
    const std::string cell(text(column));
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);  // from_chars would refuse what is beyond the range of doubles
    if (cell.empty() || end != cell.c_str() + cell.size()) fail(fmt::format("column '{}': '{}' is not a number", column, readable(cell)));
    return value;
}

double BrdfRow::number(std::string_view column, const Domain& its) const {
    const double value = any_double(column);
    if (!its.holds(value)) fail(fmt::format("column '{}': expected {} instead of '{}'", column, its.words, readable(text(column))));
    return value;
}

Vec3 BrdfRow::vector(std::string_view name) const {
    const std::string start(name);
    return {any_double(start + "x"), any_double(start + "y"), any_double(start + "z")};
}

std::string read_table_text(const std::string& path) {
    constexpr std::size_t most = std::size_t{32} << 20;
    const bool standard = path == "-";
    const std::string name = standard ? "standard input" : path;
    const auto close = [](std::FILE* file) { std::fclose(file); };
    std::unique_ptr<std::FILE, decltype(close)> opened(standard ? nullptr : std::fopen(path.c_str(), "rb"), close);
    std::FILE* file = standard ? stdin : opened.get();
    if (!file) throw OptionError(fmt::format("cannot open '{}': {}", path, std::strerror(errno)));
    std::string text;
    char block[1 << 16];
    for (std::size_t n = 0; (n = std::fread(block, 1, sizeof block, file)) > 0;) {
        text.append(block, n);
        if (text.size() > most) throw LimitError(fmt::format("{} is larger than 32 MiB", name));
    }
    if (std::ferror(file)) throw OptionError(fmt::format("cannot read '{}': {}", name, std::strerror(errno)));
    return text;
}

}  // namespace rt
