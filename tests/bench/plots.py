"""The two pictures of a report: growth with the number of primitives, and ratios beside each peer."""
import measure
import svg

PEOPLE = [("raytrace", "raytrace", 0), ("floor", "Embree alone", 1), ("povray", "POV-Ray", 2), ("tachyon", "Tachyon", 3)]


def growth_chart(frame, title, y_label, steps, figure):
    """Curves over primitives of one figure of a step and a program."""
    named = []
    for key, name, color in PEOPLE:
        points = [(s.primitives, figure(s, key)) for s in steps]
        named.append((name, svg.COLORS[color], [(n, value) for n, value in points if value and value > 0]))
    return svg.curves(frame, title, "primitives", y_label, named)


def growth(kinds):
    """`kinds`: name -> steps, a column each; rows: time of a ray, of building, and memory of one primitive."""
    median_of = lambda s, key, field: measure.median(s.measured.values(key, field)) or 0.0
    rows = [("time of a ray", "ns", lambda s, key: 1e9 * median_of(s, key, "per_ray")), ("build", "seconds", lambda s, key: median_of(s, key, "build")),
            ("memory of a primitive", "bytes", lambda s, key: s.bytes_each.get(key))]
    content, width = "", 380
    for column, (kind, steps) in enumerate(kinds.items()):
        x = 70 + column * (width + 170)
        for row, (title, unit, figure) in enumerate(rows):
            content += growth_chart(svg.Frame(x, 40 + 290 * row, width, 210), f"{kind}: {title}", unit, steps, figure)
    return svg.document(70 + 2 * (width + 170), 40 + 290 * len(rows), content)


def ratios(rows):
    """`rows`: measured jobs. Trace time over that of each peer that made the same picture, with its spread."""
    bars = []
    for m in rows:
        for key, name, color in PEOPLE[1:]:
            values = m.ratios("raytrace", key, "per_ray" if key == "floor" else "trace")
            if values:
                what = "a ray" if key == "floor" else "trace"
                label = f"{m.scene} {m.width}x{m.height}, {m.threads} threads: {what} / {name}".replace(", 1 threads", ", 1 thread")
                bars.append((label, measure.median(values), min(values), max(values), svg.COLORS[color]))
    height = 22 * len(bars)
    frame = svg.Frame(390, 60, 520, max(height, 22))
    content = svg.bars(frame, "Time over that of the peer, same picture", bars, [(0.2, "1/5"), (1.0, "1"), (1.5, "1.5")]) if bars else ""
    return svg.document(960, frame.height + 90, content)
