#!/usr/bin/env python3
"""Submissions of every kind: built by CMake and by make, nested, broken, hostile while they are built; known ones are not built again.

usage: tests/grade/build_test.py PROGRAM
"""
import json
import os
import pathlib
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import harness  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
SOURCE = '#include <cstdio>\nint main() { std::puts("T = 1.0000"); }\n'
CMAKE = "cmake_minimum_required(VERSION 3.10)\nproject(mine CXX)\nadd_executable(raytrace main.cpp)\n"
MAKE = "raytrace: main.cpp\n\tg++ -o raytrace main.cpp\n"
PATIENCE = 120  # seconds, for what comes at once or never
MARK = f"built-{os.getpid()}"  # in the command line of builds that never end by themselves


def endless(number):
    return f"raytrace:\n\tsh -c 'while :; do sleep 1; done # {MARK}-{number}.'\n"


def script(text):
    """A makefile whose program prints a text that is a shell's word when it is built."""
    return f"raytrace:\n\tprintf '#!/bin/sh\\necho %s\\n' {text} > raytrace; chmod +x raytrace\n"


def marked():
    """Numbers of the endless builds that run."""
    numbers = set()
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            numbers.update(re.findall(MARK + r"-(\d+)\.", (process / "cmdline").read_bytes().decode(errors="replace")))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return numbers


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

    def started(self, *words, **options):
        scratch = self.place / "scratch"
        scratch.mkdir(exist_ok=True)
        return subprocess.Popen([PROGRAM, "grade", self.suite, "--submissions", self.homework, "-o", self.place / "out", *words],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**os.environ, "TMPDIR": str(scratch)}, **options)

    def await_builds(self, run, numbers):
        end = time.monotonic() + PATIENCE
        while marked() != numbers:
            self.assertIsNone(run.poll(), "it has ended")
            self.assertLess(time.monotonic(), end, f"builds {marked()} run, {numbers} expected")

    def test_as_many_builds_at_a_time_as_jobs_and_an_interruption_reports_what_is_known(self):
        self.submit("a", {"Makefile": script("'T = 1.0000'")})
        self.outcomes()
        for number in range(3):
            self.submit(f"b{number}", {"Makefile": endless(number)})
        run = self.started("-j", "2")
        try:
            self.await_builds(run, {"0", "1"})
            run.send_signal(signal.SIGINT)
            out, err = run.communicate()
        finally:
            run.kill()
        self.assertEqual(run.returncode, 2, err)
        self.assertEqual(marked(), set(), "a build that was interrupted is left")
        results = {name: result for (name, _), result in harness.read_results(self.place / "out").items()}
        self.assertEqual(results["a"]["outcome"], "passed")
        for number in range(3):
            self.assertEqual(results[f"b{number}"]["outcome"], "not run")
            self.assertEqual(results[f"b{number}"]["reason"], "the grading was interrupted before")
        self.assertIn("b2 ", out)
        self.assertTrue((self.place / "out" / "junit.xml").exists())

        for number in range(3):  # what was half built is built from the start
            self.submit(f"b{number}", {"Makefile": script("'T = 1.0000'")})
        _, results = self.outcomes()
        self.assertEqual({result["outcome"] for result in results.values()}, {"passed"})

    def test_one_submission_alone_is_interrupted_with_a_report(self):
        self.submit("b0", {"Makefile": endless(0)})
        run = subprocess.Popen([PROGRAM, "grade", self.suite, "--exe", self.homework / "b0", "-o", self.place / "out", "-q"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            self.await_builds(run, {"0"})
            run.send_signal(signal.SIGTERM)
            out, err = run.communicate()
        finally:
            run.kill()
        self.assertEqual((run.returncode, out, err), (2, "", ""))
        self.assertEqual(harness.read_results(self.place / "out")["b0", "t"]["outcome"], "not run")

    def test_a_terminal_shows_how_far_builds_are(self):
        self.submit("a", {"Makefile": script("'T = 1.0000'")})
        self.outcomes()
        self.submit("b", {"Makefile": script("'T =  1.0000'")})
        self.submit("z0", {"Makefile": endless(0)})
        process, terminal = pty.fork()
        if process == 0:
            os.execv(PROGRAM, [PROGRAM, "grade", str(self.suite), "--submissions", str(self.homework), "-o", str(self.place / "out"), "-j", "1"])
        text, interrupted = "", False
        try:
            while select.select([terminal], [], [], PATIENCE)[0]:
                try:
                    text += os.read(terminal, 65536).decode()
                except OSError:
                    break
                if not interrupted and re.search(r" 2/3 builds \(1 known\)  \d+\.\d builds/(s|min)  \d:\d\d:\d\d left", text):
                    os.kill(process, signal.SIGINT)
                    interrupted = True
        finally:
            os.close(terminal)  # which ends what is still there
            _, status = os.waitpid(process, 0)
        self.assertTrue(interrupted, text)
        self.assertEqual(os.waitstatus_to_exitcode(status), 2)

    def test_a_shard_builds_what_it_has_tests_of(self):
        for name in "abcd":
            self.submit(name, {"Makefile": script("'T = 1.0000'")})
        harness.grade(PROGRAM, self.suite, self.place / "out", "--submissions", self.homework, "--shard", "2/4", check=0)
        self.assertEqual([path.name[0] for path in (self.place / "out" / "builds").glob("*.outcome")], ["b"])

    def test_shards_that_share_a_folder_build_each_submission_once(self):
        answers = [{"name": name, "kind": "text", "command": "x", "expected": "answers/t.out"} for name in ("t", "u")]
        self.suite.write_text(json.dumps({"format": "raytrace suite 1", "inputs": "inputs", "tests": answers}))
        for name in "abcd":
            self.submit(name, {"Makefile": script("$$(od -An -N8 -tx8 /dev/urandom)")})
        scratch = self.place / "scratch"
        scratch.mkdir()
        runs = [subprocess.Popen([PROGRAM, "grade", self.suite, "--submissions", self.homework, "--builds", self.place / "builds", "-j", "1",
                                  "--shard", f"{shard}/2", "-o", self.place / f"part{shard}"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 env={**os.environ, "TMPDIR": str(scratch)}) for shard in (1, 2)]
        for run in runs:
            _, err = run.communicate()
            self.assertEqual(run.returncode, 0, err)
        printed = {}
        for shard in (1, 2):
            for (name, _), result in harness.read_results(self.place / f"part{shard}").items():
                printed.setdefault(name, []).append(result["output"])
        self.assertEqual({name: len(texts) for name, texts in printed.items()}, dict.fromkeys("abcd", 2))
        for name, (first, second) in printed.items():
            self.assertEqual(first, second, f"{name} was built twice")
        self.assertFalse((self.place / "part1" / "builds").exists())

    def test_fresh_builds_cannot_be_shared(self):
        self.submit("a", {"Makefile": script("'T = 1.0000'")})
        run = self.started("--fresh", "--builds", self.place / "builds")
        _, err = run.communicate()
        self.assertEqual((run.returncode, err), (1, "raytrace: --fresh builds again what others that share --builds may be running; give one of them\n"))

    def test_names_forge_nothing(self):
        """Folders whose names hold control characters, ends of lines, other encodings, what make and cmake take amiss."""
        odd = "x\033[2J\nraytrace: forged\u0085$(HOME) #;é"
        self.submit(odd, {"Makefile": MAKE, "main.cpp": "int main() { return x; }\n"})
        self.submit("cmake $#;'" + odd, {"CMakeLists.txt": CMAKE, "main.cpp": SOURCE})
        os.mkdir(os.fsencode(self.homework) + b"/\xff")
        os.mkdir(os.fsencode(self.homework) + b"/\xfe")
        run, results = self.outcomes()
        self.assertNotIn("\033", run.stdout + run.stderr)
        self.assertNotIn("\u0085", run.stdout + run.stderr)
        self.assertEqual([line for line in (run.stdout + run.stderr).splitlines() if line.startswith("raytrace: forged")], [])
        self.assertEqual(results["cmake $#;'" + odd]["outcome"], "passed", results)
        self.assertEqual(sorted(results), sorted([odd, "cmake $#;'" + odd, "\ufffd", "\ufffd-2"]))
        self.assertIn("raytrace: x?[2J?raytrace: forged?$(HOME) #;é: build failed: ", run.stderr)
        alone = subprocess.run([PROGRAM, "grade", self.suite, "--exe", self.homework / odd, "-o", self.place / "one"], capture_output=True, text=True)
        self.assertEqual(alone.returncode, 1)
        self.assertIn("raytrace: x?[2J?raytrace: forged?$(HOME) #;é: build failed: ", alone.stderr)
        self.assertNotIn("\033", alone.stderr)

    def test_programs_of_one_name_are_told_apart(self):
        for folder in ("1", "2", "3"):
            self.submit(f"{folder}/x", {"raytrace": f"#!/bin/sh\necho 'T = {folder}.0000'\n"})
            (self.homework / folder / "x" / "raytrace").chmod(0o755)
        shutil.copytree(self.homework / "3" / "x", self.homework / "3" / "x-2")
        words = [word for folder in ("1/x", "2/x", "3/x", "3/x-2") for word in ("--exe", self.homework / folder)]
        _, results = harness.grade(PROGRAM, self.suite, self.place / "out", *words, check=0)
        self.assertEqual({name: result["output"].split()[2][0] for (name, _), result in results.items()},
                         {"x": "1", "x-3": "2", "x-4": "3", "x-2": "3"})

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

    def test_what_lies_in_the_place_of_scratch_is_put_away(self):
        victim = self.place / "victim"
        victim.mkdir()
        (victim / "file").write_text("mine")
        self.submit("file", {"Makefile": script("'T = 1.0000'"), ".raytrace-scratch": "a file"})
        self.submit("link", {"Makefile": script("'T = 1.0000'")})
        (self.homework / "link" / ".raytrace-scratch").symlink_to(victim)
        self.submit("between", {"CMakeLists.txt": CMAKE + f"file(REMOVE_RECURSE .raytrace-scratch)\nfile(CREATE_LINK {victim} .raytrace-scratch SYMBOLIC)\n",
                                "main.cpp": SOURCE})
        _, results = self.outcomes()
        self.assertEqual({name: result["outcome"] for name, result in results.items()}, dict.fromkeys(("file", "link", "between"), "passed"))
        self.assertEqual((victim / "file").read_text(), "mine")

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
