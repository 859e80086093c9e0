// One test of one program, from its start to its entry in the store.
#pragma once

#include <map>
#include <string>

#include "commands/grade/grade_store.h"
#include "grading/suite.h"

namespace rt {

/// A program to be graded.
struct Submission {
    std::string name;
    std::string program;  ///< absolute path; empty: there is none
    std::string visible;  ///< folder that it can read; empty: nothing but itself
    std::string scenes;   ///< folder of scenes of its author's own, for tests that are only shown; may be empty
    std::string problem;  ///< why there is no program, e.g. the last lines of its build
    std::string hash;     ///< of the program and of what it can read of its author's
};

/// What all tests of a grading share.
struct Grading {
    Suite suite;
    Containment containment;
    std::string common_hash;  ///< of what every result depends on: the scenes, what is readable, containment, and this program
    std::map<std::string, std::string> rule_hashes;  ///< by tests' names: of what each says, its right answer among it
    std::vector<std::string> readable;               ///< files and folders that every program may read besides
    std::string folder;                              ///< of the results: never shown to a program
};

/// `Grading::common_hash` of the other members.
std::string common_hash_of(const Grading& grading);

/// `Grading::rule_hashes`: reads every right answer once, however many programs are graded by it.
std::map<std::string, std::string> rule_hashes_of(const Suite& suite);

/// Everything that the result of a test depends on, as one name.
std::string key_of(const Grading& grading, const Submission& submission, const TestCase& test);

/// Runs the program in a folder of its own that is removed afterwards, judges what it did and puts the result into the store. `slot` tells
/// tests at the same time apart; `alone`: there are none.
void run_test(const Grading& grading, const Submission& submission, const TestCase& test, const GradeStore& store, int slot, bool alone);

/// Whether the author of `submission` has the scene of a test that is only shown.
bool has_scene(const Submission& submission, const TestCase& test);

/// The result of a test of a submission without a program.
Result result_without_program(const Submission& submission, const TestCase& test);

}  // namespace rt
