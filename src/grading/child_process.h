// The one place that forks.
#pragma once

#include <sys/types.h>

#include <functional>

namespace rt {

/// A process that does `work`, which may replace it by a program, and ends with the status it returns (or 127 for an exception), without
/// running anything that this process has planned for its own end. Throws std::system_error if there can be no process. For processes
/// of one thread.
pid_t start_child(const std::function<int()>& work);

/// Whether `work` returns true in a process of its own.
bool holds_in_child(const std::function<bool()>& work);

}  // namespace rt
