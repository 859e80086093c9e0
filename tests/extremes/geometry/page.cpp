#include "tests/extremes/geometry/page.h"

#include <fmt/format.h>

#include <fstream>

#include "tests/extremes/page_pictures.h"

namespace rt::extremes {

namespace {

struct Column {
    const char* name;
    const Bytes* picture;  ///< null: the program refused the scene, or is not installed
};

std::vector<Column> columns(const Verdict& v) {
    std::vector<Column> result;
    for (std::size_t i = 0; i < settings.size(); ++i) result.push_back({settings[i].name, &v.ours[i]});
    result.push_back({"textbook, single", &v.textbook_single});
    result.push_back({"textbook, double", &v.textbook_double});
    result.push_back({"POV-Ray", v.povray ? &*v.povray : nullptr});
    return result;
}

std::string cell(const Verdict& v, const Bytes* picture) {
    if (picture == nullptr) return v.povray_refuses ? "refuses" : "-";
    const Count c = count(*picture, v.truth);
    std::string text = fmt::format("{}", c.wrong);
    if (c.wrong > 0) text += fmt::format(" ({}, {})", c.speckles, c.lost);
    if (c.non_finite > 0) text += fmt::format(" {} nan", c.non_finite);
    return text;
}

/// The comment at the head of a scene, which says what it shows.
std::string solid_subject(const std::string& name) {
    std::ifstream file(std::string(PROJECT_ROOT) + "/pov/extremes/geometry/" + name + ".pov");
    std::string line;
    std::getline(file, line);
    return line.size() > 3 ? line.substr(3) : line;
}

std::string section(const Verdict& v) {
    std::string text = fmt::format("<section id=\"{0}\"><h2>{0}</h2><p>{1}</p><div>\n", v.truth.name, solid_subject(v.truth.name));
    text += image(png(v.truth.picture), "truth");
    for (const Column& column : columns(v)) {
        if (column.picture == nullptr || count(*column.picture, v.truth).wrong == 0) continue;
        text += image(png(*column.picture), column.name);
        text += image(png(difference(*column.picture, v.truth.picture)), fmt::format("{} - truth", column.name));
    }
    return text + "</div></section>\n";
}

}  // namespace

std::string geometry_head() {
    std::string text = fmt::format("{:<18} {:>8}", "wrong pixels", "unjudged");
    for (const Column& column : columns({})) text += fmt::format(" {:>16}", column.name);
    return text;
}

std::string geometry_line(const Verdict& v) {
    std::string text = fmt::format("{:<18} {:>8}", v.truth.name, v.truth.unstable);
    for (const Column& column : columns(v)) text += fmt::format(" {:>16}", cell(v, column.picture));
    return text;
}

std::string geometry_page(const std::vector<Verdict>& verdicts) {
    std::string text = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Geometry at the extremes</title><style>
body { font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 78em; padding: 0 1em; background: #fff; color: #222 }
table { border-collapse: collapse } td, th { padding: .15em .8em; border-bottom: 1px solid #ddd; text-align: right }
td:first-child, th:first-child { text-align: left } .bad { color: #c00; font-weight: bold }
section div { display: flex; flex-wrap: wrap; gap: .6em } figure { margin: 0 } figcaption { color: #666 }
img { width: 192px; max-width: 100%; image-rendering: pixelated; background: #000 }
</style></head><body><h1>Geometry at the extremes</h1>
<p>Each scene is rendered by the program under four settings (--precision, --distances), by formulas as texts print them in single and in
double precision, by POV-Ray where it is installed, and by a reference with 113 bits that asks every surface and moves no ray off what it
leaves; that is the truth. It starts from the doubles that the parser delivers. A pixel is wrong if a channel of its 8 bits is more than one
step from the truth; in brackets stand those most of whose neighbours are right, and the objects of whose pixels most are wrong. Pixels are
not judged whose true value changes when the camera moves sideways by 2^-46 of the scene's largest coordinate, or when of surfaces nearer
than 2^-52 of it the other one is met: silhouettes and ties. "refuses" is a scene that POV-Ray does not read. In the pictures of
differences grey is the truth itself, blue one step, yellow to red more.</p>
)";
    text += fmt::format("<p>Every picture has {} pixels.</p>\n<table><tr><th>scene<th>unjudged", geometry_width * geometry_height);
    for (const Column& column : columns({})) text += fmt::format("<th>{}", column.name);
    text += "</tr>\n";
    for (const Verdict& v : verdicts) {
        text += fmt::format("<tr><td><a href=\"#{0}\">{0}</a><td>{1}", v.truth.name, v.truth.unstable);
        for (const Column& column : columns(v)) {
            const std::string value = cell(v, column.picture);
            text += fmt::format("<td{}>{}", value == "0" || value == "-" ? "" : " class=\"bad\"", value);
        }
        text += "</tr>\n";
    }
    text += "</table>\n";
    for (const Verdict& v : verdicts) text += section(v);
    return text + "</body></html>\n";
}

}  // namespace rt::extremes
