#!/usr/bin/env python3
"""Writes copies of sources with the faults of faults.py in them, each behind a question whether it is selected.

usage: tests/faults/program/plant.py --root FOLDER --out FOLDER

Of every file that a fault changes OUT has the copy, and OUT/faults_list.h lists the faults for faults.h. A copy that would be the same as
before is left alone. src/ itself is only read. Exits with 1 and file, fault and text where a change does not find its place.
"""
import argparse
import pathlib
import sys

from faults import FAULTS


class Misplaced(Exception):
    pass


def place(text, file, name, before):
    """First and last position of the expression between [[ and ]] of `before` in the text."""
    head, mark, rest = before.partition("[[")
    # The last mark: an expression may end with an index.
    expression, end, tail = rest.rpartition("]]")
    if not mark or not end:
        raise Misplaced(f"{file}: fault {name}: no [[ ]] in {before!r}")
    whole = head + expression + tail
    count = text.count(whole)
    if count != 1:
        raise Misplaced(f"{file}: fault {name}: expected once, found {count} times: {whole}")
    begin = text.index(whole) + len(head)
    return begin, begin + len(expression)


def planted(text, file, changes):
    """The text with every change of this file in it; `changes` are (fault, before, after)."""
    places = {}
    for name, before, after in changes:
        places.setdefault(place(text, file, name, before), []).append((name, after))
    ordered = sorted(places.items())
    for (a, _), (b, names) in zip(ordered, ordered[1:]):
        if b[0] < a[1]:
            raise Misplaced(f"{file}: fault {names[0][0]}: overlaps another one")
    for (begin, end), faults in reversed(ordered):
        expression = text[begin:end]
        for name, after in reversed(faults):
            expression = f"(planted(Fault::{name}) ? ({after}) : ({expression}))"
        text = text[:begin] + expression + text[end:]
    return text


def with_include(text):
    """The question's header comes after a header's `#pragma once`, or first of all."""
    pragma = "#pragma once\n"
    at = text.index(pragma) + len(pragma) if pragma in text else 0
    return text[:at] + '#include "tests/faults/program/faults.h"\n' + text[at:]


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    by_file = {}
    for name, (_, changes) in FAULTS.items():
        for file, before, after in changes:
            by_file.setdefault(file, []).append((name, before, after))
    try:
        for file, changes in by_file.items():
            write(options.out / file, with_include(planted((options.root / "src" / file).read_text(), file, changes)))
    except Misplaced as error:
        print(f"tests/faults/program/plant.py: {error}", file=sys.stderr)
        return 1
    for path in options.out.rglob("*"):  # of a fault that there is no more
        if path.suffix in (".h", ".cpp") and path.relative_to(options.out).as_posix() not in by_file and path.name != "faults_list.h":
            path.unlink()
    write(options.out / "faults_list.h", "".join(f'FAULT({name}, "{what}")\n' for name, (what, _) in FAULTS.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
