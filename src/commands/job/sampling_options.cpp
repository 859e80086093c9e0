#include "commands/job/render_draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/base/values.h"
#include "core/source.h"

namespace rt {

/// Where --time has nothing more to gain: an eighth of the steps of 8 bits.
constexpr double error_below_sight = 1.0 / 2048.0;

void define_sampling(CommandLine& line, RenderDraft& d) {
    Sampling& sampling = d.job.sampling;
    line.value("--ss", "N", "N x N samples in every pixel", [&](const std::string& v) { d.grid = whole_number("ss", v, 1, 64); });
    const auto method = [&d, &sampling](const std::string& v) {
        sampling.method = whole_number("anti-aliasing method", v, 1, 2) == 1 ? Sampling::Method::povray1 : Sampling::Method::povray2;
    };
    const auto threshold = [&sampling](const std::string& v) {
        sampling.threshold = std::clamp(real_number("anti-aliasing threshold", v, 0.0, unbounded), 0.0, 1.0);
    };
    const auto depth = [&sampling](const std::string& v) {
        sampling.depth = std::min(9, whole_number("anti-aliasing depth", v, 1, largest_side));
    };
    line.value("--aa", "M[,T[,R]]", "POV-Ray's method 1 or 2, threshold T, depth R", [=, &d](const std::string& v) {
        const std::vector<std::string> parts = split(v, ',');
        if (parts.size() > 3) throw OptionError(fmt::format("aa: expected METHOD,THRESHOLD,DEPTH, not '{}'", v));
        method(parts[0]);
        if (parts.size() > 1) threshold(parts[1]);
        if (parts.size() > 2) depth(parts[2]);
        d.antialias = true;
        if (!d.jitter) d.jitter = false;
    });
    line.value("--max-error", "E", "", [&](const std::string& v) { d.max_error = real_number("max-error", v, 1e-4, 1.0); });
    line.value("--time", "S", "the best picture within S seconds",
               [&](const std::string& v) { d.job.time = real_number("time", v, 0.01, 1e6); });
    line.flag("--preview", "write a coarse picture at once, then refine it", [&] { d.job.preview = true; });
    line.value("--antialias", "ON", "", [&](const std::string& v) { d.antialias = on_or_off("Antialias", v); });
    line.value("--aa-method", "M", "", method);
    line.value("--aa-threshold", "T", "", threshold);
    line.value("--aa-depth", "R", "", depth);
    line.value("--aa-gamma", "G", "", [&](const std::string& v) { sampling.gamma = real_number("anti-aliasing gamma", v, 1e-3, 1e3); });
    line.value("--aa-block", "N", "",
               [&](const std::string& v) { sampling.block = std::max(4, whole_number("block size", v, 0, largest_side)); });
    line.value("--jitter", "ON", "", [&](const std::string& v) { d.jitter = on_or_off("Jitter", v); });
    line.value("--jitter-amount", "X", "",
               [&](const std::string& v) { d.jitter_amount = real_number("jitter amount", v, 0.0, unbounded); });
    line.value("--povray-quality", "N", "", [&](const std::string& v) {
        d.job.povray_quality = std::clamp(whole_number("quality", v, -largest_side, largest_side), 0, 11);
    });
}

bool chooses_samples(const RenderDraft& d) { return d.antialias || d.grid || d.max_error; }

void choose_sampling(RenderDraft& d) {
    Sampling& sampling = d.job.sampling;
    const Sampling::Method method = sampling.method == Sampling::Method::none ? Sampling::Method::povray1 : sampling.method;
    sampling.method = d.antialias ? method : Sampling::Method::none;
    if (d.grid) {
        if (d.antialias) throw OptionError("-ss and anti-aliasing (+A, --aa) both choose the samples of a pixel; give one of them");
        sampling.method = *d.grid > 1 ? Sampling::Method::grid : Sampling::Method::none;
        sampling.depth = *d.grid;
    }
    if (d.max_error || d.job.time) {
        if (d.grid || d.antialias)
            throw OptionError(fmt::format("{} and --ss or anti-aliasing (+A, --aa) both choose the samples of a pixel; give one of them",
                                          d.max_error ? "--max-error" : "--time"));
        sampling.method = Sampling::Method::adaptive;
        sampling.max_error = d.max_error.value_or(error_below_sight);
    }
    if (d.job.scale > 1) {
        const std::string_view other = d.max_error ? "--max-error" : d.job.time ? "--time" : d.job.preview ? "--preview" : "";
        if (!other.empty()) throw OptionError(fmt::format("{} and --scale both choose which pixels are traced; give one of them", other));
    }
    if (!d.antialias) return;
    if (!d.jitter && !d.jitter_amount)
        d.job.notes.emplace_back("anti-aliasing is rendered without jitter, as with -J");
    else if (d.jitter.value_or(true) && d.jitter_amount.value_or(1.0) > 0.0)
        d.job.notes.emplace_back("jitter is not available in this version: anti-aliasing is rendered as with -J");
}

}  // namespace rt
