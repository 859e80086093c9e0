// Pages that tell of many comparisons: a table, and for each row pictures, texts and facts. Made for `grade`, and for whoever compares.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// How a column's values are shown and sorted. Texts are sorted with their numbers as numbers; a missing value is always last.
enum class CellKind : std::uint8_t { text, outcome, count, points, figure, seconds, bytes };

struct ReportColumn {
    std::string key, title;
    CellKind kind = CellKind::text;
    std::string hint;  ///< what the title means; may be empty
};

/// A picture of a row. The first is what the others are compared with.
struct ReportPicture {
    std::string label;
    std::string path;     ///< of its file, in any format we read; empty: there is none
    std::string missing;  ///< then: why
};

struct ReportRow {
    /// Members of the row in the page's data; all but `name`, `good` and `cells` may be missing:
    ///     name         unique; the page's address with #NAME shows the row
    ///     good         false: to be looked at first
    ///     cells        {column's key: text or number}
    ///     tag          a word behind the name
    ///     href         address of a page of its own, relative
    ///     reason, cause, explanation, command, output, output_note    texts
    ///     commands     [[whose, text], ...] instead of one command
    ///     facts        [[name, text], ...]
    ///     phases       [[program, [[phase, seconds], ...]], ...], the same phases for all
    ///     lines        of two texts side by side, [[number, text, number, text, [differing fields]], ...]
    ///                  with number 0 where a line is missing
    ///     lines_note   how they were compared
    ///     pair         [first, second] pictures by number, which are compared at first; else the first two that there are
    ///     region       {box: [x0, y0, x1, y1], pixel: [x, y], pixels} from the top left, x1 and y1 excluded
    nlohmann::ordered_json data;
    std::vector<ReportPicture> pictures;
};

struct ReportPage {
    std::string title;  ///< the heading
    std::string about;  ///< a line below it
    std::vector<std::pair<std::string, std::string>> facts;
    std::vector<std::string> notes;       ///< what the reader has to know first
    std::string back_href, back;          ///< a link in the head, relative; empty: none
    std::string rows_name = "tests";      ///< what a row is, many of them
    std::string bad_name = "Not passed";  ///< what those that are not good are called
    std::string first;                    ///< name of the row that is shown first; empty: the first that is not good
    std::vector<ReportColumn> columns;    ///< the first names the row, the second may be its outcome
    std::vector<ReportRow> rows;
    std::string_view skeleton = "report_page.html";
    nlohmann::ordered_json more;  ///< an object: members of the page's data for scripts of that skeleton alone
};

/// Which pictures stand in a page.
struct PictureChoice {
    std::uint64_t most_bytes = 64ull << 20;  ///< of all files together; pictures of rows that are not good come first
    bool of_good_rows = true;
    std::string left_out;     ///< said of a picture that is left out
    bool good_first = false;  ///< those of good rows come first instead
};

/// The page: one file that asks the network for nothing. Files of the same bytes stand in it once; what is no plain PNG (8 or 16 bits, no
/// palette, not interlaced) is converted, and the page says so where numbers change by that. A file that cannot be read is told of in the
/// page, and so is a picture of more than 2^23 pixels (3840 x 2160 is less). The same rows and files give the same bytes.
std::string report_page(const ReportPage& page, const PictureChoice& choice);

/// A page of the table alone, whose rows lead to pages of their own (`href`).
std::string report_index(const ReportPage& page);

/// A file's name as a part of an address.
std::string in_address(const std::string& name);

}  // namespace rt
