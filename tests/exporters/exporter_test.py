#!/usr/bin/env python3
"""Scenes as other programs write them today: made by those that are installed, read strictly, and compared with POV-Ray's pictures.

usage: exporter_test.py RAYTRACE

Programs that are not installed are named, and the test passes without them. On Debian: pymol, openbabel, python3-vtk9, python3-ase, jmol.
A picture agrees as `raytrace versus` has it: 98 % of the pixels within 2/255, and an RMSE below 0.01.
"""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
RAYTRACE = str(pathlib.Path(sys.argv[1]).resolve())
BABEL_INCLUDES = ["/usr/share/povray/include/babel_povray3.inc", *sorted(map(str, pathlib.Path("/usr/share/openbabel").glob("*/babel_povray3.inc")))]
JMOL = pathlib.Path("/usr/share/java/JmolData.jar")
MOLECULE = "8\n\nC 0 0 0\nC 1.5 0 0\nO 2 1.3 0\nH 3 1.3 0.1\nH -.4 1 0\nH -.4 -.5 .9\nH 1.9 -.5 -.9\nH 1.9 -.5 .9\n"
JMOL_SCRIPT = """load "./molecule.xyz"
write povray "jmol_default.pov"
spacefill only; color translucent; isosurface vdw map mep; slab on; slab 70; background white
write povray "jmol_surface.pov"
"""


def run(command, folder, seconds=60):
    return subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, timeout=seconds, stdin=subprocess.DEVNULL,
                          env=dict(os.environ, QT_QPA_PLATFORM="offscreen"))


def python_with(module):
    """A Python that can import the module: this one or Debian's."""
    for python in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(python) and run([python, "-c", f"import {module}"], HERE).returncode == 0:
            return python
    return None


def python_command(module, *words):
    python = python_with(module)
    return [[python, *words]] if python else None


def babel_commands(folder):
    include = next((path for path in BABEL_INCLUDES if os.path.exists(path)), None)
    if not shutil.which("obabel") or include is None:
        return None
    shutil.copy(include, folder)  # as its documentation says
    (folder / "molecule.xyz").write_text(MOLECULE)
    styles = {"sticks": ["-xm", "BAS"], "filled": ["-xm", "SPF", "-xt"], "sky": ["-xm", "CST", "-xc", "-xf", "-xs"]}
    return [["obabel", "molecule.xyz", "-O", f"openbabel_{name}.pov", *words] for name, words in styles.items()]


def jmol_commands(folder):
    if not shutil.which("java") or not JMOL.exists():
        return None
    (folder / "molecule.xyz").write_text(MOLECULE)
    (folder / "write.spt").write_text(JMOL_SCRIPT)
    return [["java", "-Djava.awt.headless=true", "-jar", JMOL, "-s", "write.spt", "-g", "160x120", "-i"]]


# What each is called, and the commands that make it write scenes into a folder; none where it is not installed.
EXPORTERS = {
    "PyMOL": lambda folder: python_command("pymol", "-m", "pymol", "-cq", HERE / "pymol_scenes.py", "--", folder),
    "VTK": lambda folder: python_command("vtk", HERE / "vtk_scenes.py", folder),
    "ASE": lambda folder: python_command("ase.io.pov", HERE / "ase_scenes.py", folder),
    "Open Babel": babel_commands,
    "Jmol": jmol_commands,
}
SCENES = {"PyMOL": 4, "VTK": 3, "ASE": 3, "Open Babel": 3, "Jmol": 2}


def write_scenes(name, folder):
    """How many scenes it wrote; none where it is not installed."""
    folder.mkdir()
    commands = EXPORTERS[name](folder)
    if commands is None:
        print(f"{name} is not installed: its scenes are not checked")
        return 0
    for command in commands:
        made = run(command, folder)
        if made.returncode != 0:
            raise SystemExit(f"{name} failed:\n{made.stdout}{made.stderr}")
    count = len(list(folder.glob("*.pov")))
    if count != SCENES[name]:
        raise SystemExit(f"{name} wrote {count} scenes instead of {SCENES[name]}")
    return count


def size_of(png):
    return struct.unpack(">II", png.read_bytes()[16:24])


def check_ini(folder, ini, picture, size):
    """The file by which the program itself starts POV-Ray."""
    result = run([RAYTRACE, ini], folder)
    if result.returncode != 0 or size_of(folder / picture) != size:
        return [f"raytrace {ini}: status {result.returncode}\n{result.stderr}"]
    return []


def check_read(scenes):
    """All are read without a feature that is not modelled."""
    faults = []
    for scene in scenes:
        result = run([RAYTRACE, scene.name, "-W", "40", "-H", "30", "-o", "small.png"], scene.parent)
        if result.returncode != 0:
            faults.append(f"raytrace {scene.name}: status {result.returncode}\n{result.stderr}")
    return faults


def check_agreement(folder, scenes):
    result = run([RAYTRACE, "versus", ".", "-W", "120", "-H", "90", "-o", folder / "report"], folder, 300)
    results = json.loads((folder / "report/results.json").read_text())
    compared = {scene["scene"] for scene in results["scenes"] if scene["cause"] == "agrees"}
    if result.returncode == 0 and len(compared) == len(scenes):
        return []
    return [f"raytrace versus: status {result.returncode}, {len(compared)} of {len(scenes)} agree\n{result.stdout}{result.stderr}"]


def main():
    faults = []
    with tempfile.TemporaryDirectory(prefix="raytrace_exporters_") as name:
        folder = pathlib.Path(name)
        for exporter in EXPORTERS:
            write_scenes(exporter, folder / exporter.replace(" ", "_"))
        scenes = sorted(folder.glob("*/*.pov"))
        if not scenes:
            return 0
        faults += check_read(scenes)
        if (folder / "ASE/ase_bonds.ini").exists():
            faults += check_ini(folder / "ASE", "ase_bonds.ini", "ase_bonds.png", (129, 123))
        if (folder / "Jmol/jmol_default.pov.ini").exists():
            faults += check_ini(folder / "Jmol", "jmol_default.pov.ini", "jmol_default.pov.png", (160, 120))
        if shutil.which("povray"):
            faults += check_agreement(folder, scenes)
        else:
            print("POV-Ray is not installed: the pictures are not compared")
    for fault in faults:
        print(fault)
    print(f"{len(scenes)} scenes, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
