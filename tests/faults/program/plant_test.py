#!/usr/bin/env python3
"""Tests of plant.py: where faults come to stand in a text, and what is said of those that have no place."""
import unittest

from plant import Misplaced, planted


class Plant(unittest.TestCase):
    def test_the_expression_between_the_marks_is_asked_for(self):
        self.assertEqual(planted("a = b + c;", "f", [("x", "a = [[b + c]];", "0")]), "a = (planted(Fault::x) ? (0) : (b + c));")

    def test_faults_share_an_expression_in_their_order(self):
        changes = [("x", "[[b]];", "0"), ("y", "a = [[b]]", "1")]
        self.assertEqual(planted("a = b;", "f", changes), "a = (planted(Fault::x) ? (0) : ((planted(Fault::y) ? (1) : (b))));")

    def test_no_place_two_places_and_overlaps_are_refused(self):
        for text, changes in (
            ("a = b;", [("x", "[[c]]", "0")]),
            ("b b", [("x", "[[b]]", "0")]),
            ("a = b + c;", [("x", "[[b + c]]", "0"), ("y", "+ [[c]]", "0")]),
            ("a = b;", [("x", "b", "0")]),
        ):
            with self.assertRaisesRegex(Misplaced, "f: fault [xy]: "):
                planted(text, "f", changes)


if __name__ == "__main__":
    unittest.main()
