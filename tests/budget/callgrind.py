"""Instructions of a program as callgrind counts them, those of its own code alone: what Embree, the C library and the loader do depends on
the processor, and callgrind's count of the program's own code does not."""
import collections
import dataclasses
import os
import pathlib
import re
import subprocess

MAIN_THREAD = "01"


@dataclasses.dataclass
class Profile:
    main: int  # instructions of the thread that reads, builds and writes
    workers: int  # of those that trace
    lines: dict  # source file below src/ -> line -> addresses of its instructions that were run


def run(program, words, folder):
    """Counts in the folder, with nothing of the user's environment."""
    out = pathlib.Path(folder, "callgrind.out")
    options = ["--tool=callgrind", f"--callgrind-out-file={out}", "--separate-threads=yes", "--dump-instr=yes", "--compress-strings=no", "--compress-pos=no"]
    done = subprocess.run(["valgrind", *options, str(program), *words], cwd=folder, env={"PATH": os.environ["PATH"], "HOME": str(folder)},
                          capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        raise RuntimeError(f"{program} {' '.join(words)}: exit status {done.returncode}\n{done.stderr[-2000:]}")
    profile = Profile(0, 0, collections.defaultdict(lambda: collections.defaultdict(set)))
    for part in sorted(out.parent.glob(f"{out.name}-*")):
        count = read(part.read_text(errors="replace"), str(program), profile.lines)
        if part.name.endswith(MAIN_THREAD):
            profile.main += count
        else:
            profile.workers += count
    return profile


def read(text, program, lines):
    """The instructions of the program's own code in one file of callgrind's; adds the lines that were run, but for code that sets up
    global variables, which happens in every run.

    The format: `ob=`, `fl=` and `fn=` say where the following lines of costs belong, `fi=` and `fe=` change the file for inlined code; a
    line of costs is an address, a line number and a count; the line after `calls=` is the cost of a call and belongs to the callee."""
    count, of_program, at_start, file, skip = 0, False, False, "", False
    for line in text.splitlines():
        key, _, value = line.partition("=")
        if skip:
            skip = False
        elif key == "calls":
            skip = True
        elif key == "ob":
            of_program = value == program
        elif key in ("fl", "fi", "fe"):
            match = re.match(r"(?:.*/)?src/((?:\w+/)+\w+\.(?:h|cpp))$", value)
            file = match.group(1) if match else ""
        elif key == "fn":
            at_start = "_GLOBAL__sub_I" in value or "__static_initialization" in value
        elif of_program and line.startswith("0x"):
            address, number, cost = line.split()[:3]
            count += int(cost)
            if file and not at_start:
                lines[file][int(number)].add(int(address, 16))
    return count


def only_moves(program, address):
    """Whether the instruction there only moves, loads or clears something. Such a one may be taken out of inlined code and stand before the
    question whether that code is run at all; one that calculates may not."""
    span = [f"--start-address={address:#x}", f"--stop-address={address + 16:#x}"]
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", *span, str(program)], capture_output=True, text=True, check=True).stdout
    instruction = re.search(rf"^ *{address:x}:\t(.*)$", listing, re.M).group(1)
    return re.match(r"(mov|lea|pxor|xorp|xor |nop|push|pop)", instruction) is not None
