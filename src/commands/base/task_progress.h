// The line that a terminal shows while many things are done one after the other.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace rt {

/// How far they are.
struct TaskProgress {
    std::size_t tasks = 0, done = 0, taken = 0;  ///< `taken` of those done were known already
    double seconds = 0.0;                        ///< since the first began
    double seconds_left = 0.0;
};

/// "  120/18000 tests (40 known)  31.2 tests/s  0:09:31 left"; `things` is what they are. Slow ones are told by the minute.
std::string task_progress_text(const TaskProgress& progress, std::string_view things);

/// How long what is left will take: a task takes what those of its kind took on average, else what all took.
class TimeLeft {
public:
    void expect(const std::string& kind) { ++waiting_[kind]; }
    /// One that was expected took so long.
    void add(const std::string& kind, double seconds);
    double seconds(int parallel) const;

private:
    struct Mean {
        double sum = 0.0;
        std::size_t count = 0;
        double value() const { return count ? sum / static_cast<double>(count) : 0.0; }
    };
    std::map<std::string, Mean> by_kind_;
    std::map<std::string, long> waiting_;
    Mean all_;
};

/// Redraws the line at most ten times a second, and only if stderr is a terminal and `wanted`. Removes it at its end.
class TaskProgressLine {
public:
    TaskProgressLine(bool wanted, std::string_view things);
    ~TaskProgressLine();
    TaskProgressLine(const TaskProgressLine&) = delete;
    TaskProgressLine& operator=(const TaskProgressLine&) = delete;

    void update(const TaskProgress& progress);

private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    std::string things_;
    Clock::time_point last_{};
};

}  // namespace rt
