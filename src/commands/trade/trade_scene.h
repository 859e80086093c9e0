// The scene of a trade: read once, rendered in many ways.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands/job/render_job.h"
#include "commands/trade/trade_result.h"
#include "film/image_file.h"
#include "scene/scene.h"
#include "trace/environment.h"
#include "world/world.h"

namespace rt {

/// Thrown when Ctrl-C ends a render.
struct TradeStopped {};

/// Seconds since some moment: of the clock, and of all processors that worked for this process.
struct Clocks {
    double wall = 0.0, cpu = 0.0;
};
Clocks clocks();

class TradeScene {
public:
    /// Reads the scene of `job`, which is as the command line left it. Throws as read_scene() does.
    TradeScene(RenderJob job, const MessageSink& messages, const std::atomic<bool>& stop);

    /// The size of all renders from now on.
    void resize(int width, int height);

    const Scene& scene() const { return scene_; }
    const Timing& reading() const { return reading_; }  ///< only parse is set

    /// The job with these words carried out.
    RenderJob job_of(const std::vector<std::string>& words) const;
    /// `timing`, if given, gets the phase's seconds.
    World build(const RenderJob& job, Timing* timing = nullptr) const;
    /// Throws TradeStopped.
    RenderResult trace(const World& world, const RenderJob& job, Timing* timing = nullptr) const;
    /// The same; nothing if sampling by error goes on for longer than `most_seconds` of the clock: it is given up after that round.
    std::optional<RenderResult> trace_within(double most_seconds, const World& world, const RenderJob& job, Timing* timing = nullptr) const;
    /// Nothing where rounding says nothing. Throws TradeStopped.
    std::optional<UnstableCount> unstable(const RenderJob& job) const;
    /// The picture as a PNG file of 8 bits.
    std::string picture(const Film& film, const RenderJob& job, Timing* timing = nullptr) const;
    /// As it is shown: encoded, in 65535 steps.
    StoredImage shown(const Film& film) const;

    /// Knobs of the table that this scene can feel and that neither `words` nor the scene itself chooses.
    TurnedKnobs turned_knobs(const std::vector<std::string>& words, const MessageSink& messages) const;

    /// Fingerprint of all that was read: the scene, what it includes, pictures of the surroundings.
    std::string fingerprint() const;

private:
    RenderOptions options_of(const RenderJob& job) const;

    RenderJob plain_;  ///< without open choices
    Scene scene_;
    Timing reading_;
    std::shared_ptr<const Environment> surroundings_;
    const std::atomic<bool>& stop_;
};

/// RMSE over the channels of two pictures of one size, as shares of full scale.
double rmse_between(const StoredImage& a, const StoredImage& b);

}  // namespace rt
