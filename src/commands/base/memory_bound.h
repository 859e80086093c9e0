// A bound of what the program may take of the machine's memory.
#pragma once

#include <cstdint>

namespace rt {

/// From now on the program gets no more than `bytes` of memory to write into: what asks for more throws std::bad_alloc instead of having
/// the machine run out of it. A lower bound that was set from outside stays. Does nothing where the program is built with sanitizers.
void bound_memory(std::uint64_t bytes);

}  // namespace rt
