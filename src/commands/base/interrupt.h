// Ctrl-C, a polite kill, a lost terminal: the first one asks a render to stop, a second one ends the program at once.
#pragma once

#include <atomic>

namespace rt {

/// Exit status of a run that was interrupted.
inline constexpr int exit_interrupted = 2;

/// While one lives, the first of SIGINT, SIGTERM and SIGHUP only raises `stop`. Outside, and a second one, they end the program with exit
/// status 2; temporary files are removed.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    const std::atomic<bool>& stop() const;
};

/// Called once, by the main thread. Handles SIGINT, SIGTERM and SIGHUP as said above, but for those that were ignored when the program
/// started (nohup): they stay so. Writing to a closed pipe becomes an error instead of a signal.
void install_signal_handlers();

}  // namespace rt
