#include "commands/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "commands/base/program.h"

namespace rt {

namespace {

constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

std::string progress_text(double done, double seconds, double pixels) {
    const double rate = seconds > 0.0 ? done * pixels / seconds : 0.0;
    std::string text = fmt::format("{:3.0f} %  {:.2f} M pixels/s", std::floor(100.0 * done), rate * 1e-6);
    if (done > 0.0) {
        const auto left = static_cast<long long>(std::ceil(seconds * (1.0 - done) / done));
        text += left < 3600 ? fmt::format("  {}:{:02} left", left / 60, left % 60)
                            : fmt::format("  {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
    }
    return text;
}

Progress::Progress(bool wanted, double pixels) : shown_(wanted && isatty(STDERR_FILENO) == 1), pixels_(pixels) {}

Progress::~Progress() {
    if (shown_) write_stderr(clear_line);
}

void Progress::update(double done) {
    const Clock::time_point now = Clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    write_stderr(clear_line + progress_text(done, std::chrono::duration<double>(now - start_).count(), pixels_));
}

}  // namespace rt
