// Tables of shading values as text: comment lines with '#', one header line, rows of comma-separated cells. Every mistake in one is an
// OptionError that begins with the table's name and the line.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace rt {

class BrdfTable {
public:
    /// `name` is what messages call the table. A byte-order mark in front of it is skipped. Throws unless there is a header of distinct
    /// names and every row has as many cells. Throws LimitError beyond 1,000,000 lines or 1,000 columns.
    BrdfTable(std::string name, std::string text);
    BrdfTable(const BrdfTable&) = delete;  // cells are views into the text
    BrdfTable& operator=(const BrdfTable&) = delete;

    struct Line {
        enum class Kind { comment, header, row };
        Kind kind = Kind::comment;  ///< of comments and empty lines
        std::string_view text;      ///< without its end
        std::vector<std::string_view> cells;
        std::size_t number = 0;  ///< from 1
    };
    const std::vector<Line>& lines() const { return lines_; }
    const Line& header() const { return lines_[header_]; }
    /// Position of a column; throws if there is none of that name.
    std::size_t column(std::string_view column) const;
    /// Throws OptionError "name:line: text".
    [[noreturn]] void fail(const Line& line, std::string_view text) const;

private:
    Line split(std::string_view text, std::size_t number) const;
    void add(Line line);

    static constexpr std::size_t none = ~std::size_t{0};
    std::string name_, text_;
    std::vector<Line> lines_;
    std::size_t header_ = none;
};

/// The numbers that a column may hold, both ends included, and in words behind "expected". Not-a-number is in none.
struct Domain {
    std::string_view words;
    double least, most;
    bool holds(double value) const { return value >= least && value <= most; }
};

namespace domain {
using Limits = std::numeric_limits<double>;
inline constexpr Domain number{"a number", -Limits::infinity(), Limits::infinity()};
inline constexpr Domain finite{"a finite number", -Limits::max(), Limits::max()};
inline constexpr Domain positive{"a finite number above 0", Limits::denorm_min(), Limits::max()};
inline constexpr Domain not_negative{"a finite number from 0 on", 0.0, Limits::max()};
inline constexpr Domain distance{"a number from 0 on", 0.0, Limits::infinity()};
inline constexpr Domain share{"a number from 0 to 1", 0.0, 1.0};
inline constexpr Domain cosine{"a cosine, -1 to 1", -1.0, 1.0};
}  // namespace domain

/// One row of a table by the names of its columns; what cannot be read throws as the table does.
class BrdfRow {
public:
    BrdfRow(const BrdfTable& table, const BrdfTable::Line& line) : table_(table), line_(line) {}

    std::string_view text(std::string_view column) const { return line_.cells[table_.column(column)]; }
    /// A number of the domain; subnormal ones and "inf" are read, what is beyond the range of doubles is inf or 0.
    double number(std::string_view column, const Domain& its = domain::finite) const;
    /// Three columns: `name`x, `name`y and `name`z. Any doubles, "nan" among them: a direction may be none.
    Vec3 vector(std::string_view name) const;
    [[noreturn]] void fail(std::string_view text) const { table_.fail(line_, text); }

private:
    double any_double(std::string_view column) const;

    const BrdfTable& table_;
    const BrdfTable::Line& line_;
};

/// The whole of a file, or of standard input where `path` is "-". Throws OptionError if it cannot be read, LimitError beyond 32 MiB.
std::string read_table_text(const std::string& path);

}  // namespace rt
