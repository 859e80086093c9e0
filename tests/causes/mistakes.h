// Mistakes whose cause is known: pictures spoilt as such, and faults of a tracer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "film/image_file.h"

namespace rt::test {

/// A way to make a right picture wrong, whatever it shows.
struct Spoil {
    const char* name;
    std::vector<std::string> right;  ///< causes that are right
    std::function<StoredImage(const StoredImage&)> apply;
};
const std::vector<Spoil>& spoils();

/// A fault of raytrace_faulty.
struct PlantedFault {
    const char* name;
    std::vector<std::string> right;
};
const std::vector<PlantedFault>& planted_faults();

}  // namespace rt::test
