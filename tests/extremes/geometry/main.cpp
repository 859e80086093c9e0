#include <fmt/format.h>
#include <chrono>
#include "tests/extremes/geometry/verdict.h"
using namespace rt::extremes;
int main(int argc, char** argv) {
    for (const auto& s : geometry_scenes()) {
        if (argc > 1 && s.find(argv[1]) == std::string::npos) continue;
        auto t0 = std::chrono::steady_clock::now();
        Verdict v;
        try {
            v = verdict(s);
        } catch (std::exception& e) {
            fmt::print("{}\n", e.what());
            continue;
        }
        double dt = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
        fmt::print("{:<18} unst {:>4}", v.truth.name, v.truth.unstable);
        auto p = [&](const Bytes& b) {
            Count c = count(b, v.truth);
            fmt::print(" | {:>4} {:>3} {:>2} {:>3} {:>2}", c.wrong, c.steps, c.non_finite, c.speckles, c.unstable);
        };
        for (auto& b : v.ours) p(b);
        p(v.textbook_single);
        p(v.textbook_double);
        if (v.povray) p(*v.povray);
        fmt::print("  {:.1f}s\n", dt);
    }
}
