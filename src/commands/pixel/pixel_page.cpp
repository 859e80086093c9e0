#include "commands/pixel/pixel_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/base/interrupt.h"
#include "commands/base/json_text.h"
#include "commands/base/names.h"
#include "commands/base/program.h"
#include "commands/base/shell_words.h"
#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/job/surroundings.h"
#include "commands/job/text.h"
#include "commands/pixel/pixel_page_rays.h"
#include "commands/pixel/ray_tree_values.h"
#include "film/image_file.h"
#include "film/output_file.h"
#include "pages/page.h"

namespace rt {

namespace {

/// A ray is about a kilobyte of the page: a grid that we choose brings 3 MB of them, a page at most 60.
constexpr double usual_pixels = 1200.0;
constexpr std::size_t usual_rays = 3000;
constexpr std::size_t most_rays = 60'000;
constexpr std::size_t most_of_an_asked_pixel = 500, most_of_a_grid_pixel = 100;

struct TracedPixels {
    std::vector<PixelPlace> places;
    PixelTexts texts;
    bool contains(const PixelPlace& place) const { return std::find(places.begin(), places.end(), place) != places.end(); }
};

/// Everything that the page tells of.
struct PixelPage {
    RenderJob job;
    PixelPageRequest request;
    Scene scene;
    World world;
    RenderOptions options;
    Film film;
    int spacing = 0;
    TracedPixels asked, grid;
};

[[noreturn]] void refuse(std::string_view how_many) {
    throw LimitError(fmt::format("a page of {} rays is too large, at most {} are possible: choose a larger --grid or fewer pixels",
                                 how_many, most_rays));
}

Region region_of(const PixelPage& page) { return page.options.region.value_or(Region{0, 0, page.job.width, page.job.height}); }

/// How many rays it has at least.
std::size_t samples_of_pixel(const PixelPage& page) {
    const auto side = static_cast<std::size_t>(samples_a_side(page.options.sampling));
    return side * side;
}

void ask(PixelPage& page) {
    const Region region = region_of(page);
    for (const auto& [x, y] : page.request.pixels) {
        const PixelPlace place{x, row_from_top(page.job, y)};
        if (place.x < region.x0 || place.x >= region.x1 || place.y < region.y0 || place.y >= region.y1)
            throw OptionError(fmt::format("pixel {},{} is outside of the part that --crop leaves", x, y));
        if (!page.asked.contains(place)) page.asked.places.push_back(place);
    }
    const std::size_t least = page.asked.places.size() * samples_of_pixel(page);
    if (least > most_rays) refuse(fmt::format("{} or more", least));
}

/// The middles of squares of `spacing` pixels side by side in [begin, end), or of what is narrower than a square.
std::vector<int> middles(int begin, int end, int spacing) {
    std::vector<int> places;
    for (int at = begin + std::min(spacing, end - begin) / 2; at < end; at += spacing) places.push_back(at);
    return places;
}

/// The middle pixels of squares of `spacing` pixels, row by row, but for those asked for. None for a spacing of 0.
void lay_grid(PixelPage& page, int spacing) {
    page.spacing = spacing;
    page.grid.places.clear();
    if (spacing == 0) return;
    const Region region = region_of(page);
    const std::vector<int> columns = middles(region.x0, region.x1, spacing), rows = middles(region.y0, region.y1, spacing);
    const std::size_t least = columns.size() * rows.size() * samples_of_pixel(page);
    if (page.request.grid && least > most_rays) refuse(fmt::format("{} or more", least));
    for (const int y : rows)
        for (const int x : columns)
            if (!page.asked.contains({x, y})) page.grid.places.push_back({x, y});
}

/// The pixels asked for, and the grid asked for or one of the usual size.
void choose_pixels(PixelPage& page) {
    ask(page);
    if (page.request.grid) return lay_grid(page, *page.request.grid);
    const Region region = region_of(page);
    const double area = static_cast<double>(region.width()) * region.height();
    const double pixels = std::min(usual_pixels, static_cast<double>(usual_rays) / static_cast<double>(samples_of_pixel(page)));
    lay_grid(page, std::max(1, static_cast<int>(std::lround(std::sqrt(area / pixels)))));
}

/// False after a stop.
bool trace(const PixelPage& page, TracedPixels& pixels, std::size_t most_of_a_pixel) {
    pixels.texts = pixel_texts(page.world, page.scene, page.options, pixels.places, most_of_a_pixel, most_rays);
    return !pixels.texts.stopped;
}

/// Traces the chosen pixels; the grid becomes coarser while it has more rays than a page bears, unless it was asked for. False after a
/// stop.
bool trace(PixelPage& page) {
    if (!trace(page, page.asked, most_of_an_asked_pixel)) return false;
    if (page.asked.texts.too_many) refuse(fmt::format("more than {}", most_rays));
    if (!trace(page, page.grid, most_of_a_grid_pixel)) return false;
    while (!page.request.grid && page.grid.texts.rays > usual_rays && page.grid.places.size() > 1) {
        const double coarser = std::sqrt(static_cast<double>(page.grid.texts.rays) / static_cast<double>(usual_rays));
        lay_grid(page, std::max(page.spacing + 1, static_cast<int>(std::ceil(page.spacing * coarser))));
        if (!trace(page, page.grid, most_of_a_grid_pixel)) return false;
    }
    if (page.grid.texts.too_many || page.asked.texts.rays + page.grid.texts.rays > most_rays)
        refuse(fmt::format("more than {}", most_rays));
    return true;
}

Json command_of(const PixelPageRequest& request) {
    Json words = {"raytrace", "pixeltrace"};
    for (const std::string& word : request.words) words.push_back(shell_word(word));
    return {{"words", words}, {"x", request.x_word + 2}, {"y", request.y_word + 2}};
}

Json lights_of(const World& world) {
    Json lights = Json::array();
    for (const Light& light : world.lights) {
        const Json toward = light.parallel ? json_of(unit(light.location - light.point_at)) : Json(nullptr);
        lights.push_back({{"location", json_of(light.location)}, {"toward", toward}});
    }
    return lights;
}

Json curve_json(const Curve& curve) { return curve.kind == Curve::Kind::srgb ? Json("srgb") : Json(curve.power); }

Json encoding_json(const Encoding& encoding) {
    return {{"raw", encoding.raw}, {"working", curve_json(encoding.working)}, {"file", curve_json(encoding.file)}};
}

Json head_of(const PixelPage& page) {
    const Sampling& sampling = page.options.sampling;
    return {{"version", program_version()},
            {"scene", page.job.scene},
            {"width", page.job.width},
            {"height", page.job.height},
            {"profile", name_of(profile_names, page.job.profile)},
            {"shading", shading_text(page.job)},
            {"camera", json_of(page.world.camera)},
            {"origin", page.job.profile == Profile::csc473 ? "bottom left" : "top left"},
            {"command", command_of(page.request)},
            {"encoding", encoding_json(encoding_of(page.job, page.scene.settings.gamma))},
            {"side", samples_a_side(sampling)},
            {"averaged", sampling.method == Sampling::Method::grid || sampling.method == Sampling::Method::none},
            {"lights", lights_of(page.world)},
            {"spacing", page.grid.places.empty() ? 0 : page.spacing}};
}

/// A pixel without its samples.
Json pixel_of(const PixelPage& page, const PixelPlace& place, const PixelText& text, bool asked) {
    const Pixel& light = page.film.at(place.x, place.y);
    return {{"x", place.x},
            {"y", row_from_top(page.job, place.y)},  // counting from the other end is its own inverse
            {"asked", asked},
            {"radiance", {json_of(light.r), json_of(light.g), json_of(light.b)}},
            {"left_out", text.left_out}};
}

void append(std::string& text, const PixelPage& page, const TracedPixels& pixels, bool asked) {
    for (std::size_t i = 0; i < pixels.places.size(); ++i) {
        std::string pixel = json_line(pixel_of(page, pixels.places[i], pixels.texts.pixels[i], asked));
        pixel.pop_back();
        text += fmt::format("{}\n{},\"samples\":{}}}", asked && i == 0 ? "" : ",", pixel, pixels.texts.pixels[i].samples);
    }
}

std::string data_of(const PixelPage& page) {
    std::string text = json_line(head_of(page));
    text.pop_back();
    text += ",\n\"pixels\":[";
    append(text, page, page.asked, true);
    append(text, page, page.grid, false);
    return text + "\n]}\n";
}

/// Throws OptionError if the page would take the place of something that it is made of.
void check_inputs(const PixelPage& page) {
    std::vector<std::string> inputs = page.job.environment;
    for (std::uint32_t i = 0; i < page.scene.sources.size(); ++i) inputs.push_back(page.scene.sources.file(i).name);
    for (const std::string& input : inputs)
        if (same_file(page.request.file, input))
            throw OptionError(
                fmt::format("--html {}: the page would take the place of '{}', which it is made of", page.request.file, input));
}

/// False after a stop. The rays come first: a page of too many is refused before anyone has waited for its picture.
bool trace_and_render(PixelPage& page, const StopOnSignal& signals) {
    const MessageSink silent = message_sink(true);
    page.scene = read_scene(page.job, silent);
    check_inputs(page);
    page.world = build_world(page.job, page.scene, silent);
    page.options = render_options(page.job, page.scene);
    page.options.trace.environment = read_surroundings(page.job.environment);
    page.options.stop = &signals.stop();
    choose_pixels(page);
    if (!trace(page)) return false;
    RenderResult result = render(page.world, page.options);
    page.film = std::move(result.film);
    return result.complete;
}

}  // namespace

int write_pixel_page(CourseArguments arguments) {
    PixelPage page;
    page.job = std::move(arguments.job);
    page.request = std::move(*arguments.page);
    check_file_target(page.request.file);
    const StopOnSignal signals;  // until the page is written, so that no half file stays
    if (!trace_and_render(page, signals)) {
        write_stderr("raytrace: interrupted\n");
        return exit_interrupted;
    }
    const std::string png = png_bytes(page.film, encoding_of(page.job, page.scene.settings.gamma), picture_metadata(page.job, page.scene));
    const std::string text = assemble_page({"pixel_page.html", data_of(page), {{"render", png}}});
    OutputFile file(page.request.file);
    file.write(text.data(), text.size());
    file.commit();
    return 0;
}

}  // namespace rt
