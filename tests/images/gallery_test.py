#!/usr/bin/env python3
"""A tiny gallery: every picture is there and shows something, the page refers to nothing else, and what goes wrong is reported.

usage: gallery_test.py PROGRAM
"""

import html.parser
import os
import shlex
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GALLERY = os.path.join(ROOT, "pov", "gallery")
PROGRAM = sys.argv.pop(1)


def gallery(*arguments):
    return subprocess.run([GALLERY, *arguments], capture_output=True, text=True)


class References(html.parser.HTMLParser):
    """What a page refers to, and the text of each command in it."""

    def __init__(self):
        super().__init__()
        self.files, self.commands, self.open = [], [], []

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "img"):
            self.open.append(tag)
        for key, value in attributes:
            if key in ("src", "href"):
                self.files.append(value)
        if tag == "details":
            self.commands.append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag + " closes something else"

    def handle_data(self, data):
        if self.open and self.open[-1] == "code" and "details" in self.open:
            self.commands[-1] += data


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

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_succeeds_without_warnings(self):
        self.assertEqual((self.run_.returncode, self.run_.stderr), (0, ""))

    def identify(self, what, names):
        """What ImageMagick says of the pixels of each file."""
        run = subprocess.run(["identify", "-format", "%f " + what + "\n", *names], cwd=self.folder.name, capture_output=True, text=True, check=True)
        return {words[0]: words[1:] for words in map(str.split, run.stdout.splitlines()) if words}

    def test_every_picture_shows_something(self):
        pictures = [name for name in self.files if name.endswith(".png")]
        self.assertGreater(len(pictures), 130)
        measured = self.identify("%[fx:mean] %[fx:standard_deviation]", pictures)
        self.assertEqual(sorted(measured), pictures)
        for name, (mean, deviation) in measured.items():
            self.assertTrue(0.01 < float(mean) < 0.95, name + " is black or white: mean " + mean)
            self.assertGreater(float(deviation), 0.01, name + " is uniform")

    def test_variants_differ_from_the_default(self):
        pixels = self.identify("%#", [name for name in self.files if name.startswith("variant-")])
        self.assertGreater(len(pixels), 20)
        for name in pixels:
            if name.endswith("-variant.png"):
                self.assertNotEqual(pixels[name], pixels[name.replace("-variant", "-default")], name)

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

    def test_arguments_are_checked(self):
        for arguments in (["--size", "0"], ["--size", "x"], ["--samples", "0"], ["--only", "nothing"], ["--what"]):
            self.assertEqual(gallery(*arguments).returncode, 2, arguments)


unittest.main()
