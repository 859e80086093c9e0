#include "commands/pixel_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/encoding.h"
#include "commands/interrupt.h"
#include "commands/job_steps.h"
#include "commands/names.h"
#include "commands/pixel_page_rays.h"
#include "commands/ray_tree_values.h"
#include "commands/shell_words.h"
#include "commands/surroundings.h"
#include "commands/text.h"
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
constexpr std::size_t most_pixels = 60'000;

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

void ask(PixelPage& page) {
    for (const auto& [x, y] : page.request.pixels) {
        const PixelPlace place{x, row_from_top(page.job, y)};
        const std::optional<Region>& r = page.options.region;
        if (r && (place.x < r->x0 || place.x >= r->x1 || place.y < r->y0 || place.y >= r->y1))
            throw OptionError(fmt::format("pixel {},{} is outside of the part that --crop leaves", x, y));
        if (!page.asked.contains(place)) page.asked.places.push_back(place);
    }
}

/// The middle pixels of squares of `spacing` pixels, row by row, but for those asked for.
void lay_grid(PixelPage& page, int spacing) {
    page.spacing = spacing;
    page.grid.places.clear();
    if (spacing == 0) return;
    const Region region = page.options.region.value_or(Region{0, 0, page.job.width, page.job.height});
    const double count =
        std::ceil(region.width() / static_cast<double>(spacing)) * std::ceil(region.height() / static_cast<double>(spacing));
    if (count > most_pixels)
        throw LimitError(fmt::format("a page of {:.0f} traced pixels is too large, at most {} are possible: choose a larger --grid", count,
                                     most_pixels));
    for (int y = region.y0 + spacing / 2; y < region.y1; y += spacing)
        for (int x = region.x0 + spacing / 2; x < region.x1; x += spacing)
            if (!page.asked.contains({x, y})) page.grid.places.push_back({x, y});
}

/// The pixels asked for, and the grid asked for or one of the usual size.
void choose_pixels(PixelPage& page) {
    ask(page);
    const double pixels = static_cast<double>(page.job.width) * page.job.height;
    lay_grid(page, page.request.grid.value_or(std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / usual_pixels))))));
}

/// False after a stop.
bool trace(const PixelPage& page, TracedPixels& pixels, std::size_t most_of_a_pixel) {
    pixels.texts = pixel_texts(page.world, page.scene, page.options, pixels.places, most_of_a_pixel, most_rays);
    return pixels.texts.complete;
}

/// Traces the chosen pixels; the grid becomes coarser while it has more rays than a page bears, unless it was asked for. False after a
/// stop.
bool trace(PixelPage& page) {
    if (!trace(page, page.asked, most_of_an_asked_pixel) || !trace(page, page.grid, most_of_a_grid_pixel)) return false;
    while (!page.request.grid && page.grid.texts.rays > usual_rays && page.grid.places.size() > 1) {
        const double coarser = std::sqrt(static_cast<double>(page.grid.texts.rays) / static_cast<double>(usual_rays));
        lay_grid(page, std::max(page.spacing + 1, static_cast<int>(std::ceil(page.spacing * coarser))));
        if (!trace(page, page.grid, most_of_a_grid_pixel)) return false;
    }
    if (const std::size_t rays = page.asked.texts.rays + page.grid.texts.rays; rays > most_rays)
        throw LimitError(fmt::format("a page of {} rays is too large, at most {} are possible: choose a larger --grid or fewer pixels",
                                     rays, most_rays));
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
        lights.push_back({{"location", json_of(light.location)}, {"toward", toward}, {"color", json_of(light.color)}});
    }
    return lights;
}

Json working_of(const Encoding& encoding) {
    if (encoding.raw) return "raw";
    if (encoding.working.kind == Curve::Kind::srgb) return "srgb";
    return encoding.working.power;
}

Json head_of(const PixelPage& page) {
    const Sampling& sampling = page.options.sampling;
    const bool grid = sampling.method == Sampling::Method::grid;
    return {{"format", "raytrace pixel page 1"},
            {"version", program_version()},
            {"scene", page.job.scene},
            {"width", page.job.width},
            {"height", page.job.height},
            {"profile", name_of(profile_names, page.job.profile)},
            {"shading", shading_text(page.job)},
            {"camera", json_of(page.world.camera)},
            {"origin", page.job.profile == Profile::csc473 ? "bottom left" : "top left"},
            {"command", command_of(page.request)},
            {"working", working_of(encoding_of(page.job, page.scene.settings.gamma))},
            {"side", grid ? sampling.depth : 1},
            {"averaged", grid || sampling.method == Sampling::Method::none},
            {"lights", lights_of(page.world)},
            {"spacing", page.spacing}};
}

/// A pixel without its samples.
Json pixel_of(const PixelPage& page, const PixelPlace& place, const PixelText& text, bool asked) {
    const Pixel& light = page.film.at(place.x, place.y);
    Encoding encoding = encoding_of(page.job, page.scene.settings.gamma);
    encoding.bits = 8;
    return {{"x", place.x},
            {"y", row_from_top(page.job, place.y)},  // counting from the other end is its own inverse
            {"asked", asked},
            {"color", {quantise(light.r, encoding), quantise(light.g, encoding), quantise(light.b, encoding)}},
            {"radiance", {json_of(light.r), json_of(light.g), json_of(light.b)}},
            {"left_out", text.left_out}};
}

void append(std::string& text, const PixelPage& page, const TracedPixels& pixels, bool asked) {
    for (std::size_t i = 0; i < pixels.places.size(); ++i) {
        std::string pixel = line_of(pixel_of(page, pixels.places[i], pixels.texts.pixels[i], asked));
        pixel.pop_back();
        text += fmt::format("{}\n{},\"samples\":{}}}", asked && i == 0 ? "" : ",", pixel, pixels.texts.pixels[i].samples);
    }
}

std::string data_of(const PixelPage& page) {
    std::string text = line_of(head_of(page));
    text.pop_back();
    text += ",\n\"pixels\":[";
    append(text, page, page.asked, true);
    append(text, page, page.grid, false);
    return text + "\n]}\n";
}

/// False after a stop.
bool render_and_trace(PixelPage& page, const StopOnSignal& signals) {
    const MessageSink silent = message_sink(true);
    page.scene = read_scene(page.job, silent);
    page.world = build_world(page.job, page.scene, silent);
    page.options = render_options(page.job, page.scene);
    page.options.trace.environment = read_surroundings(page.job.environment);
    page.options.stop = &signals.stop();
    choose_pixels(page);
    RenderResult result = render(page.world, page.options);
    page.film = std::move(result.film);
    return result.complete && trace(page);
}

}  // namespace

int write_pixel_page(CourseArguments arguments) {
    PixelPage page;
    page.job = std::move(arguments.job);
    page.request = std::move(*arguments.page);
    check_file_target(page.request.file);
    const StopOnSignal signals;  // until the page is written, so that no half file stays
    if (!render_and_trace(page, signals)) {
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
