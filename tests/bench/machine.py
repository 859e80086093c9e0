"""What the figures were measured on: processor, instruction sets, programs, date, and whether the machine had other work."""
import datetime
import os
import pathlib
import platform
import re
import shutil
import subprocess
import time

# Instruction sets from the widest to the narrowest: name, and the flag of /proc/cpuinfo.
SETS = [("AVX-512", "avx512f"), ("AVX2", "avx2"), ("AVX", "avx"), ("SSE4.2", "sse4_2"), ("SSE2", "sse2")]


def cpu_field(name):
    try:
        match = re.search(rf"^{name}\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    except OSError:
        match = None
    return match.group(1) if match else ""


def version(command, pattern):
    """The first match of the pattern in what the command prints, or an empty text."""
    if not shutil.which(command[0]):
        return ""
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL)
    match = re.search(pattern, done.stdout + done.stderr)
    return match.group(1) if match else ""


def code_of(program):
    """The widest registers that a program's own code names. What it holds is what it uses: none of these programs asks the processor."""
    if not shutil.which("objdump"):
        return "unknown (no objdump)"
    listing = subprocess.Popen(["objdump", "-d", "--no-show-raw-insn", str(program)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    widest = "SSE2"
    for line in listing.stdout:
        if "%zmm" in line:
            widest = "AVX-512"
        elif widest == "SSE2" and "%ymm" in line:
            widest = "AVX"
    listing.stdout.close()
    listing.wait()
    return widest


def embree_set(text):
    """The widest set that Embree may choose, from what it tells of itself: both the processor's and compiled in."""
    compiled = re.search(r"^ *(.*)\(compile time enabled\)", text, re.M)
    offered = re.search(r"Config.*?Targets : (.*?)\(supported\)", text, re.S)
    if not compiled or not offered:
        return "unknown"
    both = set(compiled.group(1).split()) & set(offered.group(1).split())
    return next((name for name, _ in SETS if name.replace("-", "") in both), "unknown")


def busy(seconds=2.0):
    """The share of the machine's cores that are at work while this program waits."""

    def ticks():
        numbers = [int(n) for n in pathlib.Path("/proc/stat").read_text().splitlines()[0].split()[1:9]]
        return sum(numbers), numbers[3] + numbers[4]  # idle, and idle while a disk is awaited

    begin = ticks()
    time.sleep(seconds)
    end = ticks()
    return 1.0 - (end[1] - begin[1]) / max(1, end[0] - begin[0])


def facts(build):
    flags = cpu_field("flags").split()
    floor = subprocess.run([build / "tests/bench/embree_floor", "--isa"], capture_output=True, text=True, errors="replace")
    code = {"raytrace": f"{code_of(build / 'raytrace')}, Embree {embree_set(floor.stdout)}"}
    for name, path in [("POV-Ray", shutil.which("povray")), ("Tachyon", shutil.which("tachyon-nox") or shutil.which("tachyon"))]:
        if path:
            code[name] = code_of(path)
    return {
        "date": datetime.date.today().isoformat(),
        "processor": cpu_field("model name") or platform.processor() or platform.machine(),
        "cores": len(os.sched_getaffinity(0)),
        "busy": round(busy(), 2),
        "instruction_sets": next((name for name, flag in SETS if flag in flags), "unknown"),
        "code": code,
        "compiler": version(["c++", "--version"], r"^(.*)"),
        "povray": version(["povray", "--version"], r"POV-Ray (\S+)"),
        "tachyon": version(["tachyon"], r"Version (\S+)"),
    }


def sentence(machine):
    """One line for people."""
    shared = machine["busy"] > 0.05
    work = f"shared with other work ({machine['busy']:.0%} busy before the first run or after the last)" if shared else "nothing else at work"
    return f"{machine['cores']} cores of {machine['processor']}, {machine['date']}, {work}"
