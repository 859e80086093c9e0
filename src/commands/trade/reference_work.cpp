// The first part of a trade: the converged picture.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "commands/base/write_bytes.h"
#include "commands/job/encoding.h"
#include "commands/trade/reference.h"
#include "commands/trade/work.h"
#include "core/source.h"
#include "core/vec.h"
#include "film/image_file.h"

namespace rt {

namespace {

class Growth {
public:
    Growth(TradeWork& work, KnownReference& reference) : work_(work), known_(reference), job_(exact_job(work)) {}

    bool is_enough() const { return known_.facts.complete() && known_.facts.error <= work_.request.reference_error; }

    void run() {
        std::optional<World> world;
        while (!is_enough() && has_time()) {
            if (take_known()) continue;
            if (!world) refuse_the_slowest(world.emplace(work_.scene.build(job_)));
            add_grid(*world);
        }
    }

private:
    /// What it is kept by: each size of it by itself, so that whoever asks for less goes on with that.
    std::string words(std::size_t grids) const {
        return fmt::format("{} grids: {}", grids, joined_words(exact_setting(work_), work_.record.knobs));
    }

    bool take_known() {
        std::optional<KnownReference> kept = work_.store.reference(words(known_.facts.grids.size() + 1), job_.width, job_.height);
        if (!kept || kept->facts.grids.size() != known_.facts.grids.size() + 1) return false;
        kept->facts.asked = known_.facts.asked;
        known_ = std::move(*kept);
        work_.record.reference = known_.facts;
        return true;
    }

    /// Rather than to let somebody wait for hours without a word.
    void refuse_the_slowest(const World& world) const {
        if (known_.facts.complete()) return;
        const double limit = 10.0 * work_.request.reference_seconds;
        const double first = expected_seconds(work_, world, with_grid(job_, next_grid({})), limit);
        if (first > limit)
            throw LimitError(
                fmt::format("trade: the exact picture takes about {:.2g} s for {} rays a pixel; give a smaller size (-W -H), "
                            "or more time (--reference-seconds)",
                            first, sqr(next_grid({}))));
    }

    double samples_of_next() const {
        const double side = next_grid(known_.facts.grids);
        return side * side;
    }

    bool has_time() const {
        if (!known_.facts.complete()) return true;
        const double next = known_.facts.seconds / known_.facts.samples * samples_of_next();
        return known_.facts.seconds + next <= work_.request.reference_seconds;
    }

    void add_grid(const World& world) {
        const int side = next_grid(known_.facts.grids);
        ReferenceFacts& facts = known_.facts;
        tell(side);
        Timing timing;
        Film film = work_.scene.trace(world, with_grid(job_, side), &timing).film;
        const double samples = samples_of_next();
        if (facts.grids.empty()) {
            known_.film = std::move(film);
        } else {
            const double apart = rmse_between(work_.scene.shown(known_.film), work_.scene.shown(film));
            facts.error = joined_error(apart, facts.samples, samples);
            known_.film = joined(known_.film, facts.samples, film, samples);
        }
        facts.grids.push_back(side), facts.samples += samples, facts.seconds += timing.wall.trace;
        work_.store.put_reference(words(facts.grids.size()), known_);
        work_.record.reference = facts;
    }

    void tell(int side) const {
        const ReferenceFacts& facts = known_.facts;
        std::string text = fmt::format("reference: {0} x {0} rays a pixel", side);
        if (facts.complete()) text += fmt::format("; RMSE {:.5f}, {:.5f} wanted", facts.error, work_.request.reference_error);
        if (!facts.grids.empty()) text += fmt::format(" in {}", duration_text(facts.seconds / facts.samples * samples_of_next()));
        work_.progress.show(text);
    }

    TradeWork& work_;
    KnownReference& known_;
    RenderJob job_;
};

}  // namespace

void make_reference(TradeWork& work) {
    const RenderJob job = exact_job(work);
    KnownReference known{{}, Film(job.width, job.height)};
    known.facts.asked = work.request.reference_error;
    work.record.reference = known.facts;
    Growth(work, known).run();
    work.reference = work.scene.shown(known.film);
    Encoding encoding = encoding_of(job, work.scene.scene().settings.gamma);
    encoding.bits = 16;
    write_report(reference_path(work.request.folder), png_bytes(known.film, encoding, {}));
}

}  // namespace rt
