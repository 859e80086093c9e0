#include "commands/grade_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "commands/text.h"

namespace rt {

std::string grade_progress_text(const GradeProgress& progress) {
    const std::size_t run = progress.done - progress.taken;
    std::string text = fmt::format("{:>7}/{} tests", progress.done, progress.tasks);
    if (progress.taken > 0) text += fmt::format(" ({} known)", progress.taken);
    if (run == 0 || !(progress.seconds > 0.0)) return text;
    const long left = static_cast<long>(progress.seconds_left + 0.5);
    return text + fmt::format("  {:.1f} tests/s  {}:{:02}:{:02} left", static_cast<double>(run) / progress.seconds, left / 3600,
                              left / 60 % 60, left % 60);
}

GradeProgressLine::GradeProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO)) {}

GradeProgressLine::~GradeProgressLine() {
    if (shown_) write_stderr("\r\033[K");
}

void GradeProgressLine::update(const GradeProgress& progress) {
    constexpr std::chrono::milliseconds pause{100};
    if (!shown_ || Clock::now() - last_ < pause) return;
    last_ = Clock::now();
    write_stderr(fmt::format("\r\033[K{}", grade_progress_text(progress)));
}

}  // namespace rt
