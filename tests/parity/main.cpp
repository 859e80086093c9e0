// parity_check SCENE PICTURE [none|1|2 THRESHOLD DEPTH]: one line "share=0.9987 different=9 defects=0 max=123", then each defect's place.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "tests/parity/parity.h"

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    rt::ParityOptions options;
    if (argc > 5) {
        options.sampling.method = std::string_view(argv[3]) == "1" ? rt::Sampling::Method::povray1 : rt::Sampling::Method::povray2;
        options.sampling.threshold = std::atof(argv[4]);
        options.sampling.depth = std::atoi(argv[5]);
    }
    try {
        const rt::Parity parity = rt::compare_with_povray(argv[1], argv[2], options);
        int most = 0;
        for (const auto& p : parity.different) most = std::max(most, p.steps);
        fmt::print("share={:.5f} different={} defects={} max={}\n", parity.share(), parity.different.size(), parity.defects(), most);
        for (const auto& p : parity.different)
            if (!p.edge) fmt::print("  defect at ({}, {}): {} steps\n", p.x, p.y, p.steps);
        return parity.share() >= 0.995 && parity.defects() == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print("refused: {}\n", error.what());
        return 3;
    }
}
