#!/usr/bin/env python3
"""Reports in a browser: what is shown is what the files hold, everything works by mouse and keyboard, and nothing is asked of the network.

usage: tests/pages/report_page_test.py PROGRAM
"""
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "grade"))
import harness  # noqa: E402
from browser import Browser, find_chromium  # noqa: E402
from report_harness import Grading, figures, png  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
WIDTH, HEIGHT = 48, 36


NOISE = random.Random(7).choices(range(5), k=WIDTH * HEIGHT)  # few numbers: PNG's predictors often meet ties


def color(x, y):
    return ((5 * x + 3 * y) % 256, (7 * x * y) % 256, NOISE[y * WIDTH + x])


def other(x, y):
    """Another colour in columns 10 to 19 of rows 6 to 13."""
    r, g, b = color(x, y)
    return (255 - r, g, (b + 40) % 256) if 10 <= x < 20 and 6 <= y < 14 else (r, g, b)


def rows(pixel, width=WIDTH, height=HEIGHT):
    return [bytes(channel for x in range(width) for channel in pixel(x, y)) for y in range(height)]


EXPECTED, ACTUAL = rows(color), rows(other)
REGION = {"pixels": 80, "box": [10, 6, 20, 14], "pixel": [14, 9]}
EXPLANATION = "pixel 14, 9: (71, 114, 39), (184, 114, 79) expected"
VALUES = "[...document.querySelectorAll('.values td data')].map((e) => e.value)"


def small_grading(place):
    """Six tests: pictures that differ and are the same, a program that wrote none, texts, a time-out."""
    grading = Grading(place)
    right, wrong = png(WIDTH, HEIGHT, EXPECTED, filters=(0, 1, 2, 3, 4)), png(WIDTH, HEIGHT, ACTUAL, filters=(4, 3, 2, 1, 0))
    grading.add("p1/plain", picture=right, expected=right, figures=figures(0, 0, 0.0), command=["render", "../resources/it's.pov", "48", "36"])
    grading.add("p1/mirror", outcome="wrong answer", picture=wrong, expected=right, figures=figures(1200, 1300, 0.25, 0.5), region=REGION,
                reason="differing pixels 1200, at most 1000 allowed", cause="mirrored", explanation=EXPLANATION, wall=12.5)
    grading.add("p10/shadow", outcome="passed", picture=wrong, expected=right, figures=figures(80, 80, 0.01), wall=0.5)
    grading.add("p2/none", outcome="no output", expected=right, reason="no output.png", wall=0.1)
    grading.add("p2/ray", kind="text", outcome="wrong answer", expected=b"Ray 1\nT = 1.0000 2\nlost\nend\n", output="Ray 1\nT = 1.5000 2\nend\n",
                reason="line 2, field 3: '1.5000', '1.0000' expected", tolerance=0.001,
                text={"line": 2, "field": 3, "expected": "1.0000", "actual": "1.5000", "expected_line": "T = 1.0000 2", "actual_line": "T = 1.5000 2"})
    grading.add("p2/slow", kind="text", outcome="time-out", expected=b"1\n", reason="not done within 4 s", wall=4.0, required=False)
    return grading


@unittest.skipUnless(find_chromium(), "there is no Chromium")
class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="report_page_")
        cls.place = pathlib.Path(cls.folder.name)
        cls.small = small_grading(cls.place / "small").pages(PROGRAM, cls.place / "small_pages", holes=["networks are not kept out"]) / "report.html"
        cls.browser = Browser()
        cls.browser.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def open(self, path=None, fragment="", **media):
        page = self.browser.open(path or self.small, fragment, media)
        page.wait("document.documentElement.dataset.ready !== undefined")
        self.addCleanup(page.assert_clean)
        return page

    def names(self, page):
        return page.evaluate("[...document.querySelectorAll('tbody th')].map((th) => th.firstChild.textContent)")

    def assert_row(self, page, name):
        page.wait(f"byId('row-name').textContent === {json.dumps(name)}")
        self.assertEqual(page.evaluate("document.querySelector('tr[aria-selected=true] th').firstChild.textContent"), name)
        page.evaluate("shown")

    def test_head_and_facts(self):
        page = self.open(fragment="#p1%2Fmirror")
        head = page.evaluate("byId('head').innerText")
        for text in ("ada", "Winter", "2 of 6", "2 of 5", "Not contained: networks are not kept out"):
            self.assertIn(text, head)
        self.assertIn("ada", page.evaluate("document.title"))
        self.assertEqual(page.evaluate("byId('row-cause').innerText"), f"Likely cause: mirrored\n\n{EXPLANATION}")
        facts = page.evaluate("byId('told').innerText")
        for text in ("differing pixels at most 1000", "12.500 s", "2.0 MiB", "columns 10 to 19, rows 6 to 13"):
            self.assertIn(text, facts)

    def test_opens_with_what_is_not_good_and_by_address(self):
        self.assert_row(self.open(), "p1/mirror")
        self.assert_row(self.open(fragment="#p2%2Fray"), "p2/ray")
        self.assert_row(self.open(fragment="#%ff"), "p1/mirror")

    def test_sorts_numbers_and_texts(self):
        page = self.open()
        given = self.names(page)
        page.click_on("th[data-key=differing] button")
        self.assertEqual(self.names(page)[:3], ["p1/mirror", "p10/shadow", "p1/plain"])  # missing ones last
        self.assertEqual(page.evaluate("document.querySelector('th[data-key=differing]').ariaSort"), "descending")
        page.click_on("th[data-key=differing] button")
        self.assertEqual(self.names(page)[:3], ["p1/plain", "p10/shadow", "p1/mirror"])
        page.click_on("th[data-key=differing] button")
        self.assertEqual(self.names(page), given)
        page.click_on("th[data-key=name] button")
        self.assertEqual(self.names(page), ["p1/mirror", "p1/plain", "p2/none", "p2/ray", "p2/slow", "p10/shadow"])
        page.click_on("th[data-key=time] button")
        self.assertEqual(self.names(page), ["p1/mirror", "p2/slow", "p10/shadow", "p1/plain", "p2/ray", "p2/none"])

    def test_filters_by_words_and_outcome(self):
        page = self.open()
        page.click_on("input[type=search]")
        page.call("Input.insertText", text="P2 line")
        self.assertEqual(self.names(page), ["p2/ray"])
        self.assertEqual(page.evaluate("document.querySelector('.filter output').textContent"), "1 of 6 tests")
        page.evaluate("table.words.value = '', table.outcome.value = '= wrong answer', table.outcome.dispatchEvent(new Event('change'))")
        self.assertEqual(self.names(page), ["p1/mirror", "p2/ray"])
        page.evaluate("table.outcome.value = 'bad', table.outcome.dispatchEvent(new Event('change'))")
        self.assertEqual(len(self.names(page)), 4)

    def test_rows_are_chosen_by_mouse_and_keyboard(self):
        page = self.open()
        page.click_on("tr[data-index='4'] td")
        self.assert_row(page, "p2/ray")
        self.assertEqual(page.evaluate("location.hash"), "#p2%2Fray")
        for key, name in (("ArrowDown", "p2/slow"), ("ArrowDown", "p2/slow"), ("ArrowUp", "p2/ray"), ("Home", "p1/plain"), ("End", "p2/slow")):
            page.key(key)
            self.assert_row(page, name)
            self.assertEqual(page.evaluate("document.activeElement.dataset.index"), page.evaluate("String(table.selected)"))
        page.click_on("th[data-key=name] button")
        page.tab_to("document.activeElement.tagName === 'TR'")
        page.key("ArrowDown")
        self.assert_row(page, "p10/shadow")
        page.click_on("#previous")
        self.assert_row(page, "p2/slow")

    def test_pixel_values_are_those_of_the_files(self):
        page = self.open()
        pane = ".panes:not(.over) figure:nth-child({}) .pane"
        for figure, (x, y) in ((1, (0, 0)), (2, (14, 9)), (3, (47, 35)), (1, (10, 13)), (2, (31, 20))):
            left, top, width, height = page.box(pane.format(figure))
            page.move(left + (x + 0.5) / WIDTH * width, top + (y + 0.5) / HEIGHT * height)
            page.wait(f"document.querySelector('.values tr').dataset.pixel === '{x},{y}'")
            a, b = color(x, y), other(x, y)
            wanted = [" ".join(map(str, numbers)) for numbers in (a, b, [abs(p - q) for p, q in zip(a, b)])]
            self.assertEqual(page.evaluate(VALUES), wanted)
        page.move(5, 5)
        page.wait("document.querySelector('.values tr').dataset.pixel === '14,9'")  # the region's own pixel again

    def test_a_pixel_is_chosen_by_the_keyboard(self):
        page = self.open()
        live = "document.querySelector('.values').ariaLive"
        self.assertEqual(page.evaluate(live), "polite")
        left, top, width, height = page.box(".panes .pane")
        page.move(left + width / 2, top + height / 2)
        page.wait(f"{live} === 'off'")  # a pointer is too quick to be told of
        page.move(5, 5)
        page.wait(f"{live} === 'polite'")
        page.tab_to("document.activeElement.classList.contains('pane')")
        for key, place in (("ArrowRight", "15,9"), ("ArrowDown", "15,10"), ("ArrowLeft", "14,10"), ("ArrowUp", "14,9")):
            page.key(key)
            self.assertEqual(page.evaluate("document.querySelector('.values tr').dataset.pixel"), place)

    def test_every_pixel_is_drawn_as_stored(self):
        page = self.open()
        data = page.evaluate("""[...document.querySelectorAll('.panes:not(.over) canvas.picture')].slice(0, 2).map((c) =>
            Array.from(c.getContext('2d').getImageData(0, 0, c.width, c.height).data).filter((_, i) => i % 4 < 3))""")
        self.assertEqual(data, [list(b"".join(EXPECTED)), list(b"".join(ACTUAL))])

    def test_the_difference_and_its_gain(self):
        page = self.open()
        pixels = """(() => {
            const copy = new OffscreenCanvas(1, 2).getContext("2d");
            copy.drawImage(pictures.difference, -14, -8);
            return Array.from(copy.getImageData(0, 0, 1, 2).data);
        })()"""
        apart = [abs(p - q) for y in (8, 9) for p, q in zip(color(14, y), other(14, y))]
        shown = lambda gain: [v for i in (0, 3) for v in [min(255, gain * d) for d in apart[i:i + 3]] + [255]]  # noqa: E731
        self.assertEqual(page.evaluate(pixels), shown(8))
        page.evaluate("document.querySelector('.gain').focus()")
        for _ in range(6):
            page.key("ArrowLeft")
        page.wait("document.querySelector('.gain').value === '0'")
        self.assertEqual(page.evaluate(pixels), shown(1))
        self.assertEqual(page.evaluate("document.querySelector('.gain + output').textContent"), "× 1")

    def test_zoom_in_one_pane_moves_the_others(self):
        page = self.open()
        transforms = "[...document.querySelectorAll('.panes:not(.over) canvas.picture')].map((c) => c.style.transform)"
        before = page.evaluate(transforms)
        left, top, width, height = page.box(".panes figure:nth-child(2) .pane")
        page.wheel(left + width / 4, top + height / 4, -300)
        page.wait(f"String({transforms}) !== {json.dumps(','.join(before))}")
        after = page.evaluate(transforms)
        self.assertEqual(len(after), 3)
        self.assertEqual(len(set(after)), 1)
        page.drag(left + 40, top + 40, left + 10, top + 30)
        self.assertEqual(len(set(page.evaluate(transforms))), 1)
        self.assertNotEqual(page.evaluate(transforms), after)
        page.click_on(".to-region")
        self.assertTrue(page.evaluate("(() => { const [x, y] = pictures.view.place(15, 10), [w, h] = pictures.view.size; return Math.hypot(x - w / 2, y - h / 2) < 1; })()"))

    def test_the_wipe_moves_by_mouse_and_keyboard(self):
        page = self.open()
        page.click_on("[data-mode=wipe]")
        self.assertFalse(page.evaluate("pictures.overlay.handle.hidden"))
        left, top, width, height = page.box(".over .pane")
        page.drag(left + width / 2, top + height / 3, left + width / 4, top + height / 3)
        page.wait("Math.abs(pictures.overlay.border - 0.25) < 0.01")
        cut = page.evaluate("pictures.overlay.layers[1].style.clipPath.match(/([\\d.]+)px\\)/)[1]")
        self.assertAlmostEqual(float(cut), WIDTH / 4, delta=0.1)  # in pixels of the picture
        page.tab_to("document.activeElement.getAttribute('role') === 'slider'")
        for key, value in (("End", 100), ("ArrowLeft", 99), ("PageDown", 89), ("Home", 0), ("ArrowRight", 1)):
            page.key(key)
            self.assertEqual(page.evaluate("document.activeElement.getAttribute('aria-valuenow')"), str(value))
        page.click_on("tr[data-index='2'] td")
        self.assert_row(page, "p10/shadow")
        self.assertFalse(page.evaluate("pictures.overlay.handle.hidden"))  # the view stays from row to row

    def test_blinks_by_itself_and_by_the_space_bar(self):
        page = self.open()
        page.click_on("[data-mode=blink]")
        seen = "pictures.overlay.layers.map((l) => l.style.visibility).join()"
        states = ["visible,hidden", "hidden,visible"]
        for state in states * 2:
            page.wait(f"{seen} === '{state}'")
        label = "document.querySelector('.corner.left').textContent"
        page.evaluate("document.querySelector('.over .pane').focus()")
        page.key(" ", " ")
        self.assertFalse(page.evaluate("pictures.overlay.playing"))
        first = page.evaluate(label)
        page.key(" ", " ")
        self.assertEqual({first, page.evaluate(label)}, {"Expected", "Actual"})
        page.click_on(".play")
        self.assertTrue(page.evaluate("pictures.overlay.playing"))
        still = self.open(**{"prefers-reduced-motion": "reduce"})
        still.click_on("[data-mode=blink]")
        self.assertFalse(still.evaluate("pictures.overlay.playing"))

    def test_texts_side_by_side(self):
        page = self.open(fragment="#p2%2Fray")
        lines = page.evaluate("[...document.querySelectorAll('.lines tbody tr')].map((tr) => [...tr.cells].map((td) => td.innerText.trim()))")
        self.assertEqual(lines, [["1", "Ray 1", "1", "Ray 1"], ["2", "−T = 1.0000 2", "2", "+T = 1.5000 2"], ["3", "−lost", "", ""], ["4", "end", "3", "end"]])
        self.assertEqual(page.evaluate("[...document.querySelectorAll('mark')].map((m) => m.textContent)"), ["1.0000", "1.5000"])
        self.assertIn("Numbers may be 0.001 apart", page.evaluate("byId('lines').innerText"))
        self.assertTrue(page.evaluate("byId('pictures').hidden"))

    def test_what_is_missing_is_said(self):
        page = self.open(fragment="#p2%2Fnone")
        self.assertEqual(page.evaluate("document.querySelector('.missing').textContent"), "no output.png")
        self.assertEqual(page.evaluate("document.querySelectorAll('.panes:not(.over) .pane').length"), 1)
        self.assertEqual(page.evaluate(VALUES), [" ".join(map(str, color(24, 18)))])

    def test_the_command_is_one_for_a_shell(self):
        page = self.open(fragment="#p1%2Fplain")
        command = page.evaluate("byId('command').textContent")
        words = subprocess.run(["bash", "-c", f"printf '%s\\n' {command}"], capture_output=True, text=True).stdout.split("\n")[:-1]
        self.assertEqual(words, ["ada", "render", "../resources/it's.pov", "48", "36"])
        page.click_on("#copy")
        page.wait("document.querySelector('#told output').textContent !== ''")

    def test_pictures_stand_in_the_page_once(self):
        text = self.small.read_text()
        self.assertEqual(text.count('<script type="text/plain"'), 2)

    def test_legible_in_the_dark_and_at_400_percent(self):
        grounds = []
        for scheme in ("light", "dark"):
            for fragment in ("#p1%2Fmirror", "#p2%2Fray"):
                page = self.open(fragment=fragment, **{"prefers-color-scheme": scheme})
                page.resize(320, 256)
                self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 320)
                self.assertGreater(page.least_contrast(), [4.5])
            grounds.append(page.evaluate("getComputedStyle(document.documentElement).backgroundColor"))
        self.assertNotEqual(*grounds)


if __name__ == "__main__":
    unittest.main()
