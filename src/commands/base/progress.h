// The line that a terminal shows while a picture is made.
#pragma once

#include <chrono>
#include <string>

namespace rt {

/// "  42 %  1.3 M pixels/s  0:07 left". `done` is in 0..1, `seconds` since the start.
std::string progress_text(double done, double seconds, double pixels);

/// Redraws the line at most ten times a second, and only if stderr is a terminal and `wanted`. Removes it at its end.
class Progress {
public:
    Progress(bool wanted, double pixels);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    bool shown() const { return shown_; }
    void update(double done);

private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    double pixels_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_{};
};

}  // namespace rt
