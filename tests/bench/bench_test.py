#!/usr/bin/env python3
"""Tests of the benchmark's own parts: what programs tell is read right, figures of different pictures are not set beside each other, the
generated scenes are the same in both languages, reports are whole. Nothing is timed. usage: bench_test.py PROGRAM"""
import pathlib
import re
import shutil
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import growth
import machine
import measure
import plots
import programs
import readme
import scenes
import svg
import tables

BUILD = pathlib.Path("build")


def run_of(trace, wall=2.0, rays=None, peak=None):
    return programs.Run({"parse": 0.1, "build": 0.2, "trace": trace, "write": 0.01}, wall=wall, cpu=wall, peak=peak, rays=rays)


def measured(threads=1, differing=0, seconds=1.0, peak=10**8):
    runs = {"raytrace": [run_of(seconds * t, rays=1000, peak=peak) for t in (1.0, 2.0)], "povray": [run_of(4.0, 8.0), run_of(5.0, 8.0)],
            "floor": [programs.Run({"parse": None, "build": 0.1, "trace": 0.5, "write": None}, rays=1000)] * 2}
    figures = {"differing_1": differing, "differing_0": differing, "pixels": 1000, "flip": {"mean": 0.0}}
    return measure.Measured("scene", 40, 30, threads, runs, {"raytrace": figures})


def result():
    step = growth.Step("spheres", 10**5, 10**6, measured(), {"raytrace": 250.0})
    facts = {"date": "2026-01-31", "processor": "a processor", "cores": 2, "busy": 0.5, "instruction_sets": "AVX2", "code": {"raytrace": "SSE2"},
             "compiler": "c++ 12", "povray": "3.7.0", "tachyon": ""}
    return {"machine": facts, "notes": ["Tachyon is not installed."], "runs": 2, "peers": [measured(1), measured(2, seconds=0.5)],
            "growth": {"spheres": [step], "mesh2": []}, "course": [], "start_up": "3"}


class WhatProgramsTell(unittest.TestCase):
    def test_raytrace(self):
        text = ("time: parse 0.0242 s, build 0.0531 s, trace 1.2500 s, write 0.0210 s\nrays:\n  camera   100  1.0 M/s\n  all           457  1.1 M/s\n"
                "memory: peak 23.6 MB\n")
        told = programs.Raytrace.told(text)
        self.assertEqual(told, {"phases": {"parse": 0.0242, "build": 0.0531, "trace": 1.25, "write": 0.021}, "rays": 457, "peak": 23600000})

    def test_povray(self):
        text = ("  Parse Time:       0 hours  0 minutes  6 seconds (6.371 seconds)\n   using 1 thread(s) with 1.703 CPU-seconds total\n"
                "  Bounding Time:    0 hours  0 minutes 12 seconds (12.039 seconds)\n  Photon Time:      No photons\n"
                "  Trace Time:       0 hours  0 minutes  0 seconds (0.287 seconds)\n")
        self.assertEqual(programs.Povray.told(text)["phases"], {"parse": 6.371, "build": 12.039, "trace": 0.287, "write": None})

    def test_tachyon(self):
        text = ("Scene Parsing Time:     1.5747 seconds\nPreprocessing Time:     1.2434 seconds\nRendering Progress:       100% complete     \n"
                "  Ray Tracing Time:     5.1241 seconds\n    Image I/O Time:     0.0098 seconds\n")
        self.assertEqual(programs.Tachyon.told(text)["phases"], {"parse": 1.5747, "build": 1.2434, "trace": 5.1241, "write": 0.0098})

    def test_embree(self):
        told = programs.Floor.told("0.364862 307200 149292 0.001234\n")
        self.assertEqual(told, {"phases": {"parse": None, "build": 0.001234, "trace": 0.364862, "write": None}, "rays": 456492})
        text = "  Config\n    Targets : SSE SSE2 AVX AVX2 AVX512  (supported)\n              SSE2 SSE4.2 AVX AVX2  (compile time enabled)\n"
        self.assertEqual(machine.embree_set(text), "AVX2")


class Figures(unittest.TestCase):
    def test_ratios_are_taken_run_by_run(self):
        self.assertEqual(measured().ratios("raytrace", "povray", "trace"), [0.25, 0.4])
        self.assertEqual(measured().ratios("raytrace", "floor", "per_ray"), [2.0, 4.0])

    def test_different_pictures_have_no_ratio(self):
        self.assertTrue(measured(differing=10).same("raytrace"))
        self.assertFalse(measured(differing=11).same("raytrace"))
        self.assertEqual(measured(differing=11).ratios("raytrace", "povray", "trace"), [])

    def test_a_program_that_counts_no_rays_has_those_of_its_picture(self):
        self.assertEqual(measured().values("povray", "per_ray"), [0.004, 0.005])

    def test_memory_of_a_primitive(self):
        self.assertEqual(growth.bytes_each(measured(peak=5 * 10**7), measured(peak=2 * 10**7), 10**5), {"raytrace": 300.0})
        self.assertEqual(growth.bytes_each(measured(peak=5 * 10**7), measured(peak=2 * 10**7), 10**4), {})


class Scenes(unittest.TestCase):
    def test_both_languages_have_the_same_spheres(self):
        with tempfile.TemporaryDirectory() as folder:
            pov, twin = pathlib.Path(folder, "a.pov"), pathlib.Path(folder, "a.dat")
            scenes.spheres(50, 64, 48, pov, twin)
            ours = re.findall(r"sphere { <(\S+), (\S+), (\S+)>, (\S+) }", pov.read_text())
            theirs = re.findall(r"SPHERE CENTER (\S+) (\S+) (\S+) RAD (\S+) matte", twin.read_text())
        self.assertEqual(len(ours), 50)
        self.assertEqual(ours, theirs)

    def test_a_mesh_has_as_many_triangles_as_asked(self):
        with tempfile.TemporaryDirectory() as folder:
            pov = pathlib.Path(folder, "a.pov")
            scenes.mesh(1000, pov)
            text = pov.read_text()
        vertices = re.findall(r"<-?[0-9.]+,-?[0-9.]+,-?[0-9.]+>", text.split("face_indices")[0].split("mesh2")[1])
        faces = re.findall(r"<(\d+),(\d+),(\d+)>", text.split("face_indices")[1])
        self.assertEqual((len(vertices), len(faces)), (21 * 26, 1000))
        self.assertIn(f"vertex_vectors {{ {21 * 26}", text)
        self.assertEqual({int(i) for face in faces for i in face}, set(range(21 * 26)))

    @unittest.skipUnless(shutil.which("tachyon"), "Tachyon is not installed (Debian package tachyon)")
    def test_tachyon_makes_the_same_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            job = programs.Job(folder / "a.pov", 160, 120, 1, folder, twin=folder / "a.dat", linear=True)
            scenes.spheres(300, job.width, job.height, job.scene, job.twin)
            same = measure.measure(BUILD, [programs.Raytrace(BUILD), programs.Tachyon()], job, 0)
        # Not the silhouettes' rounding, but for a few pixels; values are cut to bytes and not rounded.
        self.assertLess(same.pictures["tachyon"]["differing_1"], 0.001 * 160 * 120)


class Reports(unittest.TestCase):
    def test_markdown_tables_are_rectangles(self):
        for text in (tables.report(result()), tables.summary(result())):
            for block in re.findall(r"(?:^\|.*\n)+", text, re.M):
                self.assertEqual(len({line.count("|") for line in block.splitlines()}), 1, block)
            self.assertIn("| scene | 40x30 | 1 |", text)
            self.assertIn("shared with other work (50% busy", text)
        self.assertIn("Tachyon is not installed.", tables.report(result()))

    def test_pictures_are_xml(self):
        for text in (plots.ratios(result()["peers"]), plots.growth(result()["growth"]), plots.ratios([])):
            self.assertTrue(xml.etree.ElementTree.fromstring(text.encode()).tag.endswith("svg"))

    def test_curves_stand_where_their_numbers_are(self):
        text = svg.curves(svg.Frame(0, 0, 100, 100), "t", "x", "y", [("a", "#000", [(10, 1), (1000, 100), (100, 10)])])
        self.assertIn('points="0.0,100.0 50.0,50.0 100.0,0.0"', text)

    def test_the_readme_keeps_the_rest(self):
        page = f"before\n{readme.BEGIN}\nold\n{readme.END}\nafter\n"
        self.assertEqual(readme.replaced(page, "new\n"), f"before\n{readme.BEGIN}\n\nnew\n\n{readme.END}\nafter\n")
        self.assertEqual(readme.replaced(readme.replaced(page, "a"), "b"), readme.replaced(page, "b"))
        for broken in ("", readme.BEGIN, f"{readme.END} {readme.BEGIN}", page + readme.END):
            with self.assertRaises(ValueError):
                readme.replaced(broken, "new")

    def test_the_readme_has_the_place(self):
        page = (pathlib.Path(__file__).resolve().parents[2] / "README.md").read_text()
        self.assertIn("new table", readme.replaced(page, "new table"))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        BUILD = pathlib.Path(sys.argv.pop(1)).resolve().parent
    unittest.main()
