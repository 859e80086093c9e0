// How often explain names a planted fault on scenes: pixels chosen by a rule, causes counted.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "grading/causes.h"
#include "tests/faults/program/faults.h"
#include "tests/faults/subject.h"

namespace rt::test {

/// The causes that are right names of a fault, the closest first; empty for a fault that a pixel's rays do not show.
std::span<const Cause> right_names(Fault fault);

struct Count {
    int cases = 0, right = 0;
    std::map<Cause, int> named;
    double rate() const { return cases == 0 ? 0.0 : static_cast<double>(right) / cases; }
};

/// Of one fault, by form.
struct Tally {
    int pictures = 0;  ///< that the fault changed
    std::array<Count, forms.size()> by_form;
};

/// Adds what explain says of the fault on one subject, whose picture without faults is `healthy`: at the pixel that the fault changes
/// most (the first of several), and at `more` of the others that it changes, drawn with `seed`.
void measure(const Subject& subject, const std::vector<std::uint16_t>& healthy, Fault fault, int more, unsigned seed, Tally& tally);

/// A line for each fault: cases, the rate of right names by form, and what else was named.
std::string table(std::span<const Tally> tallies);

}  // namespace rt::test
