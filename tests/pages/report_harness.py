"""Results as a grading leaves them, made up by a test, and the pages that `raytrace merge` makes of them. Nothing but the standard library."""
import json
import pathlib
import struct
import subprocess
import zlib

METRICS = ("differing", "differing_1", "rmse", "p99", "flip", "neighbourhood")


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def filtered(kind, row, above, step):
    """A row as PNG stores it with filter `kind` (PNG specification, section 9)."""
    out = bytearray([kind])
    for i, value in enumerate(row):
        a = row[i - step] if i >= step else 0
        b = above[i]
        c = above[i - step] if i >= step else 0
        nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        out.append((value - (0, a, b, (a + b) // 2, nearest)[kind]) & 255)
    return bytes(out)


def png(width, height, rows, channels=3, depth=8, filters=(0,), level=1):
    """A PNG of rows of bytes; the filters are taken in turn."""
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    step = channels * depth // 8
    above, packed = bytes(width * step), []
    for y, row in enumerate(rows):
        use = filters[y % len(filters)]
        packed.append(b"\0" + row if use == 0 else filtered(use, row, above, step))
        above = row
    head = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"".join(packed), level)) + chunk(b"IEND", b"")


def figures(*values):
    return {"pixels": 307200, "fuzz": 5.0, **dict(zip(METRICS, list(values) + [0.0] * (len(METRICS) - len(values))))}


class Grading:
    """A folder of results. Each test may have `picture` and `expected`, bytes of files; the rest are members of its result."""

    def __init__(self, place, suite="Winter"):
        self.place, self.suite = pathlib.Path(place), suite
        self.results, self.times, self.tests = [], [], {}
        self.place.mkdir(parents=True)

    def add(self, test, submission="ada", kind="picture", outcome="passed", picture=None, expected=None, command=(), wall=0.25, tolerance=0.0,
            written=None, **result):
        number = len(self.results)
        time = {"submission": submission, "test": test, "alone": False, "wall": wall, "cpu": wall / 2, "spread": 0.0, "peak": (number + 1) << 20}
        if picture is not None:
            time["picture"] = f"known/{number}/picture"
            folder = self.place / "known" / str(number)
            folder.mkdir(parents=True)
            (folder / "picture").write_bytes(picture)
        if test not in self.tests:
            path = self.place / f"expected{len(self.tests)}"
            if expected is not None:
                path.write_bytes(expected)
            asked = {"name": test, "command": list(command), "expected": str(written or path) if expected is not None or written else "",
                     "fuzz": 5.0, "tolerance": tolerance, "pass": [{"metric": "differing", "at_most": 1000.0}]}
            self.tests[test] = asked
        good = outcome in ("passed", "shown")
        self.results.append({"submission": submission, "test": test, "kind": kind, "required": True, "weight": 1.0, "outcome": outcome,
                             "credit": 1.0 if good else 0.0, "status": 0, **result})
        self.times.append(time)

    def write(self, holes=()):
        head = {"suite": self.suite}
        files = {"results.json": {"format": "raytrace results 1", **head, "holes": list(holes), "shard": [1, 1], "results": self.results},
                 "times.json": {"format": "raytrace times 1", **head, "times": self.times},
                 "tests.json": {"format": "raytrace tests 1", **head, "tests": list(self.tests.values())}}
        for name, content in files.items():
            (self.place / name).write_text(json.dumps(content))

    def pages(self, program, out, *words, holes=()):
        """Writes everything and joins this one shard; returns the folder of its pages."""
        self.write(holes)
        subprocess.run([program, "merge", "-q", "-o", str(out), *words, str(self.place)], check=True)
        return pathlib.Path(out)
