// raytrace brdf: the shading functions on tables of inputs, and their integrals.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "commands/base/command_line.h"
#include "commands/base/program.h"
#include "commands/base/values.h"
#include "commands/brdf/brdf_rows.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "core/source.h"
#include "shading/integrals.h"
#include "shading/names.h"

namespace rt {

namespace {

/// Copies the table with a column got_X behind each row for every X that the kind has.
int evaluate(const std::string& name) {
    const BrdfKind* found = find_brdf_kind(name);
    if (!found) throw OptionError(fmt::format("brdf eval: no table '{}'; expected one of {}", name, brdf_kind_names()));
    const BrdfKind& kind = *found;
    const BrdfTable table("standard input", read_table_text("-"));
    for (const std::string_view cell : table.header().cells)
        if (cell.starts_with("got_") && std::find(kind.columns.begin(), kind.columns.end(), cell.substr(4)) != kind.columns.end())
            table.fail(table.header(), fmt::format("column '{}' is there already: take an earlier evaluation's columns out first", cell));
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
        return evaluate(rest[1]);
    }
    if (action == "check") return run_brdf_check({rest.begin() + 1, rest.end()});
    if (action == "normalization" && rest.size() == 1) return print_normalization(request);
    if (action == "albedo" && rest.size() == 1) return print_albedo(request);
    throw OptionError(fmt::format("brdf: expected 'eval', 'check', 'normalization', 'albedo' or 'plot'{}; see raytrace brdf --help",
                                  action.empty() ? "" : fmt::format(" instead of '{}'", action)));
}

}  // namespace rt
