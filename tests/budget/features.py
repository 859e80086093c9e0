"""Which code belongs to which feature, and which scene has which features."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/architecture"))
from check import without_comments_and_strings  # noqa: E402

# Files below src/, whole, or one function of a file.
FEATURES = {
    "index": ["world/embree_index.cpp", "world/traveller.h"],
    "meshes": ["geometry/triangle.h:intersect", "world/surfaces.h:test_face", "world/triangle_block.h", "world/triangle_block.cpp", "world/add_surfaces.cpp:add_mesh",
               "syntax/parse_mesh2.cpp"],
    "transparency": ["shading/optics.h:refract", "shading/optics.h:distance_fade", "trace/interior_list.h:cross",
                     "trace/shadow.cpp:through_transparent", "trace/shadow.cpp:filtered", "trace/shadow.cpp:fade"],
    "patterns": ["patterns/checker.h"],
    "textures of parts": ["trace/surface_layers.cpp:blend", "geometry/mesh.cpp:texture_weights", "geometry/blob.cpp:texture_weights",
                          "geometry/texture_weight.cpp", "world/cut_textures.cpp"],
    "area lights": ["trace/area_average.h", "trace/shadow.cpp:area"],
    "mirrors": ["trace/recursion.cpp:reflectivity", "shading/optics.h:fresnel_reflectance", "shading/povray_finish.h:angular_reflectivity"],
    "highlights": ["shading/kernels.cpp:fixed_highlight", "shading/half_geometry.h", "trace/lighting.cpp:catalogue_highlight"],
    "widened highlights": ["trace/footprint.cpp", "trace/lighting.cpp:widened_highlight"],
    "other shapes": ["geometry/box.h", "geometry/cone.cpp", "geometry/torus.cpp", "geometry/disc.cpp", "geometry/polygon.cpp"],
    "lines": ["trace/edges.cpp"],
    "anti-aliasing": ["trace/sampling_povray2.cpp"],
}

# Scene in the folder `scenes`, more words of the command line, and the features that it has.
SCENES = {
    "plain": ("plain", [], set()),
    "index": ("index", [], {"index"}),
    "mesh": ("mesh", [], {"index", "meshes"}),
    "face_textures": ("face_textures", [], {"index", "meshes", "textures of parts"}),
    "transparency": ("transparency", [], {"transparency"}),
    "checker": ("checker", [], {"patterns"}),
    "area_light": ("area_light", [], {"area lights"}),
    "mirror": ("mirror", [], {"mirrors"}),
    "highlight": ("highlight", [], {"highlights"}),
    "widened": ("highlight", ["--specular-aa", "on"], {"highlights", "widened highlights"}),
    "shapes": ("shapes", [], {"index", "other shapes"}),
    "lines": ("plain", ["--edges", "all"], {"lines"}),
    "anti-aliased": ("plain", ["--aa", "2"], {"anti-aliasing"}),
}


def function_lines(text, name):
    """The lines of the bodies of all functions of this name; empty if there is none."""
    code = without_comments_and_strings(text)
    lines = set()
    for match in re.finditer(rf"\b{name}\s*\(", code):
        end = closing(code, match.end() - 1, "()")
        body = re.match(r"[\s\w&:]*\{", code[end:])
        if body:
            last = closing(code, end + body.end() - 1, "{}")
            lines |= set(range(code.count("\n", 0, match.start()) + 1, code.count("\n", 0, last) + 2))
    return lines


def closing(code, at, pair):
    """The place behind the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(code)):
        depth += (code[i] == pair[0]) - (code[i] == pair[1])
        if depth == 0:
            return i + 1
    return len(code)


def entered(place, lines):
    """The lines of a place that were run, with the addresses. Raises ValueError if the place is not in the sources."""
    file, _, name = place.partition(":")
    path = ROOT / "src" / file
    if not path.exists():
        raise ValueError(f"{place}: there is no such file")
    run = lines.get(file, {})
    if not name:
        return run
    own = function_lines(path.read_text(), name)
    if not own:
        raise ValueError(f"{place}: the file has no such function")
    return {line: addresses for line, addresses in run.items() if line in own}


def faults(profiles, only_moves):
    """Sentences about features that a scene without them enters, and about code that its own scene does not enter. `profiles`: by scene;
    `only_moves`: whether the instruction at an address does not count."""
    found = []
    for feature, places in FEATURES.items():
        having = [name for name, (_, _, features) in SCENES.items() if feature in features]
        for place in places:
            try:
                run = {name: entered(place, profiles[name].lines) for name in SCENES}
            except ValueError as error:
                found.append(str(error))
                continue
            if not any(run[name] for name in having):
                found.append(f"{place} stands for {feature}, but no scene with it enters it: the test could not fail")
            for name in SCENES:
                lines = [] if name in having else sorted(line for line, at in run[name].items() if not all(map(only_moves, at)))
                if lines:
                    found.append(f"scene {name} has no {feature}, but enters {place} (lines {', '.join(map(str, lines[:8]))})")
    return found
