#include "tests/extremes/page_program.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace rt::extremes {

namespace {

namespace fs = std::filesystem;

std::ofstream opened(const fs::path& path, std::ios::openmode mode) {
    std::ofstream file(path, mode | std::ios::binary);
    if (!file) throw std::runtime_error("cannot write " + path.string());
    return file;
}

}  // namespace

int page_program(int argc, char** argv, const std::string& name, const std::string& file, const std::function<Outcome()>& work) {
    if (argc != 2) {
        fmt::print(stderr, "usage: {} FOLDER\n", name);
        return 2;
    }
    try {
        fs::create_directories(argv[1]);
        const fs::path page = fs::path(argv[1]) / file;
        opened(page, std::ios::app);
        const Outcome outcome = work();
        std::ofstream out = opened(page, std::ios::trunc);
        out << outcome.html;
        out.close();
        if (!out) throw std::runtime_error("cannot write " + page.string());
        fmt::print("{}\n", page.string());
        return outcome.right ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", name, error.what());
        return 3;
    }
}

}  // namespace rt::extremes
