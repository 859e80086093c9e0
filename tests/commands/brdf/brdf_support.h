// Tables of one row or more for tests of `raytrace brdf`, by names and numbers.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "commands/brdf/brdf_rows.h"

namespace rt::test {

/// Cells in the order of their columns.
class Cells {
public:
    Cells& add(const std::string& column, const std::string& text) {
        cells_.emplace_back(column, text);
        return *this;
    }
    Cells& add(const std::string& column, double value) { return add(column, fmt::format("{:.17g}", value)); }
    Cells& add(const std::string& name, const Vec3& v) { return add(name + "x", v.x).add(name + "y", v.y).add(name + "z", v.z); }
    /// The same row with another text in a column.
    Cells with(const std::string& column, const std::string& text) const {
        Cells other = *this;
        for (auto& [name, cell] : other.cells_)
            if (name == column) cell = text;
        return other;
    }
    Cells with(const std::string& column, double value) const { return with(column, fmt::format("{:.17g}", value)); }
    std::string header() const {
        return joined([](const auto& cell) { return cell.first; });
    }
    std::string row() const {
        return joined([](const auto& cell) { return cell.second; });
    }

private:
    std::string joined(const auto& part) const {
        std::string text;
        for (const auto& cell : cells_) text += (text.empty() ? "" : ",") + part(cell);
        return text + "\n";
    }
    std::vector<std::pair<std::string, std::string>> cells_;
};

/// What the table's kind makes of the row, by column.
inline std::map<std::string, double> evaluated(std::string_view kind_name, const Cells& cells) {
    const BrdfKind& kind = *find_brdf_kind(kind_name);
    const BrdfTable table("row", cells.header() + cells.row());
    const std::vector<double> values = kind.evaluate(BrdfRow(table, table.lines().back()));
    std::map<std::string, double> by_name;
    for (std::size_t i = 0; i < values.size(); ++i) by_name[std::string(kind.columns[i])] = values[i];
    return by_name;
}

}  // namespace rt::test
