#include "commands/base/process_age.h"

#include <unistd.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

namespace rt {

namespace {

/// Seconds from the system's start to the process' (field 22 of stat, in ticks; the second one is a name in brackets), or -1.
double started() {
    std::ifstream file("/proc/self/stat");
    constexpr auto all = std::numeric_limits<std::streamsize>::max();
    file.ignore(all, ')');
    std::string field;
    for (int number = 3; number < 22; ++number) file >> field;
    double ticks = 0.0;
    return file >> ticks ? ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) : -1.0;
}

double since_system_start() {
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double process_age() {
    static const double start = [] {
        const double seconds = started();
        return seconds < 0.0 ? since_system_start() : seconds;
    }();
    return since_system_start() - start;
}

}  // namespace rt
