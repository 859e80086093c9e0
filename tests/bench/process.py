"""One process: what it printed, and the seconds and memory that it took."""
import dataclasses
import os
import resource
import subprocess
import tempfile
import time


class Failed(Exception):
    """A program ended with another status than 0; the text says which and what it said."""


@dataclasses.dataclass
class Process:
    status: int
    text: str  # standard output, then standard error
    wall: float  # seconds
    cpu: float  # seconds, user and system
    peak: int | None  # bytes, the largest resident set; None: no more than this interpreter's, from which the kernel starts to count


def run(command, cwd=None, allowed=(0,)):
    """Runs the command to its end; other exit statuses than the allowed ones raise Failed."""
    words = [str(word) for word in command]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begin = time.perf_counter()
        child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=out, stderr=err, cwd=cwd)
        _, status, usage = os.wait4(child.pid, 0)
        wall = time.perf_counter() - begin
        child.returncode = os.waitstatus_to_exitcode(status)
        own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        peak = usage.ru_maxrss * 1024 if usage.ru_maxrss > own else None
        out.seek(0), err.seek(0)
        text = (out.read() + err.read()).decode(errors="replace")
    if child.returncode not in allowed:
        raise Failed(f"{' '.join(words)}: exit status {child.returncode}\n{text[-2000:]}")
    return Process(child.returncode, text, wall, usage.ru_utime + usage.ru_stime, peak)
