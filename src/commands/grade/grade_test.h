// One test of one program, from its start to its entry in the store.
#pragma once

#include <map>
#include <string>

#include "commands/grade/grade_store.h"
#include "grading/suite.h"
#include "grading/turn.h"

namespace rt {

/// A program to be graded.
struct Submission {
    std::string name;
    std::string program;                             ///< absolute path; empty: there is none
    std::string visible;                             ///< folder that it can read; empty: nothing but itself
    std::string scenes;                              ///< folder of scenes of its author's own, for tests that are only shown; may be empty
    std::string problem;                             ///< why there is no program, e.g. the last lines of its build
    Outcome without_program = Outcome::not_started;  ///< what each test comes to if there is none
    std::string hash;                                ///< of the program and of what it can read of its author's
};

/// A part of a grading that is spread over machines: every `of`-th test of the whole list, from the `index`-th.
struct Shard {
    std::size_t index = 0, of = 1;
};

/// What all tests of a grading share.
struct Grading {
    Suite suite;
    Containment containment;
    std::string common_hash;  ///< of what every result depends on: the scenes, what is readable, containment, and this program
    std::map<std::string, std::string> rule_hashes;  ///< by tests' names: of what each says, its right answer among it
    std::vector<std::string> readable;               ///< files and folders that every program may read besides
    std::string folder;                              ///< of the results: never shown to a program
    std::string turns;                               ///< where graders take turns, see turn.h
    bool fresh = false;                              ///< what is known is not taken
};

/// `Grading::common_hash` of the other members.
std::string common_hash_of(const Grading& grading);

/// `Grading::rule_hashes`: reads every right answer once, however many programs are graded by it.
std::map<std::string, std::string> rule_hashes_of(const Suite& suite);

/// Everything that the result of a test depends on, as one name.
std::string key_of(const Grading& grading, const Submission& submission, const TestCase& test);

/// Runs the program in a folder of its own that is removed afterwards, judges what it did and puts the result into the store. `slot` tells
/// tests at the same time apart. Throws OutputError if the run failed and the disk may be to blame: nothing is known then.
void run_test(const Grading& grading, const Submission& submission, const TestCase& test, const GradeStore& store, int slot,
              Turn::Kind kind);

/// Whether the author of `submission` has the scene of a test that is only shown.
bool has_scene(const Submission& submission, const TestCase& test);

/// Whether a run that was ended after `wall_seconds` may have waited for processors. One that had as many as it wanted, `busy_threads` of
/// them, nearly all of its time, or that nearly never wanted one, would be as late alone.
bool may_have_waited(double cpu_seconds, double wall_seconds, int busy_threads);

/// The result of a test of a submission without a program.
Result result_without_program(const Submission& submission, const TestCase& test);

}  // namespace rt
