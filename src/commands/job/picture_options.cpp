#include "commands/job/render_draft.h"

#include <fmt/format.h>

#include "commands/base/names.h"
#include "commands/base/values.h"
#include "core/source.h"

namespace rt {

void define_picture(CommandLine& line, RenderDraft& d) {
    RenderJob& job = d.job;
    line.value("-o,--output,--outfile", "FILE", "picture; the ending chooses the type; - is stdout", [&](const std::string& v) {
        job.output.name = v;
        job.output.povray_rules = false;
    });
    line.value("--povray-output", "FILE", "", [&](const std::string& v) {
        job.output.name = v;
        job.output.povray_rules = true;
    });
    line.value("--format", "TYPE", "png, exr, hdr, tiff, jpeg, ppm, tga or bmp",
               [&](const std::string& v) { job.output.format = value_of_name(format_names, "picture format", v); });
    line.value("--povray-type", "TYPE", "", [&](const std::string& v) { job.output.format = povray_file_type(v, job.bits); });
    line.value("--bits", "N", "", [&](const std::string& v) { job.bits = whole_number("bits per colour", v, 1, most_bits); });
    line.value("--output-to-file", "ON", "", [&](const std::string& v) { job.output.to_file = on_or_off("Output_to_File", v); });
    line.value("--output-alpha", "ON", "", [&](const std::string& v) { job.output_alpha = on_or_off("Output_Alpha", v); });
    line.value("-W,--width", "N", "columns (800)", [&](const std::string& v) { job.width = whole_number("width", v, 1, largest_side); });
    line.value("-H,--height", "N", "rows (600)", [&](const std::string& v) { job.height = whole_number("height", v, 1, largest_side); });
    line.value("--size", "WxH", "", [&](const std::string& v) {
        const std::vector<std::string> sides = split(lower_case(v), 'x');
        if (sides.size() != 2) throw OptionError(fmt::format("size: expected WIDTHxHEIGHT, not '{}'", v));
        job.width = whole_number("width", sides[0], 1, largest_side);
        job.height = whole_number("height", sides[1], 1, largest_side);
    });
    line.value("--crop", "X0,X1,Y0,Y1", "", [&](const std::string& v) {
        const std::vector<std::string> ends = split(v, ',');
        if (ends.size() != 4) throw OptionError(fmt::format("crop: expected X0,X1,Y0,Y1, not '{}'", v));
        const auto edge = [&](int i) { return whole_number("crop", ends[static_cast<std::size_t>(i)], 0, largest_side); };
        d.crop = Region{edge(0), edge(2), edge(1), edge(3)};
    });
    const auto edge = [&line](const char* name, std::optional<double>& place) {
        line.value(name, "N", "", [name, &place](const std::string& v) { place = real_number(name + 2, v, 0.0, largest_side); });
    };
    edge("--start-column", d.edges.start_column);
    edge("--end-column", d.edges.end_column);
    edge("--start-row", d.edges.start_row);
    edge("--end-row", d.edges.end_row);
    line.value("--file-gamma", "G", "", [&](const std::string& v) {
        const bool srgb = lower_case(v) == "srgb";
        job.file_gamma = srgb ? Curve{Curve::Kind::srgb, 1.0} : Curve{Curve::Kind::power, real_number("file gamma", v, 1e-3, 1e3)};
    });
    line.value("--dither", "ON", "", [&](const std::string& v) { job.dither = on_or_off("dither", v); });
    line.value("--dither-method", "NAME", "", [&](const std::string& v) {
        for (const char* known : {"FS", "B2", "B3", "B4", "D1", "D2"})
            if (lower_case(v) == lower_case(known)) return void(d.dither_method = known);
        throw OptionError(fmt::format("'{}' is no dithering method; expected one of FS, B2, B3, B4, D1, D2", v));
    });
}

void check_dithering(const RenderDraft& d) {
    const std::string& method = d.dither_method;
    if (!d.job.dither || method.empty() || method == "FS") return;
    throw OptionError(fmt::format("dithering method {} is not available in this version; FS (Floyd-Steinberg) is", method));
}

void choose_region(RenderDraft& d) {
    d.job.region = resolve_region(d.edges, d.job.width, d.job.height);
    if (!d.crop) return;
    if (d.job.region) throw OptionError("--crop and +SC +EC +SR +ER both choose the region; give one of them");
    const Region& r = *d.crop;
    if (r.x0 >= r.x1 || r.y0 >= r.y1 || r.x1 > d.job.width || r.y1 > d.job.height)
        throw OptionError(fmt::format("crop: columns {} to {} and rows {} to {} are no part of a {} x {} picture", r.x0, r.x1, r.y0, r.y1,
                                      d.job.width, d.job.height));
    d.job.region = r;
}

}  // namespace rt
