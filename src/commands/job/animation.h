// The frames of an animation: which there are, what the clock says in each, and what their pictures are called.
#pragma once

#include <optional>
#include <string>

#include "syntax/parser.h"

namespace rt {

/// As Initial_Frame, Final_Frame, Initial_Clock, Final_Clock, Cyclic_Animation, Frame_Step, Subset_Start_Frame and Subset_End_Frame of
/// POV-Ray say.
struct Animation {
    int initial_frame = 1, final_frame = 1;
    double initial_clock = 0.0, final_clock = 1.0;
    bool cyclic = false;      ///< the clock would reach its last value one frame after the last: the film can be repeated without a halt
    int first = 1, last = 1;  ///< those to render
    int step = 1;             ///< from each of them to the next
};

/// What the options say; nothing chosen is no animation.
struct AnimationDraft {
    std::optional<int> initial_frame{}, final_frame{};
    std::optional<double> initial_clock{}, final_clock{};
    std::optional<double> subset_start{}, subset_end{};  ///< numbers of frames, or below 1 shares of the whole
    bool cyclic = false;
    int step = 1;
};

/// Empty for a single picture, which frames 1 to 1 and 0 to 0 are, too. Throws OptionError for frames that there are not.
std::optional<Animation> chosen_animation(const AnimationDraft& draft);

/// What the scene reads of frame `number`: its clock, frame_number and their like. Of a film of one frame the clock is the initial one.
void set_frame(ParseOptions& parse, const Animation& animation, int number);

/// "out.png" -> "out07.png": as many digits as the last frame has. What has no ending, standard output or a pipe, keeps its name.
std::string frame_name(const std::string& path, const Animation& animation, int number);

}  // namespace rt
