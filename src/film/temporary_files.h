// The temporary files that exist right now, so that a program that is ended by a signal can still remove them.
#pragma once

#include <csignal>
#include <string>

namespace rt {

/// While one lives no signal interrupts this thread: a file that is made meanwhile is registered before anybody could ask for its removal.
class HoldSignals {
public:
    HoldSignals();
    ~HoldSignals();
    HoldSignals(const HoldSignals&) = delete;
    HoldSignals& operator=(const HoldSignals&) = delete;

private:
    sigset_t before_;
};

/// Registers `path`, which remove_temporary_files() unlinks until it is forgotten. A run has two at most; what finds no room among eight,
/// or is longer than paths can be, is not registered.
void remember_temporary(const std::string& path);
void forget_temporary(const std::string& path);

/// Unlinks every registered file. Safe in a signal handler.
void remove_temporary_files();

}  // namespace rt
