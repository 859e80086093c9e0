#!/usr/bin/env python3
"""A tiny gallery: every picture is there and shows something, the page refers to nothing else, and what goes wrong is reported.

usage: gallery_test.py PROGRAM
"""

import html.parser
import os
import re
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GALLERY = os.path.join(ROOT, "pov", "gallery")
PROGRAM = sys.argv.pop(1)


def gallery(*arguments, **settings):
    return subprocess.run([GALLERY, *arguments], **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **settings})


def small(folder, *arguments, **settings):
    """Pictures as small as can be."""
    return gallery(folder, "--size", "0.02", "--samples", "1", "--program", PROGRAM, *arguments, **settings)


def contents(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def script(path, text):
    with open(path, "w") as file:
        file.write("#!/bin/sh\n" + text)
    os.chmod(path, 0o755)


def chunks(data):
    """Those of a PNG file: pairs of type and content."""
    at = 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + content), kind
        yield kind, content
        at += length + 12


class References(html.parser.HTMLParser):
    """What a page refers to, and the text of each command in it."""

    def __init__(self):
        super().__init__()
        self.files, self.commands, self.open = [], [], []
        self.texts, self.words, self.styles, self.captions = [], "", [], {}

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "img"):
            self.open.append(tag)
        for key, value in attributes:
            if key in ("src", "href"):
                self.files.append(value)
            if key == "style":
                self.styles.append(value)
        if tag == "img":
            self.captions[dict(attributes)["src"]] = dict(attributes)["alt"]
        if tag == "details":
            self.commands.append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag + " closes something else"

    def handle_data(self, data):
        if self.open and self.open[-1] == "code" and "details" in self.open:
            self.commands[-1] += data
        elif self.open and self.open[-1] != "style":
            self.words += data + " "
        if self.open and self.open[-1] == "dt":
            self.texts.append(data)


class Gallery(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.run_ = gallery(cls.folder.name, "--size", "0.1", "--samples", "1", "--program", PROGRAM)
        cls.files = sorted(os.listdir(cls.folder.name))
        cls.page = References()
        if "index.html" in cls.files:
            with open(os.path.join(cls.folder.name, "index.html"), encoding="utf-8") as file:
                cls.page.feed(file.read())
        cls.pixels = cls.identify("%#", [name for name in cls.files if name.endswith(".png") and name != "motion.png"])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_succeeds_without_warnings(self):
        self.assertEqual((self.run_.returncode, self.run_.stderr), (0, ""))

    @classmethod
    def identify(cls, what, names):
        """What ImageMagick says of the pixels of each file."""
        run = subprocess.run(["identify", "-format", "%f " + what + "\n", *names], cwd=cls.folder.name, capture_output=True, text=True, check=True)
        return {words[0]: words[1:] for words in map(str.split, run.stdout.splitlines()) if words}

    def test_every_picture_shows_something(self):
        pictures = [name for name in self.files if name.endswith(".png")]
        self.assertGreater(len(pictures), 130)
        measured = self.identify("%[fx:mean] %[fx:standard_deviation]", pictures)
        self.assertEqual(sorted(measured), pictures)
        for name, (mean, deviation) in measured.items():
            self.assertTrue(0.01 < float(mean) < 0.95, name + " is black or white: mean " + mean)
            self.assertGreater(float(deviation), 0.01, name + " is uniform")

    def test_pictures_of_a_section_differ(self):
        counts = {"hall": 6, "demo": 30, "lamps": 4, "motion": 24, "terms": 27, "gooch": 5, "lamp": 4, "spot": 4, "metals": 2, "preset": 8}
        for section, count in counts.items():
            seen = {}
            for name, pixels in self.pixels.items():
                if name.startswith(section + "-"):
                    seen.setdefault(pixels[0], []).append(name)
            self.assertEqual(sum(map(len, seen.values())), count, section)
            # Lamps, which are points, have no share in a mirror, which has no other light.
            alike = [["demo-ct-both-mirror.png", "demo-ct-env-mirror.png"]] if section == "demo" else []
            self.assertEqual([names for names in seen.values() if len(names) > 1], alike)

    def test_variants_differ_from_the_default(self):
        variants = [name for name in self.pixels if name.endswith("-variant.png")]
        self.assertEqual(len(variants), 16)
        for name in variants:
            self.assertNotEqual(self.pixels[name], self.pixels[name.replace("-variant", "-default")], name)

    def test_film_shows_each_frame_for_a_tenth_of_a_second(self):
        frames, number, delays = [], 0, []
        for kind, content in chunks(contents(self.folder.name, "motion.png")):
            if kind == b"acTL":
                self.assertEqual(struct.unpack(">II", content), (24, 0))  # 0: for ever
            if kind in (b"fcTL", b"fdAT"):
                self.assertEqual(struct.unpack(">I", content[:4])[0], number)
                number += 1
            if kind == b"fcTL":
                self.assertEqual(struct.unpack(">IIII", content[4:20]), (40, 30, 0, 0))
                delays.append(struct.unpack(">HH", content[20:24]))
                frames.append(b"")
            if kind in (b"IDAT", b"fdAT"):
                frames[-1] += content if kind == b"IDAT" else content[4:]
        self.assertEqual([numerator / denominator for numerator, denominator in delays], [0.1] * 24)
        for i, frame in enumerate(frames):
            single = b"".join(content for kind, content in chunks(contents(self.folder.name, "motion-%02d.png" % i)) if kind == b"IDAT")
            self.assertEqual(zlib.decompress(frame), zlib.decompress(single), i)

    def test_tables_shrink_with_the_window(self):
        tables = [style for style in self.page.styles if "grid" in style]
        self.assertEqual(len(tables), 3)
        for style in tables:
            self.assertRegex(style, r"^grid-template-columns: repeat\(\d, minmax\(0, auto\)\)$")

    def test_texts_are_named_as_in_the_help_and_explained_once(self):
        run = subprocess.run([PROGRAM, "help", "shading"], capture_output=True, text=True, check=True)
        self.assertEqual(self.page.texts, sorted(set(re.findall(r"\bS\d\b", run.stdout))))
        self.assertLessEqual(set(re.findall(r"\bS\d\b", self.page.words)), set(self.page.texts))
        self.assertEqual(re.findall(r"(?i)\bdocuments? \d|\berrat[a-z]*|\bE\d+\b", self.page.words), [])
        self.assertEqual([name for name in self.files if re.search(r"\bE\d+\b", name)], [])

    def test_variants_say_whose_they_are(self):
        captions = {name: caption for name, caption in self.page.captions.items() if name.endswith("-variant.png")}
        self.assertEqual(len(captions), 16)
        for name, caption in captions.items():
            self.assertRegex(caption, r"^--.*: .*(\bS\d\b|in none of the five texts)", name)

    def test_page_refers_to_the_pictures_and_to_nothing_else(self):
        shown = [name for name in self.page.files if not name.startswith("#")]
        self.assertEqual(sorted(shown), [name for name in self.files if name != "index.html"])
        self.assertEqual(self.page.open, [])

    def test_each_picture_has_its_command(self):
        commands = [shlex.split(command) for command in self.page.commands]
        for words in commands:
            self.assertEqual((words[0], words[-2]), ("./raytrace", "-o"), words)
            self.assertTrue(os.path.exists(os.path.join(ROOT, words[1])), words)
        made = [os.path.basename(words[-1]) for words in commands]
        self.assertEqual(sorted(made), [name for name in self.files if name not in ("index.html", "motion.png")])


class Parts(unittest.TestCase):
    def run_only(self, section):
        """The line of each section, the files, and what the page shows."""
        with tempfile.TemporaryDirectory() as folder:
            run = small(folder, "--only", section)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            page = References()
            page.feed(contents(folder, "index.html").decode())
            return ([line.split()[0] for line in run.stdout.splitlines()[:-1]], sorted(os.listdir(folder)),
                    sorted(name for name in page.files if not name.startswith("#")))

    def test_a_section_alone(self):
        names = ["lamp-all.png", "lamp-parallel.png", "lamp-point.png", "lamp-spot.png"]
        self.assertEqual(self.run_only("lamps"), (["lamps"], ["index.html"] + names, names))

    def test_a_section_in_the_hall_alone(self):
        names = ["lamps-%s.png" % x for x in ("0-1", "0.4-2.5", "1-0", "1-1")]
        self.assertEqual(self.run_only("brightness"), (["brightness"], ["hall-%d.png" % i for i in range(6)] + ["index.html"] + names, names))

    def test_the_hall_alone(self):
        names = ["hall-%d.png" % i for i in range(6)]
        self.assertEqual(self.run_only("hall"), (["hall"], names + ["index.html"], names))

    def test_a_program_is_looked_for_in_the_current_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            script(os.path.join(folder, "mine"), "exec %s \"$@\"\n" % shlex.quote(PROGRAM))
            run = gallery("out", "--size", "0.02", "--only", "spots", "--program", "./mine", cwd=folder)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(len(os.listdir(os.path.join(folder, "out"))), 5)

    def test_the_composite_in_the_readme_is_what_the_gallery_makes(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "composite.png")
            run = gallery("--composite", file, "--program", PROGRAM)
            self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
            self.assertEqual(os.listdir(folder), ["composite.png"])
            reference = os.path.join(ROOT, "reference", "gallery.jpg")
            run = subprocess.run(["compare", "-metric", "RMSE", file, reference, "null:"], capture_output=True, text=True)
        self.assertLess(run.returncode, 2, run.stderr)
        self.assertLess(float(run.stderr.split("(")[1].rstrip(")")), 0.02, "pov/gallery --composite reference/gallery.jpg")


class Interruption(unittest.TestCase):
    """The program stands still until Ctrl-C, then leaves a partial picture as the real one does; left alone it ends with the whole one."""
    WAITS = ("for last; do :; done\ntrap 'touch \"${last%.png}.partial.png\"; exit 2' INT\ntouch \"$STARTED\"\n"
             "for i in $(seq 100); do sleep 0.05; done\ntouch \"$last\"\n")

    def interrupted(self, send):
        with tempfile.TemporaryDirectory() as folder:
            started, out = os.path.join(folder, "started"), os.path.join(folder, "out")
            script(os.path.join(folder, "waits"), self.WAITS)
            with subprocess.Popen([GALLERY, out, "--program", os.path.join(folder, "waits")], env=dict(os.environ, STARTED=started),
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
                                  preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as process:
                for _ in range(1000):
                    if os.path.exists(started):
                        break
                    time.sleep(0.01)
                send(process.pid, signal.SIGINT)
                _, messages = process.communicate()
            return process.returncode, messages, os.listdir(out)

    def test_of_the_gallery(self):
        self.assertEqual(self.interrupted(os.kill), (2, "gallery: interrupted\n", []))

    def test_of_all_that_the_terminal_runs(self):
        self.assertEqual(self.interrupted(os.killpg), (2, "gallery: interrupted\n", []))

    def test_has_its_status_in_the_help(self):
        self.assertIn("Exit status: 0 done, 1 something is wrong, 2 interrupted.", gallery("--help").stdout)


class Mistakes(unittest.TestCase):
    def test_a_program_that_fails_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            run = gallery(folder, "--program", "/bin/false")
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("surroundings.pov", run.stderr)
            self.assertEqual(os.listdir(folder), [])

    def test_a_program_that_is_not_there_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            run = gallery(folder, "--program", os.path.join(folder, "none"))
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("No such file", run.stderr)
            self.assertNotIn("Traceback", run.stderr)

    def test_a_folder_that_cannot_be_made_is_reported(self):
        run = gallery("/dev/null/gallery")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("/dev/null", run.stderr)
        self.assertNotIn("Traceback", run.stderr)

    def test_a_full_standard_output_is_reported(self):
        with tempfile.TemporaryDirectory() as folder, open("/dev/full", "w") as full:
            run = small(folder, "--only", "spots", stdout=full)
        self.assertEqual((run.returncode, run.stderr), (1, "gallery: standard output: No space left on device\n"))

    def test_a_closed_standard_output_is_reported(self):
        reader, writer = os.pipe()
        os.close(reader)
        with tempfile.TemporaryDirectory() as folder, os.fdopen(writer, "w") as pipe:
            run = small(folder, "--only", "spots", stdout=pipe)
        self.assertEqual((run.returncode, run.stderr), (1, "gallery: standard output: Broken pipe\n"))

    def test_a_page_that_does_not_fit_is_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "index.html")
            os.symlink("/dev/full", page)
            run = small(folder, "--only", "spots")
        self.assertEqual((run.returncode, run.stderr), (1, "gallery: %s: No space left on device\n" % page))

    def test_a_composite_that_cannot_be_written_is_reported(self):
        run = gallery("--composite", "/dev/null/x.png", "--size", "0.02", "--program", PROGRAM)
        self.assertEqual(run.returncode, 1)
        self.assertIn("gallery: /dev/null/x.png: ", run.stderr)

    def test_arguments_are_checked(self):
        for arguments in (["--size", "0"], ["--size", "x"], ["--samples", "0"], ["--only", "nothing"], ["--what"],
                          ["--composite", "x.png", "--only", "hall"], ["--composite", "x.png", "folder"]):
            run = gallery(*arguments)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertIn("gallery: ", run.stderr)


unittest.main()
