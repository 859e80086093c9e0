#include "commands/versus/versus_judge.h"

#include "commands/base/verdict.h"
#include "commands/versus/program_told.h"
#include "grading/judge.h"
#include "grading/regions.h"

namespace rt {

namespace {

constexpr double full_scale = 255.0;

std::array<int, 3> colour_at(const StoredImage& image, int x, int y) {
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t first =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * channels;
    std::array<int, 3> colour{};
    for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<int>(image.values[first + (channels < 3 ? 0 : i)]);
    return colour;
}

}  // namespace

Likeness likeness_of(const StoredImage& povray, const StoredImage& ours, const VersusLimits& limits) {
    const double between_steps = (limits.step + 0.5) / full_scale;  // where no rounding decides
    Likeness like;
    like.figures = picture_figures(povray, ours, 5.0);
    like.beyond = count_pixels(povray, ours, {.fail = between_steps}).failing;
    like.region = largest_region(povray, ours, 100.0 * between_steps);
    if (like.region)
        like.theirs = colour_at(povray, like.region->x, like.region->y), like.ours = colour_at(ours, like.region->x, like.region->y);
    like.agrees = like.percent_within() >= limits.percent && like.figures[Metric::rmse] < limits.rmse;
    return like;
}

VersusCause cause_of(const VersusResult& result, const VersusLimits& limits) {
    using State = VersusRun::State;
    const State theirs = result.run(Maker::povray).state, ours = result.run(limits.judged).state;
    if (theirs == State::not_run || ours == State::not_run) return VersusCause::not_run;
    for (const VersusRun& run : result.runs)
        if (run.state == State::failed) return VersusCause::failed;
    if (theirs == State::refused && ours == State::refused && result.missing.empty()) {
        const std::string their_place = refused_place(result.run(Maker::povray).message);
        const std::string our_place = refused_place(result.run(limits.judged).message);
        if (their_place.empty() || our_place.empty()) return VersusCause::failed;
        return their_place == our_place ? VersusCause::both_refuse : VersusCause::refused_elsewhere;
    }
    if (theirs == State::refused) return VersusCause::povray_refuses;
    if (ours == State::refused) return result.missing.empty() ? VersusCause::refused : VersusCause::not_modelled;
    const std::optional<Likeness>& like = result.like(limits.judged);
    return like && like->agrees ? VersusCause::agrees : VersusCause::differs;
}

}  // namespace rt
