#include "commands/base/task_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "commands/base/program.h"

namespace rt {

std::string task_progress_text(const TaskProgress& progress, std::string_view things) {
    const std::size_t run = progress.done - progress.taken;
    std::string text = fmt::format("{:>7}/{} {}", progress.done, progress.tasks, things);
    if (progress.taken > 0) text += fmt::format(" ({} known)", progress.taken);
    if (run == 0 || !(progress.seconds > 0.0)) return text;
    const long left = static_cast<long>(progress.seconds_left + 0.5);
    const double rate = static_cast<double>(run) / progress.seconds;
    text += rate < 1.0 ? fmt::format("  {:.1f} {}/min", 60.0 * rate, things) : fmt::format("  {:.1f} {}/s", rate, things);
    return text + fmt::format("  {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
}

void TimeLeft::add(const std::string& kind, double seconds) {
    for (Mean* mean : {&by_kind_[kind], &all_}) mean->sum += seconds, ++mean->count;
    --waiting_[kind];
}

double TimeLeft::seconds(int parallel) const {
    double sum = 0.0;
    for (const auto& [kind, count] : waiting_) {
        const auto known = by_kind_.find(kind);
        sum += static_cast<double>(count) * (known == by_kind_.end() ? all_ : known->second).value();
    }
    return sum / parallel;
}

TaskProgressLine::TaskProgressLine(bool wanted, std::string_view things) : shown_(wanted && isatty(STDERR_FILENO)), things_(things) {}

TaskProgressLine::~TaskProgressLine() {
    if (shown_) write_stderr("\r\033[K");
}

void TaskProgressLine::update(const TaskProgress& progress) {
    constexpr std::chrono::milliseconds pause{100};
    if (!shown_ || Clock::now() - last_ < pause) return;
    last_ = Clock::now();
    write_stderr(fmt::format("\r\033[K{}", task_progress_text(progress, things_)));
}

}  // namespace rt
