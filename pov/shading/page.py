"""The page of the gallery, and an animated picture from frames."""

import html
import re
import struct
import zlib

STYLE = """
body { margin: 0 auto; max-width: 1720px; padding: 1rem 2rem 4rem; font: 16px/1.45 system-ui, sans-serif; color: #222; background: #f4f3f0; }
h1 { font-weight: 600; margin-bottom: 0; }
h2 { margin: 3rem 0 0; font-weight: 600; border-top: 2px solid #b9b4a8; padding-top: 0.6rem; }
.source { color: #7a5c1e; margin: 0; }
.text { max-width: 62rem; }
.texts { display: grid; grid-template-columns: auto 1fr; gap: 0 1rem; }
.texts dt { font-weight: 600; }
.texts dd { margin: 0; }
nav a { margin-right: 1.2rem; }
.flow { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
.table { display: grid; gap: 0.8rem 0.6rem; justify-content: start; }
.table b.head { align-self: end; }
figure { margin: 0; min-width: 0; }
figure img { display: block; max-width: 100%; height: auto; background: #000; }
figcaption { font-size: 0.82rem; max-width: 36rem; margin-top: 0.2rem; }
summary { cursor: pointer; color: #666; font-size: 0.78rem; }
code { font: 0.78rem/1.35 ui-monospace, monospace; overflow-wrap: anywhere; }
details code { display: block; background: #e6e3dc; padding: 0.3rem 0.5rem; user-select: all; }
.sheet figure { width: auto !important; }
.sheet { display: grid; grid-template-columns: repeat(8, minmax(0, 1fr)); gap: 0.3rem; margin-top: 0.8rem; }
"""


def figure(shot):
    width, height = shot.size
    return ('<figure style="width:%dpx;max-width:100%%"><img src="%s.png" width="%d" height="%d" alt="%s" loading="lazy"><figcaption>%s<details><summary>command line, '
            '%.2f s</summary><code>%s</code></details></figcaption></figure>' %
            (width, shot.name, width, height, html.escape(re.sub("<[^>]*>", "", shot.caption), quote=False).replace("&amp;", "&"), shot.caption,
             shot.seconds, html.escape(shot.command)))


def body_of(section, shots):
    figures = "\n".join(figure(shot) for shot in shots)
    if section.animated:
        width, height = shots[0].size
        return ('<figure><img src="%s.png" width="%d" height="%d" alt="%s"></figure>\n<div class="sheet">%s</div>' %
                (section.name, width, height, html.escape(section.title), figures))
    if section.columns:
        heads = "".join('<b class="head">%s</b>' % head for head in section.heads)
        return '<div class="table" style="grid-template-columns: repeat(%d, minmax(0, auto))">%s%s</div>' % (section.columns, heads, figures)
    return '<div class="flow">%s</div>' % figures


def page(title, introduction, texts, sections):
    """`texts` explains names that the page uses; `sections` are pairs of a section and its pictures as taken: name, scene, size, caption, command, seconds."""
    links = " ".join('<a href="#%s">%s</a>' % (section.name, section.title) for section, _ in sections)
    parts = ["<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8"><title>%s</title><style>%s</style></head><body>' % (title, STYLE),
             "<h1>%s</h1><p class=\"text\">%s</p>" % (title, introduction),
             '<dl class="texts">%s</dl>' % "".join("<dt>%s</dt><dd>%s</dd>" % (name, html.escape(text, quote=False)) for name, text in texts.items()),
             "<nav>%s</nav>" % links]
    for section, shots in sections:
        parts.append('<h2 id="%s">%s</h2><p class="source">%s</p><p class="text">%s</p>' % (section.name, section.title, section.source, section.text))
        parts.append(body_of(section, shots))
    return "\n".join(parts + ["</body></html>"]) + "\n"


def chunks(data):
    """The chunks of a PNG file: pairs of type and content."""
    at = 8
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        yield data[at + 4:at + 8], data[at + 8:at + 8 + length]
        at += length + 12


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def animated(frames, seconds_each):
    """An animated PNG of PNG files of one size and type, given as bytes, that repeats for ever."""
    header = dict(chunks(frames[0]))[b"IHDR"]
    width, height = struct.unpack(">II", header[:8])
    result = frames[0][:8] + chunk(b"IHDR", header) + chunk(b"acTL", struct.pack(">II", len(frames), 0))
    result += b"".join(chunk(kind, content) for kind, content in chunks(frames[0]) if kind in (b"gAMA", b"sRGB", b"cHRM"))
    number = 0
    for i, frame in enumerate(frames):
        result += chunk(b"fcTL", struct.pack(">IIIIIHHBB", number, width, height, 0, 0, round(1000 * seconds_each), 1000, 0, 0))
        number += 1
        data = b"".join(content for kind, content in chunks(frame) if kind == b"IDAT")
        if i == 0:
            result += chunk(b"IDAT", data)
        else:
            result += chunk(b"fdAT", struct.pack(">I", number) + data)
            number += 1
    return result + chunk(b"IEND", b"")
