#!/usr/bin/env python3
"""The page of `raytrace trade` in a browser: the plot with its front, the card at a point, the table, sources and knobs.

usage: tests/pages/trade_page_test.py PROGRAM
"""
import json
import math
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
camera { location <0, 1, -4> look_at 0 }
light_source { <5, 5, -5>, 1 }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.2> } finish { specular 0.9 roughness 0.1 reflection 0.4 } }
plane { y, -1 pigment { checker rgb 1, rgb 0.2 } finish { reflection 0.3 } }
"""


@unittest.skipUnless(find_chromium(), "there is no Chromium")
class TradePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="raytrace_trade_page_")
        cls.place = pathlib.Path(cls.folder.name)
        (cls.place / "</script>.pov".replace("/", "_")).write_text(SCENE)
        words = ["trade", "<_script>.pov", "-W", "32", "-H", "24", "--runs", "1", "--reference-error", "0.02", "--settings", "40", "-q"]
        subprocess.run([PROGRAM, *words], cwd=cls.place, check=True)
        cls.results = json.loads((cls.place / "trade-results/results.json").read_text())
        cls.browser = Browser().__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.page = self.browser.open(self.place / "trade-results/trade.html")
        self.page.wait("document.documentElement.dataset.ready !== undefined")

    def tearDown(self):
        self.page.assert_clean()

    def all(self, selector, what="e.textContent"):
        return self.page.evaluate(f"[...document.querySelectorAll({json.dumps(selector)})].map((e) => {what})")

    def setting(self, name):
        return next(s for s in self.results["settings"] if s["name"] == name)

    def choose(self, label, value):
        self.page.evaluate(f"""(() => {{
            const select = document.querySelector('select[aria-label={json.dumps(label)}]');
            select.value = {json.dumps(value)};
            select.dispatchEvent(new Event("change"));
        }})()""")

    def test_every_setting_is_a_point_and_the_front_is_that_of_the_program(self):
        names = self.all("#chart .point", "e.dataset.name")
        self.assertCountEqual(names, [s["name"] for s in self.results["settings"]])
        front = self.all("#chart .on-front", "e.dataset.name")
        self.assertCountEqual(front, self.results["front"])
        self.assertGreaterEqual(len(front), 2)

    def places(self):
        pairs = self.all("#chart .point", "[e.dataset.name, e.getAttribute('transform')]")
        return {name: [float(x) for x in transform[len("translate("):-1].split()] for name, transform in pairs}

    def test_places_are_logarithms(self):
        for cost, figure in (("wall", "rmse"), ("cpu", "flip")):
            self.choose("Time", cost)
            self.choose("Error", figure)
            places = self.places()
            draft, good, exact = (self.setting(name) for name in ("draft", "good", "exact"))
            spans = []
            for a, b in ((draft, good), (good, exact)):
                (ax, ay), (bx, by) = places[a["name"]], places[b["name"]]
                spans.append(((bx - ax) / math.log(b[cost]["total"] / a[cost]["total"]), (by - ay) / math.log(b["error"][figure] / a["error"][figure])))
            self.assertAlmostEqual(spans[0][0] / spans[1][0], 1.0, delta=0.02)
            self.assertAlmostEqual(spans[0][1] / spans[1][1], 1.0, delta=0.02)
            self.assertGreater(spans[0][0], 0)
            self.assertLess(spans[0][1], 0)

    def test_the_front_follows_the_figure(self):
        self.choose("Time", "cpu")
        self.choose("Error", "max")
        counted = [s for s in self.results["settings"] if s["comparable"]]
        for name in self.all("#chart .on-front", "e.dataset.name"):
            own = self.setting(name)
            beaten = [s for s in counted if s["cpu"]["total"] < 0.9 * own["cpu"]["total"] and s["error"]["max"] < 0.9 * own["error"]["max"]]
            self.assertEqual(beaten, [], name)

    def test_pointing_shows_figures_picture_and_difference(self):
        self.assertTrue(self.page.evaluate("byId('card').hidden"))
        left, top, width, height = self.page.box("#chart .point[data-name='good'] .dot")
        self.page.move(left + width / 2, top + height / 2)
        self.page.wait("document.querySelectorAll('#card canvas').length === 2")
        shown = self.page.evaluate("plot.pointed.name")  # another one may lie upon it
        self.assertIn(shown, self.page.evaluate("byId('card').innerText"))
        error = self.setting(shown)["error"]["rmse"]
        self.assertIn(f"RMSE {error:.3g}"[:9], self.page.evaluate("byId('card').innerText"))
        sums = self.page.evaluate("""[...document.querySelectorAll('#card canvas')].map((canvas) =>
            canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, v, i) => i % 4 === 3 ? sum : sum + v, 0))""")
        self.assertGreater(sums[0], 0)
        self.assertGreater(sums[1], 0)
        self.page.move(5, 5)
        self.page.wait("byId('card').hidden")

    def test_the_keyboard_goes_from_point_to_point_and_shows_one(self):
        self.page.tab_to("document.activeElement.closest('#chart') !== null && document.activeElement !== byId('chart')")
        self.page.key("Home")
        first = self.page.evaluate("document.activeElement.dataset.name")
        self.page.key("ArrowRight")
        second = self.page.evaluate("document.activeElement.dataset.name")
        times = [self.setting(name)["wall"]["total"] for name in (first, second)]
        self.assertEqual(sorted(s["wall"]["total"] for s in self.results["settings"])[:2], times)
        self.page.wait("document.querySelectorAll('#card canvas').length === 2")
        self.assertIn(second, self.page.evaluate("document.activeElement.getAttribute('aria-label')"))
        self.page.key("Enter")
        self.page.wait(f"byId('row-name').textContent === {json.dumps(second)}")
        self.assertEqual(self.all("#chart .chosen", "e.dataset.name"), [second])

    def test_good_is_shown_first_beside_the_reference(self):
        self.assertEqual(self.page.evaluate("byId('row-name').textContent"), "good")
        labels = " ".join(self.all("#pictures figcaption"))
        for label in ("Reference", "This setting", "Difference"):
            self.assertIn(label, labels)
        self.assertEqual(self.all("#command"), [self.setting("good")["command"]])

    def test_numbers_of_pixels_say_of_how_many(self):
        texts = self.all("[data-pixel] td")
        self.assertEqual(len(texts), 3)
        for text, full in zip(texts, ("65,535", "255", "65,535")):  # the reference, the setting, their difference
            self.assertTrue(text.endswith(f" of {full}"), text)

    def test_a_row_of_the_table_is_marked_in_the_plot(self):
        self.page.evaluate("void table.select(pageData.rows.findIndex((row) => row.name === 'exact'))")
        self.assertEqual(self.all("#chart .chosen", "e.dataset.name"), ["exact"])

    def test_points_have_the_colours_of_a_knob(self):
        self.choose("Colour by", "samples")
        knob = next(k for k in self.results["knobs"] if k["name"] == "samples")
        self.assertEqual([text.strip() for text in self.all(".legend > span")], [v["name"] for v in knob["values"]])
        colors = dict(self.all("#chart .point", "[e.dataset.name, e.querySelector('.dot').getAttribute('style')]"))
        self.assertNotEqual(colors["draft"], colors["exact"])
        same = [s["name"] for s in self.results["settings"] if s["values"]["samples"] == self.setting("good")["values"]["samples"]]
        self.assertEqual(len({colors[name] for name in same}), 1)

    def test_knobs_have_a_table_each_around_a_preset(self):
        self.assertEqual(self.all("#knobs [data-knob]", "e.dataset.knob"), [k["name"] for k in self.results["knobs"]])
        rows = "#knobs [data-knob='samples'] tbody tr"
        knob = next(k for k in self.results["knobs"] if k["name"] == "samples")
        self.assertEqual(self.all(rows + " th"), [v["name"] for v in knob["values"]])
        self.assertEqual(self.all(rows + ".of-preset th"), [self.setting("good")["values"]["samples"]])
        self.choose("Around", "exact")
        self.assertEqual(self.all(rows + ".of-preset th"), [self.setting("exact")["values"]["samples"]])

    def test_sources_add_up(self):
        lines = self.all("#sources tbody tr", "[...e.children].slice(0, 6).map((cell) => cell.textContent)")
        self.assertGreaterEqual(len(lines), 4)
        for name, measured, together, *parts in lines:
            self.assertAlmostEqual(float(together), math.sqrt(sum(float(p) ** 2 for p in parts)), delta=0.02 * float(together) + 1e-9)
            self.assertAlmostEqual(float(measured), self.setting(name)["error"]["rmse"], delta=0.01 * float(measured))

    def test_it_is_legible_and_fits_narrow_windows(self):
        for scheme in ("light", "dark"):
            page = self.browser.open(self.place / "trade-results/trade.html", media={"prefers-color-scheme": scheme})
            page.wait("document.documentElement.dataset.ready !== undefined")
            contrast, element = page.least_contrast()
            self.assertGreaterEqual(contrast, 4.5, element)
        page.resize(360, 700)  # the one in front: others are not drawn
        page.wait("byId('chart').viewBox.baseVal.width < 400")
        self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 360)


if __name__ == "__main__":
    unittest.main()
