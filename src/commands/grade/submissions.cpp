#include "commands/grade/submissions.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "commands/base/content_hash.h"
#include "commands/base/values.h"
#include "commands/base/write_bytes.h"
#include "core/utf8.h"
#include "syntax/file_text.h"

namespace rt {

namespace {

namespace fs = std::filesystem;

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

std::string find_program(const std::string& folder) {
    const std::string program = own_program(folder, program_name);
    return program.empty() ? own_program(folder, fmt::format("build/{}", program_name)) : program;
}

}  // namespace

SourceTree look_at(const std::string& path, bool as_is) {
    std::error_code error;
    const fs::path place = fs::canonical(path, error);
    SourceTree tree;
    tree.name = valid_utf8((fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path()).filename().string());
    if (error) {
        tree.problem = fmt::format("there is no '{}'", printable(path));
    } else if (is_own_program(place)) {
        tree.program = place.string();
    } else if (!fs::is_directory(place, error)) {
        tree.problem = fmt::format("'{}' is no program that can be read and executed, and no folder", printable(path));
    } else if (const std::optional<fs::path> folder = inner_folder(place); !folder) {
        tree.problem = fmt::format("'{}' cannot be read", printable(path));
    } else {
        tree.folder = folder->string();
        const bool sources = !build_steps(*folder, 1).empty();
        if (as_is || !sources) tree.program = find_program(folder->string());
        if (tree.program.empty() && !sources)
            tree.problem = fmt::format("'{}' holds neither a program '{}' nor a CMakeLists.txt or makefile", printable(path), program_name);
    }
    return tree;
}

std::vector<std::string> submissions_in(const std::string& folder) {
    std::error_code error;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (!entry.path().filename().string().starts_with('.') && (entry.is_directory(error) || is_own_program(entry.path())))
            paths.push_back(entry.path().string());
    if (error) throw OptionError(fmt::format("cannot read the folder '{}': {}", printable(folder), error.message()));
    if (paths.empty()) throw OptionError(fmt::format("'{}' holds no programs and no folders", printable(folder)));
    std::sort(paths.begin(), paths.end());
    return paths;
}

Submission not_built(const SourceTree& tree) {
    Submission submission;
    submission.name = tree.name, submission.scenes = tree.folder, submission.problem = tree.problem;
    return submission;
}

void give_program(Submission& submission, const std::string& program, const std::string& visible) {
    submission.program = program, submission.visible = visible;
    submission.hash = hash_of_file(program);
    if (!visible.empty()) submission.hash = hash_of(submission.hash + hash_of_folder(visible));
}

std::string own_program(const std::string& folder, const std::string& name) {
    const fs::path place = fs::path(folder) / name;
    return is_own_program(place) && is_in(place, folder) ? place.string() : std::string();
}

std::vector<BuildStep> build_steps(const std::string& folder, int jobs) {
    const std::string at_a_time = std::to_string(jobs);
    if (has(folder, "CMakeLists.txt"))
        return {{{"/usr/bin/cmake", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Release"}, folder},
                {{"/usr/bin/cmake", "--build", "build", "--parallel", at_a_time}, folder}};
    for (const fs::path& place : {fs::path(folder), fs::path(folder) / "src"})
        if (has_makefile(place)) return {{{"/usr/bin/make", "-j", at_a_time}, place.string()}};
    return {};
}

}  // namespace rt
