#!/usr/bin/env python3
"""A grading in parts: the README's recipe for GNU parallel, joined, is one run; what is late is run again with no part beside it.

usage: tests/grade/shards_test.py PROGRAM

Without GNU parallel (Debian package parallel) its recipe is not tested, and that is said.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import harness  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
TIMES = re.compile(r'time="[\d.]+"|"execution_time": \d+|(?<=,)\d+\.\d{3},\d+\.\d{3},\d+\.\d{3},\d+(?=\n)')


def reports(folder):
    """By their names: the bytes of every report but the one of times."""
    files = [path for path in sorted(folder.rglob("*")) if path.is_file() and path.relative_to(folder).parts[0] not in ("known", "builds")]
    return {str(path.relative_to(folder)): path.read_bytes() for path in files if path.name != "times.json"}


class Shards(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_shards_"))
        self.place.chmod(0o755)
        (self.place / "bin").mkdir()
        (self.place / "bin" / "raytrace").symlink_to(PROGRAM)
        (self.place / "scratch").mkdir()
        self.environment = {**os.environ, "TMPDIR": str(self.place / "scratch"), "PATH": f"{self.place}/bin:{os.environ['PATH']}"}

    def tearDown(self):
        shutil.rmtree(self.place)

    def lay_out_as_the_course_does(self):
        made = harness.make_suite(PROGRAM, self.place / "made").parent
        suite = self.place / "suite"
        (suite / "tests").mkdir(parents=True)
        shutil.copytree(made / "inputs", suite / "inputs")
        for name, kind, words in harness.TESTS:
            (suite / "tests" / f"{name}.args").write_text(words)
            shutil.copy(made / "answers" / f"{name}.{'out' if kind == 'text' else 'png'}", suite / "tests")
        (suite / "tests" / "tests.json").write_text(json.dumps(
            [{"name": name, "type": "text" if kind == "text" else "image", "required": True} for name, kind, _ in harness.TESTS]))

    def make_homework(self):
        homework = self.place / "homework"
        for name, script in (("right", 'exec "$real" "$@"'), ("dark", '"$real" "$@"; [ "$1" = render ] && convert output.png -negate output.png'),
                             ("crash", "kill -SEGV $$")):
            harness.make_program(PROGRAM, homework / name, script)
        for name, text in (("built", "T = 1"), ("also built", "T = 2"), ("broken", "")):
            (homework / name).mkdir()
            (homework / name / "Makefile").write_text(f"raytrace:\n\tprintf '#!/bin/sh\\necho {text}\\n' > raytrace; chmod +x raytrace; test '{text}'\n")

    def run_words(self, words):
        run = subprocess.run(words, shell=isinstance(words, str), cwd=self.place, env=self.environment, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, f"{words}\n{run.stdout}\n{run.stderr}")

    @unittest.skipUnless(shutil.which("parallel"), "there is no GNU parallel")
    def test_the_recipe_for_gnu_parallel_is_one_run(self):
        self.lay_out_as_the_course_does()
        self.make_homework()
        recipe = re.findall(r"^    ((?:parallel -j|raytrace merge) .*)$", README.read_text(), re.M)
        self.assertEqual(len(recipe), 2, recipe)
        for line in recipe:
            self.run_words(line)
        joined = reports(self.place / "results")
        self.assertEqual(sorted(joined), ["gradescope/also built.json", "gradescope/broken.json", "gradescope/built.json", "gradescope/crash.json",
                                          "gradescope/dark.json", "gradescope/right.json", "index.html", "junit.xml", "reports/also built.html",
                                          "reports/broken.html", "reports/built.html", "reports/crash.html", "reports/dark.html",
                                          "reports/right.html", "results.csv", "results.json", "tests.json"])

        # One run, whose times are others.
        whole = ["raytrace", "grade", "suite", "--submissions", "homework", "--builds", "builds", "-q", "-o"]
        self.run_words([*whole, "whole"])
        for name, text in reports(self.place / "whole").items():
            if not name.endswith(".html"):
                self.assertEqual(TIMES.sub("TIME", text.decode()), TIMES.sub("TIME", joined[name].decode()), name)
            if name in ("results.json", "tests.json"):
                self.assertEqual(text, joined[name], name)

        # One run that takes what the parts know has their times, too: every report is the same bytes.
        for part in range(1, 5):
            shutil.copytree(self.place / f"part{part}" / "known", self.place / "known" / "known", dirs_exist_ok=True)
        entries = len(list((self.place / "known" / "known").iterdir()))
        for _ in range(2):
            self.run_words([*whole, "known"])
            self.assertEqual(reports(self.place / "known"), joined)
        self.assertEqual(len(list((self.place / "known" / "known").iterdir())), entries, "something was run")
        self.assertEqual(len(list((self.place / "builds").glob("*.outcome"))), 3)

    def test_what_is_late_is_run_again_with_nothing_beside_it(self):
        """Two parts, each with one test at a time, of programs that are always late and may have waited."""
        harness.make_suite(PROGRAM, self.place, timeout=1)
        for name in ("a", "b"):
            harness.make_program(PROGRAM, self.place / "homework" / name,
                                 f'date +%s.%N; while :; do i=0; while [ $i -lt 3000 ]; do i=$((i+1)); done; sleep 0.01; done  # {name}')
        words = ["raytrace", "grade", "suite/suite.json", "--only", "ray|color", "--submissions", "homework", "-j", "1"]
        parts = [subprocess.Popen([*words, "--shard", f"{part}/2", "-o", f"part{part}"], cwd=self.place, env=self.environment,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for part in (1, 2)]
        for part in parts:
            _, err = part.communicate()
            self.assertEqual(part.returncode, 0, err)
        runs = []
        for part in ("part1", "part2"):
            times = json.loads((self.place / part / "times.json").read_text())["times"]
            for (key, result), time in zip(harness.read_results(self.place / part).items(), times):
                self.assertEqual(result["outcome"], "time-out", key)
                self.assertTrue(time["alone"], key)
                begin = float(result["output"].split()[0])
                runs.append((begin, begin + 1.0, part, key))
        runs.sort()
        self.assertEqual(len(runs), 4)
        # A program's second begins when it is started, which on a busy machine is well before it first says the time.
        for one, next_one in zip(runs, runs[1:]):
            self.assertLessEqual(one[1], next_one[0] + 0.25, f"{one} and {next_one} were run beside each other")


if __name__ == "__main__":
    if not shutil.which("parallel"):
        print("there is no GNU parallel (apt install parallel), so its recipe is not tested")
    unittest.main(verbosity=2)
