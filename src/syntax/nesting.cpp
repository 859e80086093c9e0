// How deep a scene may be nested before the stack of the thread that reads it could end.
#include <pthread.h>

#include <algorithm>
#include <cstdint>

#include "syntax/parser.h"

namespace rt {

namespace {

// Measured for the hungriest level (a declaration inside an object that is being declared): 3 KB, in sanitizer and debug builds 15 KB.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
constexpr std::size_t bytes_a_level = 16 * 1024;
constexpr std::size_t least = 100;  ///< what the tests need; fits 1 MB
#else
constexpr std::size_t bytes_a_level = 8 * 1024;
constexpr std::size_t least = 10;
#endif

constexpr std::size_t most = 1000;
constexpr std::size_t reserve = 4 * bytes_a_level;

/// The calling thread's stack (of the main thread's the limit that `ulimit -s` sets), without the thread-local memory that lies at its end.
struct Stack {
    std::uintptr_t end = 0;
    std::size_t bytes = 0;  ///< zero if it cannot be found out
};

Stack find_stack() {
    pthread_attr_t attributes;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
    void* lowest = nullptr;
    std::size_t bytes = 0;
    pthread_attr_getstack(&attributes, &lowest, &bytes);
    pthread_attr_destroy(&attributes);
    return {reinterpret_cast<std::uintptr_t>(lowest), bytes};
}

/// What is left of it.
std::size_t stack_bytes() {
    thread_local const Stack stack = find_stack();  // once: for the main thread it means to read a list of all mapped files
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    return here > stack.end ? std::min<std::size_t>(here - stack.end, stack.bytes) : 0;
}

}  // namespace

bool stack_is_low() { return stack_bytes() < reserve; }

int nesting_that_fits() {
    // In twenties: where the stack begins is the system's choice, anew for every run, and should not show.
    const std::size_t levels = stack_bytes() / bytes_a_level / 20 * 20;
    return static_cast<int>(std::clamp(levels, least, most));
}

}  // namespace rt
