// What it costs to run `true` in the sandbox instead of just so: wall time of one run, for each kind of machine.
#include <benchmark/benchmark.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "grading/sandbox.h"

namespace rt::bench {
namespace {

const Containment& here() {
    static const Containment found = find_containment();
    return found;
}

void plainly(benchmark::State& state) {
    char program[] = "/usr/bin/true";
    char* const words[] = {program, nullptr};
    for (auto _ : state) {
        pid_t child = 0;
        if (posix_spawn(&child, program, nullptr, nullptr, words, nullptr) != 0) throw std::runtime_error(program);
        waitpid(child, nullptr, 0);
    }
}

void contained(benchmark::State& state, bool bubblewrap, bool groups) {
    Containment containment = here();
    if (bubblewrap && containment.bubblewrap.empty()) return state.SkipWithError(containment.bubblewrap_problem.c_str());
    if (groups && containment.memory_group.empty()) return state.SkipWithError("no control groups can be made here");
    if (!bubblewrap) containment.bubblewrap.clear();
    if (!groups) containment.memory_group = containment.pids_group = "";
    std::string folder = "/tmp/raytrace-cost-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error(folder);
    for (auto _ : state) {
        const Ending ending = run_contained({{"/usr/bin/true"}, folder, folder, {}, {}}, Limits{}, containment, 0);
        if (ending.kind != Ending::Kind::exited || ending.status != 0) throw std::runtime_error(ending.reason);
    }
    std::filesystem::remove_all(folder);
}

BENCHMARK(plainly)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contained, limits_alone, false, false)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contained, and_groups, false, true)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contained, and_bubblewrap, true, true)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rt::bench

BENCHMARK_MAIN();
