#!/usr/bin/env python3
"""Many programs graded by a large suite: rate, memory, how good the time left is; what a kill in the middle costs; shards joined.

usage: tests/grade/scale.py PROGRAM [--submissions 300] [--tests 60] [--size 640x480]

The programs copy pictures that lie beside them; of each tenth program every picture is another one, so that figures are computed. Prints a
table of figures and exits 1 if a result was lost, repeated or changed.
"""
import argparse
import json
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time


def picture(program, place, name, size, light):
    scene = place / f"{name}.pov"
    scene.write_text(f"""camera {{ location <0, 0, 14> up <0, 1, 0> right <1.33, 0, 0> look_at <0, 0, 0> }}
light_source {{ <-60, 90, 80> color rgb {light} }}
sphere {{ <-2, 0.5, 0>, 3 pigment {{ color rgb <0.9, 0.2, 0.3> }} finish {{ ambient 0.15 diffuse 0.6 specular 0.4 }} }}
plane {{ <0, 1, 0>, -3 pigment {{ color rgb <0.8, 0.8, 0.5> }} finish {{ ambient 0.3 diffuse 0.5 }} }}""")
    subprocess.run([program, "render", scene, *size.split("x")], cwd=place, check=True)
    (place / "output.png").rename(place / f"{name}.png")
    return place / f"{name}.png"


def make(program, place, submissions, tests, size):
    suite = place / "suite"
    (suite / "answers").mkdir(parents=True)
    (suite / "inputs").mkdir()
    entries = []
    right = picture(program, place, "right", size, "1.2")
    wrong = picture(program, place, "wrong", size, "1.0")
    for i in range(tests):
        answer = f"answers/{i}." + ("png" if i % 2 else "out")
        if i % 2:
            shutil.copy(right, suite / answer)
        else:
            (suite / answer).write_text(f"test {i}\nT = 1.0000\n")
        entries.append({"name": f"t{i}", "kind": "picture" if i % 2 else "text", "command": ["picture" if i % 2 else "text", str(i)], "expected": answer})
    (suite / "suite.json").write_text(json.dumps({"format": "raytrace suite 1", "inputs": "inputs", "tests": entries}))
    for i in range(submissions):
        folder = place / "programs" / f"s{i:03}"
        folder.mkdir(parents=True)
        os.link(wrong if i % 10 == 9 else right, folder / "picture.png")
        script = folder / "raytrace"
        script.write_text(f'#!/bin/sh\n# {i}\nif [ "$1" = text ]; then printf "test %s\\nT = 1.0000\\n" "$2"; else cp "${{0%/*}}/picture.png" output.png; fi\n')
        script.chmod(0o755)
    return suite / "suite.json"


class Grading:
    """One run in a terminal of its own, whose progress line is read."""

    def __init__(self, program, suite, place, out, *words):
        self.seen, self.start = [], time.time()
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.execv(program, [program, "grade", str(suite), "--submissions", str(place / "programs"), "-o", str(out), *words])

    def follow(self, until=None):
        """Reads until the end, or until a share of the tests is done. Returns the seconds."""
        text = ""
        while True:
            try:
                text = (text + os.read(self.terminal, 65536).decode(errors="replace"))[-4096:]
            except OSError:
                break
            for done, tasks, left in re.findall(r"(\d+)/(\d+) tests.*? (\d+:\d\d:\d\d) left", text)[-1:]:
                hours, minutes, seconds = map(int, left.split(":"))
                share = int(done) / int(tasks)
                self.seen.append((share, time.time() - self.start, 3600 * hours + 60 * minutes + seconds))
                if until and share >= until:
                    return time.time() - self.start
        _, self.status, usage = os.wait4(self.pid, 0)
        self.memory = usage.ru_maxrss
        return time.time() - self.start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--submissions", type=int, default=300)
    parser.add_argument("--tests", type=int, default=60)
    parser.add_argument("--size", default="640x480")
    options = parser.parse_args()
    place = pathlib.Path(tempfile.mkdtemp(prefix="grade_scale_"))
    try:
        return measure(options, place)
    finally:
        shutil.rmtree(place)


def known(out):
    """Results that are kept, with the moment each was made. What a killed worker was writing is none; a later run removes it."""
    entries = (out / "known").glob("*/result.json")
    return {path.parent.name: path.stat().st_mtime_ns for path in entries if ".unfinished-" not in path.parent.name}


def measure(options, place):
    suite = make(options.program, place, options.submissions, options.tests, options.size)
    total = options.submissions * options.tests
    whole = place / "whole"
    run = Grading(options.program, suite, place, whole)
    seconds = run.follow()
    print(f"{total} tests in {seconds:.1f} s: {total / seconds:.1f} a second; memory of the grader {run.memory / 1024:.0f} MiB")
    for share in (0.1, 0.25, 0.5):
        at = next((state for state in run.seen if state[0] >= share), None)
        if at:
            print(f"at {100 * at[0]:.0f} %: {at[2]} s left were told, {seconds - at[1]:.1f} s it took ({at[2] / (seconds - at[1]):.2f})")
    begin = time.time()
    subprocess.run([options.program, "grade", suite, "--submissions", place / "programs", "-o", whole, "-q"])
    print(f"again, all known: {time.time() - begin:.1f} s")

    killed = place / "killed"
    run = Grading(options.program, suite, place, killed)
    run.follow(until=0.4)
    os.kill(run.pid, signal.SIGKILL)
    os.waitpid(run.pid, 0)
    time.sleep(1)
    before = known(killed)
    run = Grading(options.program, suite, place, killed)
    run.follow()
    after = known(killed)
    repeated = sum(after.get(key) != moment for key, moment in before.items())
    print(f"killed with {len(before)} results kept; the next run made the other {len(after) - len(before)} and repeated {repeated}")

    shards = [place / "shard1", place / "shard2"]
    for number, out in enumerate(shards, 1):
        Grading(options.program, suite, place, out, "--shard", f"{number}/2").follow()
    merged = place / "merged"
    subprocess.run([options.program, "merge", "-q", "-o", merged, *shards], check=True)
    results = [(folder / "results.json").read_bytes() for folder in (whole, killed, merged)]
    same = results[0] == results[1] == results[2]
    print("one run, one that was killed and went on, two shards joined: results", "are the same bytes" if same else "DIFFER")
    return 0 if same and not repeated and len(after) == total else 1


if __name__ == "__main__":
    sys.exit(main())
