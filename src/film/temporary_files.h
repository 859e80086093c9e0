// The temporary files that exist right now, so that a program that is ended by a signal can still remove them.
#pragma once

#include <csignal>
#include <string>

namespace rt {

/// While one lives no signal interrupts this thread: where signals are handled in this thread alone, a file that is made meanwhile is
/// registered before its removal can be asked for.
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
/// or is longer than paths can be, is not registered. All three functions belong to the one thread that handles signals and makes files;
/// it holds signals from the making of a file until it is registered.
void remember_temporary(const std::string& path);
void forget_temporary(const std::string& path);

/// Unlinks every registered file. Safe in a handler that interrupts any of the others.
void remove_temporary_files();

}  // namespace rt
