// Faults that a student's tracer may have, one by one in a test build of our own: faults.py says what each is, and plant.py writes them
// into copies of the sources. The product is built from the sources themselves and knows nothing of this.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rt {

enum class Fault : unsigned {
#define FAULT(name, what) name,
#include "faults_list.h"
#undef FAULT
};

struct FaultWords {
    std::string_view name, what;
};
/// By the enumeration's order.
std::span<const FaultWords> all_faults();

/// Whether this fault is selected. For all threads; asked everywhere a fault can be.
bool planted(Fault fault);

/// Selects these faults alone, while nothing is traced.
void select_faults(std::span<const Fault> faults);
/// The same by names separated by commas; empty: none. Throws std::invalid_argument with all names if one is unknown.
void select_named_faults(const std::string& names);

}  // namespace rt
