// raytrace brdf plot: a picture of the chosen terms.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "commands/base/command_line.h"
#include "commands/base/program.h"
#include "commands/base/svg_chart.h"
#include "commands/base/values.h"
#include "commands/brdf/brdf_curves.h"
#include "commands/commands.h"
#include "commands/help.h"
#include "commands/job/model_choices.h"
#include "core/source.h"
#include "film/output_file.h"
#include "shading/names.h"

namespace rt {

namespace {

using Specular = SurfaceModel::Specular;

/// Those keys of the catalogue that a picture of the lobe shows.
constexpr std::string_view shown_keys[] = {"preset", "material", "shading",     "D",           "G",     "F",         "eta",
                                           "k",      "f0",       "exponent",    "fresnel-arg", "half",  "norm",      "blinn-power",
                                           "units",  "dw",       "denominator", "raw",         "clamp", "phong-gate"};

constexpr std::string_view palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#7f7f7f"};
constexpr std::string_view channel_colors[] = {"#c00000", "#00902a", "#0040d0"};

struct Request {
    std::vector<ModelOption> choices;
    std::vector<double> alphas;  ///< none: the choice's own or the default ones
    double view = 45.0;
    std::string output = "-";
};

/// One curve of each chart.
struct Shown {
    SurfaceModel model;
    std::string_view color;
    double peak = 0.0;
    std::vector<Vec2> lobe;  ///< angle, and value / peak
};

void define(CommandLine& line, Request& request) {
    for (const ModelKey& key : model_keys()) {
        if (std::find(std::begin(shown_keys), std::end(shown_keys), key.key) == std::end(shown_keys)) continue;
        const std::string name(key.key);
        line.value("--" + name, std::string(key.values), "", [&request, name](const std::string& v) {
            if (name == "shading" && v == "povray") throw OptionError("brdf plot: POV-Ray's own finish model is not of the catalogue");
            ModelChoice scratch;
            choose(scratch, name, v);
            request.choices.push_back({name, v});
        });
    }
    line.value("--alpha", "X,Y,...", "widths, a curve each; 0.1,0.3,0.6", [&](const std::string& v) {
        request.alphas.clear();
        for (const std::string& word : split(v, ',')) request.alphas.push_back(real_number("alpha", word, 1e-8, 10.0));
        if (request.alphas.size() > std::size(palette)) throw OptionError(fmt::format("alpha: at most {} curves", std::size(palette)));
    });
    line.value("--view", "DEGREES", "angle between the viewer and the normal; 45",
               [&](const std::string& v) { request.view = real_number("view", v, 0.0, 89.9); });
    line.value("-o,--output", "FILE", "an SVG file; - (default) is standard output", [&](const std::string& v) {
        const std::string ending = std::filesystem::path(v).extension().string();
        if (!ending.empty() && lower_case(ending) != ".svg")
            throw OptionError(fmt::format("output: '{}' is not the ending of an SVG file; expected '.svg' or none", ending));
        request.output = v;
    });
}

ModelChoice choice_of(const Request& request) { return choice_for(Scene{}, {}, request.choices); }

/// The widths to show: one where the material or the exponent says it.
std::vector<double> widths_of(const Request& request, const ModelChoice& choice) {
    if (choice.model.specular == Specular::none) throw OptionError("brdf plot: shading 'none' has no lobe");
    const bool is_microfacet = choice.model.specular == Specular::microfacet;
    if (!is_microfacet && choice.exponent) {
        if (!request.alphas.empty()) throw OptionError("brdf plot: --exponent and --alpha both state the width of the lobe");
        return {std::sqrt(2.0 / (*choice.exponent + 2.0))};
    }
    if (!request.alphas.empty()) return request.alphas;
    if (!choice.alpha) return {0.1, 0.3, 0.6};
    if (*choice.alpha == 0.0) throw OptionError("brdf plot: alpha 0 is a mirror, which has no lobe; choose widths by --alpha");
    return {*choice.alpha};
}

std::vector<Shown> shown_by(const Request& request, const ModelChoice& choice) {
    std::vector<Shown> result;
    for (const double alpha : widths_of(request, choice)) {
        ModelChoice one = choice;
        one.alpha = alpha;
        Finish finish;
        finish.roughness = std::sqrt(alpha);
        Shown shown{.model = fill(one, finish, 1.5, AlphaMapping::direct), .color = palette[result.size()], .lobe = {}};
        for (const double angle : angles_around(request.view, alpha, -90.0, 90.0)) {
            const double value = lobe_at(shown.model, angle, request.view);
            shown.peak = std::max(shown.peak, value);
            shown.lobe.emplace_back(angle, value);
        }
        if (shown.peak > 0.0)
            for (Vec2& p : shown.lobe) p.y /= shown.peak;
        result.push_back(std::move(shown));
    }
    return result;
}

template <typename T, std::size_t N>
std::string_view name_in(const std::array<Named<T>, N>& table, T value) {
    for (const Named<T>& entry : table)
        if (entry.value == value) return entry.name;
    return "blinn, power 1/roughness";  // the one distribution that a variant chooses
}

std::string title_of(const SurfaceModel& model) {
    if (model.specular == Specular::phong) return "Phong's lobe (r.v)^p";
    if (model.specular == Specular::blinn_phong) return "Blinn-Phong's lobe (n.h)^p";
    return fmt::format("D {}   G {}   F {}", name_in(distribution_names, model.terms.D), name_in(masking_names, model.terms.G),
                       name_in(fresnel_names, model.terms.F));
}

/// Everything chosen, as it was written, and the interface that follows.
std::string subtitle_of(const Request& request, const SurfaceModel& model) {
    std::string text = fmt::format("view {:g}°", request.view);
    const auto channels = [&](const char* name, double Interface::*member) {
        const double r = model.interface[0].*member, g = model.interface[1].*member, b = model.interface[2].*member;
        text += r == g && r == b ? fmt::format(", {} {:.4g}", name, r) : fmt::format(", {} {:.4g}/{:.4g}/{:.4g}", name, r, g, b);
    };
    if (model.specular == Specular::microfacet) {
        channels("eta", &Interface::eta);
        channels("k", &Interface::k);
        channels("F0", &Interface::f0);
    }
    for (const ModelOption& option : request.choices)
        if (option.key.size() > 1 && option.key != "eta" && option.key != "f0") text += fmt::format(", {}={}", option.key, option.value);
    return text;
}

std::string polar_part(const Request& request, const std::vector<Shown>& all) {
    constexpr double radius = 210.0;
    const Vec2 center(255.0, 345.0);
    std::string svg;
    // Names stand a few pixels to their side, so that they are apart where the arrows are one.
    const auto arrow = [&](double degrees, const char* name, double aside, std::string_view anchor, std::string_view color) {
        const Vec2 way(std::sin(radians(degrees)), -std::cos(radians(degrees)));
        const Vec2 end = center + radius * 1.13 * way;
        svg += svg_line(center, center + radius * way, color, 1.5) + svg_text({end.x + aside, end.y, 14, anchor, color}, name);
    };
    arrow(-request.view, "v", -4.0, "end", "#222");
    arrow(request.view, "mirror", 4.0, "start", "#999");
    std::vector<ChartCurve> curves;
    for (const Shown& shown : all) curves.push_back({shown.color, false, shown.lobe});
    svg += svg_polar(center, radius, curves);
    const SurfaceModel& model = all[0].model;
    const bool cosine = model.specular == Specular::microfacet && !model.terms.without_cosine;
    const std::string value = model.specular != Specular::microfacet ? "the lobe" : cosine ? "n.l rs" : "rs";
    svg += svg_text({255, 394, 13, "middle"}, fmt::format("radius: {} over the angle of l, each curve divided by its maximum", value));
    double y = 424;
    for (const Shown& shown : all) {
        svg += svg_line({70, y - 4}, {105, y - 4}, shown.color, 3);
        const std::string width = model.specular == Specular::microfacet ? fmt::format("alpha {:g}", shown.model.alpha)
                                                                         : fmt::format("exponent {:.6g}", shown.model.exponent);
        svg += svg_text({115, y}, fmt::format("{}: maximum {:.4g}{}", width, shown.peak, cosine ? " / sr" : ""));
        y += 20;
    }
    if (!model.colorless) svg += svg_text({70, y + 4, 12}, "lobes by the luminance of the three channels");
    return svg;
}

/// D over the half angle: logarithmic, because peaks grow like 1 / alpha^2; the angle as well where a lobe would be thinner than a line.
/// `norm` multiplies it as it does the lobe.
std::string distribution_part(const Frame& frame, double norm, const std::vector<Shown>& all) {
    double narrowest = 1e9, highest = 0.0, lowest_peak = HUGE_VAL;
    std::vector<ChartCurve> curves;
    for (const Shown& shown : all) narrowest = std::min(narrowest, shown.model.alpha);
    const bool log_angle = narrowest < 0.05;
    const double least = log_angle ? std::pow(10.0, std::floor(std::log10(0.1 * narrowest * 180.0 / pi))) : 0.0;
    for (const Shown& shown : all) {
        ChartCurve curve{.color = shown.color, .points = {}};
        double peak = 0.0;
        for (const double angle : angles_around(0.0, narrowest, least, 90.0)) {
            curve.points.emplace_back(angle, norm * distribution_at(shown.model, angle));
            // At the horizon a width above 1 may be without bounds.
            if (angle < 89.5) peak = std::max(peak, curve.points.back().y);
        }
        highest = std::max(highest, peak);
        lowest_peak = std::min(lowest_peak, peak);
        curves.push_back(std::move(curve));
    }
    const double top = std::pow(10.0, std::ceil(std::log10(highest))), bottom = std::pow(10.0, std::floor(std::log10(lowest_peak)) - 4.0);
    return svg_chart(frame, norm == 1.0 ? "D" : fmt::format("{:g} D", norm), {least, 90.0, log_angle, "half angle, degrees", 15.0},
                     {bottom, top, true, "1 / sr, logarithmic", 0.0}, curves);
}

std::string masking_part(const Frame& frame, const Request& request, const std::vector<Shown>& all) {
    std::vector<ChartCurve> curves;
    for (const Shown& shown : all) {
        curves.push_back({.color = shown.color, .points = {}});
        for (const double angle : angles_around(90.0, 0.01, -90.0, 90.0))
            curves.back().points.emplace_back(angle, masking_at(shown.model, angle, request.view));
    }
    return svg_chart(frame, "G", {-90.0, 90.0, false, fmt::format("angle of l, degrees; view at {:g}", 0.0 - request.view), 30.0},
                     {0.0, 1.0, false, "", 0.25}, curves);
}

std::string fresnel_part(const Frame& frame, const SurfaceModel& model) {
    std::vector<ChartCurve> curves;
    for (int channel = 0; channel < (model.colorless ? 1 : 3); ++channel) {
        curves.push_back({.color = model.colorless ? "#222" : channel_colors[channel], .points = {}});
        for (const double angle : angles_around(90.0, 0.01, 0.0, 90.0))
            curves.back().points.emplace_back(angle, fresnel_at(model, channel, angle));
    }
    return svg_chart(frame, "F", {0.0, 90.0, false, "angle of incidence, degrees", 15.0},
                     {0.0, 1.0, false, model.colorless ? "" : "red, green, blue", 0.25}, curves);
}

std::string plot(const Request& request) {
    const ModelChoice choice = choice_of(request);
    const std::vector<Shown> all = shown_by(request, choice);
    const SurfaceModel& model = all[0].model;
    std::string svg = svg_text({30, 32, 19}, title_of(model)) + svg_text({30, 54, 13}, subtitle_of(request, model));
    svg += polar_part(request, all);
    if (model.specular != Specular::microfacet) return svg_document(520, 620, svg);
    svg += distribution_part({590, 90, 380, 135}, choice.norm, all);
    svg += masking_part({590, 288, 380, 120}, request, all);
    svg += fresnel_part({590, 471, 380, 120}, model);
    return svg_document(1000, 640, svg);
}

}  // namespace

int run_brdf_plot(const Words& words) {
    CommandLine line(brdf_plot_usage, brdf_plot_footer);
    Request request;
    define(line, request);
    const Words rest = line.parse(words);
    if (line.help_asked()) {
        write_stdout(line.help());
        return 0;
    }
    if (!rest.empty()) throw OptionError(fmt::format("brdf plot: unexpected '{}'; see raytrace brdf plot --help", rest[0]));
    const std::string svg = plot(request);
    OutputFile file(request.output);
    file.write(svg.data(), svg.size());
    file.commit();
    return 0;
}

}  // namespace rt
