"""The report as Markdown, and the short form that the README shows."""
import statistics

import machine as machines
import measure
from programs import PHASES

NAMES = {"raytrace": "raytrace", "povray": "POV-Ray", "tachyon": "Tachyon", "floor": "Embree alone"}


def table(head, rows):
    if not rows:
        return ""
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(cells) + " |\n" for cells in lines) + "\n"


def number(value):
    """Three significant digits, no exponent."""
    if value is None:
        return "-"
    if abs(value) >= 100:
        return f"{value:.0f}"
    return f"{value:.2f}" if abs(value) >= 10 else f"{value:.3f}" if abs(value) >= 0.1 else f"{value:.4f}"


def spread(values, form=number):
    """Median, and in brackets the smallest and the largest."""
    return f"{form(statistics.median(values))} ({form(min(values))}-{form(max(values))})" if values else "-"


def short(values):
    return f"{statistics.median(values):.2f}" if values else "-"


def two(value):
    return f"{value:.2f}"


def place(m):
    return [m.scene, f"{m.width}x{m.height}", str(m.threads)]


def pictures(rows):
    cells = []
    for m in rows:
        for key, figures in m.pictures.items():
            same = "yes" if m.same(key) else "**no**"
            cells.append([*place(m), NAMES.get(key, key), f"{figures['differing_1']} of {figures['pixels']}", str(figures["differing_0"]),
                          f"{figures['flip']['mean']:.6f}", same])
    head = ["scene", "size", "threads", "program", "pixels off by 1 %", "off at all", "mean FLIP", "same picture"]
    return table(head, cells)


def ratio_rows(rows, form):
    cells = []
    for m in rows:
        cell = lambda other, field: form(m.ratios("raytrace", other, field))
        cells.append([*place(m), cell("povray", "trace"), cell("povray", "cpu"), cell("povray", "wall"), cell("tachyon", "trace"),
                      cell("tachyon", "cpu"), cell("tachyon", "wall"), cell("floor", "per_ray")])
    head = ["scene", "size", "threads", "trace / POV-Ray", "CPU / POV-Ray", "wall / POV-Ray", "trace / Tachyon", "CPU / Tachyon", "wall / Tachyon",
            "time per ray / Embree alone"]
    return table(head, cells)


def phases(rows):
    cells = []
    for m in rows:
        for key in m.runs:
            peak = measure.median(m.values(key, "peak"))
            cells.append([*place(m), NAMES.get(key, key), *(spread(m.values(key, phase)) for phase in PHASES), spread(m.values(key, "wall")),
                          spread(m.values(key, "cpu")), f"{peak / 1e6:.0f}" if peak else "-"])
    return table(["scene", "size", "threads", "program", *PHASES, "process, wall", "process, CPU", "peak, MB"], cells)


def gains(rows):
    """What a second thread brings: for each scene and size the trace time of the fewest threads over that of the most, by program."""
    groups = {}
    for m in rows:
        groups.setdefault((m.scene, m.width, m.height), []).append(m)
    cells = []
    for (scene, width, height), group in groups.items():
        few, many = min(group, key=lambda m: m.threads), max(group, key=lambda m: m.threads)
        if few.threads == many.threads:
            continue
        gain = {}
        for key in few.runs:
            if few.values(key, "trace") and many.values(key, "trace"):
                gain[key] = [a / b for a, b in zip(few.values(key, "trace"), many.values(key, "trace")) if b > 0]
        beside = number(measure.median(gain["raytrace"]) / measure.median(gain["floor"])) if gain.get("floor") else "-"
        cells.append([scene, f"{width}x{height}", f"{few.threads} to {many.threads}", *(spread(gain.get(key, []), two) for key in NAMES), beside])
    return table(["scene", "size", "threads", *NAMES.values(), "raytrace / Embree alone"], cells)


def memory(step, key):
    return f"{step.bytes_each[key]:.0f}" if key in step.bytes_each else "-"


def growth(steps):
    cells = []
    for s in steps:
        m = s.measured
        parse = measure.median(m.values("raytrace", "parse"))
        nanoseconds = lambda key: spread([1e9 * v for v in m.values(key, "per_ray")])
        cells.append([s.kind, f"{s.primitives}", f"{s.file_bytes / 1e6:.1f}", spread(m.values("raytrace", "parse")),
                      number(s.file_bytes / 1e6 / parse) if parse else "-", spread(m.values("raytrace", "build")), spread(m.values("floor", "build")),
                      nanoseconds("raytrace"), nanoseconds("floor"), spread(m.ratios("raytrace", "floor", "per_ray"), two), memory(s, "raytrace"),
                      memory(s, "povray"), memory(s, "tachyon"),
                      spread(m.ratios("raytrace", "povray", "trace"), two), spread(m.ratios("raytrace", "tachyon", "trace"), two)])
    head = ["kind", "primitives", "file, MB", "parse", "MB/s", "build", "Embree's build", "ns a ray", "Embree's", "ratio", "bytes a primitive",
            "POV-Ray's", "Tachyon's", "trace / POV-Ray", "trace / Tachyon"]
    return table(head, cells)


def course(rows):
    cells = [[*place(m)[:2], spread(m.values("ours", "wall")), spread(m.values("theirs", "wall")), spread(m.ratios("ours", "theirs", "wall"), two),
              spread(m.ratios("ours", "theirs", "cpu"), two), f"{m.pictures['theirs']['differing_1']} of {m.pictures['theirs']['pixels']}"] for m in rows]
    return table(["scene", "size", "raytrace render", "the course's program", "wall ratio", "CPU ratio", "pixels off by 1 %"], cells)


def code(machine):
    held = ", ".join(f"{name} {widest}" for name, widest in machine["code"].items())
    return f"The machine has {machine['instruction_sets']}; the programs use: {held}."


def report(result):
    """The whole report. `result` is what `run` gathers."""
    machine = result["machine"]
    versions = ", ".join(f"{name} {machine[key]}" for name, key in [("POV-Ray", "povray"), ("Tachyon", "tachyon")] if machine[key])
    text = f"# Beside its peers\n\n{machines.sentence(machine)}. {code(machine)} {versions}. {machine['compiler']}.\n\n"
    text += "".join(f"{note}\n\n" for note in result["notes"])
    text += (f"Medians of {result['runs']} runs in turn after one that does not count, the smallest and largest in brackets; seconds. Ratios are taken "
             "run by run, only where the pictures agree (at most 1 % of the pixels off by 1 %). Embree alone shoots the camera rays and the shadow "
             "rays of what they hit and does nothing else, in single precision, so it is compared by time per ray.\n\n")
    peers, kinds = result["peers"], result["growth"]
    text += "## Pictures\n\nBeside POV-Ray's.\n\n" + pictures([*peers, *(s.measured for steps in kinds.values() for s in steps)])
    text += "## Ratios\n\n![ratios](ratios.svg)\n\n" + ratio_rows(peers, lambda values: spread(values, two))
    text += "## Phases\n\n" + phases(peers)
    text += "## Threads\n\nTrace time of the first number of threads over that of the second.\n\n" + gains(peers)
    if any(kinds.values()):
        text += "## Growth\n\nOne thread, 640x480.\n\n![growth](growth.svg)\n\n" + growth([s for steps in kinds.values() for s in steps])
    if result["course"]:
        text += "## The course's program\n\nWhole processes, each as it is.\n\n" + course(result["course"])
    return text + f"## Start-up\n\nMilliseconds: {result['start_up']}.\n"


def summary(result):
    """What stands in the README."""
    text = f"{machines.sentence(result['machine'])}; medians of {result['runs']} runs in turn, pictures compared first. {code(result['machine'])}\n\n"
    text += ratio_rows(result["peers"], short)
    rows = gains(result["peers"])
    if rows:
        text += "What a second thread brings to the trace time, with the spread:\n\n" + rows
    steps = [s for steps in result["growth"].values() for s in steps]
    if steps:
        text += "One thread, 640x480, more and more primitives; build is in seconds:\n\n"
        cells = []
        for s in steps:
            of = lambda key, field, scale=1.0: number(scale * measure.median(s.measured.values(key, field)))
            ratio = lambda key, field: short(s.measured.ratios("raytrace", key, field))
            cells.append([f"{s.primitives} {s.kind}", of("raytrace", "build"), of("raytrace", "per_ray", 1e9), ratio("floor", "per_ray"), memory(s, "raytrace"),
                          ratio("povray", "trace"), ratio("tachyon", "trace")])
        text += table(["primitives", "build", "ns a ray", "time per ray / Embree alone", "bytes a primitive", "trace / POV-Ray", "trace / Tachyon"], cells)
    return text.rstrip("\n") + "\n"
