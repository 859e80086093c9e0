#include "syntax/memory.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

#include "syntax/parser.h"

namespace rt {

std::size_t memory_that_fits() {
    const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)), bytes = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return pages * bytes / 4 * 3;
}

std::uint64_t memory_in_use() {
    // The second number of the file is the count of resident pages. A file that stays open is read at a third of the cost.
    static const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    char text[128];
    const ssize_t length = pread(file, text, sizeof text - 1, 0);
    if (length <= 0) return 0;
    text[length] = '\0';
    char* resident = nullptr;
    std::strtoull(text, &resident, 10);
    return std::strtoull(resident, nullptr, 10) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace rt
