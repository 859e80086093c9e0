#include "tests/faults/program/faults.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace rt {

namespace {

constexpr FaultWords words[] = {
#define FAULT(name, what) {#name, what},
#include "faults_list.h"
#undef FAULT
};

std::array<bool, std::size(words)> selected{};

Fault fault_named(std::string_view name) {
    std::string known;
    for (std::size_t i = 0; i < std::size(words); ++i) {
        if (words[i].name == name) return static_cast<Fault>(i);
        known += fmt::format("\n  {:24}{}", words[i].name, words[i].what);
    }
    throw std::invalid_argument(fmt::format("unknown fault '{}', expected one of{}", name, known));
}

}  // namespace

std::span<const FaultWords> all_faults() { return words; }

bool planted(Fault fault) { return selected[static_cast<std::size_t>(fault)]; }

void select_faults(std::span<const Fault> faults) {
    selected.fill(false);
    for (const Fault fault : faults) selected[static_cast<std::size_t>(fault)] = true;
}

void select_named_faults(const std::string& names) {
    selected.fill(false);
    for (std::size_t begin = 0; begin < names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        selected[static_cast<std::size_t>(fault_named(std::string_view(names).substr(begin, end - begin)))] = true;
        begin = end + 1;
    }
}

}  // namespace rt
