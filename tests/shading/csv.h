// Reads a table of golden values: comment lines with '#', one header line, comma-separated rows. For tests.
#pragma once

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace rt::testing_csv {

class Table {
public:
    explicit Table(const std::string& path) {
        std::ifstream in(path);
        for (std::string line; std::getline(in, line);) {
            if (line.empty() || line[0] == '#') continue;
            std::vector<std::string> cells = split(line);
            if (columns_.empty()) {
                for (std::size_t i = 0; i < cells.size(); ++i) columns_[cells[i]] = i;
            } else {
                rows_.push_back(std::move(cells));
            }
        }
    }
    std::size_t size() const { return rows_.size(); }
    const std::string& text(std::size_t row, const std::string& column) const { return rows_.at(row).at(columns_.at(column)); }
    double number(std::size_t row, const std::string& column) const { return std::strtod(text(row, column).c_str(), nullptr); }

private:
    static std::vector<std::string> split(const std::string& line) {
        std::vector<std::string> cells;
        std::istringstream in(line);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        return cells;
    }
    std::map<std::string, std::size_t> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace rt::testing_csv
