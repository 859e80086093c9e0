// extremes_page FOLDER: writes FOLDER/index.html and prints a line a scene. Exit status 0 if every pixel of ours is a number and within one
// step, 1 if not, 2 for wrong arguments, 3 if something could not be read, rendered or written.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>

#include "tests/extremes/page.h"

namespace {

std::ofstream opened(const std::filesystem::path& path, std::ios::openmode mode) {
    std::ofstream file(path, mode | std::ios::binary);
    if (!file) throw std::runtime_error("cannot write " + path.string());
    return file;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: extremes_page FOLDER\n");
        return 2;
    }
    try {
        std::filesystem::create_directories(argv[1]);
        const std::filesystem::path page = std::filesystem::path(argv[1]) / "index.html";
        opened(page, std::ios::app);  // told before the work; an older page stays until there is a new one
        std::vector<rt::extremes::Judgement> judgements;
        bool right = true;
        fmt::print("{:<34} {:>20} {:>20} {:>20}\n", "wrong pixels (not finite)", "textbook, single", "textbook, double", "ours");
        for (const std::string& scene : rt::extremes::scenes()) {
            judgements.push_back(rt::extremes::judge(scene));
            fmt::print("{}\n", rt::extremes::line(judgements.back()));
            right = right && rt::extremes::right(judgements.back());
        }
        std::ofstream file = opened(page, std::ios::trunc);
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
