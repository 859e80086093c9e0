// geometry_page FOLDER: writes FOLDER/geometry.html and prints a line a scene. Right is what rt::extremes::right() says of every scene.
#include <fmt/format.h>

#include "tests/extremes/geometry/page.h"
#include "tests/extremes/page_program.h"

namespace {

rt::extremes::Outcome work() {
    std::vector<rt::extremes::Verdict> verdicts;
    bool right = true;
    fmt::print("{}\n", rt::extremes::geometry_head());
    for (const std::string& scene : rt::extremes::geometry_scenes()) {
        verdicts.push_back(rt::extremes::verdict(scene));
        fmt::print("{}\n", rt::extremes::geometry_line(verdicts.back()));
        right = right && rt::extremes::right(verdicts.back());
    }
    return {rt::extremes::geometry_page(verdicts), right};
}

}  // namespace

int main(int argc, char** argv) { return rt::extremes::page_program(argc, argv, "geometry_page", "geometry.html", work); }
