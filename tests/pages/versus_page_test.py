#!/usr/bin/env python3
"""The page of `raytrace versus` in a browser: scenes worst first, three pictures and their difference, phases as bars, commands.

usage: tests/pages/versus_page_test.py PROGRAM
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, find_chromium

PROGRAM = os.path.abspath(sys.argv.pop(1))

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -4*z }
light_source { <5, 5, -5>, 1 }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.2> } finish { specular 0.9 roughness 0.05 } }
"""

# Prints what POV-Ray prints, and gives every scene the same picture.
STAND_IN = """#!/bin/sh
case $1 in --version) echo 'POV-Ray 3.7 of the tests'; exit;; esac
for word; do case $word in +O*) out=${word#+O};; esac; done
cp '%s/right.png' $out
echo '  Parse Time:  0 hours 0 minutes 0 seconds (0.250 seconds)'
echo '  Trace Time:  0 hours 0 minutes 0 seconds (0.500 seconds)'
"""


@unittest.skipUnless(find_chromium(), "there is no Chromium")
class VersusPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="raytrace_versus_page_")
        place = cls.place = pathlib.Path(cls.folder.name)
        scenes = {
            "same.pov": SCENE,
            "moved.pov": SCENE.replace("-4*z", "<0.5, 0, -4>"),
            "</script>.pov".replace("/", "_"): SCENE + "media { }\n",
            "two.pov": SCENE + "ovus { 1, 0.5 }\nmedia { }\n",
        }
        (place / "scenes").mkdir()
        for name, text in scenes.items():
            (place / "scenes" / name).write_text(text)
        subprocess.run([PROGRAM, "scenes/same.pov", "--size=64x48", "--shading=povray", "-o", "right.png"], cwd=place, check=True)
        stand_in = place / "stand_in"
        stand_in.write_text(STAND_IN % place)
        stand_in.chmod(0o755)
        run = subprocess.run([PROGRAM, "versus", "scenes", "-W", "64", "-H", "48", "--povray", "./stand_in", "-q"], cwd=place)
        assert run.returncode == 1
        cls.results = json.loads((place / "versus-results/results.json").read_text())
        words = ["--judge", "general", "-o", "general", "--povray", "./stand_in", "-q"]
        run = subprocess.run([PROGRAM, "versus", "scenes/same.pov", "scenes/moved.pov", "-W", "64", "-H", "48", *words], cwd=place)
        assert run.returncode == 1
        cls.browser = Browser().__enter__()
        cls.page = cls.browser.open(place / "versus-results/report.html")
        cls.page.wait("document.documentElement.dataset.ready !== undefined")

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def show(self, name):
        self.page.evaluate(f"void (location.hash = '#' + encodeURIComponent({json.dumps(name)}))")
        self.page.wait(f"byId('row-name').textContent === {json.dumps(name)}")
        self.page.evaluate("shown")

    def all(self, selector, what="e.textContent"):
        return self.page.evaluate(f"[...document.querySelectorAll({json.dumps(selector)})].map((e) => {what})")

    def test_scenes_are_worst_first(self):
        self.assertEqual(self.all("#table tbody th"), ["scenes/moved", "scenes/<_script>", "scenes/two", "scenes/same"])
        self.assertEqual(self.all("#table tbody td:nth-child(2)"), ["✗ differs", "✗ not modelled", "✗ not modelled", "✓ agrees"])
        self.assertIn("Not modelled, by the scenes that ask for nothing else: media 1 (of 2).", self.all("#head .notes li"))
        self.assertIn("1 of 4", self.all("#head dd"))

    def test_a_scene_has_its_pictures_and_their_difference(self):
        self.show("scenes/moved")
        self.assertEqual(len(self.all("#pictures .pane")), 5)  # three pictures, their difference, and one for wiping and blinking
        labels = " ".join(self.all("#pictures .label"))
        for label in ("POV-Ray", "Same shading", "General form", "Difference"):
            self.assertIn(label, labels)
        region = self.results["scenes"][[s["scene"] for s in self.results["scenes"]].index("scenes/moved")]["same"]["likeness"]["region"]
        x, y = region["pixel"]
        self.page.evaluate(f"void pictures.choosePixel({x}, {y})")
        values = self.all("#pictures .values td data", "e.value")
        likeness = next(s for s in self.results["scenes"] if s["scene"] == "scenes/moved")["same"]["likeness"]
        self.assertEqual(values[0], " ".join(map(str, likeness["povray"])))
        self.assertEqual(values[1], " ".join(map(str, likeness["ours"])))

    def test_phases_are_bars_of_one_scale(self):
        self.show("scenes/same")
        self.assertEqual(self.all(".phase-table tbody th"), ["POV-Ray", "Same shading", "General form"])
        self.assertEqual(self.all(".phase-table tbody tr:first-child td.number")[:3], ["0.2500", "0.0000", "0.5000"])
        widths = self.all(".phase-table tbody tr:first-child .phase", "e.getBoundingClientRect().width")
        self.assertAlmostEqual(widths[2] / widths[0], 2.0, delta=0.1)
        self.assertGreater(widths[0], 10)

    def test_commands_are_those_that_were_run(self):
        self.show("scenes/same")
        scene = next(s for s in self.results["scenes"] if s["scene"] == "scenes/same")
        self.assertEqual(self.all(".command code"), [f"cd {self.place}/scenes && " + " ".join(scene[who]["command"]) for who in ("povray", "same", "general")])

    def test_what_is_not_modelled_says_where(self):
        self.show("scenes/two")
        self.assertRegex(self.page.evaluate("byId('row-reason').textContent"), r"two\.pov:6:1: ovus is not modelled")
        self.assertEqual(len(self.all("#pictures .pane")), 1)

    def test_rows_are_filtered_by_cause(self):
        self.assertEqual(self.all(".filter select", "e.ariaLabel"), ["Cause"])
        self.assertEqual(self.all(".filter option")[:2], ["All (4)", "Not agreeing (3)"])

    def test_what_is_judged_is_shown_first(self):
        results = json.loads((self.place / "general" / "results.json").read_text())
        moved = next(s for s in results["scenes"] if s["scene"].endswith("moved"))
        pages = {"Same shading": self.page, "General form": self.browser.open(self.place / "general" / "report.html")}
        pages["General form"].wait("document.documentElement.dataset.ready !== undefined")
        self.show("scenes/moved")
        for judged, page in pages.items():
            with self.subTest(judged):
                pair = page.evaluate("[...document.querySelectorAll('.pair select')].map((e) => e.selectedOptions[0].text)")
                self.assertEqual(pair, ["POV-Ray", judged])
                self.assertIn(f"{judged} is judged", page.evaluate("byId('head').innerText"))
        cells = pages["General form"].evaluate("pageData.rows.find((row) => row.name.endsWith('moved')).cells")
        self.assertEqual(cells["beyond"], moved["general"]["likeness"]["beyond"])
        self.assertNotEqual(cells["beyond"], moved["same"]["likeness"]["beyond"])
        self.assertEqual(cells["rmse"], moved["general"]["likeness"]["figures"]["rmse"])
        self.assertEqual(cells["other_rmse"], moved["same"]["likeness"]["figures"]["rmse"])
        self.assertIn("Same RMSE", pages["General form"].evaluate("byId('table').innerText"))
        pages["General form"].assert_clean()

    def test_nothing_is_asked_of_the_network(self):
        self.page.assert_clean()


if __name__ == "__main__":
    unittest.main()
