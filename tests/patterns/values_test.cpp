// Every pattern against POV-Ray's own numbers: those kept in values.txt, and those of the installed povray, asked anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/patterns/cases.h"

namespace rt::values_test {
namespace {

using Values = std::map<std::string, std::vector<double>>;

const std::string kept = PROJECT_ROOT "/tests/patterns/values.txt";

Values read_values(std::istream& in) {
    Values values;
    std::string line;
    while (std::getline(in, line)) {
        const auto colon = line.find(" : ");
        if (colon == std::string::npos) continue;
        std::istringstream numbers(line.substr(colon + 3));
        for (double v = 0; numbers >> v;) values[line.substr(0, colon)].push_back(v);
    }
    return values;
}

double ours(const Pattern& pattern, const Vec3& p) {
    return has_cells(pattern.kind) ? pattern_cell(pattern, p) : pattern_value(pattern, p);
}

/// One failure a case: how many points differ, and the first of them.
void compare(const Values& expected) {
    const auto points = case_points();
    for (const auto& [text, pattern] : pattern_cases()) {
        const auto found = expected.find(text);
        ASSERT_NE(found, expected.end()) << text;
        ASSERT_EQ(found->second.size(), points.size()) << text;
        // POV-Ray interpolates grids in single precision.
        const bool is_grid = pattern.kind == PatternKind::density_file || pattern.kind == PatternKind::image_pattern;
        const double tolerance = is_grid ? 1e-6 : 1e-9;
        std::vector<std::size_t> wrong;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!(std::fabs(ours(pattern, points[i]) - found->second[i]) <= tolerance)) wrong.push_back(i);
        if (wrong.empty()) continue;
        const Vec3& p = points[wrong[0]];
        ADD_FAILURE() << fmt::format("{}: {} of {} points differ; at <{}, {}, {}> {} instead of {}", text, wrong.size(), points.size(), p.x,
                                     p.y, p.z, ours(pattern, p), found->second[wrong[0]]);
    }
}

std::string escaped(std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

/// A scene that prints all cases at all points while it is parsed.
void write_scene(const std::filesystem::path& path) {
    std::ofstream scene(path);
    scene << "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#fopen Out \"values.out\" write\n";
    for (const auto& [text, pattern] : pattern_cases()) {
        scene << "#declare F = function { pattern { " << text << " } }\n#write (Out, \"" << escaped(text) << " :\")\n";
        for (const Vec3& p : case_points())
            scene << fmt::format("#write (Out, \" \", str(F({:.17g}, {:.17g}, {:.17g}), 0, 12))\n", p.x, p.y, p.z);
        scene << "#write (Out, \"\\n\")\n#undef F\n";
    }
    scene << "#fclose Out\ncamera { location 0 }\n";
}

TEST(PatternValues, AreThoseKept) {
    std::ifstream in(kept);
    ASSERT_TRUE(in) << kept;
    compare(read_values(in));
}

TEST(PatternValues, AreThoseOfTheInstalledPovRay) {
    if (std::system("command -v povray > /dev/null 2>&1") != 0) GTEST_SKIP() << "povray is not installed";
    const auto folder = std::filesystem::path(testing::TempDir()) / fmt::format("pattern_values_{}", getpid());
    std::filesystem::create_directories(folder);
    write_scene(folder / "values.pov");
    std::ofstream(folder / "cases.df3", std::ios::binary) << case_density();
    std::ofstream(folder / "cases.pgm", std::ios::binary) << case_picture_file();
    const std::string command = fmt::format("cd '{}' && povray +Ivalues.pov +W1 +H1 -F -D > log 2>&1", folder.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << folder;
    std::ifstream in(folder / "values.out");
    const Values measured = read_values(in);
    compare(measured);
    if (std::getenv("WRITE_PATTERN_VALUES") != nullptr)
        std::filesystem::copy_file(folder / "values.out", kept, std::filesystem::copy_options::overwrite_existing);
    if (!HasFailure()) std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rt::values_test
