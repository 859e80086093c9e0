#!/usr/bin/env python3
"""Scenes that ask for very much: each is rendered or refused by a limit that is named; none crashes, hangs or takes all memory.

usage: limits_test.py PROGRAM [NAME...]    NAME: part of a case's name
With RAYTRACE_DEEP=1 the full sizes (files of 200 MB in the temporary folder, up to 12 GB of memory), and a table of what each takes.
"""
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time

import cases

DEEP = os.environ.get("RAYTRACE_DEEP") == "1"
SECONDS = 900 if DEEP else 120  # before a case counts as hanging; nothing is timed
MEGABYTES = None if DEEP else 1500
RENDER = ("-W", "16", "-H", "12", "-t", "2", "--shading", "povray", "-q", "-F")


def write(folder, name, content):
    path = pathlib.Path(folder, name)
    if content is None:
        path.symlink_to("/dev/zero")
    elif isinstance(content, bytes):
        path.write_bytes(content)
    else:
        with open(path, "w", encoding="ascii") as file:
            file.writelines([content] if isinstance(content, str) else content)


def run(program, words, folder):
    """Exit status (negative: signal, None: it hung), what it said, seconds of processors, peak MB."""
    with open(pathlib.Path(folder, "err"), "w+b") as err:
        before = time.monotonic()
        child = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err)
        late = False
        while True:
            done, status, usage = os.wait4(child.pid, os.WNOHANG)
            if done:
                break
            if time.monotonic() - before > SECONDS and not late:
                late = True
                child.kill()
            time.sleep(0.005)
        child.returncode = os.waitstatus_to_exitcode(status)
        err.seek(0)
        said = err.read(4000).decode(errors="replace")
    return None if late else child.returncode, said, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def problem_of(case, status, said, megabytes):
    wanted = case.wanted(DEEP)
    if status is None:
        return f"hangs: killed after {SECONDS} s"
    if status != (case.status if wanted else 0):
        return f"status {status}: {said[:300]}"
    if wanted and wanted not in said:
        return f"says {said[:300]!r}, not {wanted!r}"
    if not wanted and said:
        return f"says {said[:300]!r}"
    if MEGABYTES and megabytes > MEGABYTES:
        return f"takes {megabytes:.0f} MB"
    return ""


def check(program, case):
    size = case.full if DEEP else case.small
    with tempfile.TemporaryDirectory() as folder:
        write(folder, "scene.pov", case.scene(size))
        for name, content in case.files(size).items():
            write(folder, name, content)
        words = ["scene.pov", *RENDER, *case.options, *(() if DEEP else case.small_options)]
        status, said, seconds, megabytes = run(program, words, folder)
    problem = problem_of(case, status, said, megabytes)
    if DEEP:
        result = "rendered" if status == 0 else said.partition("Error: ")[2].partition("\n")[0] or said.partition("\n")[0]
        print(f"| {case.name} | {size or ''} | {seconds:.1f} s | {megabytes:.0f} MB | {result[:150]} |", flush=True)
    return problem


def interrupted(program, number):
    """An endless loop ends at once, whatever is being read."""
    with tempfile.TemporaryDirectory() as folder:
        write(folder, "scene.pov", "#debug \"here\"\n#while (1)\n  #declare A = 1;\n#end\n")
        child = subprocess.Popen([program, "scene.pov", "--limit", "reread=1000G"], cwd=folder, stderr=subprocess.PIPE)
        child.stderr.read(4)
        child.send_signal(number)
        try:
            _, said = child.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            child.kill()
            return "goes on"
    said = said.decode()
    return "" if child.returncode == 2 and said == "\nraytrace: interrupted\n" else f"status {child.returncode}: {said!r}"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    names = sys.argv[2:]
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    chosen = [case for case in cases.ALL if not names or any(name in case.name for name in names)]
    if DEEP:
        print("| case | size | processor time | memory | result |\n|---|---|---|---|---|")
    problems = {case.name: check(program, case) for case in chosen}
    if not names:
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            problems[f"{number.name} while reading"] = interrupted(program, number)
    for name, problem in problems.items():
        if problem:
            print(f"{name}: {problem}", file=sys.stderr)
    print(f"{sum(1 for p in problems.values() if not p)} of {len(problems)} cases are as they should be")
    sys.exit(any(problems.values()))


if __name__ == "__main__":
    main()
