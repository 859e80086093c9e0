// From fork to execve: how a program becomes one that has nothing of ours but what it is given.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "grading/sandbox.h"

namespace rt {

struct ProgramStart {
    std::vector<std::string> command;
    std::string home;            ///< the value of HOME
    std::string scratch;         ///< of TMPDIR
    std::string working_folder;  ///< where it starts
    std::optional<uid_t> user;   ///< whose it becomes; none: stays ours
    std::vector<int> entrances;  ///< of the control groups it joins
    int input = -1, output = -1;
    Limits limits;
    bool limit_addresses = true;          ///< each process's address space; not where a control group counts all their memory
    std::optional<long> users_processes;  ///< processes and threads that the user may have in all
};

/// Starts the program in a session of its own; it dies with us. Throws std::system_error naming the step that failed, execve's included.
pid_t start_program(const ProgramStart& start);

/// A list of words as execve wants it; valid as long as the words are.
std::vector<char*> pointers_to(const std::vector<std::string>& words);

/// All signals handled as the system does by itself, none blocked.
void reset_signals();

}  // namespace rt
