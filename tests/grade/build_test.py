#!/usr/bin/env python3
"""Submissions of every kind: built by CMake and by make, nested, broken, hostile while they are built; known ones are not built again.

usage: tests/grade/build_test.py PROGRAM
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import harness  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
SOURCE = '#include <cstdio>\nint main() { std::puts("T = 1.0000"); }\n'
CMAKE = "cmake_minimum_required(VERSION 3.10)\nproject(mine CXX)\nadd_executable(raytrace main.cpp)\n"
MAKE = "raytrace: main.cpp\n\tg++ -o raytrace main.cpp\n"


class Build(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_build_"))
        self.place.chmod(0o755)  # runs may be another user's
        self.homework = self.place / "homework"
        (self.place / "inputs").mkdir()
        (self.place / "answers").mkdir()
        (self.place / "answers" / "t.out").write_text("T = 1.0000\n")
        self.suite = self.place / "suite.json"
        self.suite.write_text(json.dumps({"format": "raytrace suite 1", "inputs": "inputs",
                                          "tests": [{"name": "t", "kind": "text", "command": "x", "expected": "answers/t.out"}]}))

    def tearDown(self):
        shutil.rmtree(self.place)

    def submit(self, name, files):
        for path, text in files.items():
            path = self.homework / name / path
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def outcomes(self, check=0):
        run, results = harness.grade(PROGRAM, self.suite, self.place / "out", "--submissions", self.homework, check=check)
        return run, {name: result for (name, _), result in results.items()}

    def test_every_kind(self):
        self.submit("cmake", {"CMakeLists.txt": CMAKE, "main.cpp": SOURCE})
        self.submit("make", {"Makefile": MAKE, "main.cpp": SOURCE})
        self.submit("make_in_src", {"README": "", "src/makefile": MAKE, "src/main.cpp": SOURCE})
        self.submit("nested", {"ray/prog1/Makefile": MAKE, "ray/prog1/main.cpp": SOURCE})
        self.submit("broken", {"Makefile": MAKE, "main.cpp": "int main() { return x; }\n"})
        self.submit("empty", {"README": "nothing yet"})
        self.submit("other_name", {"Makefile": "ray: main.cpp\n\tg++ -o ray main.cpp\n", "main.cpp": SOURCE})
        run, results = self.outcomes()
        for name in ("cmake", "make", "make_in_src", "nested"):
            self.assertEqual(results[name]["outcome"], "passed", f"{name}: {run.stderr}")
        for name, words in (("broken", "build failed: "), ("empty", "holds neither a program 'raytrace' nor a CMakeLists.txt or makefile"),
                            ("other_name", "the build made no 'raytrace'")):
            self.assertEqual(results[name]["outcome"], "not started")
            self.assertIn(words, results[name]["reason"])
        self.assertEqual(len((self.place / "out" / "results.csv").read_text().splitlines()), 8)
        self.assertEqual(sorted(path.stem for path in (self.place / "out" / "gradescope").iterdir()), sorted(results))

    def test_sources_stay_as_they_are_and_known_builds_are_taken(self):
        self.submit("cmake", {"CMakeLists.txt": CMAKE, "main.cpp": SOURCE})
        self.outcomes()
        self.assertEqual(sorted(path.name for path in (self.homework / "cmake").iterdir()), ["CMakeLists.txt", "main.cpp"])
        built = next((self.place / "out" / "builds").glob("cmake-*/build/raytrace"))
        moment = built.stat().st_mtime_ns
        self.outcomes()
        self.assertEqual(built.stat().st_mtime_ns, moment)
        (self.homework / "cmake" / "main.cpp").write_text(SOURCE.replace("1.0", "2.0"))
        _, results = self.outcomes()
        self.assertEqual(results["cmake"]["outcome"], "wrong answer")

    def test_what_a_program_has_beside_it_can_be_read_and_counts(self):
        self.submit("reader", {"Makefile": "raytrace: script\n\tcp script raytrace; chmod +x raytrace\n", "data.txt": "T = 1.0000\n",
                               "script": '#!/bin/sh\ncat "$(dirname "$0")/data.txt"\n'})
        _, results = self.outcomes()
        self.assertEqual(results["reader"]["outcome"], "passed", results["reader"])
        (self.homework / "reader" / "data.txt").write_text("T = 2.0000\n")
        _, results = self.outcomes()
        self.assertEqual(results["reader"]["outcome"], "wrong answer")

    def test_links_make_nothing_a_submissions_own(self):
        self.submit("alice", {"raytrace": "#!/bin/sh\necho 'T = 1.0000'\n"})
        (self.homework / "alice" / "raytrace").chmod(0o755)
        (self.homework / "mallory").mkdir()
        (self.homework / "mallory" / "raytrace").symlink_to("../alice/raytrace")
        (self.homework / "eve").mkdir()
        (self.homework / "eve" / "mine").symlink_to("../alice")
        self.submit("trudy", {"Makefile": f"raytrace:\n\tln -s {self.homework}/alice/raytrace raytrace\n"})
        _, results = self.outcomes()
        self.assertEqual(results["alice"]["outcome"], "passed")
        for name in ("mallory", "eve", "trudy"):
            self.assertEqual(results[name]["outcome"], "not started", name)

    def test_failed_builds_are_known_and_rebuilt_when_asked(self):
        self.submit("broken", {"Makefile": MAKE, "main.cpp": "int main() { return x; }\n"})
        self.outcomes()
        outcome = next((self.place / "out" / "builds").glob("broken-*.outcome"))
        moment = outcome.stat().st_mtime_ns
        self.outcomes()
        self.assertEqual(outcome.stat().st_mtime_ns, moment)
        harness.grade(PROGRAM, self.suite, self.place / "out", "--submissions", self.homework, "--fresh", check=0)
        self.assertNotEqual(outcome.stat().st_mtime_ns, moment)

    def test_a_broken_answer_is_not_the_programs_fault(self):
        (self.place / "answers" / "p.png").write_text("no picture")
        self.suite.write_text(json.dumps({"format": "raytrace suite 1", "inputs": "inputs",
                                          "tests": [{"name": "p", "command": "x", "expected": "answers/p.png"}]}))
        self.submit("right", {"raytrace": "#!/bin/sh\nexit 0\n"})
        (self.homework / "right" / "raytrace").chmod(0o755)
        _, results = self.outcomes()
        self.assertEqual(results["right"]["outcome"], "not judged", results["right"])

    def test_a_hostile_build_is_contained(self):
        mark = self.place / "mark"
        self.submit("writer", {"Makefile": f"raytrace:\n\t-touch {mark} {self.suite} {self.place}/answers/t.out\n\tcat {self.place}/answers/t.out\n"})
        run, results = self.outcomes()
        if "warning:" in run.stderr:
            self.skipTest("not contained here")
        self.assertEqual(results["writer"]["outcome"], "not started")
        self.assertFalse(mark.exists())
        self.assertNotIn("T = 1.0000", json.dumps(results))

    def test_one_program_that_is_none(self):
        run = subprocess.run([PROGRAM, "grade", self.suite, "--exe", self.place / "inputs", "-o", self.place / "out"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("holds neither a program 'raytrace' nor a CMakeLists.txt or makefile", run.stderr)

    def test_mistakes_on_the_command_line(self):
        for words, text in ((["grade"], "grade: expected one suite; see raytrace grade --help"),
                            (["grade", self.suite], "grade: expected --exe PROGRAM or --submissions DIR; see raytrace grade --help"),
                            (["grade", "nothing"], "there is no suite 'nothing'"),
                            (["grade", self.suite, "--exe", "nothing"], "nothing: there is no 'nothing'"),
                            (["grade", self.suite, "--shard", "3/2", "--exe", PROGRAM], "shard"),
                            (["grade", self.suite, "--only", "(", "--exe", PROGRAM], "--only: '(' is no regular expression"),
                            (["grade", self.suite, "--only", "zzz", "--exe", PROGRAM], "--only: no test's name matches 'zzz'"),
                            (["merge"], "merge: expected the output folders of shards"),
                            (["merge", self.place], "cannot read")):
            run = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, cwd=self.place)
            self.assertEqual(run.returncode, 1, words)
            self.assertIn(text, run.stderr)
            self.assertEqual(run.stdout, "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
