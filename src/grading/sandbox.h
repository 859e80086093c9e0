// One program, run so that whatever it does stays in a folder of its own and ends: the only place that starts processes.
//
// A run has three processes of ours around it. The caller's lends it a user, a control group and its folder (sandbox.cpp); a keeper, forked
// from the caller, watches it and outlives the caller by as long as it takes to end everything (keeper.cpp); and bubblewrap makes the room
// in which it runs, with its own root folder, processes and network (bubblewrap_room.cpp). The program itself is the keeper's child, so
// that what it ended with is what the kernel says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// What one run may use. Beyond any of it the run ends, with all the processes it has started.
struct Limits {
    double wall_seconds = 60.0;
    std::uint64_t memory_bytes = 4ull << 30;  ///< of all its processes where memory is a control group's, else of each
    std::uint64_t output_bytes = 1ull << 20;  ///< standard output and error together
    std::uint64_t file_bytes = 1ull << 28;    ///< of any one file
    std::uint64_t folder_bytes = 1ull << 30;  ///< of all its files, seen four times a second: it may write more in between
    int processes = 64;                       ///< at one time, threads counted
    bool operator==(const Limits&) const = default;
};

/// A program, its words and what it can see: the system read-only, `readable` read-only, `folder` for its own, and nothing else.
struct ContainedRun {
    std::vector<std::string> command;   ///< program (absolute path that it can see) and its arguments
    std::string folder;                 ///< absolute; may be written
    std::string working_folder;         ///< absolute; `folder`, one in it, or one that it can read
    std::vector<std::string> readable;  ///< absolute paths of files and folders
    std::vector<std::string> hidden;    ///< absolute paths that are empty for it even if they lie in a readable folder
    std::string scratch{};              ///< absolute, in `folder`: what TMPDIR says; empty: /tmp, or `folder` where that is everybody's
};

struct Ending {
    enum class Kind : std::uint8_t { exited, signalled, time_out, out_of_memory, too_much_output, not_started };
    Kind kind = Kind::not_started;
    int status = 0;               ///< of `exited`: the exit status; else the signal, 0 if there was none
    std::string reason;           ///< of `not_started`: what the system said; of the ends by a limit: which one
    std::string output;           ///< standard output and error as they came, cut at the limit
    bool left_processes = false;  ///< some were still there when the program had ended; they are no more
    double wall_seconds = 0.0, cpu_seconds = 0.0;
    std::uint64_t peak_memory_bytes = 0;  ///< of all its processes where memory is a control group's, else of the largest; 0: not known
    int busy_threads = 0;                 ///< of `time_out`: those that ran or waited for a processor when the time was over
    std::uint64_t least_room_bytes = ~std::uint64_t{0};  ///< that its folder's disk had left, seen four times a second and at its end
};

/// What this machine lets us contain. Found out once by trying; never guessed from a name or a version. Throws OutputError if there is no
/// folder to try it in: a full disk says nothing of what could be contained.
struct Containment {
    std::string bubblewrap;                ///< path of the program; empty: none that works here
    std::string bubblewrap_problem;        ///< why there is none
    std::string memory_group, pids_group;  ///< folders of control groups we may make groups in (version 2: the same); empty: none
    bool own_user = false;                 ///< runs get a user of their own (only root can give them one)
};
Containment find_containment();
/// What a run can do in spite of us, in sentences for whoever is about to start it; empty if nothing is known.
std::vector<std::string> holes(const Containment& containment);

/// Runs and waits. When it returns nothing that the run started is alive, and `run.folder` may be read and removed by us, unless the
/// machine could not contain it (see `holes`). `slot` tells runs at the same time apart (their user, their control group): 0, 1, 2, ...
/// Never throws for what the program does. If the sandbox itself cannot be made or the program cannot be executed, the ending is
/// `not_started` with a reason. The calling process has one thread; its signal dispositions do not matter and stay as they are.
Ending run_contained(const ContainedRun& run, const Limits& limits, const Containment& containment, int slot);

}  // namespace rt
