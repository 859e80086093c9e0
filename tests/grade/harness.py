"""What the tests of grading share: a small suite of the course's kind whose right answers the program itself makes, and programs to grade."""
import atexit
import json
import os
import pathlib
import shutil
import subprocess

# Gradings of one test wait for each other where they have to, and for no other test's.
os.environ["RAYTRACE_TURNS"] = f"/tmp/grade_turns_{os.getpid()}"
atexit.register(lambda: pathlib.Path(os.environ["RAYTRACE_TURNS"]).unlink(missing_ok=True))

SCENE = """
camera { location <0, 0, 14> up <0, 1, 0> right <1.333333, 0, 0> look_at <0, 0, 0> }
light_source { <-60, 90, 80> color rgb <1.2, 1.2, 1.2> }
sphere { <-2, 0.5, 0>, 2.2 pigment { color rgb <0.9, 0.2, 0.3> } finish { ambient 0.15 diffuse 0.6 specular 0.4 roughness 0.05 } }
sphere { <1.4, 2.2, 3>, 1.1 pigment { color rgb <0.2, 0.7, 0.4> } finish { ambient 0.15 diffuse 0.6 } }
box { <1, -3, -2>, <4, -0.5, 1> pigment { color rgb <0.3, 0.4, 0.9> } finish { ambient 0.2 diffuse 0.6 reflection 0.3 } rotate <0, 25, 0> }
plane { <0, 1, 0>, -3 pigment { color rgb <0.8, 0.8, 0.5> } finish { ambient 0.3 diffuse 0.5 } }
"""


TESTS = [
    ("ray", "text", "pixelray ../resources/still.pov 160 120 40 30"),
    ("color", "text", "pixelcolor ../resources/still.pov 160 120 60 62"),
    ("plain", "picture", "render ../resources/still.pov 160 120"),
    ("smooth", "picture", "render ../resources/still.pov 160 120 -ss=3"),
]


def make_suite(program, place, **limits):
    """A suite file with two texts and two pictures in `place`/suite, their answers in a folder of their own; returns the file."""
    suite = pathlib.Path(place) / "suite"
    (suite / "answers").mkdir(parents=True)
    (suite / "inputs").mkdir()
    (suite / "inputs" / "still.pov").write_text(SCENE)
    work = suite / "build"
    work.mkdir()
    os.symlink(suite / "inputs", suite / "resources")
    entries = []
    for name, kind, words in TESTS:
        run = subprocess.run([program, *words.split()], cwd=work, capture_output=True, check=True)
        answer = f"answers/{name}." + ("out" if kind == "text" else "png")
        if kind == "text":
            (suite / answer).write_bytes(run.stdout)
        else:
            shutil.move(work / "output.png", suite / answer)
        entries.append({"name": name, "kind": kind, "command": words, "expected": answer})
    shutil.rmtree(work)
    (suite / "resources").unlink()
    path = suite / "suite.json"
    path.write_text(json.dumps({"format": "raytrace suite 1", "name": "small", "inputs": "inputs", "defaults": limits, "tests": entries}, indent=1))
    return path


def make_program(program, folder, script):
    """An executable `raytrace` in `folder` that runs `script`, a shell's, with the program itself beside it as ./real."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    shutil.copy(program, folder / "real")
    path = folder / "raytrace"
    path.write_text(f'#!/bin/sh\nreal="$(dirname "$0")/real"\n{script}\n')
    path.chmod(0o755)
    return path


def grade(program, suite, place, *words, check=None):
    """Runs `raytrace grade`; returns the finished process and the results by (submission, test)."""
    scratch = pathlib.Path(place).parent / "scratch"  # of this grader alone, so that what stays there is its own
    scratch.mkdir(parents=True, exist_ok=True)
    run = subprocess.run([program, "grade", str(suite), "-o", str(place), *map(str, words)], capture_output=True, text=True,
                         env={**os.environ, "TMPDIR": str(scratch)})
    left = list(scratch.glob("raytrace-*"))
    if left:
        raise AssertionError(f"folders of runs were left: {left}")
    if check is not None and run.returncode != check:
        raise AssertionError(f"exit {run.returncode}, {check} expected\n{run.stdout}\n{run.stderr}")
    return run, read_results(place)


def read_results(place):
    content = json.loads((pathlib.Path(place) / "results.json").read_text())
    return {(result["submission"], result["test"]): result for result in content["results"]}
