#!/usr/bin/env python3
"""What a suite cannot notice: right answers with one mistake each, judged by the suite's own rule.

usage: tests/grade/audit_test.py PROGRAM
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import harness  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))


class Audit(unittest.TestCase):
    def setUp(self):
        self.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_audit_"))

    def tearDown(self):
        shutil.rmtree(self.place)

    def audited(self, **rule):
        suite = harness.make_suite(PROGRAM, self.place, **rule)
        run = subprocess.run([PROGRAM, "grade", suite, "--audit", "-o", self.place / "out"], capture_output=True, text=True, check=True)
        content = json.loads((self.place / "out" / "audit.json").read_text())
        return run.stdout, {line["mistake"]: line for line in content["mistakes"]}

    def test_the_courses_rule_is_blind_to_much(self):
        text, lines = self.audited()
        self.assertEqual(lines["mirrored"]["noticed"], 2)
        self.assertEqual(lines["without shadows"]["blind"], ["plain", "smooth"])  # they fall on fewer than 1,000 pixels
        self.assertEqual(lines["one digit changed"]["noticed"], 2)
        self.assertEqual(lines["5 % darker"]["blind"], ["plain", "smooth"])
        self.assertEqual(lines["without anti-aliasing"]["blind"], ["smooth"])
        self.assertIn("5 % darker                 0 of   2 tests notice it; blind: plain smooth\n", text)

    def test_a_tighter_rule_notices(self):
        _, lines = self.audited(**{"pass": [{"metric": "rmse", "at_most": 0.001}]})
        for mistake in lines.values():
            self.assertEqual(mistake["blind"], [], mistake["mistake"])
            self.assertGreater(mistake["noticed"], 0, mistake["mistake"])

    def test_digits_within_a_tolerance_are_not_noticed(self):
        _, lines = self.audited(tolerance=0.01)
        self.assertEqual(lines["one digit changed"]["blind"], ["ray", "color"])

    def test_a_mistake_that_no_test_has_is_called_so(self):
        suite = harness.make_suite(PROGRAM, self.place)
        run = subprocess.run([PROGRAM, "grade", suite, "--audit", "--only", "ray|color", "-o", self.place / "out"], capture_output=True, text=True,
                             check=True)
        self.assertIn("without anti-aliasing      no test has it\n", run.stdout)
        self.assertNotIn("of   0", run.stdout)

    def test_a_broken_answer_is_told_with_its_test_and_file(self):
        suite = harness.make_suite(PROGRAM, self.place)
        answer = self.place / "suite" / "answers" / "smooth.png"
        answer.write_bytes(b"\x89PNG no more")
        run = subprocess.run([PROGRAM, "grade", suite, "--audit", "-o", self.place / "out"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn(f"test 'smooth': the expected picture: Cannot read '{answer}'", run.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
