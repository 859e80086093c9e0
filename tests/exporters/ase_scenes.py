"""Scenes that ASE writes, each with the INI file that renders it. Usage: ase_scenes.py FOLDER"""
import os
import sys

import numpy
from ase.build import fcc111, molecule
from ase.constraints import FixAtoms
from ase.io import write
from ase.io.pov import get_bondpairs


def main():
    molecules = molecule("CH3CH2OH"), molecule("C6H6")
    molecules[0].center(vacuum=1.0)
    write("ase_default.pov", molecules[0], rotation="20x,30y", povray_settings={"canvas_width": 160})
    write("ase_bonds.pov", molecules[1], rotation="35x", radii=0.4,
          povray_settings={"canvas_height": 123, "bondatoms": get_bondpairs(molecules[1], radius=1.1), "transparent": False})
    slab = fcc111("Cu", size=(2, 2, 2), vacuum=2.0)
    slab.set_constraint(FixAtoms([0, 1]))
    write("ase_styles.pov", slab, rotation="-70x,20y", show_unit_cell=2,
          povray_settings={"canvas_width": 160, "exportconstraints": True, "transmittances": numpy.linspace(0, 0.7, 8),
                           "textures": ["ase2", "ase3", "glass", "jmol", "intermediate", "pale", "simple", "vmd"],
                           "camera_type": "perspective", "depth_cueing": True, "cue_density": 0.02, "area_light": None,
                           "point_lights": [[(10, 8, 20), "White"]]})


os.chdir(sys.argv[1])
main()
