// extremes_page FOLDER: writes FOLDER/index.html and prints a line a scene. Right is every pixel of ours that is a number and within one
// step.
#include <fmt/format.h>

#include "tests/extremes/page.h"
#include "tests/extremes/page_program.h"

namespace {

rt::extremes::Outcome work() {
    std::vector<rt::extremes::Judgement> judgements;
    bool right = true;
    fmt::print("{:<34} {:>20} {:>20} {:>20}\n", "wrong pixels (not finite)", "textbook, single", "textbook, double", "ours");
    for (const std::string& scene : rt::extremes::scenes()) {
        judgements.push_back(rt::extremes::judge(scene));
        fmt::print("{}\n", rt::extremes::line(judgements.back()));
        right = right && rt::extremes::right(judgements.back());
    }
    return {rt::extremes::page(judgements), right};
}

}  // namespace

int main(int argc, char** argv) { return rt::extremes::page_program(argc, argv, "extremes_page", "index.html", work); }
