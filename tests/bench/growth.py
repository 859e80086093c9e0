"""How time and memory grow with the number of primitives, one thread, a picture of one size."""
import dataclasses
import pathlib
import tempfile

import measure
import programs
import scenes

WIDTH, HEIGHT = 640, 480
COUNTS = [10**3, 10**4, 10**5, 10**6]
HUGE = 10**7
HUGE_MEMORY = 12e9  # bytes that must be free for it
PEERS_UP_TO = 10**6
FEWEST_FOR_MEMORY = 10**5
MUCH_MEMORY = 100e6  # bytes
FEWEST = 10  # the scene whose memory is that of the program without primitives


@dataclasses.dataclass
class Step:
    kind: str  # "spheres" or "mesh2"
    primitives: int
    file_bytes: int
    measured: measure.Measured
    bytes_each: dict = dataclasses.field(default_factory=dict)  # by program: memory above that of a scene of FEWEST, for one primitive


def write_scene(kind, count, folder):
    """The scene's file, and Tachyon's if it has one."""
    pov, twin = folder / f"{kind}.pov", folder / f"{kind}.dat" if kind == "spheres" and count <= PEERS_UP_TO else None
    if kind == "spheres":
        scenes.spheres(count, WIDTH, HEIGHT, pov, twin)
    else:
        scenes.mesh(count, pov)
    return pov, twin


def step(build, kind, count, peers, runs):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        pov, twin = write_scene(kind, count, folder)
        job = programs.Job(pov, WIDTH, HEIGHT, 1, folder, twin=twin, linear=True)
        who = [programs.Raytrace(build), programs.Floor(build), *(peers if count <= PEERS_UP_TO else [])]
        return Step(kind, count, pov.stat().st_size, measure.measure(build, who, job, runs, reference="povray"))


def free_memory():
    """Bytes that programs could still take."""
    lines = pathlib.Path("/proc/meminfo").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith("MemAvailable"))


def bytes_each(measured, base, count):
    """Of few primitives the difference is noise. A base that is not known is small, and does not count beside much memory."""
    if count < FEWEST_FOR_MEMORY:
        return {}
    peaks = {key: (measure.median(measured.values(key, "peak")), measure.median(base.values(key, "peak"))) for key in measured.runs}
    return {key: (peak - (least or 0.0)) / count for key, (peak, least) in peaks.items() if peak and (least or peak > MUCH_MEMORY)}


def series(build, kind, counts, peers, runs, say):
    """The steps of one kind, smallest first."""
    base = step(build, kind, FEWEST, peers, 1).measured
    steps = []
    for count in counts:
        if count >= HUGE and free_memory() < HUGE_MEMORY:
            say(f"{kind}, {count}: left out, {free_memory() / 1e9:.0f} GB of memory are free and {HUGE_MEMORY / 1e9:.0f} are wanted")
            continue
        say(f"{kind}, {count}")
        steps.append(step(build, kind, count, peers, runs))
        steps[-1].bytes_each = bytes_each(steps[-1].measured, base, count)
    return steps
