#include "commands/grade/submissions.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "commands/base/content_hash.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

constexpr const char* program_name = "raytrace";

/// A file that can be read and executed, and no link: what is a submission's own.
bool is_own_program(const fs::path& path) {
    std::error_code none;
    return fs::symlink_status(path, none).type() == fs::file_type::regular && access(path.c_str(), R_OK | X_OK) == 0;
}

bool has(const fs::path& folder, const char* name) {
    std::error_code none;
    return fs::exists(folder / name, none);
}

bool has_makefile(const fs::path& folder) { return has(folder, "Makefile") || has(folder, "makefile") || has(folder, "GNUmakefile"); }

/// The folder meant by a submission's; none if one on the way cannot be read.
std::optional<fs::path> inner_folder(fs::path folder) {
    for (int depth = 0; depth < 8; ++depth) {
        std::vector<fs::path> folders;
        bool files = false;
        std::error_code error;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
            if (entry.path().filename().string().starts_with('.')) continue;
            if (entry.symlink_status(error).type() == fs::file_type::directory)
                folders.push_back(entry.path());
            else
                files = true;
        }
        if (error) return std::nullopt;
        for (const fs::path& inner : std::vector<fs::path>(folders))
            if (!files && (inner.filename() == "prog1" || inner.filename() == "CPE473")) folders = {inner};
        if (files || folders.size() != 1) break;
        folder = folders.front();
    }
    return folder;
}

/// What lies at a path and leads nowhere else: no link on the way from `folder`.
bool is_in(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    return fs::canonical(path, error) == fs::canonical(folder, error) / path.lexically_relative(folder) && !error;
}

std::string find_program(const fs::path& folder) {
    for (const fs::path& place : {folder / program_name, folder / "build" / program_name})
        if (is_own_program(place) && is_in(place, folder)) return place.string();
    return {};
}

/// The end of what a build printed.
std::string last_lines(const std::string& text, std::size_t count) {
    std::vector<std::string> lines = split(text, '\n');
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    const std::size_t from = lines.size() > count ? lines.size() - count : 0;
    std::string last;
    for (std::size_t i = from; i < lines.size(); ++i) last += (last.empty() ? "" : " / ") + printable(lines[i], 200);
    return last;
}

Limits build_limits() {
    Limits limits;
    limits.wall_seconds = 600.0;
    limits.output_bytes = 16ull << 20;
    limits.file_bytes = 1ull << 30;
    limits.processes = 256;
    return limits;
}

/// Each step in its folder; empty where there is nothing to build with.
struct BuildStep {
    std::vector<std::string> command;
    fs::path folder;
};
std::vector<BuildStep> build_steps(const fs::path& copy) {
    const std::string jobs = std::to_string(std::max(1l, sysconf(_SC_NPROCESSORS_ONLN)));
    if (has(copy, "CMakeLists.txt"))
        return {{{"/usr/bin/cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release"}, copy},
                {{"/usr/bin/cmake", "--build", "build", "--parallel", jobs}, copy}};
    for (const fs::path& place : {copy, copy / "src"})
        if (has_makefile(place)) return {{{"/usr/bin/make", "-j", jobs}, place}};
    return {};
}

Submission without_program(const SourceTree& tree, std::string problem) { return {tree.name, "", "", tree.folder, std::move(problem), ""}; }

/// A program that sees the folder around it, and whose results depend on all of that.
Submission with_folder(const SourceTree& tree, const std::string& program, const std::string& visible) {
    return {tree.name, program, visible, tree.folder, "", hash_of(hash_of_file(program) + hash_of_folder(visible))};
}

/// Builds the copy. Returns why it has no program, or nothing.
std::string problem_of_build(const SourceTree& tree, const fs::path& copy, const Containment& containment, int slot) {
    std::error_code error;
    fs::remove_all(copy, error);
    fs::create_directories(copy.parent_path(), error);
    fs::copy(tree.folder, copy, fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
    if (error) return fmt::format("cannot copy '{}': {}", tree.folder, error.message());
    fs::remove_all(copy / "build", error);
    for (const BuildStep& step : build_steps(copy)) {
        const Ending ending = run_contained({step.command, copy.string(), step.folder.string(), {}, {}}, build_limits(), containment, slot);
        if (ending.kind == Ending::Kind::exited && ending.status == 0) continue;
        const bool late = ending.kind == Ending::Kind::time_out;
        return fmt::format("build failed: {}", late ? "not done in time" : last_lines(ending.output + ending.reason, 3));
    }
    return {};
}

}  // namespace

SourceTree look_at(const std::string& path, bool as_is) {
    std::error_code error;
    const fs::path place = fs::canonical(path, error);
    SourceTree tree;
    tree.name = (fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path()).filename().string();
    if (error) {
        tree.problem = fmt::format("there is no '{}'", path);
    } else if (is_own_program(place)) {
        tree.program = place.string();
    } else if (!fs::is_directory(place, error)) {
        tree.problem = fmt::format("'{}' is no program that can be read and executed, and no folder", path);
    } else if (const std::optional<fs::path> folder = inner_folder(place); !folder) {
        tree.problem = fmt::format("'{}' cannot be read", path);
    } else {
        tree.folder = folder->string();
        const bool sources = !build_steps(*folder).empty();
        if (as_is || !sources) tree.program = find_program(*folder);
        if (tree.program.empty() && !sources)
            tree.problem = fmt::format("'{}' holds neither a program '{}' nor a CMakeLists.txt or makefile", path, program_name);
    }
    return tree;
}

std::vector<std::string> submissions_in(const std::string& folder) {
    std::error_code error;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (!entry.path().filename().string().starts_with('.') && (entry.is_directory(error) || is_own_program(entry.path())))
            paths.push_back(entry.path().string());
    if (error) throw OptionError(fmt::format("cannot read the folder '{}': {}", folder, error.message()));
    if (paths.empty()) throw OptionError(fmt::format("'{}' holds no programs and no folders", folder));
    std::sort(paths.begin(), paths.end());
    return paths;
}

Submission build(const SourceTree& tree, const BuildOptions& options, const Containment& containment, int slot) {
    if (!tree.problem.empty()) return without_program(tree, tree.problem);
    if (!tree.program.empty() && tree.folder.empty()) return {tree.name, tree.program, "", "", "", hash_of_file(tree.program)};
    if (!tree.program.empty()) return with_folder(tree, tree.program, tree.folder);

    const fs::path copy = fs::path(options.folder) / fmt::format("{}-{}", tree.name, hash_of_folder(tree.folder).substr(0, 16));
    const std::string outcome = copy.string() + ".outcome";  // holds what went wrong
    constexpr std::size_t most_bytes = 1u << 16;
    std::optional<std::string> problem = options.fresh ? std::nullopt : read_file_text(outcome, most_bytes);
    if (!problem) {
        problem = problem_of_build(tree, copy, containment, slot);
        write_bytes(outcome, *problem);
    }
    if (!problem->empty()) return without_program(tree, *problem);
    for (const fs::path& place : {copy / "build", copy, copy / "src"})
        if (is_own_program(place / program_name) && is_in(place / program_name, copy))
            return with_folder(tree, (place / program_name).string(), copy.string());
    return without_program(tree, fmt::format("the build made no '{}'", program_name));
}

}  // namespace rt
