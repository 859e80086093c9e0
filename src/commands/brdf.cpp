// raytrace brdf: the shading functions on tables of inputs, and their values against known ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "commands/brdf_rows.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/text.h"
#include "commands/values.h"
#include "core/source.h"
#include "shading/integrals.h"
#include "shading/names.h"

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

/// What the integrals are asked for; an unset term means all of its kind.
struct IntegralRequest {
    std::optional<Distribution> D;
    std::optional<Masking> G;
    std::vector<double> alphas{0.05, 0.1, 0.25, 0.5, 1.0};
};

void define_integrals(CommandLine& line, IntegralRequest& request) {
    const auto known = [](const auto& table, std::string_view what, const std::string& name) {
        const auto value = find_named(table, name);
        if (!value) throw OptionError(fmt::format("'{}' is no {}; expected one of {}", name, what, known_names(table)));
        return *value;
    };
    line.value("--D", "NAME", "distribution of the integrals; all of them",
               [&, known](const std::string& v) { request.D = known(distribution_names, "D", v); });
    line.value("--G", "NAME", "masking of the albedo; all of them",
               [&, known](const std::string& v) { request.G = known(masking_names, "G", v); });
    line.value("--alpha", "X,Y,...", "widths; 0.05,0.1,0.25,0.5,1", [&](const std::string& v) {
        request.alphas.clear();
        for (const std::string& word : split(v, ',')) request.alphas.push_back(real_number("alpha", word, 1e-8, 10.0));
    });
}

std::string alpha_heading(const IntegralRequest& request, std::string_view first) {
    std::string text = fmt::format("{:<28}", first);
    for (const double alpha : request.alphas) text += fmt::format("  alpha {:<14g}", alpha);
    return text + "\n";
}

int print_normalization(const IntegralRequest& request) {
    std::string text = "integral of D (n.m) over the hemisphere; 1 if normalised\n" + alpha_heading(request, "D");
    for (const auto& entry : distribution_names) {
        if (request.D && *request.D != entry.value) continue;
        text += fmt::format("{:<28}", entry.name);
        for (const double alpha : request.alphas) text += fmt::format("  {:<20.15g}", normalization(entry.value, alpha));
        text += "\n";
    }
    write_stdout(text);
    return 0;
}

int print_albedo(const IntegralRequest& request) {
    std::string text = "directional albedo with F = 1 at n.v = 1 / 0.5 / 0.1\n" + alpha_heading(request, "D, G");
    for (const auto& D : distribution_names) {
        if (request.D && *request.D != D.value) continue;
        for (const auto& G : masking_names) {
            if (request.G && *request.G != G.value) continue;
            text += fmt::format("{:<28}", fmt::format("{}, {}", D.name, G.name));
            for (const double alpha : request.alphas) {
                const auto at = [&](double n_dot_v) { return directional_albedo(D.value, G.value, alpha, n_dot_v); };
                text += fmt::format("  {:<20}", fmt::format("{:.3f}/{:.3f}/{:.3f}", at(1.0), at(0.5), at(0.1)));
            }
            text += "\n";
        }
    }
    write_stdout(text);
    return 0;
}

}  // namespace

int run_brdf(const Words& words) {
    if (!words.empty() && words[0] == "plot") return run_brdf_plot({words.begin() + 1, words.end()});
    CommandLine line(brdf_usage, brdf_footer);
    IntegralRequest request;
    define_integrals(line, request);
    const Words rest = line.parse(words);
    if (line.help_asked()) {
        write_stdout(line.help());
        return 0;
    }
    const std::string action = rest.empty() ? "" : rest[0];
    const bool for_albedo = action == "albedo", for_integral = for_albedo || action == "normalization";
    if ((request.G && !for_albedo) || ((request.D || request.alphas != IntegralRequest{}.alphas) && !for_integral))
        throw OptionError("brdf: --D and --alpha are for normalization and albedo, --G for albedo");
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
    if (action == "normalization" && rest.size() == 1) return print_normalization(request);
    if (action == "albedo" && rest.size() == 1) return print_albedo(request);
    throw OptionError(fmt::format("brdf: expected 'eval', 'check', 'normalization', 'albedo' or 'plot'{}; see raytrace brdf --help",
                                  action.empty() ? "" : fmt::format(" instead of '{}'", action)));
}

}  // namespace rt
