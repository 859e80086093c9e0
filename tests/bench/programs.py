"""The programs that are measured: how each is called, and what it tells of its phases."""
import dataclasses
import pathlib
import re
import shutil

import process

PHASES = ["parse", "build", "trace", "write"]


@dataclasses.dataclass
class Job:
    """One picture: a scene, a size, a number of threads."""

    scene: pathlib.Path
    width: int
    height: int
    threads: int
    folder: pathlib.Path  # where pictures go
    twin: pathlib.Path | None = None  # the same scene for Tachyon
    linear: bool = False  # the file holds linear values, as Tachyon writes them

    def povray_words(self, name):
        gamma = ["File_Gamma=1.0"] if self.linear else []
        return [f"+I{self.scene}", f"+W{self.width}", f"+H{self.height}", "-A", f"+WT{self.threads}", "+FN8", f"+O{self.folder / name}.png", *gamma]


@dataclasses.dataclass
class Run:
    """Seconds by phase (None: the program does not tell), of the whole process by the clock and by the processor; rays; bytes at the peak."""

    phases: dict
    wall: float | None = None
    cpu: float | None = None
    peak: int | None = None
    rays: int | None = None


def seconds_of(text, pattern):
    match = re.search(pattern, text, re.S)
    return float(match.group(1)) if match else None


class Raytrace:
    name, key = "raytrace", "raytrace"

    def __init__(self, build):
        self.program = build / "raytrace"

    def takes(self, job):
        return True

    def run(self, job):
        done = process.run([self.program, *job.povray_words(self.key), "--shading", "povray", "--stats", "-q"])
        return Run(**self.told(done.text), wall=done.wall, cpu=done.cpu)

    @staticmethod
    def told(text):
        times = re.search(r"parse ([0-9.]+) s, build ([0-9.]+) s, trace ([0-9.]+) s, write ([0-9.]+) s", text)
        return {
            "phases": dict(zip(PHASES, map(float, times.groups()))),
            "rays": int(re.search(r"^ *all +(\d+)", text, re.M).group(1)),
            "peak": round(float(re.search(r"peak ([0-9.]+) MB", text).group(1)) * 1e6),
        }


class Povray:
    name, key, package = "POV-Ray", "povray", "povray"

    def takes(self, job):
        return shutil.which("povray") is not None

    def run(self, job):
        done = process.run(["povray", *job.povray_words(self.key), "-D", "-V"], cwd=job.folder)
        return Run(**self.told(done.text), wall=done.wall, cpu=done.cpu, peak=done.peak)

    @staticmethod
    def told(text):
        phase = lambda title: seconds_of(text, rf"{title} Time:[^(\n]*\(([0-9.]+) seconds\)")
        return {"phases": {"parse": phase("Parse"), "build": phase("Bounding"), "trace": phase("Trace"), "write": None}}


class Tachyon:
    name, key, package = "Tachyon", "tachyon", "tachyon"

    def takes(self, job):
        return job.twin is not None and shutil.which("tachyon") is not None

    def run(self, job):
        picture = job.folder / f"{self.key}.png"
        size = ["-res", job.width, job.height]
        done = process.run(["tachyon", job.twin, *size, "-numthreads", job.threads, "-format", "PNG", "+V", "-o", picture], cwd=job.folder)
        return Run(**self.told(done.text), wall=done.wall, cpu=done.cpu, peak=done.peak)

    @staticmethod
    def told(text):
        titles = {"parse": "Scene Parsing", "build": "Preprocessing", "trace": "Ray Tracing", "write": "Image I/O"}
        return {"phases": {phase: seconds_of(text, rf"{title} Time: +([0-9.]+) seconds") for phase, title in titles.items()}}


class Floor:
    """Rays straight to Embree. It makes no picture, and its rays are fewer where there are mirrors: it is compared by time per ray."""

    name, key = "Embree alone", "floor"
    OTHER_SHAPES = 3

    def __init__(self, build):
        self.program = build / "tests/bench/embree_floor"

    def takes(self, job):
        return True

    def run(self, job):
        words = [self.program, job.scene, job.width, job.height, job.threads, 1]
        done = process.run(words, allowed=(0, self.OTHER_SHAPES))
        return None if done.status else Run(**self.told(done.text))

    @staticmethod
    def told(text):
        seconds, camera, shadow, build = text.split()[:4]
        return {"phases": {"parse": None, "build": float(build), "trace": float(seconds), "write": None}, "rays": int(camera) + int(shadow)}


class Course:
    """A program with the course's command line: PROGRAM render SCENE WIDTH HEIGHT writes output.png where it is started."""

    def __init__(self, program, name, key):
        self.program, self.name, self.key = program, name, key

    def takes(self, job):
        return True

    def run(self, job):
        done = process.run([self.program, "render", job.scene, job.width, job.height], cwd=job.folder)
        (job.folder / "output.png").replace(job.folder / f"{self.key}.png")
        return Run({phase: None for phase in PHASES}, wall=done.wall, cpu=done.cpu, peak=done.peak)
