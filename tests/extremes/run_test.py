#!/usr/bin/env python3
"""What tests/extremes/run and its programs say when something is wrong: a build that fails, a folder that cannot be written.

usage: run_test.py EXTREMES_PAGE GEOMETRY_PAGE
"""

import os
import subprocess
import sys
import tempfile
import unittest

FOLDER = os.path.dirname(os.path.abspath(__file__))
PAGES = {sys.argv.pop(1): "index.html", sys.argv.pop(1): "geometry.html"}


class Run(unittest.TestCase):
    def test_a_build_that_fails_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            cmake = os.path.join(folder, "cmake")
            with open(cmake, "w") as file:
                file.write("#!/bin/sh\n[ \"$1\" != --build ] || { echo 'page.cpp:7: error: such'; exit 1; }\n")
            os.chmod(cmake, 0o755)
            run = subprocess.run([os.path.join(FOLDER, "run")], capture_output=True, text=True,
                                 env=dict(os.environ, PATH=folder + os.pathsep + os.environ["PATH"]))
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn("page.cpp:7: error: such", run.stderr)


class Page(unittest.TestCase):
    def test_a_page_that_cannot_be_written_is_told_before_the_work(self):
        for program, page in PAGES.items():
            with tempfile.TemporaryDirectory() as folder:
                os.mkdir(os.path.join(folder, page))
                run = subprocess.run([program, folder], capture_output=True, text=True)
                self.assertEqual((run.returncode, run.stdout), (3, ""))
                self.assertIn(os.path.join(folder, page), run.stderr)

    def test_a_folder_that_cannot_be_made_is_told_before_the_work(self):
        for program in PAGES:
            run = subprocess.run([program, "/dev/null/page"], capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stdout), (3, ""))
            self.assertIn("/dev/null/page", run.stderr)

    def test_arguments_are_checked(self):
        for program in PAGES:
            run = subprocess.run([program], capture_output=True, text=True)
            self.assertEqual(run.returncode, 2)
            self.assertIn(f"usage: {os.path.basename(program)} FOLDER", run.stderr)


unittest.main()
