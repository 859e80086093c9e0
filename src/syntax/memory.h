// How much memory the program uses.
#pragma once

#include <cstdint>

namespace rt {

/// Bytes of physical memory that the process holds; 0 if it cannot be found out.
std::uint64_t memory_in_use();

}  // namespace rt
