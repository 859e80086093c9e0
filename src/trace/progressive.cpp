#include "trace/progressive.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "film/spaced_fill.h"
#include "trace/error_estimate.h"
#include "trace/pixel_points.h"
#include "trace/spaced_passes.h"

namespace rt {

namespace {

/// Pixels that a worker takes at a time.
constexpr std::size_t pixels_at_a_time = 64;

using Clock = std::chrono::steady_clock;

class ProgressiveRender {
public:
    ProgressiveRender(const World& world, const RenderOptions& options, const ProgressiveOptions& progressive)
        : options_(options),
          progressive_(progressive),
          region_(rendered_region(options)),
          frame_(options.only_region ? region_ : Region{0, 0, options.width, options.height}),
          workers_(world, options),
          passes_(region_),
          film_(region_.width(), region_.height()) {}

    RenderResult run() {
        bool go_on = trace_centres();
        if (reached_.spacing > 1 || reached_.traced < 1.0)
            fill_between(film_, std::max(reached_.spacing, 1), passes_.known());
        else if (go_on && options_.sampling.method == Sampling::Method::adaptive)
            sample_pixels();
        RenderResult result;
        result.counts = workers_.counts();
        result.threads = workers_.threads();
        result.complete = !stopped_;
        result.convergence = reached_;
        for (Pixel& p : film_.pixels) {
            if (finite(p)) continue;
            ++result.non_finite;
            p = Pixel{};
        }
        result.film = std::move(framed());
        return result;
    }

private:
    /// False if the work has come to an end.
    bool trace_centres() {
        for (int spacing = progressive_.first_spacing; spacing >= 1; spacing /= 2) {
            const bool whole = passes_.trace(spacing, workers_, film_);
            reached_.traced = passes_.share();
            if (!whole) return ended();
            workers_.end_at(progressive_.deadline);
            reached_.spacing = spacing;
            if (spacing == 1) reached_.least = reached_.most = 1, reached_.mean = 1.0;
            if (spacing == 1 && options_.sampling.method == Sampling::Method::adaptive) return true;  // told with its error
            if (!after_step()) return false;
        }
        return true;
    }

    void sample_pixels() {
        SampledPicture samples(region_.width(), region_.height(), options_.display);
        for_pixels(samples.size(), [&](PlaneWorker&, std::size_t i) { samples.add(i, {&film_.pixels[i], 1}); });
        Clock::duration overhead{};
        for (;; ++reached_.rounds) {
            const Clock::time_point begin = Clock::now();
            if (progressive_.deadline && reached_.error && begin + overhead >= *progressive_.deadline) return;
            samples.estimate();
            reached_.error = samples.error();
            reached_.reached = *reached_.error <= options_.sampling.max_error;
            if (!after_step() || reached_.reached) return;
            const std::vector<std::uint32_t> chosen = samples.worst(options_.sampling.max_error, progressive_.most_samples);
            overhead = Clock::now() - begin;
            if (chosen.empty()) return;
            const bool whole = add_round(samples, chosen);
            count(samples);
            if (!whole) return void(ended());
        }
    }

    bool add_round(SampledPicture& samples, const std::vector<std::uint32_t>& chosen) {
        std::atomic<bool> whole{true};
        for_pixels(chosen.size(), [&](PlaneWorker& worker, std::size_t i) {
            if (!whole || !add_to(samples, chosen[i], worker)) whole = false;
        });
        return whole;
    }

    bool add_to(SampledPicture& samples, std::uint32_t pixel, PlaneWorker& worker) {
        const int x = region_.x0 + static_cast<int>(pixel) % region_.width(), y = region_.y0 + static_cast<int>(pixel) / region_.width();
        worker.points.resize(static_cast<std::size_t>(samples.next_batch(pixel)));
        std::uint32_t n = static_cast<std::uint32_t>(samples.samples(pixel));
        for (Vec2& point : worker.points) point = pixel_point(x, y, n++);
        if (!workers_.light(worker)) return false;
        samples.add(pixel, worker.pixels);
        film_.pixels[pixel] = samples.mean(pixel);
        return true;
    }

    void for_pixels(std::size_t count, const std::function<void(PlaneWorker&, std::size_t)>& work) {
        workers_.for_each((count + pixels_at_a_time - 1) / pixels_at_a_time, [&](PlaneWorker& worker, std::size_t task) {
            const std::size_t end = std::min((task + 1) * pixels_at_a_time, count);
            for (std::size_t i = task * pixels_at_a_time; i < end; ++i) work(worker, i);
        });
    }

    void count(const SampledPicture& samples) {
        reached_.least = samples.samples(0), reached_.most = 0;
        double sum = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            reached_.least = std::min(reached_.least, samples.samples(i)), reached_.most = std::max(reached_.most, samples.samples(i));
            sum += samples.samples(i);
        }
        reached_.mean = sum / static_cast<double>(samples.size());
    }

    bool after_step() {
        if (options_.progress) options_.progress(done());
        if (!progressive_.after_step) return true;
        if (reached_.spacing > 1) fill_between(film_, reached_.spacing, passes_.known());
        return progressive_.after_step(framed(), reached_);
    }

    /// Share of the work: the error falls as samples^-0.75.
    double done() const {
        if (options_.sampling.method != Sampling::Method::adaptive) return reached_.traced;
        return reached_.error ? std::min(1.0, std::pow(options_.sampling.max_error / *reached_.error, 4.0 / 3.0)) : 0.0;
    }

    /// Always false.
    bool ended() {
        stopped_ = workers_.stopped();
        return false;
    }

    /// The film that is asked for: the region, or all with the region in it.
    Film& framed() {
        if (film_.width == frame_.width() && film_.height == frame_.height()) return film_;
        if (whole_.pixels.empty()) whole_ = Film(frame_.width(), frame_.height());
        for (int y = 0; y < film_.height; ++y)
            std::copy_n(&film_.at(0, y), film_.width, &whole_.at(region_.x0 - frame_.x0, region_.y0 - frame_.y0 + y));
        return whole_;
    }

    const RenderOptions& options_;
    const ProgressiveOptions& progressive_;
    Region region_, frame_;
    PlaneWorkers workers_;
    SpacedPasses passes_;
    Film film_;   ///< of the region
    Film whole_;  ///< of the frame, where that is more
    Convergence reached_;
    bool stopped_ = false;
};

}  // namespace

RenderResult render_progressive(const World& world, const RenderOptions& options, const ProgressiveOptions& progressive) {
    const Region region = rendered_region(options);
    std::uint64_t further = picture_memory(options.width, options.height);
    if (options.sampling.method == Sampling::Method::adaptive) further += SampledPicture::memory(region.width(), region.height());
    check_picture_memory(options.width, options.height, available_memory(), further);
    return ProgressiveRender(world, options, progressive).run();
}

}  // namespace rt
