// raytrace brdf check: tables of shading values against known ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/base/program.h"
#include "commands/brdf/brdf_rows.h"
#include "commands/commands.h"
#include "core/source.h"

namespace rt {

namespace {

/// What became of one judged column.
struct Judgement {
    std::size_t rows = 0, beyond = 0;
    double largest = 0.0;  ///< error as a fraction of the tolerance
    std::string largest_id, complaints;

    void add(const BrdfRow& row, const JudgedColumn& judged, double got);
};

/// Infinite for a value that is no number.
double fraction_of_tolerance(double want, double got, double tolerance) {
    if (want == got) return 0.0;
    const double fraction = std::fabs(got - want) / tolerance;
    return std::isnan(fraction) ? HUGE_VAL : fraction;
}

/// A row that cannot be judged is a mistake, not a row that passes.
void Judgement::add(const BrdfRow& row, const JudgedColumn& judged, double got) {
    const double want = row.number(judged.column, domain::number), tolerance = judged.tolerance(row, want);
    if (std::isfinite(want) && !domain::not_negative.holds(tolerance))
        row.fail(fmt::format("column '{}': its tolerance is {}, expected {}", judged.column, tolerance, domain::not_negative.words));
    const double fraction = fraction_of_tolerance(want, got, tolerance);
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

std::vector<Judgement> judge(const BrdfKind& kind, const BrdfTable& table) {
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
    return judgements;
}

/// The kind of table that a file's name states.
const BrdfKind& kind_of(const std::string& path) {
    std::string name = path.substr(path.rfind('/') + 1);
    if (name.ends_with(".csv")) name.resize(name.size() - 4);
    if (const BrdfKind* kind = find_brdf_kind(name)) return *kind;
    throw OptionError(fmt::format("{}: the name is no table's; expected one of {}, or one in front of the files", path, brdf_kind_names()));
}

/// Prints the verdict on one file; true if no row is beyond its tolerance. `stated` may be nullptr: then its name states the kind.
bool check(const std::string& path, const BrdfKind* stated) {
    std::string text = read_table_text(path);
    const BrdfKind& kind = stated ? *stated : kind_of(path);
    const std::string name = path == "-" ? "standard input" : path;
    const std::vector<Judgement> judgements = judge(kind, BrdfTable(name, std::move(text)));
    if (judgements.front().rows == 0) throw OptionError(fmt::format("{}: no rows", name));
    std::string out = name + "\n";
    bool good = true;
    for (std::size_t i = 0; i < judgements.size(); ++i) {
        const Judgement& j = judgements[i];
        out += fmt::format("  {:<15}{:>7} rows  largest {:.3g} at id {}  beyond {}\n", kind.judged[i].column, j.rows, j.largest,
                           j.largest_id, j.beyond);
        good = good && j.beyond == 0;
    }
    for (const Judgement& j : judgements) out += j.complaints;
    write_stdout(out);
    return good;
}

}  // namespace

int run_brdf_check(const Words& words) {
    const BrdfKind* stated = words.size() > 1 ? find_brdf_kind(words[0]) : nullptr;
    const Words files(words.begin() + (stated ? 1 : 0), words.end());
    if (files.empty()) throw OptionError("brdf check: expected a file; see raytrace brdf --help");
    int status = 0;
    const auto refused = [&](int its_status, const char* text) {  // the other files still count
        write_stderr(fmt::format("raytrace: {}\n", text));
        status = std::max(status, its_status);
    };
    for (const std::string& file : files) {
        try {
            if (!check(file, stated)) status = std::max(status, 1);
        } catch (const OptionError& error) {
            refused(1, error.what());
        } catch (const LimitError& error) {
            refused(4, error.what());
        }
    }
    return status;
}

}  // namespace rt
