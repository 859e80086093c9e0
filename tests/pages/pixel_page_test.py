#!/usr/bin/env python3
"""`pixeltrace --html` as a reader meets it: what the page shows is what --json prints, by mouse and by keys, and nothing leaves it.

usage: pixel_page_test.py PROGRAM
"""
import base64
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, find_chromium

PROGRAM = os.path.abspath(sys.argv.pop(1))

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 0.5, 6> up <0, 1, 0> right <1.25, 0, 0> look_at <0, 0, 0> }
light_source { <-4, 9, 7> color rgb <0.9, 0.8, 0.7> }
light_source { <5, 3, 2> color rgb 0.5 }
sphere { <0, 0, 0>, 1 pigment { color rgbf <1, 0.5, 0.25, 0.75> }
  finish { ambient 0.2 diffuse 0.4 specular 0.3 roughness 0.1 reflection 0.25 ior 1.5 } scale <1, 1.5, 1> }
plane { <0, 1, 0>, -2 pigment { color rgb <0.2, 0.7, 0.8> } finish { ambient 0.4 diffuse 0.6 reflection 0.2 } }
"""
MIRRORS = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 250 }
camera { location <0, 0, 0> look_at <0.01, 0.02, 1> }
light_source { <0, 3, 0> rgb 1 }
plane { z, 2 pigment { rgb 1 } finish { ambient 0.1 diffuse 0 reflection 0.999 } }
plane { z, -2 pigment { rgb 1 } finish { ambient 0.1 diffuse 0 reflection 0.999 } }
"""
SIZE = ["80", "64"]
GENERAL = ["--profile=povray"]
POVRAY = ["--profile=povray", "--shading=povray"]
COURSE = []
SAMPLED = ["-ss=2"]
PROFILES = {"the general form": GENERAL, "POV-Ray's shading": POVRAY, "the course": COURSE, "the course, 2 x 2": SAMPLED}
CONTRIBUTIONS = ["ambient", "diffuse", "specular", "reflection", "refraction", "background", "radiance"]

# The numbers of each open ray as they stand in the page, by the names of its fields.
SHOWN = """[...document.querySelectorAll("#rays > li")].map((item) => {
    const fields = {};
    for (const row of item.querySelectorAll("[data-field]"))
        (fields[row.dataset.field] ??= []).push([...row.querySelectorAll("data")].map((number) => Number(number.value)));
    fields.text = item.textContent;
    return fields;
})"""


def run(*words, **settings):
    return subprocess.run([PROGRAM, *words], capture_output=True, timeout=300, **settings)


def data_of(path):
    """What the page holds as JSON."""
    text = pathlib.Path(path).read_text()
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S).group(1))


@unittest.skipUnless(find_chromium(), "no Chromium here: the page is not looked at")
class PixelPageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = cls.enterClassContext(Browser())
        folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        os.chdir(folder)
        pathlib.Path("a.pov").write_text(SCENE)
        pathlib.Path("mirrors.pov").write_text(MIRRORS)

    def make(self, options, scene="a.pov", pixel=("41", "30")):
        made = run("pixeltrace", scene, *SIZE, *pixel, *options, "--html", "page.html")
        self.assertEqual((made.returncode, made.stdout, made.stderr), (0, b"", b""))
        return data_of("page.html")

    def open(self, fragment="", **media):
        page = self.browser.open("page.html", fragment, media)
        self.addCleanup(page.assert_clean)
        page.wait("'ready' in document.documentElement.dataset")
        return page

    def json_of(self, options, x, y, scene="a.pov"):
        return json.loads(run("pixeltrace", scene, *SIZE, str(x), str(y), *options, "--json").stdout)

    def click_pixel(self, page, x, row):
        """Where the picture itself is seen in the window says where its pixel is."""
        left, top, width, height = page.box("#render")
        page.click(left + (x + 0.5) * width / int(SIZE[0]), top + (row + 0.5) * height / int(SIZE[1]))

    def assert_shows(self, page, rays):
        """The page's tree is these rays, number for number."""
        page.click_on("#open-all")
        page.wait(f"document.querySelectorAll('#rays .body').length === {len(rays)}")
        shown = page.evaluate(SHOWN)
        self.assertEqual(len(shown), len(rays))
        for got, ray in zip(shown, rays):
            want = {name: [ray[name]] for name in CONTRIBUTIONS + ["origin", "direction"]}
            want["level"] = [[ray["level"], ray["weight"]]]
            if ray["parent"] is not None:
                want["factor"] = [ray["factor"]]
            if "hit" in ray:
                hit = ray["hit"]
                want.update(t=[[hit["t"]]], point=[hit["point"]], normal=[hit["normal"]])
                want["layer"] = [[*layer["rgb"], layer["filter"], layer["transmit"]] for layer in hit["layers"]]
                side = "inside" if hit["inside"] else "outside"
                self.assertIn(f"{hit['type']}, object {hit['object']}, part {hit['part']}, {side}", got["text"])
                for shadow in hit["shadows"]:
                    answer = "hidden" if max(shadow["transmitted"]) == 0 else "arrives"
                    self.assertIn(f"Light {shadow['light']}: {answer}", got["text"])
            for name, values in want.items():
                self.assertEqual(got.get(name), values, name)

    def test_a_clicked_pixel_tells_what_json_prints(self):
        for name, options in PROFILES.items():
            with self.subTest(name):
                data = self.make(options)
                page = self.open()
                grid = [pixel for pixel in data["pixels"] if not pixel["asked"]]
                chosen = max(grid, key=lambda pixel: len(pixel["samples"][0]))
                want = self.json_of(options, chosen["x"], chosen["y"])
                row = chosen["y"] if options in (GENERAL, POVRAY) else int(SIZE[1]) - 1 - chosen["y"]
                self.click_pixel(page, chosen["x"], row)
                page.wait(f"location.hash === '#{chosen['x']},{chosen['y']}'")
                self.assertEqual(page.evaluate("byId('pixel-name').textContent"), f"Pixel {chosen['x']}, {chosen['y']}")
                color = page.evaluate("byId('pixel-color').textContent").strip()
                self.assertEqual(color, "({}, {}, {})".format(*want["pixel"]["color"]))
                self.assertIn("very pixel", page.evaluate("byId('pixel-shown').textContent"))
                self.assertGreater(len(want["samples"][0]), 2)
                self.assert_shows(page, want["samples"][0])

    def test_the_picture_is_what_render_makes_and_its_pixels_are_their_rays(self):
        for name, options in PROFILES.items():
            with self.subTest(name):
                self.make(options)
                run("render", "a.pov", *SIZE, *options, "-o", "picture.png")
                embedded = re.search(r"data:image/png;base64,([^\"]*)", pathlib.Path("page.html").read_text()).group(1)
                self.assertEqual(base64.b64decode(embedded), pathlib.Path("picture.png").read_bytes())
                page = self.open()
                differing = "pageData.pixels.filter((p) => !raysMakeThePixel(p))"
                self.assertEqual(page.evaluate(f"{differing}.map((p) => [p.x, p.y])"), [])
                self.assertGreater(page.evaluate("pageData.pixels.length"), 100)

    def test_swatches_have_the_colours_of_the_picture(self):
        pathlib.Path("srgb.pov").write_text(SCENE.replace("assumed_gamma 1", "assumed_gamma srgb"))
        pathlib.Path("two.pov").write_text(SCENE.replace("assumed_gamma 1", "assumed_gamma 2"))
        pathlib.Path("legacy.pov").write_text(SCENE.replace("#version 3.7", "#version 3.6").replace("assumed_gamma 1", ""))
        for scene in ("a.pov", "srgb.pov", "two.pov", "legacy.pov"):
            for options in (GENERAL, [*GENERAL, "--file-gamma=2.2"], [*GENERAL, "--file-gamma=1"], COURSE):
                with self.subTest(f"{scene} {options}"):
                    self.make([*options, "--grid=4"], scene=scene)
                    page = self.open()
                    wrong = page.evaluate("""pageData.pixels.filter((p) =>
                        String(decoded.at(p.x, p.row)) !== String(p.radiance.map((light) => shownByte(light))))""")
                    self.assertEqual(wrong, [])
                    of_light = page.evaluate("byId('pixel-light').querySelector('.swatch').style.backgroundColor")
                    of_pixel = page.evaluate("byId('pixel-color').querySelector('.swatch').style.backgroundColor")
                    self.assertEqual(of_light, of_pixel)

    def test_pictures_of_every_shape_are_seen_and_zoomed(self):
        for size in (("2000", "1"), ("1", "300"), ("8", "6"), ("600", "60")):
            with self.subTest(size):
                made = run("pixeltrace", "a.pov", *size, "0", "0", *GENERAL, "--html", "page.html")
                self.assertEqual((made.returncode, made.stderr), (0, b""))
                page = self.open()
                self.assertGreater(page.evaluate("view.size[1]"), 100)
                self.assertGreater(page.evaluate("view.scale"), 0)
                for _ in range(3):
                    before = page.evaluate("view.scale")
                    page.click_on("#zoom-in")
                    page.wait(f"view.scale > {before} && document.images[0].getBoundingClientRect().width > 0")
                page.click_on("#zoom-fit")
                page.wait("view.scale === view.fitScale")

    def test_the_head_counts_pixels(self):
        for options, told in ((["--grid=0"], " · 1 pixel traced · "), (["--grid=32", "--pixel=1,1"], " pixels traced, a grid of every 32 pixels among"),
                              (["--crop=40,43,29,32", "--grid=1"], " · 9 pixels traced, a grid of every pixel among them · ")):
            self.make([*GENERAL, *options])
            self.assertIn(told, self.open().evaluate("byId('about').textContent"))

    def test_light_beyond_all_numbers_is_told(self):
        bright = SCENE.replace("ambient 0.2", "ambient 1e200").replace("rgb <0.9, 0.8, 0.7>", "rgb 1e200").replace("rgbf <1,", "rgbf <1e200,")
        pathlib.Path("bright.pov").write_text(bright)
        self.make(GENERAL, scene="bright.pov", pixel=("40", "32"))
        page = self.open()
        self.assertEqual(page.evaluate("byId('pixel-color').textContent").strip(), "(0, 0, 0)")
        self.assertEqual(page.evaluate("byId('rays-note').textContent"),
                         "The light of its rays is not a finite number: the picture has black there.")

    def test_a_browser_that_refuses_addresses_shows_the_pixel(self):
        self.make([*GENERAL, "--grid", "8"], pixel=("44", "36"))
        page = self.open()
        page.evaluate("""{
            const replace = history.replaceState.bind(history);
            globalThis.refused = 0;
            history.replaceState = (...address) => {
                if (++refused < 3) throw new DOMException("too many", "SecurityError");
                replace(...address);
            };
        }""")
        page.tab_to("document.activeElement.classList.contains('pane')")
        page.key("ArrowRight")
        page.wait("byId('pixel-name').textContent === 'Pixel 52, 36'")
        page.wait("location.hash === '#52,36'")
        self.assertEqual(page.evaluate("refused"), 3)

    def test_a_pixel_between_has_its_own_colour_and_the_nearest_rays(self):
        for options in (GENERAL, COURSE):
            self.make([*options, "--grid", "20"], pixel=("40", "35"))
            page = self.open()
            row = 33 if options == GENERAL else int(SIZE[1]) - 1 - 33
            self.click_pixel(page, 43, row)
            page.wait("location.hash === '#43,33'")
            want = self.json_of(options, 43, 33)["pixel"]["color"]
            self.assertEqual(page.evaluate("byId('pixel-color').textContent").strip(), "({}, {}, {})".format(*want))
            shown = page.evaluate("byId('pixel-shown').textContent")
            self.assertEqual(shown, "of the nearest traced pixel, 40, 35: 3.6 pixels away")
            command = shlex.split(page.evaluate("byId('pixel-command').textContent"))
            self.assertEqual(command[0], "raytrace")
            text = run(*command[1:]).stdout.decode()
            self.assertTrue(text.startswith("Pixel: [43, 33] Color: ({}, {}, {})\n".format(*want)), text[:60])
            self.assert_shows(page, self.json_of(options, 40, 35)["samples"][0])

    def test_each_sample_can_be_chosen_by_keys(self):
        self.make(SAMPLED)
        page = self.open("#41,30")
        samples = self.json_of(SAMPLED, 41, 30)["samples"]
        self.assertEqual(page.evaluate("document.querySelectorAll('#sample option').length"), 4)
        self.assert_shows(page, samples[0])
        page.evaluate("byId('sample').focus()")
        page.key("ArrowDown")
        page.key("ArrowDown")
        page.wait("selected.sample === 2")
        self.assert_shows(page, samples[2])
        self.assertNotEqual(samples[0], samples[2])

    def test_without_a_mouse(self):
        data = self.make([*GENERAL, "--grid", "8"], pixel=("44", "36"))
        page = self.open()
        page.tab_to("document.activeElement.classList.contains('pane')")
        self.assertTrue(page.evaluate("document.activeElement.getAttribute('aria-label').includes('Arrow keys')"))
        self.assertEqual(page.evaluate("location.hash"), "#44,36")
        for key, place in (("ArrowRight", [52, 36]), ("ArrowUp", [52, 28]), ("ArrowLeft", [44, 28]), ("ArrowDown", [44, 36])):
            self.assertTrue(any([pixel["x"], pixel["y"]] == place for pixel in data["pixels"]), place)
            page.key(key)
            page.wait("location.hash === '#{},{}'".format(*place))
        before = page.evaluate("view.scale")
        page.key("+", "+")
        page.wait(f"view.scale > {before}")
        page.key("0", "0")
        page.wait(f"view.scale === {before}")
        page.tab_to("document.activeElement.id === 'paths'")
        axes = page.evaluate("String(paths.axes)")
        page.key("ArrowRight")
        page.wait(f"String(paths.axes) !== {json.dumps(axes)}")
        page.tab_to("document.activeElement.tagName === 'SUMMARY'")
        self.assertEqual(page.evaluate("document.querySelectorAll('#paths g.lit').length"), 1)
        page.key("Tab")
        page.key("Enter", "\r")
        page.wait("document.querySelectorAll('#rays details')[1].open")

    def test_views_are_linked_turned_and_zoomed_by_the_mouse(self):
        self.make(GENERAL, pixel=("40", "32"))
        page = self.open()
        left, top, width, height = page.box("#rays > li:nth-child(2) summary")
        page.move(left + width / 2, top + height / 2)
        page.wait("document.querySelector('#paths g.lit')?.dataset.ray === '1'")
        page.click_on("#close-all")
        left, top, width, height = page.box("#paths")
        at = page.evaluate("""(() => {
            const ray = paths.rays[1];
            return paths.project(vec.scale(vec.add(numbers(ray.origin), paths.end(ray)), 0.5));
        })()""")
        page.move(left + at[0], top + at[1])
        page.wait("document.querySelector('#rays li.lit') !== null")
        axes = page.evaluate("String(paths.axes)")
        page.drag(left + 20, top + 20, left + 80, top + 40)
        page.wait(f"String(paths.axes) !== {json.dumps(axes)}")
        left, top, width, height = page.box("#render")
        before = page.evaluate("view.scale")
        page.wheel(left + width / 2, top + height / 2, -200)
        page.wait(f"Math.abs(view.scale / {before} - 2) < 1e-9")
        hash_before = page.evaluate("location.hash")
        place = page.evaluate("view.left")
        page.drag(left + width / 2, top + height / 2, left + width / 2 - 40, top + height / 2)
        page.wait(f"view.left === {place} - 40")
        self.assertEqual(page.evaluate("location.hash"), hash_before)

    def test_the_shares_of_rays_sum_to_the_pixel(self):
        for options in PROFILES.values():
            self.make(options)
            page = self.open()
            worst = page.evaluate("""Math.max(...pageData.pixels.map((pixel) => {
                const local = pixel.samples.flatMap((rays) => {
                    const paths = pathFactors(rays, pixel.samples.length);
                    const own = ["ambient", "diffuse", "specular", "background"];
                    return rays.map((ray, i) => sum(own.map((name) => shareOfPixel(ray[name], paths[i], pixel.radiance))));
                });
                return sum(pixel.radiance) === 0 ? 0 : Math.abs(sum(local) - 1);
            }))""")
            self.assertLess(worst, 1e-5)

    def test_a_hostile_name_stays_a_name(self):
        folder = pathlib.Path("<")
        folder.mkdir(exist_ok=True)
        name = "</script><img src=x onerror=document.title='out'>&amp;<!--\"' \\ {{data}}.pov"
        pathlib.Path(name).write_text(SCENE)
        self.make(GENERAL, scene=name)
        page = self.open()
        self.assertEqual(page.evaluate("byId('scene').textContent"), name)
        self.assertEqual(page.evaluate("document.images.length"), 1)
        command = shlex.split(page.evaluate("byId('pixel-command').textContent"))
        self.assertTrue(run(*command[1:]).stdout.startswith(b"Pixel: [41, 30]"))

    def test_a_name_that_is_no_utf8_survives(self):
        name = b"na\xefve'.pov"
        with open(name, "wb") as file:
            file.write(SCENE.encode())
        self.make(GENERAL, scene=name)
        page = self.open()
        self.assertEqual(page.evaluate("byId('scene').textContent"), "na\ufffdve'.pov")
        command = page.evaluate("byId('pixel-command').textContent").replace("raytrace", shlex.quote(PROGRAM), 1)
        text = subprocess.run(["bash", "-c", command], capture_output=True).stdout
        self.assertTrue(text.startswith(b"Pixel: [41, 30]"), command)

    def test_a_tree_too_large_says_so(self):
        data = self.make(["--profile=povray", "--grid=16"], scene="mirrors.pov")
        self.assertEqual(data["pixels"][0]["left_out"], 0)  # 251 rays: an asked pixel bears them
        cut = data["pixels"][1]
        self.assertEqual(len(cut["samples"][0]), 100)
        page = self.open(f"#{cut['x']},{cut['y']}")
        self.assertIn(f"{cut['left_out']} rays more of this pixel are not in the page: use --json.",
                      page.evaluate("byId('rays-note').textContent"))
        self.assert_shows(page, self.json_of(GENERAL, cut["x"], cut["y"], "mirrors.pov")["samples"][0][:100])
        self.assertIn(f"{cut['left_out']} rays more below", page.evaluate("byId('rays').lastElementChild.textContent"))

    def test_numbers_are_short_or_whole(self):
        self.make(GENERAL, pixel=("40", "32"))
        page = self.open()
        page.click_on("#rays > li summary")
        page.wait("document.querySelector('#rays .body') !== null")
        direction = "document.querySelector('[data-field=direction] data').textContent"
        short = page.evaluate(direction)
        page.click_on("#digits")
        page.wait(f"{direction} !== {json.dumps(short)}")
        self.assertEqual(float(page.evaluate(direction)), self.json_of(GENERAL, 40, 32)["samples"][0][0]["direction"][0])

    def test_legible_in_the_dark_and_at_400_percent(self):
        self.make(SAMPLED)
        grounds = []
        for scheme in ("light", "dark"):
            page = self.open(**{"prefers-color-scheme": scheme})
            page.resize(320, 256)  # 1280 x 1024 at 400 %
            page.click_on("#open-all")
            page.wait("document.querySelectorAll('#rays .body').length > 1")
            self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 320)
            grounds.append(page.evaluate("getComputedStyle(document.documentElement).backgroundColor"))
            self.assertGreater(page.least_contrast(), [4.5])
        self.assertNotEqual(*grounds)


if __name__ == "__main__":
    unittest.main()
