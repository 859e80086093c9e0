#include "commands/job/stepwise.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/base/clock.h"
#include "commands/base/process_age.h"
#include "trace/progressive.h"

namespace rt {

namespace {

/// Decides which steps are written, and when to end so that the last one can still be.
class Steps {
public:
    Steps(const RenderOptions& options, const RenderJob& job, const std::function<void(const Film&)>& write)
        : job_(job), write_(write), last_is_written_(options.sampling.method == Sampling::Method::none) {
        constexpr double seconds_per_pixel = 80e-9;  // of a PNG; measured as soon as there is time for it
        const Region region = rendered_region(options);
        writing_ =
            options.only_region ? seconds_per_pixel * region.width() * region.height() : seconds_per_pixel * options.width * options.height;
        set_deadline();
    }

    const Deadline* deadline() const { return job_.time ? &deadline_ : nullptr; }

    bool after_step(const Film& film, const Convergence& reached) {
        if (write_ && (job_.preview ? shows(reached) : measures(reached))) {
            const Clock::time_point begin = Clock::now();
            write_(film);
            written_ = Clock::now();
            writing_ = seconds_since(begin);
            measured_at_ = reached.spacing;
        }
        set_deadline();
        return true;
    }

private:
    /// Every halving of the spacing, then at most two pictures a second; the last picture is the caller's to write.
    bool shows(const Convergence& reached) const {
        if (reached.spacing == 1 && last_is_written_) return false;
        return reached.rounds == 0 || (!reached.reached && seconds_since(written_) > 0.5);
    }

    bool measures(const Convergence& reached) const {
        if (!job_.time || (measured_at_ != 0 && (measured_at_ == 1 || reached.spacing != 1))) return false;
        return process_age() + 5.0 * writing_ < *job_.time;
    }

    void set_deadline() {
        if (!job_.time) return;
        constexpr double end_of_program = 0.005;
        const double left = *job_.time - process_age() - 1.2 * writing_ - end_of_program;
        deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(left));
    }

    const RenderJob& job_;
    const std::function<void(const Film&)>& write_;
    bool last_is_written_;
    double writing_ = 0.0;  ///< seconds that the picture takes
    int measured_at_ = 0;   ///< spacing
    Clock::time_point written_{};
    Deadline deadline_;
};

}  // namespace

RenderResult render_stepwise(const World& world, const RenderOptions& options, const RenderJob& job,
                             const std::function<void(const Film&)>& write) {
    const bool adaptive = options.sampling.method == Sampling::Method::adaptive;
    const bool fixed = !adaptive && options.sampling.method != Sampling::Method::none;
    Steps steps(options, job, write);
    ProgressiveOptions progressive;
    progressive.first_spacing = job.time ? 64 : job.preview ? 16 : 1;
    progressive.deadline = steps.deadline();
    progressive.after_step = [&](const Film& film, const Convergence& reached) { return steps.after_step(film, reached); };
    if (!fixed) return render_progressive(world, options, progressive);
    // Methods that are no matter of single samples begin anew.
    RenderOptions plain = options;
    plain.sampling.method = Sampling::Method::none;
    RenderResult coarse = render_progressive(world, plain, progressive);
    if (!coarse.complete) return coarse;
    RenderResult result = render(world, options);
    coarse.counts += result.counts;
    if (result.complete) coarse.film = std::move(result.film), coarse.non_finite = result.non_finite;
    coarse.complete = result.complete;
    return coarse;
}

std::string reached_text(const Convergence& reached, double seconds) {
    std::string text = fmt::format("{:.2f} s: ", seconds);
    if (reached.traced < 1.0)
        return text + fmt::format("{:.2g} % of the pixels are traced, the others made up from them", 100.0 * reached.traced);
    text += fmt::format("{:.3g} samples a pixel", reached.mean);
    if (reached.error) text += fmt::format(", the error is estimated to be {:.2g}", *reached.error);
    return text;
}

}  // namespace rt
