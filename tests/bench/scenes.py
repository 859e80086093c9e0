"""Scenes that are written by rule: spheres at random places, for POV-Ray's language and Tachyon's, and a hilly field as one flat mesh2.

Both keep the picture's look whatever their number of primitives: as many spheres are met by a ray, and the hills are the same.
"""
import math
import random

POV_HEAD = """#version 3.7;
global_settings {{ assumed_gamma 1 }}
camera {{ {camera} }}
light_source {{ <{light}> rgb 1 }}
#default {{ texture {{ pigment {{ rgb <1, 0.75, 0.5> }} finish {{ ambient 0.1 diffuse 0.8 }} }} }}
"""

TACHYON_HEAD = """BEGIN_SCENE
RESOLUTION {width} {height}
CAMERA
  ZOOM 2.0
  ASPECTRATIO 1.0
  ANTIALIASING 0
  RAYDEPTH 5
  CENTER 0 0 -4
  VIEWDIR 0 0 1
  UPDIR 0 1 0
END_CAMERA
BACKGROUND 0 0 0
LIGHT CENTER 10 10 -10 RAD 0.0001 COLOR 1 1 1
TEXDEF matte AMBIENT 0.1 DIFFUSE 0.8 SPECULAR 0 OPACITY 1 COLOR 1 0.75 0.5 TEXFUNC 0
"""


def spheres(count, width, height, pov, tachyon=None):
    """Spheres of one size in the cube from -1 to 1; a ray across the cube meets about one and a half of them.

    Tachyon's camera rays pass half a pixel right of and above the middle of their pixels, so here the camera of the other file looks
    that much aside."""
    radius = 1.38 / math.sqrt(count)
    draw = random.Random(1)
    aside = 0.5 / height
    camera = f"location <0, 0, -4> direction <{aside:.9f}, {aside:.9f}, 2> right <{width / height:.9f}, 0, 0> up <0, 1, 0>"
    with open(pov, "w") as file:
        file.write(POV_HEAD.format(camera=camera, light="10, 10, -10"))
        twin = open(tachyon, "w") if tachyon else None
        if twin:
            twin.write(TACHYON_HEAD.format(width=width, height=height))
        for _ in range(count):
            x, y, z = (f"{draw.uniform(-1, 1):.7f}" for _ in range(3))
            file.write(f"sphere {{ <{x}, {y}, {z}>, {radius:.7f} }}\n")
            if twin:
                twin.write(f"SPHERE CENTER {x} {y} {z} RAD {radius:.7f} matte\n")
        if twin:
            twin.write("END_SCENE\n")
            twin.close()


def hills(x, z):
    return 0.12 * math.sin(5 * x + 1) * math.cos(4 * z) + 0.05 * math.sin(13 * x - 7 * z) + 0.02 * math.cos(31 * x + 23 * z)


def mesh(count, pov):
    """A field of hills, seen from above at a slant: `count` triangles (an even number), two in each rectangle of rows and columns that
    are as near each other in number as the count allows."""
    rows = next(n for n in range(math.isqrt(count // 2), 0, -1) if count // 2 % n == 0)
    columns = count // 2 // rows
    xs, zs = ([2.0 * i / n - 1.0 for i in range(n + 1)] for n in (columns, rows))
    with open(pov, "w") as file:
        file.write(POV_HEAD.format(camera="location <0, 1.6, -2.4> look_at <0, -0.1, 0> angle 50", light="3, 4, -1"))
        file.write(f"mesh2 {{\nvertex_vectors {{ {(rows + 1) * (columns + 1)}\n")
        for z in zs:
            file.write("".join(f",<{x:.7f},{hills(x, z):.7f},{z:.7f}>" for x in xs) + "\n")
        file.write(f"}}\nface_indices {{ {count}\n")
        for row in range(rows):
            for a in range(row * (columns + 1), row * (columns + 1) + columns):
                b = a + columns + 1
                file.write(f",<{a},{a + 1},{b}>,<{a + 1},{b + 1},{b}>\n")
        file.write("}\n}\n")
