// The program's commands. Each takes the words behind its name and returns the exit status; mistakes are exceptions.
#pragma once

#include <string>
#include <vector>

namespace rt {

using Words = std::vector<std::string>;

/// Picks the command by the first word: one of the course's, one of ours, else a render.
int run_program(const Words& words);

int run_render(const Words& words);
int run_requires(const Words& words);
int run_compare(const Words& words);
int run_explain(const Words& words);
int run_brdf(const Words& words);
/// [TABLE] FILE...
int run_brdf_check(const Words& words);
int run_brdf_plot(const Words& words);
int run_grade(const Words& words);
int run_merge(const Words& words);
int run_versus(const Words& words);
int run_trade(const Words& words);
int run_help(const Words& words);
int run_version(const Words& words);
/// Whether `word` is one of the course's commands.
bool is_course_command(const std::string& word);
/// The course's dialect; `command` is its first word, one of those.
int run_course(const std::string& command, const Words& words);

}  // namespace rt
