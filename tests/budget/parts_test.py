#!/usr/bin/env python3
"""Tests of what the budgets are judged by, with profiles made by hand. usage: tests/budget/parts_test.py"""
import collections
import pathlib
import unittest

import budget_test
import callgrind
import features

PROFILE = """\
events: Ir
ob=/usr/lib/libembree3.so.3
fl=/x/src/trace/recursion.cpp
fn=rtcIntersect1
0x10 5 1000
ob=/build/raytrace
fl=/elsewhere/src/trace/recursion.cpp
fn=rt::Recursion::pass()
0x20 90 7
fi=/elsewhere/src/shading/optics.h
0x28 23 5
0x2c 23 2
fe=/elsewhere/src/trace/recursion.cpp
0x30 91 3
cob=/usr/lib/libm.so.6
cfn=pow
calls=4 0x100 0
0x34 92 500
fl=/usr/include/c++/12/bits/stl_vector.h
fn=std::vector<int>::size()
0x40 7 11
fl=/elsewhere/src/patterns/checker.h
fn=_GLOBAL__sub_I_checker
0x50 12 2
"""


def by_scene(lines):
    """Profiles in which each scene runs `lines`, a dictionary by scene's name."""
    return {name: callgrind.Profile(0, 0, lines.get(name, {})) for name in features.SCENES}


def all_lines(places):
    """Every line of the places, with one address each."""
    lines = {}
    for place in places:
        file, _, name = place.partition(":")
        text = (features.ROOT / "src" / file).read_text()
        for line in features.function_lines(text, name) if name else range(1, text.count("\n")):
            lines.setdefault(file, {})[line] = {line}
    return lines


class Profiles(unittest.TestCase):
    def test_only_the_programs_own_code_counts(self):
        lines = collections.defaultdict(lambda: collections.defaultdict(set))
        self.assertEqual(callgrind.read(PROFILE, "/build/raytrace", lines), 7 + 5 + 2 + 3 + 11 + 2)
        self.assertEqual({file: dict(of) for file, of in lines.items()},
                         {"trace/recursion.cpp": {90: {0x20}, 91: {0x30}}, "shading/optics.h": {23: {0x28, 0x2C}}})


class Functions(unittest.TestCase):
    TEXT = "int once(int x);\nint once(int x) {\n    return twice(x);  // } \n}\nint twice(\n    int x) const {\n    return x;\n}\n"

    def test_the_body_is_found_and_calls_are_not(self):
        self.assertEqual(features.function_lines(self.TEXT, "once"), {2, 3, 4})
        self.assertEqual(features.function_lines(self.TEXT, "twice"), {5, 6, 7, 8})
        self.assertEqual(features.function_lines(self.TEXT, "wice"), set())

    def test_every_place_is_in_the_sources(self):
        for places in features.FEATURES.values():
            for place in places:
                self.assertIsNotNone(features.entered(place, {}))
        with self.assertRaisesRegex(ValueError, "^shading/optics.h:bend: the file has no such function$"):
            features.entered("shading/optics.h:bend", {})
        with self.assertRaisesRegex(ValueError, "^shading/optic.h: there is no such file$"):
            features.entered("shading/optic.h", {})


class Features(unittest.TestCase):
    def own(self):
        """Each scene runs the code of its own features."""
        return {name: all_lines([p for f in having for p in features.FEATURES[f]]) for name, (_, _, having) in features.SCENES.items()}

    def test_scenes_that_run_their_own_code_are_right(self):
        self.assertEqual(features.faults(by_scene(self.own()), lambda address: False), [])

    def test_code_of_another_feature_is_told(self):
        lines = self.own()
        lines["plain"] = {"patterns/checker.h": {13: {1}}}
        self.assertEqual(features.faults(by_scene(lines), lambda address: False),
                         ["scene plain has no patterns, but enters patterns/checker.h (lines 13)"])
        self.assertEqual(features.faults(by_scene(lines), lambda address: True), [])

    def test_a_place_that_nothing_enters_is_told(self):
        lines = self.own()
        del lines["checker"]
        self.assertEqual(features.faults(by_scene(lines), lambda address: False),
                         ["patterns/checker.h stands for patterns, but no scene with it enters it: the test could not fail"])


class Budgets(unittest.TestCase):
    def test_limits(self):
        budget = {"start": 1000, "plain": 1000}
        self.assertEqual(budget_test.over_budget({"start": 1100, "plain": 1010}, budget), [])
        self.assertEqual(budget_test.over_budget({"start": 950, "plain": 950}, budget), [])
        self.assertEqual(budget_test.over_budget({"start": 1101, "plain": 1011}, budget),
                         ["start: 1101 instructions, +10.1% on the budget of 1000", "plain: 1011 instructions, +1.1% on the budget of 1000"])
        self.assertEqual(budget_test.over_budget({"plain": 949, "new": 5}, budget),
                         ["plain: 949 instructions, -5.1% on the budget of 1000: better, so the budget hides what comes back",
                          "new: no budget is recorded"])

    def test_what_an_empty_scene_takes_is_the_start(self):
        profiles = {"empty": callgrind.Profile(100, 3, {}), "plain": callgrind.Profile(120, 50, {})}
        self.assertEqual(budget_test.figures(profiles), {"start": 100, "plain": 70})

    def test_every_scene_has_its_file(self):
        for scene, _, _ in features.SCENES.values():
            self.assertTrue(pathlib.Path(budget_test.HERE, "scenes", f"{scene}.pov").exists())


if __name__ == "__main__":
    unittest.main()
