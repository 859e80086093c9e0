#include "commands/job/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/source.h"

namespace rt {

namespace {

/// A bound of the subset as the number of a frame. POV-Ray counts a share from 0 frames and not from the first one, whatever that is
/// called; where it is 1 the two are the same.
int subset_frame(double stated, const Animation& animation) {
    const int frames = animation.final_frame - animation.initial_frame + 1;
    const int frame = stated < 1.0 ? animation.initial_frame - 1 + static_cast<int>(stated * frames) : static_cast<int>(stated);
    if (frame > animation.final_frame)
        throw OptionError(fmt::format("frame {} is not among the frames {} to {}", frame, animation.initial_frame, animation.final_frame));
    return std::max(frame, animation.initial_frame);
}

/// Frames over which the clock goes from its first to its last value; 0 for a single one.
int clock_frames(const Animation& animation) { return animation.final_frame + animation.cyclic - animation.initial_frame; }

}  // namespace

std::optional<Animation> chosen_animation(const AnimationDraft& draft) {
    Animation animation;
    animation.initial_frame = draft.initial_frame.value_or(1);
    animation.final_frame = draft.final_frame.value_or(1);
    if (animation.initial_frame == animation.final_frame && animation.final_frame <= 1) return std::nullopt;
    if (animation.final_frame < animation.initial_frame)
        throw OptionError(fmt::format("the last frame, {}, comes before the first, {}", animation.final_frame, animation.initial_frame));
    animation.initial_clock = draft.initial_clock.value_or(0.0);
    animation.final_clock = draft.final_clock.value_or(1.0);
    animation.cyclic = draft.cyclic;
    animation.step = draft.step;
    animation.first = draft.subset_start ? subset_frame(*draft.subset_start, animation) : animation.initial_frame;
    animation.last = draft.subset_end ? subset_frame(*draft.subset_end, animation) : animation.final_frame;
    if (animation.last < animation.first)
        throw OptionError(fmt::format("the subset's last frame, {}, comes before its first, {}", animation.last, animation.first));
    return animation;
}

void set_frame(ParseOptions& parse, const Animation& animation, int number) {
    FrameValues& frame = parse.frame;
    const int frames = clock_frames(animation);
    frame.clock_on = true;
    frame.number = number;
    frame.initial_frame = animation.initial_frame;
    frame.final_frame = animation.final_frame + animation.cyclic;
    frame.initial_clock = animation.initial_clock;
    frame.final_clock = animation.final_clock;
    frame.clock_delta = frames == 0 ? 0.0 : (animation.final_clock - animation.initial_clock) / frames;
    parse.clock = animation.initial_clock + (number - animation.initial_frame) * frame.clock_delta;
}

std::string frame_name(const std::string& path, const Animation& animation, int number) {
    const std::filesystem::path name(path);
    if (!name.has_extension()) return path;
    const std::size_t digits = fmt::format("{}", animation.final_frame).size();
    return (name.parent_path() / fmt::format("{}{:0{}}{}", name.stem().string(), number, digits, name.extension().string())).string();
}

}  // namespace rt
