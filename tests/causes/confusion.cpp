#include "tests/causes/confusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "commands/causes/wrong_picture.h"
#include "grading/difference.h"
#include "tests/causes/mistakes.h"

namespace rt::test {

namespace {

namespace fs = std::filesystem;

StoredImage traced(const std::string& program, const fs::path& folder, const TestCase& test, const std::string& fault) {
    fs::create_directories(folder / "build");
    const std::string command = fmt::format("cd '{}' && RAYTRACE_FAULT={} '{}' {} -t2 2>&1", (folder / "build").string(), fault, program,
                                            fmt::join(test.arguments, " "));
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
    return read_image((folder / "build" / "output.png").string());
}

}  // namespace

Confusion::Confusion(const std::vector<SceneCase>& scenes) {
    std::string pattern = (fs::temp_directory_path() / "raytrace_causes_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error(pattern);
    folder_ = pattern;
    const fs::path inputs = fs::path(folder_) / "resources";
    fs::create_directories(inputs);
    suite_.inputs = inputs.string();
    for (const SceneCase& scene : scenes) {
        TestCase test;
        test.name = scene.name;
        test.arguments = {"render", fmt::format("../resources/{}.pov", scene.name), std::to_string(scene.width),
                          std::to_string(scene.height)};
        test.arguments.insert(test.arguments.end(), scene.options.begin(), scene.options.end());
        std::ofstream(inputs / (scene.name + ".pov")) << scene.text;
        traced(PROGRAM, folder_, test, "");
        test.expected = (fs::path(folder_) / (scene.name + ".png")).string();
        fs::rename(fs::path(folder_) / "build" / "output.png", test.expected);
        suite_.tests.push_back(std::move(test));
    }
}

Confusion::~Confusion() {
    std::error_code none;
    fs::remove_all(folder_, none);
}

void Confusion::judge(const std::string& mistake, const std::vector<std::string>& causes, const TestCase& test, const StoredImage& expected,
                      const StoredImage& actual) {
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const auto& r) { return r.first == mistake; });
    if (row == rows_.end()) row = rows_.insert(rows_.end(), {mistake, {}});
    // As the course's graders have it, 1000 of 640 x 480.
    const Difference d = compare(expected, actual, {.fuzz_percent = 5.0});
    if (d.differing * 640 * 480 <= 1000 * d.pixels) return;
    const Verdicts verdicts = cause_of(suite_, test, expected, actual);
    const auto is_right = [&](const std::string& cause) { return std::find(causes.begin(), causes.end(), cause) != causes.end(); };
    ++row->second.asked;
    if (is_right(verdicts.cause)) {
        ++row->second.right;
        return;
    }
    ++row->second.others[verdicts.cause.empty() ? "none" : verdicts.cause];
    row->second.among_equals += std::any_of(verdicts.lines.begin() + 1, verdicts.lines.end(), [&](const std::string& line) {
        return std::any_of(causes.begin(), causes.end(),
                           [&](const std::string& c) { return line.starts_with("as well explained by " + c); });
    });
    if (std::getenv("RAYTRACE_CAUSES_VERBOSE"))
        fmt::print(stderr, "{} on {} ({}): '{}'\n  {}\n", mistake, test.name, d.differing, verdicts.cause,
                   fmt::join(verdicts.lines, "\n  "));
}

void Confusion::run() {
    for (std::size_t i = 0; i < suite_.tests.size(); ++i) {
        const TestCase& test = suite_.tests[i];
        const StoredImage expected = read_image(test.expected);
        for (const Spoil& spoil : spoils()) judge(spoil.name, spoil.right, test, expected, spoil.apply(expected));
        const TestCase& next = suite_.tests[(i + 1) % suite_.tests.size()];
        judge("another test's picture", {"picture of another test"}, test, expected, read_image(next.expected));
        for (const PlantedFault& fault : planted_faults())
            judge(fault.name, fault.right, test, expected, traced(FAULTY, folder_, test, fault.name));
    }
}

std::string Confusion::table() const {
    std::string text;
    for (const auto& [mistake, row] : rows_) {
        text += fmt::format("{:<24} {:>3} of {:>3}", mistake, row.right, row.asked);
        if (row.among_equals > 0) text += fmt::format("  ({} named among equals)", row.among_equals);
        for (const auto& [cause, count] : row.others) text += fmt::format("  {} x {}", count, cause);
        text += '\n';
    }
    return text + fmt::format("{:<24} {:>3} of {:>3} ({:.1f} %)\n", "all", right(), asked(), 100.0 * right() / std::max(asked(), 1));
}

int Confusion::right() const {
    return std::accumulate(rows_.begin(), rows_.end(), 0, [](int sum, const auto& row) { return sum + row.second.right; });
}
int Confusion::asked() const {
    return std::accumulate(rows_.begin(), rows_.end(), 0, [](int sum, const auto& row) { return sum + row.second.asked; });
}

}  // namespace rt::test
