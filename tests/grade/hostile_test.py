#!/usr/bin/env python3
"""Programs that are wrong, slow, broken or hostile, graded by a suite of the course's kind: each outcome, nothing outside touched, nothing left.

usage: tests/grade/hostile_test.py PROGRAM [FAULTY]

FAULTY is the program whose mistakes can be selected by RAYTRACE_FAULT.
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
FAULTY = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and os.path.exists(sys.argv[1]) else None
MARK = f"graded-{os.getpid()}"  # in the command line of every process that must not stay

PICTURE = 'case "$1" in render) ;; *) exec "$real" "$@" ;; esac\n"$real" "$@" || exit\n'


def picture_then(command):
    """Right texts; pictures through ImageMagick."""
    return PICTURE + command


# name: (script, outcome of the texts, outcome of the pictures)
PROGRAMS = {
    "right": ('exec "$real" "$@"', "passed", "passed"),
    "mirrored": (picture_then("/usr/bin/convert output.png -flop output.png"), "passed", "wrong answer"),
    "gamma": (picture_then("/usr/bin/convert output.png -gamma 2.2 output.png"), "passed", "wrong answer"),
    "half_pixel": (picture_then("/usr/bin/convert output.png -virtual-pixel edge -filter triangle -distort SRT '0,0 1 0 0.5,0' output.png"),
                   "passed", "wrong answer"),
    "slow": ("sleep 60", "time-out", "time-out"),
    "spinning": ("while :; do :; done", "time-out", "time-out"),
    "crash": ("kill -SEGV $$", "signal", "signal"),
    "crash_after": ('"$real" "$@"; kill -ABRT $$', "signal", "signal"),
    "fork_bomb": (f"bomb() {{ bomb | bomb & }}; bomb; sleep 60 # {MARK}", "time-out", "time-out"),
    "endless_output": (f"exec yes {MARK}", "too much output", "too much output"),
    "memory": ("head -c 20G /dev/zero | tail", "out of memory", "out of memory"),
    "wrong_size": (picture_then("/usr/bin/convert output.png -resize 50% output.png"), "passed", "wrong size"),
    "one_digit": ('"$real" "$@" | sed "s/\\(.*[0-9][.][0-9]*\\)[0-4]/\\19/"', "wrong answer", "passed"),
    "exit_status": ('"$real" "$@"; exit 3', "non-zero exit", "non-zero exit"),
    "nothing": ("exit 0", "no output", "no output"),
    "no_picture": (picture_then("echo no > output.png"), "passed", "unreadable output"),
    "link": (picture_then("rm output.png; ln -s /etc/passwd output.png"), "passed", "unreadable output"),
    "pipe": (picture_then("rm output.png; mkfifo output.png"), "passed", "unreadable output"),
}
# What a wrong picture is called by.
CAUSES = {"mirrored": "mirrored", "gamma": "gamma twice", "half_pixel": "half-pixel shift"}
NEED_CONTAINMENT = ("fork_bomb", "memory")  # end otherwise, or not at all, where groups and users cannot be made


class Hostile(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_test_"))
        cls.place.chmod(0o755)  # runs may be another user's
        cls.suite = harness.make_suite(PROGRAM, cls.place, timeout=4, memory=512, **{"pass": [{"metric": "rmse", "at_most": 0.003}]})
        cls.folder = cls.suite.parent
        cls.tight = harness.make_suite(PROGRAM, cls.place / "tight", timeout=10, **{"pass": [{"metric": "rmse", "at_most": 0.001}]})
        right = harness.make_program(PROGRAM, cls.place / "programs" / "first", 'exec "$real" "$@"')
        run, _ = harness.grade(PROGRAM, cls.suite, cls.place / "out" / "first", "--exe", right.parent)
        cls.holes = [line for line in run.stderr.splitlines() if "warning:" in line]
        if cls.holes:
            print("this machine cannot contain all, so less is tested:", *cls.holes, sep="\n  ")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.place)

    def graded(self, name, script, *words):
        path = harness.make_program(PROGRAM, self.place / "programs" / name, script)
        run, results = harness.grade(PROGRAM, self.suite, self.place / "out" / name, "--exe", path.parent, *words)
        self.assertEqual(len(results), 2 if words else 4, run.stderr)
        self.assertNothingLeft()
        return run, {test: result for (_, test), result in results.items()}

    def assertNothingLeft(self):
        """No process that carries the mark, and no folder of a run."""
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                self.assertNotIn(MARK.encode(), (process / "cmdline").read_bytes(), process)
            except (FileNotFoundError, ProcessLookupError):
                pass

    def test_every_outcome(self):
        for name, (script, texts, pictures) in PROGRAMS.items():
            if self.holes and name in NEED_CONTAINMENT:
                continue
            with self.subTest(name):
                words = ["--only", "ray|plain"] if "time-out" in (texts, pictures) else []
                run, results = self.graded(name, script, *words)
                for test, result in results.items():
                    expected = texts if result["kind"] == "text" else pictures
                    if expected:
                        self.assertEqual(result["outcome"], expected, f"{test}: {result.get('reason')}")
                    if name in CAUSES and result["kind"] == "picture":
                        self.assertEqual(result.get("cause"), CAUSES[name], result.get("explanation"))
                self.assertEqual(run.returncode, 0 if name == "right" else 1, run.stderr)
                for report in ("results.json", "times.json", "results.csv", "junit.xml", "gradescope.json", "tests.json", "report.html"):
                    self.assertTrue((self.place / "out" / name / report).exists())

    def test_a_tracer_without_shadows_is_told_so(self):
        if not FAULTY:
            self.skipTest("no program with selectable mistakes")
        path = harness.make_program(FAULTY, self.place / "programs" / "shadowless", 'RAYTRACE_FAULT=no_shadows exec "$real" "$@"')
        harness.grade(PROGRAM, self.tight, self.place / "out" / "shadowless", "--exe", path.parent, check=1)
        results = harness.read_results(self.place / "out" / "shadowless")
        for name in ("plain", "smooth"):
            result = results["shadowless", name]
            self.assertEqual(result["outcome"], "wrong answer")
            self.assertEqual(result.get("cause"), "missing shadows", result.get("explanation"))

    def test_what_is_said_of_a_picture_is_kept_with_it(self):
        """Whatever program wrote it: what is kept is changed by hand, to be known again."""
        out = self.place / "out" / "kept"
        programs = [harness.make_program(PROGRAM, self.place / "programs" / f"kept{i}",
                                         picture_then(f"/usr/bin/convert output.png -flop -set comment 'file {i}' output.png")).parent for i in range(3)]
        words = ("--only", "plain", "--exe")
        _, results = harness.grade(PROGRAM, self.suite, out, *words, programs[0], check=1)
        self.assertEqual(results["kept0", "plain"]["cause"], "mirrored")
        (entry,) = (out / "known").glob("cause-*/cause.json")
        kept = json.loads(entry.read_text())
        self.assertEqual(kept, {name: results["kept0", "plain"][name] for name in ("cause", "explanation")})
        entry.write_text(json.dumps({"cause": "kept", "explanation": "by hand"}))
        _, results = harness.grade(PROGRAM, self.suite, out, *words, programs[1], check=1)
        self.assertEqual((results["kept1", "plain"]["cause"], results["kept1", "plain"]["explanation"]), ("kept", "by hand"))
        _, results = harness.grade(PROGRAM, self.suite, out, *words, programs[1], "--fresh", check=1)
        self.assertEqual(results["kept1", "plain"]["cause"], "mirrored")
        for broken in ("", "{}", '{"cause": 1, "explanation": ""}'):
            entry.write_text(broken)
            harness.grade(PROGRAM, self.suite, out, *words, programs[2], "--fresh", check=1)
            entry.write_text(broken)
            shutil.rmtree(next(path.parent for path in (out / "known").glob("*/result.json") if '"kept2"' in path.read_text()))
            _, results = harness.grade(PROGRAM, self.suite, out, *words, programs[2], check=1)
            self.assertEqual(results["kept2", "plain"]["cause"], "mirrored", broken)

    def test_what_is_said_of_a_picture_depends_on_the_other_answers(self):
        suite = harness.make_suite(PROGRAM, self.place / "others", **{"pass": [{"metric": "rmse", "at_most": 0.001}]})
        out = self.place / "out" / "others"
        path = harness.make_program(PROGRAM, self.place / "programs" / "others", picture_then("/usr/bin/convert output.png -flop output.png"))
        harness.grade(PROGRAM, suite, out, "--only", "plain", "--exe", path.parent, check=1)
        self.assertEqual(len(list((out / "known").glob("cause-*"))), 1)
        shutil.copy(suite.parent / "answers" / "plain.png", suite.parent / "answers" / "smooth.png")
        harness.grade(PROGRAM, suite, out, "--only", "plain", "--exe", path.parent, "--fresh", check=1)
        self.assertEqual(len(list((out / "known").glob("cause-*"))), 2)

    def test_writes_nowhere_else(self):
        if self.holes:
            self.skipTest("not contained here")
        script = f'''for place in /tmp /dev/shm /var/tmp {self.folder} {self.folder}/inputs ../resources "$(dirname "$0")" {self.place} $HOME / /etc /root
do echo {MARK} > "$place/{MARK}"; done 2>/dev/null
exec "$real" "$@"'''
        _, results = self.graded("writer", script)
        self.assertEqual({result["outcome"] for result in results.values()}, {"passed"})
        for place in ("/tmp", "/dev/shm", "/var/tmp", self.folder, self.folder / "inputs", self.place, self.place / "programs" / "writer", "/", "/etc", "/root"):
            self.assertFalse((pathlib.Path(place) / MARK).exists(), place)

    def test_what_lies_beside_the_picture_is_not_touched(self):
        """Links and pipes that a program leaves where a careless judge would write."""
        victim = self.place / "victim"
        answer = self.folder / "answers" / "plain.png"
        right = answer.read_bytes()
        for name, command in (("link_away", f"ln -s {victim} ../taken.png"), ("link_to_answer", f"ln -sf {answer} ../taken.png"),
                              ("pipe_beside", "mkfifo ../taken.png")):
            with self.subTest(name):
                _, results = self.graded(name, picture_then(f"/usr/bin/convert output.png -negate output.png; {command}"))
                self.assertEqual(results["plain"]["outcome"], "wrong answer")
                self.assertFalse(victim.exists())
                self.assertEqual(answer.read_bytes(), right)

    def test_a_picture_that_would_fill_the_memory_is_of_a_wrong_size(self):
        head = "89504e470d0a1a0a0000000d49484452" + (20000).to_bytes(4, "big").hex() * 2 + "0802000000"
        _, results = self.graded("bomb", picture_then(f"printf '{''.join(chr(92) + 'x' + head[i:i+2] for i in range(0, len(head), 2))}' > output.png".replace("printf", "/usr/bin/printf")))
        self.assertIn(results["plain"]["outcome"], ("unreadable output", "wrong size"))
        self.assertIn("20000 x 20000", results["plain"]["reason"])

    def test_an_executable_by_itself_sees_nothing_beside_it(self):
        if self.holes:
            self.skipTest("not contained here")
        path = harness.make_program(PROGRAM, self.place / "programs" / "alone", 'ls -a "$(dirname "$0")"; cat "$(dirname "$0")/secret"')
        (path.parent / "secret").write_text("do not tell")
        _, results = harness.grade(PROGRAM, self.suite, self.place / "out" / "alone", "--exe", path, "--only", "ray", check=1)
        self.assertNotIn("do not tell", results["raytrace", "ray"]["output"])
        self.assertNotIn("real", results["raytrace", "ray"]["output"])

    def test_cannot_read_the_answers(self):
        if self.holes:
            self.skipTest("not contained here")
        part = self.folder / "answers"
        script = f'cp {part}/plain.png output.png; cat {part}/*.out; find {self.folder} -name "*.out"; ls {part}'
        _, results = self.graded("reader", script)
        for test, result in results.items():
            self.assertIn(result["outcome"], ("no output", "wrong answer", "non-zero exit"), test)
            self.assertNotIn("Pixel: [", result.get("output", ""))
            self.assertNotIn("figures", result)

    def test_children_that_stay_end_with_the_run(self):
        script = f'''sh -c "trap '' TERM HUP INT; while :; do sleep 1; done # {MARK}" &
setsid sh -c "trap '' TERM; sleep 1000 # {MARK}" >/dev/null 2>&1 </dev/null &
exec "$real" "$@"'''
        _, results = self.graded("parent", script)
        for test, result in results.items():
            self.assertEqual(result["outcome"], "passed", test)
            self.assertTrue(result.get("left_processes"), test)

    def test_without_bubblewrap_it_says_so(self):
        path = harness.make_program(PROGRAM, self.place / "programs" / "plain", 'exec "$real" "$@"')
        empty = self.place / "empty"
        empty.mkdir()
        run = subprocess.run([PROGRAM, "grade", str(self.suite), "--exe", str(path.parent), "-o", str(self.place / "out" / "plain")],
                             capture_output=True, text=True, env={**os.environ, "PATH": str(empty)})
        self.assertIn("bubblewrap", run.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
