// extremes_page FOLDER: writes FOLDER/index.html and prints a line a scene. Exit status 0 if every pixel of ours is within one step.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>

#include "tests/extremes/page.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        std::vector<rt::extremes::Judgement> judgements;
        bool right = true;
        fmt::print("{:<34} {:>20} {:>20} {:>20}\n", "wrong pixels (not finite)", "textbook, single", "textbook, double", "ours");
        for (const std::string& scene : rt::extremes::scenes()) {
            judgements.push_back(rt::extremes::judge(scene));
            fmt::print("{}\n", rt::extremes::line(judgements.back()));
            right = right && rt::extremes::wrong(judgements.back().ours, judgements.back().truth).pixels == 0;
        }
        std::filesystem::create_directories(argv[1]);
        const std::filesystem::path page = std::filesystem::path(argv[1]) / "index.html";
        std::ofstream file(page, std::ios::binary);
        file << rt::extremes::page(judgements);
        file.close();
        if (!file) throw std::runtime_error("cannot write " + page.string());
        fmt::print("{}\n", page.string());
        return right ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "extremes_page: {}\n", error.what());
        return 3;
    }
}
