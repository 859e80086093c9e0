#include "tests/extremes/page.h"

#include <fmt/format.h>

#include <fstream>

#include "tests/extremes/page_pictures.h"

namespace rt::extremes {

namespace {

std::string counts(const Bytes& picture, const Bytes& truth) {
    return fmt::format("{} ({})", wrong(picture, truth).pixels, picture.non_finite);
}

/// The comment at the head of a scene, which says what it shows.
std::string subject(const std::string& name) {
    std::ifstream file(std::string(PROJECT_ROOT) + "/pov/extremes/" + name + ".pov");
    std::string line;
    std::getline(file, line);
    return line.size() > 3 ? line.substr(3) : line;
}

std::string section(const Judgement& j) {
    return fmt::format("<section id=\"{0}\"><h2>{0}</h2><p>{1}</p><div>\n", j.name, subject(j.name)) + image(j.png, "ours") +
           image(png(j.naive_single), "textbook, single precision") + image(png(difference(j.ours, j.truth)), "ours - truth") +
           image(png(difference(j.naive_single, j.truth)), "single - truth") + "</div></section>\n";
}

}  // namespace

std::string line(const Judgement& j) {
    return fmt::format("{:<34} {:>20} {:>20} {:>20}", j.name, counts(j.naive_single, j.truth), counts(j.naive_double, j.truth),
                       counts(j.ours, j.truth));
}

std::string page(const std::vector<Judgement>& judgements) {
    std::string text = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Shading at the extremes</title><style>
body { font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 74em; padding: 0 1em; background: #fff; color: #222 }
table { border-collapse: collapse } td, th { padding: .15em .8em; border-bottom: 1px solid #ddd; text-align: right }
td:first-child, th:first-child { text-align: left } .bad { color: #c00; font-weight: bold }
section div { display: flex; flex-wrap: wrap; gap: .6em } figure { margin: 0 } figcaption { color: #666 }
img { width: 258px; max-width: 100%; image-rendering: pixelated; background: #000 }
</style></head><body><h1>Shading at the extremes</h1>
<p>Each scene is rendered by the program, and by a second renderer with 113 bits, which is the truth. Beside them are the formulas as texts
print them, in single and in double precision; the rays that lead to them are in double. A pixel is wrong if a channel of its 8 bits is more
than one step from the truth; in brackets stand the pixels that are not a finite number. The lobes of 1e-8 radians need directions of more
than 24 bits, whatever the formulas; there the column of double precision shows what the formulas do. In the pictures of differences grey is
the truth itself, blue one step, yellow to red more.</p>
)";
    text += fmt::format("<p>Every picture has {} pixels.</p>\n", picture_width * picture_height);
    text += "<table><tr><th>scene<th>textbook, single<th>textbook, double<th>ours<th>ours, largest step</tr>\n";
    for (const Judgement& j : judgements) {
        const Wrong ours = wrong(j.ours, j.truth);
        text +=
            fmt::format("<tr><td><a href=\"#{0}\">{0}</a><td>{1}<td>{2}<td{5}>{3}<td>{4}</tr>\n", j.name, counts(j.naive_single, j.truth),
                        counts(j.naive_double, j.truth), counts(j.ours, j.truth), ours.steps, right(j) ? "" : " class=\"bad\"");
    }
    text += "</table>\n";
    for (const Judgement& j : judgements) text += section(j);
    return text + "</body></html>\n";
}

}  // namespace rt::extremes
