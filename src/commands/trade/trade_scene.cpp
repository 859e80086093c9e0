#include "commands/trade/trade_scene.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "commands/base/content_hash.h"
#include "commands/job/encoding.h"
#include "commands/job/job_steps.h"
#include "commands/job/surroundings.h"
#include "commands/job/text.h"
#include "commands/trade/instability.h"
#include "commands/trade/median.h"

namespace rt {

namespace {

/// Adds what the clocks tell while this lives to one phase of a timing.
class PhaseTimed {
public:
    PhaseTimed(Timing* timing, double Phases::*phase) : timing_(timing), phase_(phase), start_(clocks()) {}
    ~PhaseTimed() {
        if (!timing_) return;
        const Clocks end = clocks();
        timing_->wall.*phase_ += end.wall - start_.wall;
        timing_->cpu.*phase_ += end.cpu - start_.cpu;
    }
    PhaseTimed(const PhaseTimed&) = delete;
    PhaseTimed& operator=(const PhaseTimed&) = delete;

private:
    Timing* timing_;
    double Phases::*phase_;
    Clocks start_;
};

const MessageSink nobody = [](std::string_view) {};

/// Whether an option, of the command line or in a comment of the scene, chooses what a knob would: it is the knob's own, or a row of the
/// catalogue of shading.
bool chooses(const std::string& option, const Knob& knob) {
    const bool is_row = option == "--preset" || option == "--material" || option == "--shading";
    const bool of_catalogue = knob.name == "fresnel" || knob.name == "distribution" || knob.name == "masking";
    return turns({option}, knob) || (is_row && of_catalogue);
}

bool is_chosen(const Knob& knob, const std::vector<std::string>& words, const Scene& scene) {
    const auto in_words = [&](const std::string& word) { return chooses(word.substr(0, word.find('=')), knob); };
    const auto in_comments = [&](const std::vector<SceneOption>& options) {
        return std::any_of(options.begin(), options.end(), [&](const SceneOption& option) { return chooses("--" + option.key, knob); });
    };
    return std::any_of(words.begin(), words.end(), in_words) || in_comments(scene.options) ||
           std::any_of(scene.finish_options.begin(), scene.finish_options.end(), in_comments);
}

}  // namespace

Clocks clocks() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

TradeScene::TradeScene(RenderJob job, const MessageSink& messages, const std::atomic<bool>& stop)
    : plain_(std::move(job)), surroundings_(read_surroundings(plain_.environment)), stop_(stop) {
    std::vector<double> wall, cpu;
    const auto timed = [&](const auto& read) {
        Timing timing;
        {
            const PhaseTimed phase(&timing, &Phases::parse);
            read();
        }
        wall.push_back(timing.wall.parse), cpu.push_back(timing.cpu.parse);
    };
    timed([&] { scene_ = read_scene(plain_, messages); });
    constexpr double short_time = 0.5;
    while (wall.size() < 5 && static_cast<double>(wall.size()) * wall[0] < short_time)
        timed([&] { parse_file(plain_.scene, plain_.parse, nobody); });
    reading_.wall.parse = median(wall), reading_.cpu.parse = median(cpu);
}

void TradeScene::resize(int width, int height) { plain_.width = width, plain_.height = height; }

RenderJob TradeScene::job_of(const std::vector<std::string>& words) const {
    RenderJob job = plain_;
    for (const std::string& word : words) turn(job, word);
    return job;
}

World TradeScene::build(const RenderJob& job, Timing* timing) const {
    const PhaseTimed timed(timing, &Phases::build);
    return build_world(job, scene_, nobody);
}

RenderOptions TradeScene::options_of(const RenderJob& job) const {
    RenderOptions options = render_options(job, scene_);
    options.stop = &stop_;
    options.trace.environment = surroundings_;
    return options;
}

RenderResult TradeScene::trace(const World& world, const RenderJob& job, Timing* timing) const {
    const RenderOptions options = options_of(job);
    const PhaseTimed timed(timing, &Phases::trace);
    RenderResult result = render(world, options);
    if (!result.complete) throw TradeStopped{};
    return result;
}

std::optional<RenderResult> TradeScene::trace_within(double most_seconds, const World& world, const RenderJob& job, Timing* timing) const {
    if (job.sampling.method != Sampling::Method::adaptive) return trace(world, job, timing);
    struct TooSlow {};
    RenderOptions options = options_of(job);
    const double end = clocks().wall + most_seconds;
    options.progress = [end](double) {  // called between rounds, by the thread that asked for the render
        if (clocks().wall > end) throw TooSlow{};
    };
    const PhaseTimed timed(timing, &Phases::trace);
    try {
        RenderResult result = render(world, options);
        if (!result.complete) throw TradeStopped{};
        return result;
    } catch (const TooSlow&) {
        return std::nullopt;
    }
}

std::optional<UnstableCount> TradeScene::unstable(const RenderJob& job) const {
    const RenderOptions options = options_of(job);
    if (!has_instability(options)) return std::nullopt;
    const Instability found = instability(job, scene_, options);
    if (!found.complete) throw TradeStopped{};
    UnstableCount count{found.pixels.size(), {}};
    std::copy(found.by_cause.begin(), found.by_cause.end(), count.by_cause.begin());
    return count;
}

std::string TradeScene::picture(const Film& film, const RenderJob& job, Timing* timing) const {
    const PhaseTimed timed(timing, &Phases::write);
    return png_bytes(film, encoding_of(job, scene_.settings.gamma), {picture_metadata(job, scene_)});
}

StoredImage TradeScene::shown(const Film& film) const {
    Encoding encoding = encoding_of(plain_, scene_.settings.gamma);
    encoding.bits = 16;
    const std::vector<std::uint16_t> numbers = quantise(film, encoding);
    return {film.width, film.height, 3, 65535, {numbers.begin(), numbers.end()}};
}

TurnedKnobs TradeScene::turned_knobs(const std::vector<std::string>& words, const MessageSink& messages) const {
    const World world = build_world(plain_, scene_, messages);
    TurnedKnobs turned;
    for (const Knob& knob : knobs())
        if (!is_chosen(knob, words, scene_) && knob.felt({plain_, scene_, world})) turned.push_back(turned_knob(knob, scene_));
    return turned;
}

std::string TradeScene::fingerprint() const {
    std::string lines;
    for (std::uint32_t i = 0; i < scene_.sources.size(); ++i) {
        const SourceFile& file = scene_.sources.file(i);
        lines += fmt::format("{}\n{}\n", file.name, hash_of(file.text));
    }
    for (const std::string& file : plain_.environment) lines += hash_of_file(file) + "\n";
    return hash_of(lines);
}

double rmse_between(const StoredImage& a, const StoredImage& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double difference = static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]);
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.values.size())) / a.max_value;
}

}  // namespace rt
