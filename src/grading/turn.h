// Who runs beside whom, among all graders of one user on one machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grading/file_lock.h"

namespace rt {

/// Held while a program is run and judged. Any number of them are held together; one that is `alone` waits for those that are held, and
/// later ones wait for it. So what a time says does not depend on how many graders were started: shards, or gradings of other suites.
class Turn {
public:
    enum class Kind { together, alone };

    /// Waits. `place`: the file that graders share; see place_of_turns(). Where it is empty, or has no locks, nothing is waited for.
    Turn(const std::string& place, Kind kind);

    /// Whether no other turn has been held since this one began, as far as can be known.
    bool was_alone() const;

private:
    /// Bytes of the file: a number that each turn raises, then two locks. Whoever wants a turn first has the gate, so that one who waits
    /// to be alone is not passed by those who come later.
    static constexpr off_t number_at = 0, gate = 8, room = 9;

    std::uint64_t number() const;

    std::optional<LockFile> file_;
    std::uint64_t own_number_ = 0;
    bool began_alone_ = false, stays_alone_ = false;
};

/// A file in /tmp that is this user's, whatever TMPDIR says, or the one that RAYTRACE_TURNS names. Throws std::system_error if it cannot
/// be used.
std::string place_of_turns();

}  // namespace rt
