"""Scenes that ask for more than usual: each a generator of text, of a size that is stated, so that no scene lies on the disk."""
import struct
import zlib

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\nlight_source { <3, 5, -9> rgb 1 }\n"


def place(n, i="I"):
    """Where object `i` of `n` stands: rows of a square."""
    side = int(n**0.5) + 1
    return f"<mod({i},{side})*{8 / side:.6f}-4, int({i}/{side})*{6 / side:.6f}-3, 0>"


def repeat(text, n, piece=4096):
    """`text` n times, in large pieces."""
    while n > 0:
        count = min(n, piece)
        yield text * count
        n -= count


# --- loops, macros, includes


def while_objects(n, look=""):
    yield HEAD + f"#declare I = 0;\n#while (I < {n})\n  sphere {{ {place(n)}, {3 / n**0.5:.6f} {look} }}\n  #declare I = I + 1;\n#end\n"


def for_objects(n, look=""):
    yield HEAD + f"#for (I, 1, {n})\n  sphere {{ {place(n)}, {3 / n**0.5:.6f} {look} }}\n#end\n"


LOOK = "texture { pigment { rgb <mod(I,7)/7, mod(I,11)/11, mod(I,13)/13> } finish { diffuse mod(I,5)/5 } }"


def endless(text):
    yield HEAD + text


def macro_depth(n):
    yield HEAD + f"#macro M(N)\n  #if (N > 0)\n    M(N - 1)\n  #else\n    sphere {{ 0, 1 }}\n  #end\n#end\nM({n})\n"


def value_depth(n):
    yield HEAD + f"#macro F(N)\n  #local R = 0;\n  #if (N > 0)\n    #local R = 1 + F(N - 1);\n  #end\n  R\n#end\nsphere {{ 0, F({n}) / {n} }}\n"


# --- size of the text


def many_spheres(n):
    yield HEAD
    for first in range(0, n, 1000):
        yield "".join(f"sphere {{ <{(i % 997) / 100 - 5}, {(i // 997 % 991) / 160 - 3}, {i % 89}>, 0.01 }}\n" for i in range(first, min(first + 1000, n)))


def large_mesh(n):
    side = max(2, int((n / 2) ** 0.5))
    yield HEAD + f"mesh2 {{ vertex_vectors {{ {(side + 1) ** 2}\n"
    for j in range(side + 1):
        yield "".join(f",<{8 * i / side - 4:.5f},{6 * j / side - 3:.5f},{(i * j) % 7 / 70:.3f}>" for i in range(side + 1)) + "\n"
    yield f"}} face_indices {{ {2 * side * side}\n"
    for j in range(side):
        row = j * (side + 1)
        yield "".join(f",<{row + i},{row + i + 1},{row + i + side + 1}>,<{row + i + 1},{row + i + side + 2},{row + i + side + 1}>" for i in range(side)) + "\n"
    yield "} pigment { rgb 1 } }\n"


def long_name(n):
    yield HEAD + "#declare "
    yield from repeat("a", n)
    yield " = 1;\nsphere { 0, 1 }\n"


def long_string(n):
    yield HEAD + '#declare S = "'
    yield from repeat("a", n)
    yield '";\nsphere { 0, strlen(S) / ' + f"{n} }}\n"


def long_comment(n):
    yield HEAD + "/* "
    yield from repeat("a ", n // 2)
    yield "*/\nsphere { 0, 1 }\n"


def long_number(n):
    yield HEAD + "#declare N = 0."
    yield from repeat("1", n)
    yield ";\nsphere { 0, N }\n"


def blank(n):
    yield HEAD
    yield from repeat(" \n\t", n // 3)
    yield "sphere { 0, 1 }\n"


# --- depth


def nested(before, open_text, inner, close_text, after, n):
    yield HEAD + before
    yield from repeat(open_text, n)
    yield inner
    yield from repeat(close_text, n)
    yield after


def chain(first, link, last, n):
    """Declarations that each use the one before, {0} and {1}: their numbers."""
    yield HEAD + first
    for i in range(n):
        yield link.format(i, i + 1)
    yield last.format(n)


# --- long lists


def listed(before, item, after, n, separator=" "):
    """{0} is the item's number, {1} the same as a share of n."""
    yield HEAD + before
    for first in range(0, n, 1000):
        yield separator.join(item.format(i, i / n) for i in range(first, min(first + 1000, n)))
        if first + 1000 < n:
            yield separator
    yield after


# --- pictures and other files


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png_header(width, height):
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))


def png(width, height):
    """A black grey picture, which takes a thousandth of its size."""
    packer = zlib.compressobj(9)
    rows = 4096
    line = bytes(width + 1)
    packed = b"".join(packer.compress(line * min(rows, height - y)) for y in range(0, height, rows)) + packer.flush()
    return png_header(width, height) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def numbers(n):
    for first in range(0, n, 1000):
        yield "".join(f"{i % 1000 / 1000}, " for i in range(first, min(first + 1000, n)))
    yield "1\n"
