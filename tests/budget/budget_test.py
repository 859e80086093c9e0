#!/usr/bin/env python3
"""An unused feature costs nothing: instructions of small scenes against a budget, and no scene enters the code of features it has not.

usage: tests/budget/budget_test.py PROGRAM [--record]

Each scene of tests/budget/scenes is rendered under callgrind by one thread. A figure is what the scene takes above an empty one, in the
program's own code; `start` is what the empty one takes. It fails if a figure is 1 % above what budgets.json holds for this compiler, system
and build (start: 10 %, since each option of the command line adds to it), and asks for new budgets if it is 5 % below. With another compiler
the budgets are not judged and it says so; exit status 77 if nothing could be. --record writes the budgets of this build.
"""
import argparse
import functools
import json
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import callgrind
import features

HERE = pathlib.Path(__file__).resolve().parent
BUDGETS = HERE / "budgets.json"
SIZE = ["-W", "48", "-H", "36"]
MOST, MOST_START, LEAST = 1.01, 1.10, 0.95
SKIPPED = 77


def first_line(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    return (done.stdout.splitlines() or ["unknown"])[0].strip()


def made_with(program):
    """What the counts depend on besides the sources. Embree walks other trees where the processor has no AVX2."""
    cache = next(folder / "CMakeCache.txt" for folder in program.parents if (folder / "CMakeCache.txt").exists()).read_text()
    entry = lambda name: re.search(rf"^{name}:\w+=(.*)$", cache, re.M).group(1)
    kind = entry("CMAKE_BUILD_TYPE")
    system = re.search(r'^PRETTY_NAME="?([^"\n]*)', pathlib.Path("/etc/os-release").read_text(), re.M)
    return {
        "compiler": first_line(entry("CMAKE_CXX_COMPILER"), "--version"),
        "build": f"{kind} {entry('CMAKE_CXX_FLAGS')} {entry('CMAKE_CXX_FLAGS_' + kind.upper())}".strip(),
        "system": f"{system.group(1)}, {platform.machine()}, " + ("AVX2" if " avx2" in pathlib.Path("/proc/cpuinfo").read_text() else "no AVX2"),
        "valgrind": first_line("valgrind", "--version"),
    }


def profile(program, scene, words):
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(HERE / "scenes" / f"{scene}.pov", pathlib.Path(folder, "scene.pov"))
        return callgrind.run(program, ["scene.pov", *SIZE, "--threads", "1", "-q", "-o", "out.ppm", *words], folder)


def profiles(program):
    """By scene, and of `empty`."""
    wanted = {"empty": ("empty", []), **{name: (scene, words) for name, (scene, words, _) in features.SCENES.items()}}
    with ThreadPoolExecutor(2) as pool:
        return dict(zip(wanted, pool.map(lambda job: profile(program, *job), wanted.values())))


def figures(by_scene):
    """Instructions: `start`, and of each scene above it."""
    empty = by_scene["empty"].main
    return {"start": empty, **{name: p.main + p.workers - empty for name, p in by_scene.items() if name != "empty"}}


def over_budget(counted, budget):
    """Sentences about figures that are not within their budgets."""
    found = []
    for name, count in counted.items():
        if name not in budget:
            found.append(f"{name}: no budget is recorded")
            continue
        share = count / budget[name]
        if share > (MOST_START if name == "start" else MOST):
            found.append(f"{name}: {count} instructions, {share - 1:+.1%} on the budget of {budget[name]}")
        elif share < LEAST:
            found.append(f"{name}: {count} instructions, {share - 1:+.1%} on the budget of {budget[name]}: better, so the budget hides what comes back")
    return found


def report(counted, budget):
    for name, count in counted.items():
        beside = f"{count / budget[name] - 1:+8.2%}" if name in budget else ""
        print(f"{name:14}{count:12}{beside}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        print("budgets: valgrind is not installed (Debian package valgrind); nothing is judged")
        return SKIPPED
    program = options.program.resolve()
    here = made_with(program)
    by_scene = profiles(program)
    counted = figures(by_scene)
    if options.record:
        BUDGETS.write_text(json.dumps({"made_with": here, "instructions": counted}, indent=2) + "\n")
    recorded = json.loads(BUDGETS.read_text())
    same = recorded["made_with"] == here
    report(counted, recorded["instructions"] if same else {})
    found = features.faults(by_scene, functools.cache(functools.partial(callgrind.only_moves, program)))
    if same:
        over = over_budget(counted, recorded["instructions"])
        found += over + (["where that is right: tests/budget/budget_test.py build/raytrace --record, and commit budgets.json"] if over else [])
    else:
        print(f"budgets: recorded with {recorded['made_with']}, this is {here}; not judged")
    print("\n".join(found) if found else "no scene enters code of features that it has not")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
