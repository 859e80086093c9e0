// raytrace brdf: the shading functions on tables of inputs, and their values against known ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/brdf_rows.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/text.h"
#include "core/source.h"

namespace rt {

namespace {

/// Copies the table with a column got_X behind each row for every X that the kind has.
int evaluate(const BrdfKind& kind) {
    const BrdfTable table("standard input", read_table_text("-"));
    std::string out;
    for (const BrdfTable::Line& line : table.lines()) {
        out += line.text;
        if (line.kind == BrdfTable::Line::Kind::header)
            for (const std::string_view column : kind.columns) out += fmt::format(",got_{}", column);
        if (line.kind == BrdfTable::Line::Kind::row)
            for (const double value : kind.evaluate(BrdfRow(table, line))) out += fmt::format(",{:.17g}", value);
        out += '\n';
    }
    write_stdout(out);
    return 0;
}

/// What became of one judged column.
struct Judgement {
    std::size_t rows = 0, beyond = 0;
    double largest = 0.0;  ///< error as a fraction of the tolerance
    std::string largest_id, complaints;

    void add(const BrdfRow& row, const JudgedColumn& judged, double got);
};

double fraction_of_tolerance(double want, double got, double tolerance) {
    if (want == got || (std::isnan(want) && std::isnan(got))) return 0.0;
    const double fraction = std::fabs(got - want) / tolerance;
    return std::isnan(fraction) ? HUGE_VAL : fraction;
}

void Judgement::add(const BrdfRow& row, const JudgedColumn& judged, double got) {
    const double want = row.number(judged.column);
    const double fraction = fraction_of_tolerance(want, got, judged.tolerance(row, want));
    ++rows;
    if (fraction > largest || rows == 1) {
        largest = fraction;
        largest_id = row.text("id");
    }
    if (fraction <= 1.0) return;
    ++beyond;
    complaints +=
        fmt::format("  beyond: id {} {} wanted {:.17g} got {:.17g} fraction {:.3g}\n", row.text("id"), judged.column, want, got, fraction);
}

/// Prints the verdict on one file; true if no row is beyond its tolerance.
bool check(const std::string& path) {
    const std::string file = path.substr(path.rfind('/') + 1);
    const BrdfKind& kind = brdf_kind(file.ends_with(".csv") ? file.substr(0, file.size() - 4) : file);
    const BrdfTable table(path, read_table_text(path));
    for (const JudgedColumn& judged : kind.judged) table.column(judged.column);
    std::vector<Judgement> judgements(kind.judged.size());
    for (const BrdfTable::Line& line : table.lines()) {
        if (line.kind != BrdfTable::Line::Kind::row) continue;
        const BrdfRow row(table, line);
        const std::vector<double> values = kind.evaluate(row);
        for (std::size_t i = 0; i < judgements.size(); ++i) {
            const auto place = std::find(kind.columns.begin(), kind.columns.end(), kind.judged[i].column) - kind.columns.begin();
            judgements[i].add(row, kind.judged[i], values[static_cast<std::size_t>(place)]);
        }
    }
    std::string out = path + "\n";
    bool good = true;
    for (std::size_t i = 0; i < judgements.size(); ++i) {
        const Judgement& j = judgements[i];
        out += fmt::format("  {:<15}{:>7} rows  largest {:.3g} at id {}  beyond {}\n", kind.judged[i].column, j.rows, j.largest,
                           j.rows ? j.largest_id : "-", j.beyond);
        good = good && j.beyond == 0;
    }
    for (const Judgement& j : judgements) out += j.complaints;
    write_stdout(out);
    return good;
}

}  // namespace

int run_brdf(const Words& words) {
    CommandLine line(brdf_usage, brdf_footer);
    const Words rest = line.parse(words);
    if (line.help_asked()) {
        write_stdout(line.help());
        return 0;
    }
    const std::string action = rest.empty() ? "" : rest[0];
    if (action == "eval") {
        if (rest.size() != 2) throw OptionError("brdf eval: expected one table's name; see raytrace brdf --help");
        return evaluate(brdf_kind(rest[1]));
    }
    if (action == "check") {
        if (rest.size() < 2) throw OptionError("brdf check: expected a file; see raytrace brdf --help");
        bool good = true;
        for (std::size_t i = 1; i < rest.size(); ++i) good = check(rest[i]) && good;
        return good ? 0 : 1;
    }
    throw OptionError(fmt::format("brdf: expected 'eval' or 'check'{}; see raytrace brdf --help",
                                  action.empty() ? "" : fmt::format(" instead of '{}'", action)));
}

}  // namespace rt
