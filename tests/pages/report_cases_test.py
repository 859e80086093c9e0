#!/usr/bin/env python3
"""Reports at their limits: hostile names and texts, every kind of picture, many programs, 400 tests, and a grading from its start.

usage: tests/pages/report_cases_test.py PROGRAM
"""
import json
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "grade"))
import harness  # noqa: E402
from browser import Browser, find_chromium  # noqa: E402
from report_harness import Grading, chunk, figures, png  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
HOSTILE = "</script><img src=x onerror=document.title='out'><!--\"'{{data}}{{pictures}}&amp;%2F#?"
CONTROLS = "\u0000\u001b[31m\u202egnp\u2066\u0007\ufeff\u200b"
NUMBERS = "[...document.querySelectorAll('.values td data')].map((e) => e.value)"


def change_data(path, change):
    """Lets `change` work on what a page's script is given."""
    text = path.read_text()
    start = text.index(">", text.index('id="data"')) + 1
    end = text.index("</script>", start)
    data = json.loads(text[start:end])
    change(data)
    path.write_text(text[:start] + json.dumps(data) + text[end:])


@unittest.skipUnless(find_chromium(), "no Chromium here: the pages are not looked at")
class ReportCases(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = cls.enterClassContext(Browser())

    def setUp(self):
        self.place = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="report_cases_")))

    def open(self, path, fragment="", **media):
        page = self.browser.open(path, fragment, media)
        page.wait("document.documentElement.dataset.ready !== undefined")
        self.addCleanup(page.assert_clean)
        return page

    def select(self, page, index):
        page.evaluate(f"(table.select({index}), shown)")

    def test_hostile_texts_stay_texts(self):
        grading = Grading(self.place / "shard", suite=HOSTILE)
        for name in (HOSTILE, CONTROLS + "name", "x" * 3000):
            grading.add(name, submission=HOSTILE, kind="text", outcome="wrong answer", expected=(HOSTILE + "\n" + CONTROLS + "\n").encode() + b"\xff\xfe\n",
                        output=CONTROLS + HOSTILE + "\nlast", reason=HOSTILE, cause=HOSTILE, explanation=HOSTILE, command=[HOSTILE, CONTROLS],
                        text={"line": 1, "field": 1, "expected": HOSTILE, "actual": CONTROLS, "expected_line": HOSTILE, "actual_line": CONTROLS})
        page = self.open(grading.pages(PROGRAM, self.place / "out", holes=[HOSTILE]) / "report.html")
        for index in range(3):
            self.select(page, index)
            self.assertEqual(page.evaluate("document.images.length"), 0)
            self.assertIn(HOSTILE, page.evaluate("document.title"))
            self.assertEqual(page.evaluate("document.querySelectorAll('script:not([type]), script[type=\"text/plain\"], script[type=\"application/json\"]').length"),
                             page.evaluate("document.scripts.length"))
            self.assertIn(HOSTILE, page.evaluate("byId('output').textContent"))
            self.assertNotRegex(page.evaluate("document.body.innerText"), "[\x00-\x08\x0b-\x1f\u202a-\u202e\u2066-\u2069]")
            self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), page.evaluate("innerWidth"))
        self.select(page, 1)
        self.assertEqual(page.evaluate("byId('row-name').textContent"), "␀␛[31m⟨202e⟩gnp⟨2066⟩␇⟨feff⟩⟨200b⟩name")

    def test_long_lines_are_cut_and_many_are_folded(self):
        grading = Grading(self.place / "shard")
        lines = "".join(f"line {i}\n" for i in range(2000))
        long = "y" * (1 << 20)
        difference = {"line": 1, "field": 1, "expected": long, "actual": long, "expected_line": long, "actual_line": long + "z"}
        grading.add("long", kind="text", outcome="wrong answer", expected=(long + "\n").encode(), output=long[:16384], reason=long, text=difference)
        grading.add("many", kind="text", outcome="wrong answer", expected=lines.encode(), output=lines.replace("line 9", "lime 9"),
                    text=dict(difference, line=10))
        grading.add("beyond", kind="text", outcome="wrong answer", expected=lines.encode(), output=lines[:16384],
                    text=dict(difference, line=1999, expected_line="line 1998", actual_line="lime 1998"))
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"
        self.assertLess(path.stat().st_size, 600_000)
        page = self.open(path)
        self.assertIn("bytes more", page.evaluate("byId('lines').textContent"))
        self.select(page, 1)
        self.assertLess(page.evaluate("document.querySelectorAll('.lines tr').length"), 500)
        before = page.evaluate("document.querySelectorAll('.lines tr.same').length")
        page.click_on(".folded button")
        self.assertGreater(page.evaluate("document.querySelectorAll('.lines tr.same').length"), before)
        self.select(page, 2)
        self.assertIn("the page has no more of what was printed", page.evaluate("byId('lines').innerText"))
        self.assertEqual(page.evaluate("document.querySelector('.lines tbody').innerText.replace(/\\s+/g, ' ').trim()"), "−line 1998 1999 +lime 1998")

    def shown_values(self, path, index=0):
        """The numbers of the first pixel in all panes of a row, and everything said about the pictures."""
        page = self.open(path)
        self.select(page, index)
        page.evaluate("pictures.choosePixel(0, 0)")
        return page.evaluate(NUMBERS), page.evaluate("byId('pictures').innerText")

    def test_kinds_of_pictures(self):
        def palette():
            head = struct.pack(">IIBBBBB", 2, 1, 2, 3, 0, 0, 0)
            return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"PLTE", bytes([1, 2, 3, 40, 50, 60])) +
                    chunk(b"IDAT", zlib.compress(b"\0\x40")) + chunk(b"IEND", b""))

        wide = struct.pack(">6H", 1000, 2000, 65535, 4, 5, 6)
        pictures = {  # the first pixel's numbers, and what is said
            "grey": (png(2, 1, [bytes([7, 8])], channels=1), "7", ""),
            "grey with alpha": (png(2, 1, [bytes([7, 200, 8, 9])], channels=2), "7 200", ""),
            "alpha": (png(2, 1, [bytes([7, 8, 9, 200, 1, 2, 3, 4])], channels=4), "7 8 9 200", ""),
            "16 bits": (png(2, 1, [wide], depth=16, filters=(1,)), "1000 2000 65535", ""),
            "palette": (palette(), "40 50 60", ""),
            "ppm": (b"P6 2 1 255\n" + bytes([11, 12, 13, 14, 15, 16]), "11 12 13", ""),
            "pgm of 4 bits": (b"P5 2 1 15\n" + bytes([5, 15]), "85", "numbers from 0 to 15, shown as 0 to 255"),
        }
        grading = Grading(self.place / "shard")
        for name, (picture, _, _) in pictures.items():
            grading.add(name, outcome="shown", kind="shown", picture=picture)
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"
        for index, (name, (_, numbers, said)) in enumerate(pictures.items()):
            with self.subTest(name):
                values, text = self.shown_values(path, index)
                self.assertEqual(values, [numbers])
                self.assertIn(said, text)

    def test_pictures_that_do_not_fit_together(self):
        grading = Grading(self.place / "shard")
        small, large = png(2, 1, [bytes([1, 2, 3, 4, 5, 6])]), png(3, 2, [bytes(range(9)), bytes(range(9))])
        deep = png(2, 1, [struct.pack(">6H", 257, 514, 772, 0, 0, 0)], depth=16)
        grading.add("size", outcome="wrong size", picture=large, expected=small, reason="3 x 2 pixels, 2 x 1 expected")
        grading.add("depth", outcome="wrong answer", picture=deep, expected=small)
        grading.add("broken", outcome="wrong answer", picture=small[:46], expected=small)
        grading.add("no picture", outcome="wrong answer", picture=b"%PDF", expected=small)
        grading.add("gone", outcome="wrong answer", picture=small, written="/nowhere/expected.png")
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"
        values, text = self.shown_values(path, 0)
        self.assertEqual(values, ["1 2 3", "0 1 2", "1 1 1"])
        self.assertIn("The pictures differ in size", text)
        page = self.open(path, "#size")
        page.evaluate("pictures.choosePixel(2, 1)")
        self.assertEqual(page.evaluate(NUMBERS), ["", "6 7 8", ""])
        self.assertIn("outside", page.evaluate("document.querySelector('.values').innerText"))
        self.assertEqual(self.shown_values(path, 1)[0], ["1 2 3", "257 514 772", "0 0 1"])  # of 65535
        for index, said in ((2, "cannot be shown"), (3, "its file is no picture that can be read"), (4, "its file is not there")):
            values, text = self.shown_values(path, index)
            self.assertIn(said, text)
            self.assertEqual(values, ["1 2 3"])

    def three_pictures(self):
        """The page of whoever compares more than two programs: POV-Ray with 10, same with 20, general with 50."""
        grading = Grading(self.place / "shard")
        for i, value in enumerate((10, 20, 50)):
            grading.add(f"t{i}", kind="shown", outcome="shown", picture=png(2, 1, [bytes([value] * 6)]))
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"

        def put_together(data):
            labels = ("POV-Ray", "same", "general")
            data["rows"][0]["pictures"] = [dict(row["pictures"][0], label=label) for row, label in zip(data["rows"], labels)]

        change_data(path, put_together)
        return path

    def test_three_pictures_are_compared_two_at_a_time(self):
        path = self.three_pictures()
        values, said = self.shown_values(path)
        self.assertEqual(values, ["10 10 10", "20 20 20", "50 50 50", "10 10 10"])
        page = self.open(path)
        page.evaluate("document.querySelectorAll('.pair select')[1].focus()")
        page.key("ArrowDown")
        page.wait(f"{NUMBERS}.at(-1) === '40 40 40'")
        page.click_on("[data-mode=wipe]")
        self.assertEqual(page.evaluate("[...document.querySelectorAll('.corner')].map((e) => e.textContent)"), ["POV-Ray", "general"])

    def test_the_first_two_pictures_that_are_there_are_compared(self):
        path = self.three_pictures()
        change_data(path, lambda data: data["rows"][0]["pictures"].__setitem__(0, {"label": "POV-Ray", "missing": "refused"}))
        values, said = self.shown_values(path)
        self.assertEqual(values, ["20 20 20", "50 50 50", "30 30 30"])
        self.assertIn("refused", said)

    def test_colours_are_multiplied_by_alpha_where_the_first_picture_has_it(self):
        """As the figures are made (grading/difference.h)."""
        grading = Grading(self.place / "shard")
        opaque, half = png(1, 1, [bytes([100, 50, 200])]), png(1, 1, [bytes([100, 50, 200, 51])], channels=4)
        grading.add("opaque first", outcome="passed", expected=opaque, picture=half)
        grading.add("alpha first", outcome="wrong answer", expected=half, picture=opaque)
        page = self.open(grading.pages(PROGRAM, self.place / "out") / "report.html")
        for index, apart in ((0, [0, 0, 0]), (1, [80, 40, 160])):
            self.select(page, index)
            for value, wanted in zip(page.evaluate("Array.from(pictures.apart.apart)"), apart):
                self.assertAlmostEqual(value, wanted, places=3)

    def test_a_picture_without_pixels(self):
        grading = Grading(self.place / "shard")
        empty = png(0, 0, [])
        grading.add("empty", outcome="wrong answer", picture=empty, expected=png(1, 1, [bytes(3)]))
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"
        values, said = self.shown_values(path)
        self.assertEqual(values, ["0 0 0"])
        self.assertIn("its file is no picture that can be read", said)
        message = self.open(path).evaluate(f"decodePng(new Uint8Array({list(empty)})).then(() => 'read', (error) => error.message)")
        self.assertEqual(message, "a picture without pixels")

    def test_what_goes_wrong_with_pictures_is_said(self):
        page = self.open(self.three_pictures())
        page.evaluate("pictures.fillPanes = () => { throw new Error('no canvas') }")
        self.select(page, 0)
        self.assertIn("cannot be shown: no canvas", page.evaluate("byId('pictures').innerText"))

    def test_large_pictures_do_not_stop_the_page(self):
        grading = Grading(self.place / "shard")
        small, large = png(1, 1, [bytes([1, 2, 3])]), png(4096, 2049, [bytes(4096)] * 2049, channels=1)
        grading.add("large", outcome="wrong answer", picture=large, expected=small)
        grading.add("together", outcome="wrong answer", picture=png(1, 30000, [bytes(1)] * 30000, channels=1), expected=png(30000, 1, [bytes(30000)], channels=1))
        grading.add("long", outcome="wrong answer", picture=png(40000, 1, [bytes(40000)], channels=1), expected=small)
        for i in range(5):  # of 64 MiB each when unpacked
            grading.add(f"many {i}", kind="shown", outcome="shown", picture=png(4096, 2048, [bytes([i]) * (8 * 4096)] * 2048, channels=4, depth=16))
        path = grading.pages(PROGRAM, self.place / "out") / "report.html"
        for index, values, said in ((0, ["1 2 3"], "4096 × 2049 pixels, too large"), (1, ["0"], "1 × 30000 pixels, too large"), (2, ["1 2 3"], "40000 × 1 pixels, too large")):
            found, text = self.shown_values(path, index)
            self.assertEqual(found, values)
            self.assertIn(said, text)
        page = self.open(path, "#many%200")
        for index in range(3, 8):
            self.select(page, index)
        self.assertEqual(page.evaluate("[...unpacked.keys()].length"), 4)

    def test_many_programs(self):
        grading = Grading(self.place / "shard")
        right, wrong = png(2, 1, [bytes([1, 2, 3, 4, 5, 6])]), png(2, 1, [bytes([9, 2, 3, 4, 5, 6])])
        names = ["ada", "bob #2", HOSTILE[:40].replace("/", "_"), "ü", "long" * 60]
        for i, name in enumerate(names):
            grading.add("same", submission=name, picture=right, expected=right, wall=1.0 + i)
            grading.add("differs", submission=name, outcome="passed" if i == 0 else "wrong answer", picture=right if i == 0 else wrong, expected=right)
        out = grading.pages(PROGRAM, self.place / "out")
        page = self.open(out / "index.html")
        self.assertEqual(page.evaluate("[...document.querySelectorAll('tbody th')].map((th) => th.textContent)"), names)
        self.assertIn("1 of 5 programs", page.evaluate("byId('head').innerText"))
        page.click_on("th[data-key=time] button")
        self.assertEqual(page.evaluate("document.querySelector('tbody th').textContent"), names[4])
        page.click_on("th[data-key=time] button")
        for i, name in enumerate(names):
            link = page.evaluate(f"document.querySelectorAll('tbody a')[{i}].href")
            self.assertTrue(link.startswith((out / "reports").as_uri()))
            one = self.open(out / "index.html")
            one.requests.clear()
            one.url = link
            one.call("Page.navigate", url=link)
            one.wait("document.readyState === 'complete' && document.documentElement.dataset.ready !== undefined && typeof pageData !== 'undefined'")
            self.assertEqual(one.evaluate("byId('head').querySelector('h1').textContent"), name)
            self.assertEqual(one.evaluate("document.querySelector('#head a').textContent"), "← All programs")
            self.assertIn("--all-pictures", one.evaluate("pageData.rows[0].pictures[0].missing"))
            self.assertEqual(one.evaluate("document.querySelectorAll('script[type=\"text/plain\"]').length"), 0 if i == 0 else 2)
        pages = {path: (path.read_bytes(), path.stat().st_mtime_ns) for path in [out / "index.html", *out.glob("reports/*")]}
        self.assertEqual(len(pages), 6)
        grading.times[0]["wall"] = 77.0
        grading.pages(PROGRAM, out)
        changed = {path.name for path, (content, moment) in pages.items() if path.stat().st_mtime_ns != moment}
        self.assertEqual(changed, {"index.html", "ada.html"})
        grading.pages(PROGRAM, out, "--all-pictures")
        self.assertEqual((out / "reports" / "ada.html").read_text().count('<script type="text/plain"'), 1)

    def test_the_same_results_give_the_same_bytes(self):
        grading = Grading(self.place / "shard")
        grading.add("same", picture=png(2, 1, [bytes(6)]), expected=png(2, 1, [bytes(6)]), figures=figures(0))
        pages = [(grading.pages(PROGRAM, self.place / name) / "report.html").read_bytes() for name in ("one", "two")]
        self.assertEqual(*pages)

    def test_results_without_their_pictures(self):
        grading = Grading(self.place / "shard")
        grading.add("gone", outcome="wrong answer", picture=png(2, 1, [bytes(6)]), expected=png(2, 1, [bytes(6)]), figures=figures(5))
        grading.write()
        shutil.rmtree(self.place / "shard" / "known")
        (self.place / "shard" / "tests.json").unlink()
        subprocess.run([PROGRAM, "merge", "-q", "-o", self.place / "out", self.place / "shard"], check=True)
        page = self.open(self.place / "out" / "report.html")
        text = page.evaluate("byId('pictures').innerText")
        self.assertIn("not known here", text)
        self.assertIn("its file is not there", text)

    def test_a_grading_and_its_pages(self):
        """From programs to pages; the numbers are those that ImageMagick reads from the files."""
        suite = harness.make_suite(PROGRAM, self.place)
        program = harness.make_program(PROGRAM, self.place / "flopped", 'case "$1" in render) ;; *) exec "$real" "$@" ;; esac\n'
                                       '"$real" "$@" && /usr/bin/convert output.png -flop output.png')
        harness.grade(PROGRAM, suite, self.place / "out", "--exe", program.parent, check=1)
        page = self.open(self.place / "out" / "report.html", "#plain")
        expected = suite.parent / "answers" / "plain.png"
        picture = json.loads((self.place / "out" / "times.json").read_text())["times"][2]["picture"]
        for x, y in ((0, 0), (100, 60), (40, 90), (159, 119)):
            page.evaluate(f"pictures.choosePixel({x}, {y})")
            numbers = []
            for path in (expected, self.place / "out" / picture):
                pixel = subprocess.run(["convert", f"{path}[1x1+{x}+{y}]", "-alpha", "off", "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout
                numbers.append(list(pixel))
            numbers.append([abs(a - b) for a, b in zip(*numbers)])
            shown = [list(map(int, value.split()))[:3] for value in page.evaluate(NUMBERS)]
            self.assertEqual(shown, numbers, (x, y))
        before = (self.place / "out" / "report.html").stat().st_mtime_ns
        harness.grade(PROGRAM, suite, self.place / "out", "--exe", program.parent, check=1)
        self.assertEqual((self.place / "out" / "report.html").stat().st_mtime_ns, before)

    def test_a_page_of_400_tests_answers(self):
        noise = random.Random(1)
        base = [bytes(noise.choice((40, 42, 44, 200)) for _ in range(3 * 640)) for _ in range(480)]
        grading = Grading(self.place / "shard")
        expected = png(640, 480, base, filters=(0,))
        for i in range(400):
            actual = png(640, 480, base[:i] + [bytes([i % 251]) * 1920] + base[i + 1:]) if i < 200 else expected
            region = {"pixels": 640, "box": [0, i, 640, i + 1], "pixel": [320, i]} if i < 200 else None
            grading.add(f"p{i % 7}/test{i}", outcome="wrong answer" if i < 200 else "passed", picture=actual, expected=expected,
                        figures=figures(noise.randrange(300000), noise.randrange(300000), noise.random()), **({"region": region} if region else {}))
        page = self.open(grading.pages(PROGRAM, self.place / "out", "--all-pictures") / "report.html")
        size = (self.place / "out" / "report.html").stat().st_size
        seen = page.evaluate("""(async () => {
            const names = () => [...document.querySelectorAll("#table tbody tr th")].map((cell) => cell.textContent);
            const differing = () => table.shown.map((index) => Number(table.rows[index].cells.differing));
            const seen = { steps: {} };
            const step = async (name, action, result = () => true) => {
                const start = performance.now();
                await action();
                await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
                seen.steps[name] = Math.round(performance.now() - start);
                seen[name] = result();
            };
            await step("sort numbers", () => document.querySelector("th[data-key=differing] button").click(), differing);
            await step("sort texts", () => document.querySelector("th[data-key=name] button").click(), names);
            await step("filter", () => { table.words.value = "test1"; table.words.dispatchEvent(new Event("input")); }, names);
            table.words.value = "", table.order();
            for (const index of [0, 150, 77, 300])
                await step(`select ${index}`, async () => { table.select(index); await shown; }, () => document.getElementById("row-name").textContent);
            table.select(60), await shown;
            const pane = document.querySelector(".panes .pane"), box = pane.getBoundingClientRect();
            const at = { clientX: box.left + 50, clientY: box.top + 60, bubbles: true, cancelable: true };
            await step("zoom", () => pane.dispatchEvent(new WheelEvent("wheel", { ...at, deltaY: -300 })));
            await step("values", () => pane.dispatchEvent(new PointerEvent("pointermove", at)));
            const gain = document.querySelector(".gain");
            await step("gain", () => { gain.value = 5; gain.dispatchEvent(new Event("input")); });
            await step("wipe mode", () => pictures.setMode("wipe"));
            await step("wipe", () => pictures.overlay.handle.dispatchEvent(new KeyboardEvent("keydown", { key: "PageUp", bubbles: true })));
            await step("blink mode", () => pictures.setMode("blink"));
            return seen;
        })()""")
        print(f"page of {size / 1e6:.0f} MB, milliseconds:", seen["steps"], file=sys.stderr)
        every = [f"p{i % 7}/test{i}" for i in range(400)]
        known = [value for value in seen["sort numbers"] if value is not None]
        self.assertEqual(len(seen["sort numbers"]), 400)
        self.assertGreater(len(known), 300)
        self.assertEqual(known, sorted(known, reverse=True))
        self.assertEqual(seen["sort texts"], sorted(every, key=lambda name: [int(part) for part in name[1:].split("/test")]))
        self.assertEqual(sorted(seen["filter"]), sorted(name for name in every if "test1" in name))
        for index in (0, 150, 77, 300):
            self.assertEqual(seen[f"select {index}"], every[index])


if __name__ == "__main__":
    unittest.main()
