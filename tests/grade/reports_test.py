#!/usr/bin/env python3
"""Reports of a grading with every kind of result and the strangest names and texts, read by other parsers than the program's own, and held
against what their readers document: JUnit's common subset, Gradescope's results.json, CSV, pages. The same results are the same bytes.

usage: tests/grade/reports_test.py PROGRAM
"""
import csv
import html.parser
import io
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
import xml.parsers.expat

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import harness  # noqa: E402

PROGRAM = os.path.abspath(sys.argv.pop(1))
MARK = f"reported-{os.getpid()}"
REPLACED = "\ufffd"
CUT = 16384  # bytes that are kept of what a program prints

# name: what its `raytrace` does
PROGRAMS = {
    "right": 'exec "$real" "$@"',
    "dark": '"$real" "$@"; [ "$1" = render ] && /usr/bin/convert output.png -negate output.png',
    "crash": "kill -SEGV $$",
    "late": "while :; do :; done",
    "exit": '"$real" "$@"; exit 3',
    "nothing": "exit 0",
    "flood": "yes éééé",
    "no picture": "echo '<b>&amp;\"' > output.png; exit 0",
    "small": '"$real" "$@"; [ "$1" = render ] && /usr/bin/convert output.png -resize 50% output.png',
    "cut": f"head -c {CUT - 1} /dev/zero | tr '\\0' x; printf 'é'",
    "bytes": "printf 'a\\377\\376\\000\\001\\033]0;x\\007 \\355\\240\\200 \\357\\277\\276 <b>&\"]]>\\r\\n\\302'",
    "=formula, \"quoted\"": "printf '=1+1,\"x\"\\n@x'",
    "<i>& 'é' \u202e\u0085\n\033[31m": "echo '</script><script>alert(1)</script>'",
}
TESTS = [("ray", "text", {}), ("color", "text", {"required": False, "weight": 0.1}), ("plain", "picture", {"weight": 3}),
         ("smooth", "picture", {"credit": {"metric": "rmse", "curve": [[0.0, 1.0], [0.7, 0.0]]}})]

VISIBILITIES = ("hidden", "after_due_date", "after_published", "visible")
FORMATS = ("text", "html", "simple_format", "md", "ansi")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value == value and abs(value) != float("inf")


def is_text(value):
    return isinstance(value, str)


# https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format"
GRADESCOPE = {
    "score": is_number,
    "execution_time": is_number,
    "output": is_text,
    "output_format": lambda value: value in FORMATS,
    "test_output_format": lambda value: value in FORMATS,
    "test_name_format": lambda value: value in FORMATS,
    "visibility": lambda value: value in VISIBILITIES,
    "stdout_visibility": lambda value: value in VISIBILITIES,
    "extra_data": lambda value: isinstance(value, dict),
    "tests": lambda value: isinstance(value, list),
    "leaderboard": lambda value: isinstance(value, list),
}
GRADESCOPE_TEST = {
    "score": is_number,
    "max_score": is_number,
    "status": lambda value: value in ("passed", "failed"),
    "name": is_text,
    "name_format": lambda value: value in FORMATS,
    "number": is_text,
    "output": is_text,
    "output_format": lambda value: value in FORMATS,
    "tags": lambda value: isinstance(value, list) and all(map(is_text, value)),
    "visibility": lambda value: value in VISIBILITIES,
    "extra_data": lambda value: isinstance(value, dict),
}

FAILURES = ("wrong answer", "wrong size", "no output")
SKIPPED = ("not run",)


def strict(text):
    """JSON as its standard has it: no NaN, no member twice, no lone surrogate."""
    def members(pairs):
        if len({name for name, _ in pairs}) != len(pairs):
            raise AssertionError("a member twice")
        return dict(pairs)

    def refuse(constant):
        raise AssertionError(constant)
    content = json.loads(text, object_pairs_hook=members, parse_constant=refuse)
    json.dumps(content, ensure_ascii=False).encode()
    return content


def in_xml(text):
    """What XML 1.0 can hold of a text, the rest as '?'."""
    return re.sub("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "?", text)


class Data(html.parser.HTMLParser):
    """The element of a page with the id "data"."""

    def __init__(self, text):
        super().__init__()
        self.inside, self.text = False, ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.inside = dict(attributes).get("id") == "data"

    def handle_endtag(self, tag):
        self.inside = False

    def handle_data(self, data):
        if self.inside:
            self.text += data


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp(prefix="grade_reports_"))
        cls.place.chmod(0o755)
        cls.suite = harness.make_suite(PROGRAM, cls.place, timeout=2)
        content = json.loads(cls.suite.read_text())
        content["name"] = "Winter <1> & \"é\""
        for entry, (name, kind, more) in zip(content["tests"], TESTS):
            assert (entry["name"], entry["kind"]) == (name, kind)
            entry.update(more)
        content["tests"][1]["name"] = "colour <é>\u0007\u2028"
        content["tests"].append({"name": "own", "kind": "shown", "command": "render own.pov 64 48"})
        cls.suite.write_text(json.dumps(content))
        cls.homework = cls.place / "homework"
        for name, script in PROGRAMS.items():
            harness.make_program(PROGRAM, cls.homework / name, script)
        (cls.homework / "right" / "own.pov").write_text(harness.SCENE)
        (cls.homework / "empty").mkdir()
        cls.words = ["--submissions", cls.homework, "-j", "2"]
        _, cls.results = harness.grade(PROGRAM, cls.suite, cls.place / "out", *cls.words, check=0)
        # Whoever's build never ends is not run, once it is interrupted.
        (cls.homework / "zz").mkdir()
        (cls.homework / "zz" / "Makefile").write_text(f"raytrace:\n\tsh -c 'while :; do sleep 1; done # {MARK}.'\n")
        cls.interrupt()
        shutil.rmtree(cls.homework / "zz")
        cls.single = cls.place / "single"
        harness.grade(PROGRAM, cls.suite, cls.single, "--exe", cls.homework / "bytes", check=1)

    @classmethod
    def interrupt(cls):
        out = cls.place / "interrupted"
        shutil.copytree(cls.place / "out" / "known", out / "known")
        run = subprocess.Popen([PROGRAM, "grade", cls.suite, "-o", out, *cls.words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env={**os.environ, "TMPDIR": str(cls.place / "scratch")})
        end = time.monotonic() + 120
        while run.poll() is None and time.monotonic() < end:
            if any(f"{MARK}.".encode() in cls.command_of(process) for process in pathlib.Path("/proc").glob("[0-9]*")):
                run.send_signal(signal.SIGINT)
                break
        run.communicate()
        assert run.returncode == 2, run.returncode

    @staticmethod
    def command_of(process):
        try:
            return (process / "cmdline").read_bytes()
        except (FileNotFoundError, ProcessLookupError):
            return b""

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.place)

    def folders(self):
        return self.place / "out", self.place / "interrupted", self.single

    def test_there_is_every_outcome_that_a_program_can_have(self):
        outcomes = {result["outcome"] for folder in self.folders() for result in harness.read_results(folder).values()}
        self.assertEqual(outcomes, {"passed", "wrong answer", "wrong size", "no output", "unreadable output", "non-zero exit", "signal",
                                    "time-out", "too much output", "not started", "shown", "not run"})

    def test_junit_is_the_common_subset(self):
        for folder in self.folders():
            with self.subTest(folder.name):
                self.check_junit((folder / "junit.xml").read_bytes(), harness.read_results(folder), json.loads((folder / "times.json").read_text()))

    def check_junit(self, text, results, times):
        self.assertTrue(text.startswith(b'<?xml version="1.0" encoding="UTF-8"?>\n'))
        xml.parsers.expat.ParserCreate().Parse(text, True)
        root = xml.etree.ElementTree.fromstring(text)
        self.assertEqual((root.tag, root.get("name")), ("testsuites", "Winter <1> & \"é\""))
        counts = ("tests", "failures", "errors", "skipped")
        self.assertEqual(set(root.attrib), {"name", "time", *counts})
        seconds = {(entry["submission"], entry["test"]): entry["wall"] for entry in times["times"]}
        seen = []
        for suite in root:
            self.assertEqual((suite.tag, set(suite.attrib)), ("testsuite", {"name", "time", *counts}))
            self.assertEqual(suite[0].tag, "properties")
            for entry in suite[0]:
                self.assertEqual((entry.tag, set(entry.attrib)), ("property", {"name", "value"}))
            cases = suite[1:]
            kinds = [self.check_case(case, suite.get("name"), results, seconds, seen) for case in cases]
            expected = {"tests": len(cases), **{count: kinds.count(kind) for count, kind in zip(counts[1:], ("failure", "error", "skipped"))}}
            self.assertEqual({count: int(suite.get(count)) for count in counts}, expected)
            self.assertAlmostEqual(float(suite.get("time")), sum(float(case.get("time")) for case in cases), delta=0.0006 * (len(cases) + 1))
        self.assertEqual(seen, [(in_xml(program), in_xml(test)) for program, test in results], "each result once, in their order")
        for count in counts:
            self.assertEqual(int(root.get(count)), sum(int(suite.get(count)) for suite in root))
        self.assertAlmostEqual(float(root.get("time")), sum(float(suite.get("time")) for suite in root), delta=0.0006 * (len(root) + 1))

    def check_case(self, case, suite, results, seconds, seen):
        """Returns the element that says what is wrong, or None."""
        self.assertEqual((case.tag, set(case.attrib)), ("testcase", {"classname", "name", "time"}))
        self.assertEqual(case.get("classname"), suite)
        key = next(key for key in results if (in_xml(key[0]), in_xml(key[1])) == (case.get("classname"), case.get("name")))
        seen.append((case.get("classname"), case.get("name")))
        result = results[key]
        self.assertRegex(case.get("time"), r"^\d+\.\d{3}$")
        self.assertAlmostEqual(float(case.get("time")), seconds[key], delta=0.0006)
        inner = {element.tag: element for element in case}
        self.assertEqual(len(inner), len(case))
        self.assertLessEqual(set(inner), {"failure", "error", "skipped", "system-out"})
        outcome = result["outcome"]
        expected = (None if outcome in ("passed", "shown") else "skipped" if outcome in SKIPPED else "failure" if outcome in FAILURES else "error")
        self.assertEqual([tag for tag in inner if tag != "system-out"], [expected] if expected else [])
        if expected in ("failure", "error"):
            self.assertEqual(set(inner[expected].attrib), {"type", "message"})
            self.assertEqual(inner[expected].get("type"), outcome)
            self.assertTrue(inner[expected].get("message").startswith(in_xml(result["reason"])))
        if "output" in result:
            self.assertEqual(inner["system-out"].text, in_xml(result["output"]))
        return expected

    def test_gradescope_is_what_it_documents(self):
        files = [self.single / "gradescope.json"]
        for folder in self.folders()[:2]:
            programs = sorted({program for program, _ in harness.read_results(folder)})
            found = sorted((folder / "gradescope").iterdir())
            self.assertEqual([path.name for path in found], sorted(f"{program}.json" for program in programs))
            files += found
        for path in files:
            with self.subTest(path):
                program = "bytes" if path.parent == self.single else path.stem
                results = {test: result for (name, test), result in harness.read_results(self.single if path.parent == self.single
                                                                                         else path.parents[1]).items() if name == program}
                self.check_gradescope(strict(path.read_bytes()), results)

    def check_gradescope(self, content, results):
        self.check_members(content, GRADESCOPE)
        for entry in content["tests"]:
            self.check_members(entry, GRADESCOPE_TEST)
        judged = {test: result for test, result in results.items() if result["kind"] != "shown"}
        self.assertEqual([entry["name"] for entry in content["tests"]], list(judged))
        for entry, result in zip(content["tests"], judged.values()):
            self.assertEqual(entry["status"], "passed" if result["outcome"] == "passed" else "failed")
            self.assertAlmostEqual(entry["score"], result["credit"] * result["weight"])
            self.assertEqual(entry["max_score"], result["weight"])
            self.assertIn(result["outcome"], entry["output"])
            self.assertIn(result.get("explanation", ""), entry["output"])
        self.assertAlmostEqual(content["score"], sum(entry["score"] for entry in content["tests"]))

    def check_members(self, content, documented):
        self.assertLessEqual(set(content), set(documented))
        for name, value in content.items():
            self.assertTrue(documented[name](value), f"{name}: {value!r}")

    def test_csv_has_a_line_for_each_result(self):
        for folder in self.folders():
            text = (folder / "results.csv").read_bytes().decode()
            rows = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
            results = harness.read_results(folder)
            self.assertEqual(len(rows), len(results))
            for row, ((program, test), result) in zip(rows, results.items()):
                self.assertNotIn(None, row)
                self.assertFalse(any(value.startswith(("=", "@", "+", "-")) for value in row.values()), row)
                shown = re.sub("[\0-\x08\x0b\x0c\x0e-\x1f\x7f]", "?", program)
                self.assertEqual(row["submission"], "'" + shown if program.startswith("=") else shown)
                self.assertEqual((row["outcome"], row["kind"]), (result["outcome"], result["kind"]))
                self.assertEqual(float(row["credit"]), result["credit"])

    def test_pages_are_html_with_one_text_of_json(self):
        pages = [path for folder in self.folders() for path in folder.rglob("*.html")]
        self.assertGreater(len(pages), len(PROGRAMS))
        for path in pages:
            content = strict(Data(path.read_bytes().decode()).text)
            self.assertIn("rows", content)

    def test_no_character_is_cut_in_two_and_other_bytes_are_replaced(self):
        results = self.results
        self.assertEqual(results["cut", "ray"]["output"], "x" * (CUT - 1))
        flood = results["flood", "ray"]["output"]
        self.assertEqual(flood, ("éééé\n" * CUT).encode()[:len(flood.encode())].decode())
        self.assertIn(len(flood.encode()), (CUT - 1, CUT))
        self.assertEqual(results["bytes", "ray"]["output"],
                         f"a{REPLACED * 2}\0\1\033]0;x\7 {REPLACED * 3} \ufffe <b>&\"]]>\r\n{REPLACED}")
        for path in (self.place / "out").rglob("*"):
            if path.is_file() and "known" not in path.parts and path.suffix in (".json", ".xml", ".csv", ".html"):
                text = path.read_bytes().decode()  # strict
                if path.stem in ("cut", "flood"):
                    self.assertNotIn(REPLACED, Data(text).text if path.suffix == ".html" else text, path)

    def test_the_same_results_are_the_same_bytes(self):
        def written(folder):
            return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*")
                    if path.is_file() and path.relative_to(folder).parts[0] != "known"}
        first = written(self.place / "out")
        self.assertGreater(len(first), 2 * len(PROGRAMS))
        harness.grade(PROGRAM, self.suite, self.place / "out", "--submissions", self.homework, "-j", "1", check=0)
        self.assertEqual(written(self.place / "out"), first, "where they were")
        shutil.copytree(self.place / "out" / "known", self.place / "elsewhere" / "known")
        harness.grade(PROGRAM, self.suite, self.place / "elsewhere", "--submissions", self.homework, check=0)
        self.assertEqual(written(self.place / "elsewhere"), first, "elsewhere")
        subprocess.run([PROGRAM, "merge", "-q", self.place / "out", "-o", self.place / "merged"], check=True)
        merged, times = written(self.place / "merged"), pathlib.Path("times.json")
        self.assertEqual({name for name in first if merged.get(name) != first[name]}, {times}, "merged: pictures lie elsewhere, seen from it")
        shutil.rmtree(self.place / "again", ignore_errors=True)
        harness.grade(PROGRAM, self.suite, self.place / "again", "--submissions", self.homework, "-j", "3", check=0)
        for name in ("results.json", "tests.json"):
            self.assertEqual((self.place / "again" / name).read_bytes(), first[pathlib.Path(name)], "run again")


if __name__ == "__main__":
    unittest.main(verbosity=2)
