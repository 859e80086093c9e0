"""Scenes that PyMOL writes. Usage: python3 -m pymol -cq pymol_scenes.py -- FOLDER"""
import pathlib
import sys

from pymol import cgo, cmd

folder = pathlib.Path(sys.argv[-1])


def save(name):
    cmd.save(str(folder / f"pymol_{name}.pov"))


cmd.viewport(160, 120)
cmd.bg_color("white")
cmd.fab("ACDKW", "peptide")
cmd.orient()
cmd.show_as("spheres")
cmd.show("sticks", "resi 1-2")
cmd.set("sphere_transparency", 0.4, "elem C")
cmd.set("orthoscopic", 1)
save("spheres")
cmd.set("orthoscopic", 0)
cmd.show_as("cartoon")
cmd.alter("all", "ss='H'")
cmd.rebuild()
cmd.spectrum("resi", "rainbow")
save("cartoon")
cmd.show_as("surface")
cmd.set("surface_quality", -1)
cmd.set("transparency", 0.5)
cmd.color("red", "elem O")
cmd.color("blue", "elem N")
save("surface")
cmd.hide()
corners = [((1, 0, 0), (0, 0, 1), (0, 0, 0)), ((0, 1, 0), (0, 0.3, 1), (5, 0, 0)), ((0, 0, 1), (0.2, 0, 1), (0, 5, 0))]
drawing = [cgo.BEGIN, cgo.TRIANGLES]
for color, normal, corner in corners:
    drawing += [cgo.COLOR, *color, cgo.NORMAL, *normal, cgo.VERTEX, *corner]
drawing += [cgo.END, cgo.CONE, -3, 0, 0, -3, 4, 0, 1.5, 0.2, 1, 1, 0, 0, 1, 1, 1, 1, cgo.CYLINDER, -5, 0, 0, -5, 4, 0, 0.5, 1, 0, 0, 0, 1, 0]
cmd.load_cgo(drawing, "drawing")
cmd.zoom("drawing")
cmd.set("field_of_view", 50)
cmd.set("ray_shadows", 0)
cmd.pseudoatom("note", label="text")
save("drawing")
