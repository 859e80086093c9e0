"""Charts as SVG text: curves on logarithmic axes, and bars. Text in, text out; knows nothing of what is shown."""
import dataclasses
import html
import math

COLORS = ["#0a5fb4", "#c2410c", "#15803d", "#7c3aed", "#737373"]
GRID, BORDER, INK = "#ddd", "#888", "#222"


@dataclasses.dataclass
class Frame:
    """Place of a chart in the picture, in pixels; ticks and labels stand outside of it."""

    x: float
    y: float
    width: float
    height: float


def text(x, y, words, size=12, anchor="start", color=INK):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" fill="{color}">{html.escape(words, quote=False)}</text>\n'


def line(x1, y1, x2, y2, color=GRID):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}"/>\n'


def power(exponent):
    """10 to the exponent as people write it, in digits where that is short."""
    return f"{10.0**exponent:g}" if -3 <= exponent <= 3 else f"1e{exponent}"


def decades(values):
    """The whole exponents of ten around the values."""
    least, most = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
    return least, max(most, least + 1)


def curves(frame, title, x_label, y_label, named):
    """A log-log chart. `named`: (name, color, [(x, y), ...]) with positive numbers; names stand at the last points."""
    points = [p for _, _, curve in named for p in curve]
    if not points:
        return text(frame.x, frame.y - 9, title, 14) + text(frame.x, frame.y + 20, "nothing was measured")
    x0, x1 = decades([x for x, _ in points])
    y0, y1 = decades([y for _, y in points])
    right, bottom = frame.x + frame.width, frame.y + frame.height
    place = lambda x, y: (frame.x + frame.width * (math.log10(x) - x0) / (x1 - x0), bottom - frame.height * (math.log10(y) - y0) / (y1 - y0))
    out = text(frame.x, frame.y - 9, title, 14) + text(right, frame.y - 9, y_label, anchor="end")
    out += text(right, bottom + 32, x_label, anchor="end")
    for exponent in range(x0, x1 + 1):
        x, _ = place(10.0**exponent, 10.0**y0)
        out += line(x, frame.y, x, bottom) + text(x, bottom + 16, power(exponent), anchor="middle")
    for exponent in range(y0, y1 + 1):
        _, y = place(10.0**x0, 10.0**exponent)
        out += line(frame.x, y, right, y) + text(frame.x - 6, y + 4, power(exponent), anchor="end")
    out += f'<rect x="{frame.x}" y="{frame.y}" width="{frame.width}" height="{frame.height}" fill="none" stroke="{BORDER}"/>\n'
    labels = []
    for name, color, curve in named:
        if not curve:
            continue
        placed = [place(x, y) for x, y in sorted(curve)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in placed)
        out += f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.8"/>\n'
        out += "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{color}"/>\n' for x, y in placed)
        labels.append((placed[-1][1], placed[-1][0], name, color))
    return out + spread_labels(labels)


def spread_labels(labels, apart=13):
    """Names right of their curves' ends; each at least a line below the one above it."""
    out, last = "", -math.inf
    for y, x, name, color in sorted(labels):
        last = max(y + 4, last + apart)
        out += text(x + 7, last, name, color=color)
    return out


def bars(frame, title, rows, marks):
    """Bars from the left on a linear axis from 0. `rows`: (label, value, least, most, color); `marks`: values with a line and a name."""
    most = max([row[3] for row in rows] + [value for value, _ in marks]) * 1.05
    step = frame.height / max(1, len(rows))
    place = lambda value: frame.x + frame.width * value / most
    out = text(frame.x, frame.y - 22, title, 14)
    for value, name in marks:
        out += line(place(value), frame.y - 4, place(value), frame.y + frame.height, BORDER) + text(place(value), frame.y - 7, name, 11, "middle")
    for i, (label, value, least, greatest, color) in enumerate(rows):
        y = frame.y + i * step
        out += text(frame.x - 8, y + step / 2 + 4, label, anchor="end")
        out += f'<rect x="{frame.x:.1f}" y="{y + 3:.1f}" width="{place(value) - frame.x:.1f}" height="{step - 6:.1f}" fill="{color}"/>\n'
        out += line(place(least), y + step / 2, place(greatest), y + step / 2, INK)
        out += text(place(max(value, greatest)) + 6, y + step / 2 + 4, f"{value:.2f}")
    return out


def document(width, height, content):
    return (f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Verdana, sans-serif">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n{content}</svg>\n')
