#include "commands/trade/instability.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/trade/instability_scene.h"
#include "trace/camera.h"

namespace rt {

namespace {

constexpr double larger = 1.0 + 0x1p-40;
constexpr double one_step = 1.0 / 255.0;

Rounding rounding_of(Variant variant) {
    switch (variant) {
        case Variant::downward:
            return Rounding::downward;
        case Variant::upward:
            return Rounding::upward;
        case Variant::toward_zero:
            return Rounding::toward_zero;
        case Variant::scaled:
            break;
    }
    return Rounding::nearest;
}

World build(const RenderJob& job, const Scene& scene, Rounding rounding) {
    const RoundingScope scope(rounding);
    return build_world(job, scene, message_sink(true));
}

/// The largest difference of a channel as displays show it, 0..1; transmittance as it is.
double moved(const Pixel& a, const Pixel& b, const Encoding& encoding) {
    const auto shown = [&](float v) { return std::clamp(encode(v, encoding), 0.0, 1.0); };
    return std::max({std::fabs(shown(a.r) - shown(b.r)), std::fabs(shown(a.g) - shown(b.g)), std::fabs(shown(a.b) - shown(b.b)),
                     std::fabs(double{a.transmittance} - b.transmittance)});
}

/// Linear light of the map's colours: red, magenta, yellow, blue, orange, green, cyan and white.
Pixel color_of(UnstableCause cause) {
    constexpr std::array<Pixel, unstable_causes> colors{{{1.0f, 0.02f, 0.02f, 0.0f},
                                                         {1.0f, 0.02f, 1.0f, 0.0f},
                                                         {1.0f, 1.0f, 0.02f, 0.0f},
                                                         {0.1f, 0.2f, 1.0f, 0.0f},
                                                         {1.0f, 0.3f, 0.02f, 0.0f},
                                                         {0.05f, 0.8f, 0.05f, 0.0f},
                                                         {0.02f, 0.9f, 1.0f, 0.0f},
                                                         {1.0f, 1.0f, 1.0f, 0.0f}}};
    return colors[static_cast<std::size_t>(cause)];
}

/// The picture in grey, dark enough for every colour of a cause to stand out.
Film dimmed(const Film& film, const Encoding& encoding) {
    Film dim(film.width, film.height);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const Pixel& p = film.pixels[i];
        const Rgb light(to_linear(p.r, encoding), to_linear(p.g, encoding), to_linear(p.b, encoding));
        const auto shade = static_cast<float>(0.15 * std::clamp(grey(light), 0.0, 1.0));
        dim.pixels[i] = {shade, shade, shade, 0.0f};
    }
    return dim;
}

/// The search for the cause of one pixel after the other, in two worlds.
class CauseFinder {
public:
    CauseFinder(const World& world, const World& variant, const RenderOptions& options, Rounding rounding)
        : world_(world), variant_(variant), options_(options), rounding_(rounding), tracer_(world, options.trace) {
        const RoundingScope scope(rounding);
        variant_tracer_ = std::make_unique<Tracer>(variant, options.trace);
    }

    UnstableCause find(int x, int y) {
        const int n = samples_a_side(options_.sampling);
        std::optional<UnstableCause> cause;
        for (int sub_y = y * n; sub_y < (y + 1) * n; ++sub_y)
            for (int sub_x = x * n; sub_x < (x + 1) * n && !cause; ++sub_x) cause = compare(sub_x, sub_y, n);
        if (!cause) cause = sensitivity(world_, log_);
        if (!cause && beside_edge(x, y)) cause = UnstableCause::silhouette;
        return cause.value_or(UnstableCause::other);
    }

private:
    std::optional<UnstableCause> compare(int sub_x, int sub_y, int scale) {
        tracer_.camera_ray(ray(world_, sub_x, sub_y, scale), log_);
        {
            const RoundingScope scope(rounding_);
            variant_tracer_->camera_ray(ray(variant_, sub_x, sub_y, scale), variant_log_);
        }
        return disagreement(world_, log_, variant_log_);
    }

    [[gnu::noinline]] Ray ray(const World& world, int sub_x, int sub_y, int scale) const {
        return camera_ray(world.camera, sub_x + 0.5, sub_y + 0.5, options_.width * scale, options_.height * scale);
    }

    /// Whether the rays of the pixel and its eight neighbours meet several objects or faces.
    bool beside_edge(int x, int y) const {
        constexpr double parallel = 0.9;
        std::optional<Hit> first;
        Vec3 normal(0.0);
        for (int j = y - 1; j <= y + 1; ++j) {
            for (int i = x - 1; i <= x + 1; ++i) {
                const Ray r = ray(world_, i, j, 1);
                Hit hit;
                if (!world_.nearest(r, {}, RayKind::image, hit)) hit.object = RayNode::none;
                const Vec3 n = hit.object == RayNode::none ? Vec3(0.0) : world_.normal(hit, r.at(hit.shape.t));
                if (!first) first = hit, normal = n;
                if (hit.object != first->object || (hit.object != RayNode::none && dot(n, normal) < parallel)) return true;
            }
        }
        return false;
    }

    const World& world_;
    const World& variant_;
    const RenderOptions& options_;
    Rounding rounding_;
    Tracer tracer_;
    std::unique_ptr<Tracer> variant_tracer_;
    RayLog log_, variant_log_;
};

/// What is known so far.
struct Map {
    const RenderJob& job;
    RenderOptions options;
    Encoding encoding;
    World world;
    Film film;
    std::vector<UnstablePixel> pixels;  ///< in the order in which they were found
    std::vector<std::uint32_t> known;   ///< by pixel: its place among them + 1, or 0

    bool stopped() const { return options.stop && options.stop->load(std::memory_order_relaxed); }

    /// Compares the variant's film, whose new unstable pixels are appended with no cause yet; returns how many it moves.
    std::size_t compare(const Film& other) {
        std::size_t count = 0;
        for (int y = 0; y < film.height; ++y) {
            for (int x = 0; x < film.width; ++x) {
                const double by = moved(film.at(x, y), other.at(x, y), encoding);
                if (!(by > one_step)) continue;
                ++count;
                std::uint32_t& place = known[static_cast<std::size_t>(y) * film.width + x];
                if (place == 0) {
                    pixels.push_back({x, y, UnstableCause::other, by});
                    place = static_cast<std::uint32_t>(pixels.size());
                } else {
                    pixels[place - 1].moved = std::max(pixels[place - 1].moved, by);
                }
            }
        }
        return count;
    }

    void find_causes(std::size_t first, const World& variant, Rounding rounding) {
        const std::size_t count = pixels.size() - first;
        std::vector<std::unique_ptr<CauseFinder>> finders(static_cast<std::size_t>(worker_count(options.threads, count)));
        for_each_tile(options.threads, count, [&](int worker, std::size_t number) {
            std::unique_ptr<CauseFinder>& finder = finders[static_cast<std::size_t>(worker)];
            if (!finder) finder = std::make_unique<CauseFinder>(world, variant, options, rounding);
            UnstablePixel& pixel = pixels[first + number];
            if (!stopped()) pixel.cause = finder->find(pixel.x, pixel.y);
        });
    }

    /// False after a stop.
    bool add(const Scene& scene, Variant variant, std::size_t& moved_pixels) {
        RenderOptions other = options;
        other.rounding = rounding_of(variant);
        const World other_world = build(job, scene, other.rounding);
        const RenderResult result = render(other_world, other);
        if (!result.complete) return false;
        const std::size_t before = pixels.size();
        moved_pixels = compare(result.film);
        find_causes(before, other_world, other.rounding);
        return !stopped();
    }
};

Instability result_of(Map& map) {
    Instability result;
    result.pixels = std::move(map.pixels);
    std::ranges::sort(result.pixels, {}, [](const UnstablePixel& p) { return std::pair(p.y, p.x); });
    result.picture = dimmed(map.film, map.encoding);
    for (const UnstablePixel& pixel : result.pixels) {
        ++result.by_cause[static_cast<std::size_t>(pixel.cause)];
        result.picture.at(pixel.x, pixel.y) = color_of(pixel.cause);
    }
    return result;
}

}  // namespace

bool has_instability(const RenderOptions& options) { return !options.trace.course || options.trace.course->indirect_samples.empty(); }

Instability instability(const RenderJob& job, const Scene& scene, const RenderOptions& options) {
    if (!has_instability(options)) throw OptionError("-gi takes random directions from the rays' last bits: no map of what hangs by those");
    Map map{job, options, encoding_of(job, scene.settings.gamma), build(job, scene, Rounding::nearest), {}, {}, {}};
    map.options.only_region = false;
    map.options.rounding = Rounding::nearest;
    int renderings = 0;
    if (options.progress) map.options.progress = [&](double done) { options.progress((renderings + done) / (1.0 + variant_count)); };
    RenderResult first = render(map.world, map.options);
    Instability result;
    result.complete = first.complete;
    map.film = std::move(first.film);
    map.known.resize(map.film.pixels.size());
    std::array<std::size_t, variant_count> by_variant{};
    for (const auto& [name, variant] : variant_names) {
        ++renderings;
        const bool other_scene = variant == Variant::scaled;
        std::size_t& count = by_variant[static_cast<std::size_t>(variant)];
        result.complete =
            result.complete && (other_scene ? map.add(scaled(scene, larger), variant, count) : map.add(scene, variant, count));
    }
    if (!result.complete) return result;
    result = result_of(map);
    result.by_variant = by_variant;
    return result;
}

}  // namespace rt
