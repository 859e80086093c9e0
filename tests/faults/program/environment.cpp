// The faults of raytrace_faulty: those that the variable RAYTRACE_FAULT names, before main begins.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "tests/faults/program/faults.h"

namespace {

const bool chosen = [] {
    try {
        const char* names = std::getenv("RAYTRACE_FAULT");
        rt::select_named_faults(names != nullptr ? names : "");
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "raytrace_faulty: RAYTRACE_FAULT: %s\n", error.what());
        std::_Exit(1);
    }
    return true;
}();

}  // namespace
