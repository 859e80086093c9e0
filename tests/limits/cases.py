"""What each scene asks for, how much of it in the quick test and in the full one, and what has to become of it."""
import dataclasses
import typing

import scenes
from scenes import chain, listed, nested


@dataclasses.dataclass
class Case:
    name: str
    scene: typing.Callable  # of the size
    small: int
    full: int
    says: str = ""  # what the error says; empty: the scene is rendered
    status: int = 4
    options: tuple = ()  # of both sizes
    small_options: tuple = ()  # besides, where the limit itself would take too long to reach
    files: typing.Callable = lambda n: {}  # beside the scene: names and contents, bytes or pieces of text
    full_says: str = None  # where the full size ends otherwise

    def wanted(self, full):
        return self.full_says if full and self.full_says is not None else self.says


REREAD = "Loops and macros have read more than {} bytes of text again. --limit reread=N allows more."
FEW = ("--limit", "reread=8M")
FEW_SAYS, ALL_SAY = REREAD.format(8 << 20), REREAD.format(2 << 30)
STEPS = "A call of a function takes more than {} steps. --limit reread=N allows more."
NESTING = "Blocks and parentheses are nested more than 1000 deep. --limit nesting=N allows more."
STACK = r"The stack is too small for "
MACROS = "Macros call each other more than 10000 deep. --limit macro-depth=N allows more."
ARRAY = "An array has more than 10000000 elements. --limit array=N allows more."
PICTURE = "pixels, more than 268435456 in all. --limit picture=N allows more."
FEW_PARTS = "The sets of objects have more than 100000 parts in all. --limit parts=N allows more."
PARTS = "The sets of objects have more than 10000000 parts in all. --limit parts=N allows more."


def looping(name, text):
    return Case(name, lambda n: scenes.endless(text), 0, 0, FEW_SAYS, small_options=FEW, full_says=ALL_SAY)





LOOPS = [
    Case("#while: spheres", scenes.while_objects, 5_000, 1_000_000),
    Case("#for: spheres", scenes.for_objects, 5_000, 1_000_000),
    Case("#while: spheres with textures", lambda n: scenes.while_objects(n, scenes.LOOK), 5_000, 1_000_000),
    Case("#for: spheres with textures", lambda n: scenes.for_objects(n, scenes.LOOK), 5_000, 1_000_000),
    looping("#while, endless", "#while (1)\n#end\n"),
    looping("#for, endless", "#for (I, 1, 1e300)\n#end\n"),
    looping("#while of macros, endless", "#macro M()\n#end\n#while (1)\n  M()\n#end\n"),
    looping("#while in a block, endless", "union {\n  #while (1)\n    rotate x\n  #end\n}\n"),
    looping("#read in an endless #while", '#fopen F "n.txt" write\n#write (F, 1)\n#fclose F\n#while (1)\n#end\n'),
    Case("objects, endless", lambda n: scenes.endless("#while (1)\n  sphere { 0, 1 }\n#end\n"), 0, 0, "of memory. --limit memory=N allows more.",
         options=("--limit", "memory=4G"), small_options=("--limit", "memory=200M")),
]

RECURSION = [
    Case("macros 1,000 deep", scenes.macro_depth, 1000, 1000),
    Case("macros as values 1,000 deep", scenes.value_depth, 1000, 1000),
    Case("macros 100,000 deep", scenes.macro_depth, 100_000, 100_000, MACROS),
    Case("macros 100,000 deep, allowed", scenes.macro_depth, 100_000, 100_000, options=("--limit", "macro-depth=200k")),
    Case("macros as values 100,000 deep", scenes.value_depth, 100_000, 100_000, STACK),
    Case("macros, endless", lambda n: scenes.endless("#macro M()\n  M()\n#end\nM()\n"), 0, 0, MACROS),
    Case("macros as values, endless", lambda n: scenes.endless("#macro F()\n  (1 + F())\n#end\n#declare A = F();\n"), 0, 0, NESTING),
    Case("a function that calls itself", lambda n: scenes.endless("#declare F = function(x) { F(x - 1) }\n"), 0, 0,
         "Expected 'operand', undeclared identifier 'F' found instead", status=1),
    Case("functions that call two", lambda n: chain("#declare F0 = function(x) { x + 1 }\n", "#declare F{1} = function(x) {{ F{0}(x) + F{0}(x) }}\n",
                                                    "#declare A = F{0}(1);\n", n), 60, 60, STEPS.format(1 << 20), small_options=FEW, full_says=STEPS.format(1 << 28)),
    Case("functions 1,000 deep", lambda n: chain("#declare F0 = function(x) { x }\n", "#declare F{1} = function(x) {{ F{0}(x) }}\n", "", n), 1000, 1000,
         "Functions call each other more than 100 deep."),
    Case("a sum without end", lambda n: scenes.endless("#declare F = function(x) { sum(i, 1, 1e300, x) }\n#declare A = F(1);\n"), 0, 0, STEPS.format(1 << 20), small_options=FEW,
         full_says=STEPS.format(1 << 28)),
]


def include_chain(n):
    files = {f"{i}.inc": f'#include "{i + 1}.inc"\n' for i in range(n)}
    return files | {f"{n}.inc": "sphere { 0, 1 }\n"}


def doubling_includes(n):
    return {f"{i}.inc": 2 * f'#include "{i + 1}.inc"\n' for i in range(n)} | {f"{n}.inc": "\n"}


INCLUDE = lambda n: scenes.endless('#include "0.inc"\n')
INCLUDES = [
    Case("includes 50 deep", INCLUDE, 49, 49, files=include_chain),
    Case("includes 1,000 deep", INCLUDE, 999, 999, "Too many nested include files. More than 100 are open. --limit include-depth=N allows more.",
         files=include_chain),
    Case("includes 1,000 deep, allowed", INCLUDE, 999, 999, files=include_chain, options=("--limit", "include-depth=2k")),
    Case("an include of itself", INCLUDE, 0, 0, "Too many nested include files. More than 100 are open. --limit include-depth=N allows more.",
         files=lambda n: {"0.inc": '#include "0.inc"\n'}),
    Case("includes that double", INCLUDE, 40, 40, "More than 1000 files are included. --limit includes=N allows more.", files=doubling_includes,
         small_options=("--limit", "includes=1k"), full_says="More than 1000000 files are included. --limit includes=N allows more."),
]

MB = 1_000_000
SIZES = [
    Case("text of spheres", scenes.many_spheres, 5_000, 6_000_000),
    Case("text of one mesh2", scenes.large_mesh, 10_000, 5_400_000),
    Case("a name", scenes.long_name, 2 * MB, 200 * MB),
    Case("a string", scenes.long_string, 2 * MB, 200 * MB),
    Case("a comment", scenes.long_comment, 2 * MB, 200 * MB),
    Case("a number", scenes.long_number, 2 * MB, 200 * MB),
    Case("blanks", scenes.blank, 2 * MB, 200 * MB),
    Case("a file beyond its limit", scenes.blank, 2 * MB, 1_100 * MB, "is larger than 1048576 bytes. --limit file=N allows more.",
         small_options=("--limit", "file=1M"), full_says="is larger than 1073741824 bytes. --limit file=N allows more."),
]


def deep(name, before, open_text, inner, close_text, after, says=NESTING, status=4):
    return Case(name, lambda n: nested(before, open_text, inner, close_text, after, n), 20_000, 100_000, says, status)


DEPTH = [
    deep("unions", "", "union { ", "sphere { 0, 1 }", " }", "\n"),
    deep("braces without a word", "sphere { 0, 1 ", "{ ", "", "} ", "}\n", "No matching } in 'sphere', { found instead", 1),
    deep("parentheses", "#declare A = ", "(", "1", ")", ";\n"),
    deep("vectors", "#declare A = ", "<", "1", ",1>.x", ";\n"),
    deep("signs", "#declare A = ", "-(", "1", ")", ";\n"),
    deep("#if", "", "#if (1)\n", "sphere { 0, 1 }\n", "#end\n", "", ""),
    deep("#if not taken", "#if (0)\n", "#if (1)\n", "#error \"\"\n", "#end\n", "#end\nsphere { 0, 1 }\n", ""),
    deep("#if of #if", "", "#if (1 ", "", "#end ) #end ", "", NESTING),
    deep("arrays in braces", "#declare A = ", "array[1] { ", "1", " }", ";\n"),
    deep("parentheses of functions", "#declare F = function { ", "(", "x", ")", " }\n"),
    deep("textures in checkers", "sphere { 0, 1 ", "texture { checker ", "", " }", " }\n"),
    deep("declarations in values", "", "#declare A = sphere { 0, 1 ", "", " }", "\n"),
    Case("blocks that are not modelled", lambda n: nested("", "media { ", "", "} ", "\n", n), 20_000, 100_000, options=("--lenient",)),
    Case("#end without #if", lambda n: scenes.endless("#end\n" * n), 1000, 100_000, "#end", status=1),
    Case("unions of names", lambda n: chain("#declare U0 = sphere { 0, 1 }\n", "#declare U{1} = union {{ object {{ U{0} }} }}\n", "object {{ U{0} }}\n", n),
         20_000, 100_000),
    Case("differences of names", lambda n: chain("#declare U0 = sphere { 0, 1 }\n",
                                                 "#declare U{1} = difference {{ object {{ U{0} }} box {{ 2, 3 }} }}\n", "object {{ U{0} }}\n", n),
         2_000, 4_000),
    Case("merges of names", lambda n: chain("#declare U0 = sphere { 0, 1 }\n", "#declare U{1} = merge {{ object {{ U{0} }} box {{ 2, 3 }} }}\n",
                                            "object {{ U{0} }}\n", n), 2_000, 4_000),
    Case("sets in sets", lambda n: chain("#declare U0 = sphere { 0, 1 }\n",
                                         "#declare U{1} = difference {{ box {{ -{1}, {1} }} object {{ U{0} }} }}\n", "", n), 2_000, 20_000,
         "Sets of objects are nested more than 1000 deep."),
]


def doubling(name, first, link, last, says, n=60, **more):
    return Case(name, lambda n: chain(first, link, last, n), n, n, says, **more)


GROWTH = [
    Case("array[1000000000]", lambda n: scenes.endless("#declare A = array[1000000000];\n"), 0, 0, ARRAY),
    Case("arrays of five dimensions", lambda n: scenes.endless("#declare A = array[99999][99999][99999][99999][99999];\n"), 0, 0, ARRAY),
    doubling("strings that double", '#declare S0 = "0123456789";\n', "#declare S{1} = concat(S{0}, S{0});\n", "",
             "A string is longer than 1048576 bytes. --limit string=N allows more."),
    doubling("arrays that double", "#declare A0 = array[1] { 1 }\n", "#declare A{1} = array[2] {{ A{0}, A{0} }}\n", "", "bytes of text again. --limit reread=N",
             small_options=FEW),
    doubling("arrays in arrays", "#declare A0 = array[1] { 1 }\n", "#declare A{1} = array[1] {{ A{0} }}\n", "", "Arrays hold arrays more than 100 deep.", 200),
    doubling("unions that double", "#declare U0 = sphere { 0, 1 }\n", "#declare U{1} = union {{ object {{ U{0} }} object {{ U{0} }} }}\n", "", FEW_PARTS, small_options=("--limit", "parts=100k"), full_says=PARTS),
    doubling("merges that double", "#declare U0 = sphere { 0, 1 }\n", "#declare U{1} = merge {{ object {{ U{0} }} object {{ U{0} }} }}\n", "", FEW_PARTS, small_options=("--limit", "parts=100k"), full_says=PARTS),
    doubling("textures that double", "#declare T0 = texture { pigment { rgb 1 } }\n", "#declare T{1} = texture {{ T{0} }} texture {{ T{0} }}\n", "",
             "A texture has more than 10000 pigments in its layers and cells. --limit texture=N allows more."),
    doubling("pigment maps that double", "#declare P0 = pigment { rgb 1 }\n",
             "#declare P{1} = pigment {{ bozo pigment_map {{ [0 P{0}] [1 P{0}] }} }}\n", "",
             "A texture has more than 10000 pigments in its layers and cells. --limit texture=N allows more."),
    doubling("meshes that double", "#declare M0 = union { triangle { 0, x, y } }\n",
             "#declare M{1} = union {{ object {{ M{0} }} object {{ M{0} translate z }} }}\n", "object {{ M{0} }}\n", FEW_PARTS, small_options=("--limit", "parts=100k"), full_says=PARTS),
    doubling("splines that grow", "#declare S0 = spline { linear_spline 0, x 1, y }\n", "#declare S{1} = spline {{ S{0} }}\n", "", "", 60),
    doubling("#write that doubles", '#macro W(N)\n#fopen F N write\n#for (I, 1, 1e9) #write (F, "0123456789abcdef") #end\n#end\nW("a")\n', "", "",
             "The scene writes more than 1000000 bytes. --limit written=N allows more.", 1, options=("--limit", "written=1000000")),
]

LISTS = [
    Case("prism of a million points", lambda n: listed(f"prism {{ linear_spline 0, 1, {n},\n", "<cos(2*pi*{1}), sin(2*pi*{1})>", " }\n", n, ",\n"), 5_000, 1_000_000,
         files=lambda n: {}),
    Case("lathe", lambda n: listed(f"lathe {{ linear_spline {n},\n", "<1 + {1}, 2*{1} - 1>", " pigment {{ rgb 1 }} }}\n".format(), n, ",\n"), 5_000, 1_000_000),
    Case("lathe, cubic", lambda n: listed(f"lathe {{ cubic_spline {n},\n", "<1 + {1}, 2*{1} - 1>", " }\n", n, ",\n"), 5_000, 1_000_000),
    Case("sor", lambda n: listed(f"sor {{ {n},\n", "<1 + {1}, 2*{1} - 1>", " }\n", n, ",\n"), 5_000, 1_000_000),
    Case("polygon", lambda n: listed(f"polygon {{ {n},\n", "<cos(2*pi*{1}), sin(2*pi*{1})>", " }\n", n, ",\n"), 5_000, 1_000_000),
    Case("sphere_sweep", lambda n: listed(f"sphere_sweep {{ linear_spline {n},\n", "<8*{1} - 4, sin(20*{1}), 0>, 0.1", " }\n", n, ",\n"), 2_000, 1_000_000),
    Case("blob", lambda n: listed("blob { threshold 0.5\n", "sphere {{ <8*{1} - 4, sin(20*{1}), 0>, 0.1, 1 }}", " }\n", n), 2_000, 1_000_000),
    Case("union", lambda n: listed("union {\n", "sphere {{ <8*{1} - 4, sin(20*{1}), 0>, 0.1 }}", " }\n", n), 5_000, 100_000),
    Case("merge", lambda n: listed("merge {\n", "sphere {{ <8*{1} - 4, sin(20*{1}), 0>, 0.1 }}", " }\n", n), 2_000, 100_000),
    Case("intersection", lambda n: listed("intersection {\n", "sphere {{ <{1}, 0, 0>, 2 }}", " }\n", n), 2_000, 5_000),  # each part asks all others
    Case("difference", lambda n: listed("difference { box { -3, 3 }\n", "sphere {{ <8*{1} - 4, sin(20*{1}), -3>, 0.1 }}", " }\n", n), 2_000, 5_000),
    Case("color_map", lambda n: listed("sphere { 0, 1 pigment { bozo color_map {\n", "[{1} rgb {1}]", " } } }\n", n), 5_000, 1_000_000),
    Case("texture_map", lambda n: listed("sphere { 0, 1 texture { bozo texture_map {\n", "[{1} pigment {{ rgb {1} }}]", " } } }\n", n), 5_000, 1_000_000,
         full_says="A texture has more than 10000 pigments in its layers and cells. --limit texture=N allows more."),
    Case("warps", lambda n: listed("sphere { 0, 1 pigment { bozo\n", "warp {{ turbulence 0.1 }}", " } }\n", n), 2_000, 100_000),
    Case("transforms", lambda n: listed("sphere { 0, 1\n", "rotate x*{1}", " }\n", n), 5_000, 1_000_000),
    Case("lamps", lambda n: listed("sphere { 0, 1 }\n", "light_source {{ <3, 5, -9>, rgb 1/1e4 }}", "\n", n), 500, 100_000),
    Case("fogs", lambda n: listed("sphere { 0, 1 }\n", "fog {{ distance 1e6 }}", "\n", n), 2_000, 100_000),
    Case("splines", lambda n: listed("#declare S = spline { cubic_spline\n", "{0}, x*{1}", " }\n#declare A = S(0.5);\nsphere { 0, 1 }\n", n, ",\n"), 5_000, 1_000_000),
    Case("array values", lambda n: listed(f"#declare A = array[{n}] {{\n", "{0}", " };\nsphere { 0, 1 }\n", n, ","), 5_000, 1_000_000),
    Case("macro parameters", lambda n: listed("#macro M(", "A{0}", ")\n#end\nsphere { 0, 1 }\n", n, ","), 5_000, 1_000_000),
    Case("#case", lambda n: listed("#switch (-1)\n", "#case ({0})\n", "#end\nsphere { 0, 1 }\n", n), 5_000, 1_000_000),
    Case("names", lambda n: listed("", "#declare N{0} = {1};\n", "sphere { 0, 1 }\n", n), 5_000, 1_000_000),
    Case("bicubic patches", lambda n: listed("", "bicubic_patch {{ type 1 u_steps 5 v_steps 5 0, x, 2*x, 3*x, y, x+y, 2*x+y, 3*x+y, 2*y, x+2*y, 2*x+2*y-z, 3*x+2*y, 3*y, "
                                             "x+3*y, 2*x+3*y, 3*x+3*y translate {1}*z }}", "\n", n), 10, 1_000),
]

TEXT = 'text {{ ttf "timrom.ttf" "{}", 0.1, 0 }}\n'
VALUES = [
    Case("turbulence of 1e9 octaves", lambda n: scenes.endless("sphere { 0, 1 pigment { bozo turbulence 1 octaves 1000000000 } }\n"), 0, 0),
    Case("warp of 1e9 octaves", lambda n: scenes.endless("sphere { 0, 1 pigment { bozo warp { turbulence 1 octaves 1000000000 } } }\n"), 0, 0),
    Case("text of a huge string", lambda n: scenes.endless(TEXT.format("W" * n)), 100, 1_000_000, full_says="The outlines of this text have too many pieces.", status=1),
    Case("poly 35", lambda n: scenes.endless("poly { 35, <1" + ", 0" * (36 * 37 * 38 // 6 - 2) + ", -1> }\n"), 0, 0),
    Case("poly 36", lambda n: scenes.endless("poly { 36, <1> }\n"), 0, 0, "Order of poly is out of range.", status=1),
    Case("area light of 1e9 lamps", lambda n: scenes.endless("light_source { 5*y rgb 1 area_light x, z, 100000, 100000 }\nsphere { 0, 1 }\n"), 0, 0, "4096", status=1),
    Case("a patch of 2^60 cells", lambda n: scenes.endless("bicubic_patch { type 1 u_steps 30 v_steps 30 0,x,2*x,3*x,y,x+y,2*x+y,3*x+y,2*y,x+2*y,2*x+2*y-z,"
                                                           "3*x+2*y,3*y,x+3*y,2*x+3*y,3*x+3*y }\n"), 0, 0),
    Case("waves of 1e9 sources", lambda n: scenes.endless("global_settings { number_of_waves 1000000000 }\nsphere { 0, 1 pigment { waves } }\n"), 0, 0, "10", status=1),
    Case("julia of 1e9 rounds", lambda n: scenes.endless("sphere { 0, 1 pigment { mandel 1000000000 } }\n"), 0, 0, "A fractal pattern has at most 1000000 iterations.",
         status=1),
    Case("str of a billion places", lambda n: scenes.endless("#debug str(1, 1000000000, 0)\n"), 0, 0, "Illegal parameters in str.", status=1),
    Case("a field of a function, 1e10 samples", lambda n: scenes.endless("height_field { function 100000, 100000 { x } }\n"), 0, 0, "A height field has at most 1073741824 samples.", status=1),
    Case("a field of a function", lambda n: scenes.endless(f"height_field {{ function {n}, {n} {{ x*y }} translate -0.5 }}\n"), 200, 4000),
    Case("a field of a picture", lambda n: scenes.endless('height_field { png "p.png" translate -0.5 }\n'), 200, 8000, files=lambda n: {"p.png": scenes.png(n, n)}),
    Case("a picture of 10^10 pixels, on an object", lambda n: scenes.endless('sphere { 0, 1 pigment { image_map { png "p.png" } } }\n'), 20_000, 100_000, PICTURE,
         files=lambda n: {"p.png": scenes.png(n, n)}),
    Case("a picture of 10^10 pixels, as a field", lambda n: scenes.endless('height_field { png "p.png" }\n'), 20_000, 100_000, PICTURE,
         files=lambda n: {"p.png": scenes.png(n, n)}),
    Case("a header of 10^12 pixels", lambda n: scenes.endless('sphere { 0, 1 pigment { image_map { png "p.png" } } }\n'), 1, 1, PICTURE,
         files=lambda n: {"p.png": scenes.png_header(10**6, 10**6) + scenes.chunk(b"IDAT", bytes(8))}),
    Case("a picture, large", lambda n: scenes.endless('sphere { 0, 1 pigment { image_map { png "p.png" } } }\n'), 500, 10_000, files=lambda n: {"p.png": scenes.png(n, n)}),
    Case("a pixmap's header", lambda n: scenes.endless('sphere { 0, 1 pigment { image_map { ppm "p.ppm" } } }\n'), 1, 1, PICTURE,
         files=lambda n: {"p.ppm": b"P6 9999999 9999999 255\n"}),
    Case("a density file's header", lambda n: scenes.endless('sphere { 0, 1 pigment { density_file df3 "d.df3" } }\n'), 1, 1, "d.df3", status=1,
         files=lambda n: {"d.df3": b"\xff" * 6}),
    Case("#read of a large file", lambda n: scenes.endless('#fopen F "n.txt" read\n#while (defined(F))\n  #read (F, A)\n#end\nsphere { 0, 1 }\n'), 20_000, 5_000_000,
         files=lambda n: {"n.txt": scenes.numbers(n)}),
    Case("#read of a device", lambda n: scenes.endless('#fopen F "/dev/zero" read\n'), 0, 0, "Cannot open user file /dev/zero (read).", status=1),
    Case("#read of a link to a device", lambda n: scenes.endless('#fopen F "zero" read\n'), 0, 0, "Cannot open user file zero (read).", status=1,
         files=lambda n: {"zero": None}),
    Case("an include of a device", lambda n: scenes.endless('#include "/dev/zero"\n'), 0, 0, "Cannot open include file /dev/zero.", status=1),
]

ALL = LOOPS + RECURSION + INCLUDES + SIZES + DEPTH + GROWTH + LISTS + VALUES
