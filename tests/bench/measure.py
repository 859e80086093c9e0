"""Pictures compared first, then times: programs take turns, so that a slower machine is slower for all of them."""
import dataclasses
import json
import statistics
import subprocess

# Times are set beside each other only where the pictures agree: at most this share of pixels may differ by 1 %.
SAME_PICTURE = 0.01


@dataclasses.dataclass
class Measured:
    """The runs of every program on one job, and how each picture differs from the first program's."""

    scene: str
    width: int
    height: int
    threads: int
    runs: dict  # key of a program -> list of Run
    pictures: dict  # key of a program -> figures of `raytrace compare --json`

    def same(self, key):
        """Whether the program made the picture; a program without one counts."""
        figures = self.pictures.get(key)
        return figures is None or figures["differing_1"] <= SAME_PICTURE * figures["pixels"]

    def values(self, key, field):
        """Of each run: seconds of a phase, or of the whole process (`wall`, `cpu`), `peak` bytes, seconds `per_ray`; empty if unknown.

        Programs that do not count their rays are given those of raytrace, since they make its picture."""
        runs = self.runs.get(key, [])
        if field != "per_ray":
            return known([value_of(run, field) for run in runs])
        rays = next((run.rays for run in [*runs, *self.runs.get("raytrace", [])] if run.rays), None)
        return [trace / rays for trace in self.values(key, "trace")] if rays and self.same(key) else []

    def ratios(self, key, other, field):
        """Run by run, so that what both suffered cancels. Empty where a figure is unknown or the pictures differ."""
        if not (self.same(key) and self.same(other)):
            return []
        pairs = zip(self.values(key, field), self.values(other, field))
        return [a / b for a, b in pairs if b > 0]


def known(values):
    return [value for value in values if value is not None]


def value_of(run, field):
    return run.phases[field] if field in run.phases else getattr(run, field)


def median(values):
    return statistics.median(values) if values else None


def compare(build, first, second):
    done = subprocess.run([build / "raytrace", "compare", "--json", first, second], capture_output=True, text=True)
    return json.loads(done.stdout)


def measure(build, programs, job, runs, reference=None):
    """Runs each program once to compare its picture with that of the reference (a key; the first program's otherwise) and to fill the
    caches, then in turn. Programs that do not take the job are left out."""
    programs = [program for program in programs if program.takes(job)]
    programs = [program for program in programs if program.run(job) is not None]
    drawn = {program.key: job.folder / f"{program.key}.png" for program in programs}
    drawn = {key: picture for key, picture in drawn.items() if picture.exists()}
    reference = reference if reference in drawn else next(iter(drawn))
    pictures = {key: compare(build, drawn[reference], picture) for key, picture in drawn.items() if key != reference}
    measured = Measured(job.scene.stem, job.width, job.height, job.threads, {program.key: [] for program in programs}, pictures)
    for _ in range(runs):
        for program in programs:
            measured.runs[program.key].append(program.run(job))
    return measured
