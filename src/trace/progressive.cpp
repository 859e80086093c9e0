#include "trace/progressive.h"

#include <algorithm>
#include <memory>

#include "trace/error_estimate.h"
#include "trace/pixel_points.h"
#include "trace/plane_sampler.h"

namespace rt {

namespace {

/// Chosen pixels that a worker takes at a time.
constexpr std::size_t pixels_at_a_time = 64;

class ProgressiveRender {
public:
    ProgressiveRender(const World& world, const RenderOptions& options)
        : world_(world),
          options_(options),
          region_(rendered_region(options)),
          samples_(region_.width(), region_.height(), options.display),
          workers_(static_cast<std::size_t>(worker_count(options.threads, samples_.size()))) {
        const Region frame = options.only_region ? region_ : Region{0, 0, options.width, options.height};
        shift_x_ = region_.x0 - frame.x0, shift_y_ = region_.y0 - frame.y0;
        result_.film = Film(frame.width(), frame.height());
        result_.convergence.emplace();
    }

    RenderResult run(const ProgressiveOptions& progressive) {
        std::vector<std::uint32_t> all(samples_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
        for (sample(all);; sample(all)) {
            conclude_round();
            const Convergence& reached = *result_.convergence;
            if (!result_.complete || reached.reached) break;
            if (progressive.after_round && !progressive.after_round(result_.film, reached)) break;
            all = samples_.worst(options_.sampling.max_error, progressive.most_samples);
            if (all.empty()) break;
            ++result_.convergence->rounds;
        }
        for (const std::unique_ptr<Worker>& worker : workers_)
            if (worker) result_.counts += worker->plane.counts();
        for (const Pixel& p : result_.film.pixels) result_.non_finite += finite(p) ? 0 : 1;
        for (Pixel& p : result_.film.pixels) p = finite(p) ? p : Pixel{};
        return std::move(result_);
    }

private:
    struct Worker {
        Worker(const World& world, const RenderOptions& options) : plane(world, options) {}
        PlaneSampler plane;
        std::vector<Vec2> points;
        std::vector<Pixel> pixels;
    };

    bool stopped() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }

    void sample(const std::vector<std::uint32_t>& chosen) {
        std::atomic<bool> complete{true};
        const std::size_t tasks = (chosen.size() + pixels_at_a_time - 1) / pixels_at_a_time;
        const int threads = for_each_tile(options_.threads, tasks, [&](int index, std::size_t task) {
            std::unique_ptr<Worker>& worker = workers_[static_cast<std::size_t>(index)];
            if (!worker) worker = std::make_unique<Worker>(world_, options_);
            const std::size_t end = std::min((task + 1) * pixels_at_a_time, chosen.size());
            for (std::size_t i = task * pixels_at_a_time; i < end; ++i) {
                if (stopped()) return void(complete = false);
                add_to(chosen[i], *worker);
            }
        });
        result_.threads = std::max(result_.threads, threads);
        result_.complete = complete;
    }

    void add_to(std::uint32_t pixel, Worker& worker) {
        const int x = static_cast<int>(pixel) % region_.width(), y = static_cast<int>(pixel) / region_.width();
        const int before = samples_.samples(pixel);
        worker.points.resize(before == 0 ? 1 : static_cast<std::size_t>(samples_.next_batch(pixel)));
        worker.pixels.resize(worker.points.size());
        std::uint32_t n = static_cast<std::uint32_t>(before);
        for (Vec2& point : worker.points) point = pixel_point(region_.x0 + x, region_.y0 + y, n++);
        worker.plane(worker.points, 1, worker.pixels);
        samples_.add(pixel, worker.pixels);
        result_.film.at(x + shift_x_, y + shift_y_) = samples_.mean(pixel);
    }

    void conclude_round() {
        Convergence& c = *result_.convergence;
        samples_.estimate();
        c.error = samples_.error();
        c.reached = c.error <= options_.sampling.max_error;
        c.least = samples_.size() > 0 ? samples_.samples(0) : 0, c.most = 0;
        double sum = 0.0;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            c.least = std::min(c.least, samples_.samples(i)), c.most = std::max(c.most, samples_.samples(i));
            sum += samples_.samples(i);
        }
        c.mean = samples_.size() > 0 ? sum / static_cast<double>(samples_.size()) : 0.0;
    }

    const World& world_;
    const RenderOptions& options_;
    Region region_;
    SampledPicture samples_;
    std::vector<std::unique_ptr<Worker>> workers_;
    int shift_x_ = 0, shift_y_ = 0;  ///< from the region to the film
    RenderResult result_;
};

}  // namespace

RenderResult render_progressive(const World& world, const RenderOptions& options, const ProgressiveOptions& progressive) {
    const Region region = rendered_region(options);
    check_picture_memory(options.width, options.height, available_memory(), SampledPicture::memory(region.width(), region.height()));
    return ProgressiveRender(world, options).run(progressive);
}

}  // namespace rt
