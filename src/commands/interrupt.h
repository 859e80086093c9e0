// Ctrl-C: the first one asks a render to stop, a second one ends the program at once.
#pragma once

#include <atomic>

namespace rt {

/// Exit status of a run that was interrupted.
inline constexpr int exit_interrupted = 2;

/// While one lives, SIGINT and SIGTERM only raise `stop`. Outside, and for a second signal, they end the program with exit status 2.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    const std::atomic<bool>& stop() const;
};

/// Makes SIGINT and SIGTERM end the program with exit status 2, and writing to a closed pipe an error instead of a signal.
void install_signal_handlers();

}  // namespace rt
