#!/usr/bin/env python3
"""The house rules that a machine can check: who includes whom, one room for each library, and sizes.

usage: tests/architecture/check.py [--root FOLDER] [--headers]

Prints every breach as file:line: text and exits with 1 if there is one. --headers also compiles every header on its own.
"""
import argparse
import pathlib
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOMS = {
    "core": set(),
    "geometry": {"core"},
    "shading": {"core"},
    "patterns": {"core"},
    "scene": {"core", "geometry", "patterns"},
    "syntax": {"core", "geometry", "patterns", "scene"},
    "world": {"core", "geometry", "scene", "shading", "patterns"},
    "film": {"core"},
    "trace": {"core", "shading", "world", "film"},
    "grading": {"core", "film"},
    "pages": set(),
}
ALL_ROOMS = set(ROOMS) | {"commands"}
# The folders of the room commands. What lies beside them may use them all; they may use its headers.
PARTS = {
    "base": set(),
    "job": {"base"},
    "brdf": {"base", "job"},
    "pixel": {"base", "job"},
    "course": {"base", "job", "pixel"},
    "causes": {"base", "job", "pixel"},
    "report": {"base"},
    "grade": {"base", "job", "causes", "report"},
    "versus": {"base", "job", "report"},
    "trade": {"base", "job", "report"},
}

# Where a library may be included, as a pattern of paths under src/.
LIBRARIES = {
    r"embree\d?/": r"world/embree_(index\.cpp|handles\.h)",
    r"png\.h": r"film/png\.cpp",
    r"ft2build|freetype": r"syntax/font_file\.cpp",
    r"OpenImageIO/": r"film/oiio/.*",
    r"CLI/": r"commands/.*|main\.cpp",
    r"nlohmann/": r"commands/.*|grading/report.*",
    r"thread$": r"trace/render\.cpp",
    r"glm/": r"core/.*",
    r"xxhash": r"commands/base/content_hash\.cpp",
    r"iostream": r"$never",
}

# Where processes may be started, as a pattern of paths under src/: one file forks, two have the forked process become a program.
STARTS_PROCESSES = r"grading/(child_process|program_start|bubblewrap_room)\.cpp"

FILE_LINES = 400
FUNCTION_LINES = 60
MAIN_LINES = 60

UNFINISHED = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "X" + "XX"]) + r")\b")
LEAVES_PROGRAM = re.compile(r"\b(?:std::)?(?:_?exit|_Exit|quick_exit|abort|terminate)\s*\(")
STARTS = re.compile(r"\b(?:v?fork|clone3?|exec(?:l|le|lp|v|ve|vp|vpe|veat)|fexecve|posix_spawnp?|system|popen)\s*\(")
PRINTS = re.compile(r"\bfmt::print\b|\bstd::(?:cout|cerr|clog)\b|\b(?:std::)?(?:printf|puts|putchar)\s*\(")
# Pages ask the network for nothing and keep behaviour out of their markup.
ADDRESS = re.compile(r"""\b[a-z]+://|["'(]//|@import\b""")
HANDLER = re.compile(r"<[^>]*\son[a-z]+\s*=")
ASSETS = (".html", ".css", ".js")
SCOPE = re.compile(r"^\s*(?:template\s*<.*?>\s*)?(?:inline\s+|typedef\s+|extern\s+)*(?:namespace|class|struct|union|enum|extern)\b", re.S)


# What a file keeps to itself, one line each: functions with their parameters' types, kinds and constants.
PRIVATE = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.M | re.S)
PRIVATE_FUNCTION = re.compile(r"^(?!using|return|struct|class|enum|namespace)[\w:\[].*?\b(\w+)\((.*)\) (?:const )?\{")
PRIVATE_NAME = re.compile(r"^(?:struct|class|enum(?: class)?|using) (\w+)\b(?!.*;$)|^(?:inline )?const(?:expr)? [\w:<>, ]+ (\w+)(?:\[\w*\])?(?: =|\{|\()")


def without_comments_and_strings(text):
    """The text with comments and literals blanked out; lines stay where they are."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^()\s\\]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)

    def blank(match):
        start = match.start()
        if match.group().startswith("'") and start and text[start - 1].isalnum() and text[start - 1] not in "uUL":
            return match.group()  # a digit separator
        return re.sub(r"[^\n]", " ", match.group())

    return pattern.sub(blank, text)


def functions(text):
    """Yields (first line, last line) of every function body that is not inside another one, headers included."""
    code = re.sub(r"^[ \t]*#.*?(?<!\\)$", lambda m: re.sub(r"[^\n]", " ", m.group()), without_comments_and_strings(text), flags=re.M | re.S)
    stack, header_start, line, start_line = [], 0, 1, 1
    for position, char in enumerate(code):
        if char == "\n":
            line += 1
        elif char == "{":
            header = code[header_start:position]
            inside = "function" in [kind for kind, _ in stack]
            if inside or (stack and stack[-1][0] == "value"):
                kind = "nested"
            elif SCOPE.match(header):
                kind = "scope"
            elif "(" not in header or header.count("(") > header.count(")") or re.search(r"=\s*$", header):
                kind = "value"
            elif re.search(r"\)[^()]*(?<!:):(?!:).*[\w>]$", header.rstrip(), re.S) and not header.endswith((" ", "\n")):
                kind = "value"  # a member's initialiser in a constructor
            else:
                kind = "function"
            start_line = line - header[len(header) - len(header.lstrip()):].count("\n")
            stack.append((kind, start_line))
            if kind in ("scope", "function"):
                header_start = position + 1
        elif char == "}" and stack:
            kind, first = stack.pop()
            if kind == "function":
                yield first, line
            if kind in ("scope", "function"):
                header_start = position + 1
        elif char == ";" and (not stack or stack[-1][0] == "scope"):
            header_start = position + 1


def private_names(text):
    """Yields (line, name) of what the unnamed namespaces of a file declare; of functions the name with the types of the parameters."""
    for space in PRIVATE.finditer(text):
        first = text[: space.start()].count("\n") + 2
        for number, line in enumerate(without_comments_and_strings(space.group(1)).splitlines(), first):
            function = PRIVATE_FUNCTION.match(line)
            named = PRIVATE_NAME.match(line)
            if function:
                parameters = [re.sub(r"\s*=.*", "", p).strip() for p in function.group(2).split(",")]
                yield number, function.group(1) + "(" + ", ".join(re.sub(r"\s*\b\w+$", "", p) if " " in p else p for p in parameters) + ")"
            elif named:
                yield number, named.group(1) or named.group(2)


class Check:
    def __init__(self, root):
        self.root = root
        self.src = root / "src"
        self.breaches = []

    def report(self, path, line, text):
        self.breaches.append(f"{path.relative_to(self.root)}:{line}: {text}")

    def check_includes(self, path, text):
        inner = path.relative_to(self.src).as_posix()
        room = inner.split("/")[0] if "/" in inner else ""
        allowed = ROOMS.get(room, ALL_ROOMS) | {room}
        part = inner.split("/")[1] if room == "commands" and inner.count("/") == 2 else ""
        for number, line in enumerate(text.splitlines(), 1):
            quoted = re.match(r'\s*#\s*include\s*"([^"]+)"', line)
            if quoted:
                other = quoted.group(1).split("/")[0] if "/" in quoted.group(1) else ""
                if other not in ALL_ROOMS:
                    self.report(path, number, f'include "{quoted.group(1)}" does not say "room/file.h"')
                elif other not in allowed:
                    self.report(path, number, f"room {room} may not include room {other}")
                elif part and quoted.group(1).count("/") == 2 and quoted.group(1).split("/")[1] not in PARTS.get(part, set()) | {part}:
                    self.report(path, number, f"commands/{part} may not include commands/{quoted.group(1).split('/')[1]}")
            angled = re.match(r"\s*#\s*include\s*<([^>]+)>", line)
            for library, place in LIBRARIES.items():
                if angled and re.match(library, angled.group(1)) and not re.fullmatch(place, inner):
                    self.report(path, number, f"<{angled.group(1)}> has no place in this file")

    def check_words(self, path, text):
        code = without_comments_and_strings(text).splitlines()
        inner = path.relative_to(self.src).as_posix()
        for number, line in enumerate(code, 1):
            if inner not in ("main.cpp", "commands/base/interrupt.cpp", "grading/child_process.cpp") and LEAVES_PROGRAM.search(line):
                self.report(path, number, "only main ends the program (and the signal handler)")
            if not re.fullmatch(STARTS_PROCESSES, inner) and STARTS.search(line):
                self.report(path, number, "only the sandbox starts processes")
            if not inner.startswith(("commands/", "main.cpp")) and PRINTS.search(line):
                self.report(path, number, "only commands print")

    def check_private_names(self, sources):
        """Files of a room are compiled together: what each keeps to itself has a name of its own in the room."""
        known = {}
        for path in sources:
            room = path.relative_to(self.src).parts[0]
            for number, name in private_names(path.read_text()):
                first = known.setdefault((room, name), path)
                if first != path:
                    self.report(path, number, f"{name} stands in {first.relative_to(self.root)} too")

    def check_asset(self, path, text):
        for number, line in enumerate(text.splitlines(), 1):
            if ADDRESS.search(line):
                self.report(path, number, "a page asks for nothing outside of itself")
            if HANDLER.search(line):
                self.report(path, number, "behaviour belongs in a script, not in markup")

    def check_sizes(self, path, text):
        lines = text.count("\n")
        limit = MAIN_LINES if path == self.src / "main.cpp" else FILE_LINES
        if lines > limit:
            self.report(path, lines, f"{lines} lines, at most {limit} are allowed")
        code = path.suffix in (".h", ".cpp") and path.is_relative_to(self.src)
        for first, last in functions(text) if code else []:  # a test's body is mostly its table of cases
            if last - first + 1 > FUNCTION_LINES:
                self.report(path, first, f"a function of {last - first + 1} lines, at most {FUNCTION_LINES} are allowed")
        for number, line in enumerate(text.splitlines(), 1):
            if UNFINISHED.search(line):
                self.report(path, number, "unfinished work belongs in the tracker")

    def check_headers(self):
        headers = sorted(self.src.rglob("*.h"))
        options = ["g++", "-std=c++20", "-fsyntax-only", "-DGLM_FORCE_CTOR_INIT", "-Wall", "-Wextra", "-x", "c++", f"-I{self.src}"]
        with ThreadPoolExecutor() as pool:
            runs = list(pool.map(lambda header: subprocess.run(options + [header], capture_output=True, text=True), headers))
        for header, run in zip(headers, runs):
            if run.returncode != 0:
                self.report(header, 1, "does not compile on its own: " + run.stderr.strip().split("\n")[0])

    def run(self, headers):
        sources = [p for p in sorted(self.src.rglob("*")) if p.suffix in (".h", ".cpp")]
        for path in sources:
            text = path.read_text()
            self.check_includes(path, text)
            self.check_words(path, text)
        self.check_private_names([p for p in sources if p.suffix == ".cpp"])
        assets = [p for p in sorted(self.src.rglob("*")) if p.suffix in ASSETS]
        for path in assets:
            self.check_asset(path, path.read_text())
            if path.parent != self.src / "pages":
                self.report(path, 1, "page assets stand in the room pages")
        for path in sources + assets + [p for p in sorted((self.root / "tests").rglob("*")) if p.suffix in (".h", ".cpp")]:
            self.check_sizes(path, path.read_text())
        if headers:
            self.check_headers()
        return self.breaches


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--headers", action="store_true")
    options = parser.parse_args()
    breaches = Check(options.root.resolve()).run(options.headers)
    print("\n".join(breaches) if breaches else "the house is in order")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
