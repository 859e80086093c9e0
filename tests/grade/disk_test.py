#!/usr/bin/env python3
"""Disks that are full: never a program's fault. What is known stays, the exit status says that not everything could be written.

usage: tests/grade/disk_test.py PROGRAM

Small disks are mounted in a mount namespace of its own; where none can be made it says so and passes.
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

INSIDE = "RAYTRACE_DISK_TEST"
FILLS = "head -c 60M /dev/zero > junk 2>/dev/null"


def mount(folder, megabytes):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={megabytes}m,mode=0755", "tmpfs", folder], check=True)


class Disk(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_disk_"))
        self.place.chmod(0o755)
        self.scratch, self.out = self.place / "scratch", self.place / "out"  # as the harness has them
        self.suite = harness.make_suite(PROGRAM, self.place)

    def tearDown(self):
        for folder in (self.scratch, self.out, self.place / "builds"):
            subprocess.run(["umount", folder], stderr=subprocess.DEVNULL)
        shutil.rmtree(self.place)

    def program(self, name, script):
        return harness.make_program(PROGRAM, self.place / "programs" / name, script).parent

    def grade(self, *words, **options):
        run, results = harness.grade(PROGRAM, self.suite, self.out, *words, **options)
        return run, {key: result["outcome"] for key, result in results.items()}, results

    def test_no_run_is_begun_where_none_can_write(self):
        right = self.program("right", 'exec "$real" "$@"')
        mount(self.scratch, 8)
        run, outcomes, results = self.grade("--exe", right, check=3)
        self.assertEqual(set(outcomes.values()), {"not judged"})
        reason = f"the disk of '{self.scratch}' is full, or nearly so: runs need 16 MiB"
        self.assertEqual({result["reason"] for result in results.values()}, {reason})
        self.assertTrue(run.stderr.endswith(f"raytrace: not everything could be judged: {reason}\n"), run.stderr)
        for report in ("times.json", "tests.json", "results.csv", "junit.xml", "gradescope.json", "report.html"):
            self.assertTrue((self.out / report).exists(), report)
        subprocess.run(["umount", self.scratch], check=True)
        _, outcomes, _ = self.grade("--exe", right, check=0)
        self.assertEqual(set(outcomes.values()), {"passed"}, "nothing was kept of what was not judged")

    def test_what_fails_on_a_disk_that_was_filled_is_not_judged(self):
        right = self.program("right", f'{FILLS}; exec "$real" pixelray ../resources/still.pov 160 120 40 30')
        nothing = self.program("nothing", f"{FILLS}; exit 0")
        crash = self.program("crash", "kill -SEGV $$")
        mount(self.scratch, 24)
        run, outcomes, results = self.grade("--exe", right, "--exe", nothing, "--exe", crash, "--only", "ray", "-j", "1", check=3)
        self.assertEqual(outcomes, {("right", "ray"): "passed", ("nothing", "ray"): "not judged", ("crash", "ray"): "signal"})
        self.assertIn("was full, or nearly so, during a run that failed", results["nothing", "ray"]["reason"])
        subprocess.run(["umount", self.scratch], check=True)
        _, outcomes, _ = self.grade("--exe", nothing, "--only", "ray", check=1)
        self.assertEqual(outcomes, {("nothing", "ray"): "no output"}, "with room it is its own fault")

    def test_results_that_cannot_be_kept_leave_those_that_are(self):
        right = self.program("right", 'exec "$real" "$@"')
        mount(self.out, 24)
        self.grade("--exe", right, "--only", "ray", check=0)
        before = (self.out / "results.json").read_bytes()
        known = {path: path.stat().st_mtime_ns for path in (self.out / "known").glob("*/result.json")}
        self.assertEqual(len(known), 1)
        filler = self.out / "filler"
        with filler.open("wb", buffering=0) as file:
            try:
                while True:
                    file.write(bytes(4096))
            except OSError:
                pass
        scratch = {**os.environ, "TMPDIR": str(self.scratch)}
        run = subprocess.run([PROGRAM, "grade", self.suite, "--exe", right, "-o", self.out], capture_output=True, text=True, env=scratch)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("No space left on device", run.stderr)
        self.assertEqual((self.out / "results.json").read_bytes(), before)
        self.assertEqual([path for path in (self.out / "known").iterdir() if "unfinished" in path.name], [])
        filler.unlink()
        _, outcomes, _ = self.grade("--exe", right, check=0)
        self.assertEqual(set(outcomes.values()), {"passed"})
        self.assertLessEqual(known.items(), {path: path.stat().st_mtime_ns for path in (self.out / "known").glob("*/result.json")}.items())

    def test_a_table_is_printed_though_reports_cannot_be(self):
        right = self.program("right", 'exec "$real" "$@"')
        self.grade("--exe", right, check=0)
        (self.out / "report.html").unlink()
        (self.out / "report.html").mkdir()
        scratch = {**os.environ, "TMPDIR": str(self.scratch)}
        run = subprocess.run([PROGRAM, "grade", self.suite, "--exe", right, "-o", self.out], capture_output=True, text=True, env=scratch)
        self.assertEqual(run.returncode, 3)
        self.assertIn("4 of 4 passed", run.stdout)
        self.assertIn("report.html': Is a directory", run.stderr)

    def test_a_build_without_room_is_not_the_submissions_fault(self):
        homework = self.place / "homework" / "large"
        homework.mkdir(parents=True)
        (homework / "Makefile").write_text("raytrace:\n\thead -c 60M /dev/zero > junk\n\tprintf '#!/bin/sh\\n' > raytrace; chmod +x raytrace\n")
        words = ["--submissions", homework.parent, "--builds", self.place / "builds", "--only", "ray"]
        mount(self.place / "builds", 32)
        _, outcomes, results = self.grade(*words, check=3)
        self.assertEqual(outcomes, {("large", "ray"): "not judged"})
        self.assertEqual(results["large", "ray"]["reason"], f"the disk of '{self.place}/builds' was full, or nearly so")
        self.assertEqual(list((self.place / "builds").glob("*.outcome")), [], "it is not known to fail")
        subprocess.run(["mount", "-o", "remount,size=200m", self.place / "builds"], check=True)
        _, outcomes, _ = self.grade(*words, check=0)
        self.assertEqual(outcomes, {("large", "ray"): "no output"})

    def test_no_folder_for_runs_is_said(self):
        right = self.program("right", 'exec "$real" "$@"')
        run = subprocess.run([PROGRAM, "grade", self.suite, "--exe", right, "-o", self.out], capture_output=True, text=True,
                             env={**os.environ, "TMPDIR": str(self.place / "none")})
        self.assertEqual(run.returncode, 3)
        self.assertIn("TMPDIR names no folder: ", run.stderr)
        self.assertFalse((self.out / "results.json").exists())


if __name__ == "__main__":
    if INSIDE not in os.environ:
        unshare = ["unshare", "-m"] if os.geteuid() == 0 else ["unshare", "-r", "-m"]
        trial = subprocess.run([*unshare, "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True, text=True)
        if trial.returncode != 0:
            print(f"no small disks can be mounted here, nothing is tested: {trial.stderr.strip()}")
            sys.exit(0)
        os.execvpe(unshare[0], [*unshare, sys.executable, os.path.abspath(__file__), *sys.argv[1:]], {**os.environ, INSIDE: "1"})
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
