#!/usr/bin/env python3
"""Plants one breach of every rule in a small tree and sees each reported; a tree without one is in order."""
import pathlib
import tempfile
import unittest

import check

LONG_FUNCTION = "int f() {\n" + "    g();\n" * 60 + "}\n"

BREACHES = {
    "room geometry may not include room scene": ("src/geometry/a.h", '#include "scene/scene.h"\n'),
    "room grading may not include room trace": ("src/grading/a.cpp", '#include "trace/render.h"\n'),
    "room core may not include room geometry": ("src/core/a.h", '#include "geometry/sphere.h"\n'),
    "commands/grade may not include commands/versus": ("src/commands/grade/a.h", '#include "commands/versus/a.h"\n'),
    'does not say "room/file.h"': ("src/core/a.h", '#include "vec.h"\n'),
    "<embree3/rtcore.h> has no place": ("src/world/world.cpp", "#include <embree3/rtcore.h>\n"),
    "<png.h> has no place": ("src/film/image_file.cpp", "#include <png.h>\n"),
    "<OpenImageIO/imageio.h> has no place": ("src/film/png.cpp", "#include <OpenImageIO/imageio.h>\n"),
    "<CLI/CLI.hpp> has no place": ("src/trace/render.cpp", "#include <CLI/CLI.hpp>\n"),
    "<nlohmann/json.hpp> has no place": ("src/grading/difference.cpp", "#include <nlohmann/json.hpp>\n"),
    "<thread> has no place": ("src/trace/tracer.cpp", "#include <thread>\n"),
    "<glm/vec3.hpp> has no place": ("src/geometry/a.h", "#include <glm/vec3.hpp>\n"),
    "only main ends the program": ("src/syntax/a.cpp", "void f() {\n    std::exit(1);\n}\n"),
    "src/commands/a.cpp:2: only the sandbox starts processes": ("src/commands/a.cpp", 'void f() {\n    std::system("ls");\n}\n'),
    "src/grading/sandbox.cpp:2: only the sandbox starts processes": ("src/grading/sandbox.cpp", "void f() {\n    g(fork());\n}\n"),
    "only commands print": ("src/syntax/a.cpp", 'void f() {\n    fmt::print("x");\n}\n'),
    "401 lines, at most 400": ("tests/core/a.h", "\n" * 401),
    "61 lines, at most 60": ("src/main.cpp", "\n" * 61),
    "a function of 62 lines": ("src/core/a.cpp", "namespace rt {\nclass A {\n" + LONG_FUNCTION + "};\n}\n"),
    "a function of 64 lines": ("src/scene/a.cpp", "A::A(int n) : a_{n}, b_(n) {\n" + "    // {\n" + LONG_FUNCTION[10:-2] + "\n}\n"),
    "room pages may not include room core": ("src/pages/a.cpp", '#include "core/vec.h"\n'),
    "page assets stand in the room pages": ("src/commands/a.css", "p {}\n"),
    "a page asks for nothing": ("src/pages/a.js", 'fetch("https://example.org/");\n'),
    "a page asks for nothing outside": ("src/pages/a.css", "p { background: url(//example.org/a.png) }\n"),
    "behaviour belongs in a script": ("src/pages/a.html", '<p class="a" onclick="f()">\n'),
    "402 lines, at most 400": ("src/pages/a.js", "\n" * 402),
    "unfinished work": ("src/core/a.h", "// TO" + "DO: later\n"),
}

GOOD = """#include "core/vec.h"
// exit( is only a word here, and "std::exit(1)" a string
namespace rt {
constexpr int table[] = {1'000, 2};
const char* text = "exit(";
struct A {
    int b{3};
    A(int c) : b{c} {}
};
template <typename T>
T twice(T t) {
    return t + t;
}
}  // namespace rt
"""


class CheckTest(unittest.TestCase):
    def breaches(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return check.Check(root).run(headers=False)

    def test_good_code_is_in_order(self):
        self.assertEqual(self.breaches({"src/geometry/a.cpp": GOOD, "src/main.cpp": '#include "commands/commands.h"\n'}), [])

    def test_files_of_a_room_keep_names_apart(self):
        one = "namespace rt {\n\nnamespace {\n\nconstexpr int most = 3;\nstruct A {\n    int b;\n};\nint f(const A& a, int c = 2) {\n    return g(c);\n}\n\n}  // namespace\n}\n"
        other = one.replace("constexpr int most", "const double most").replace("struct A", "class A").replace("const A& a, int c", "const A& b, int")
        overload = "namespace {\nint f(const A& a) { return h(a); }\n}  // namespace\n"
        names = [breach.split(": ")[1] for breach in self.breaches({"src/core/a.cpp": one, "src/core/b.cpp": other})]
        self.assertEqual(names, [f"{name} stands in src/core/a.cpp too" for name in ("most", "A", "f(const A&, int)")])
        self.assertEqual(self.breaches({"src/core/a.cpp": one, "src/core/b.cpp": overload, "src/film/a.cpp": one}), [])

    def test_functions_are_found_with_their_lengths(self):
        self.assertEqual(list(check.functions(GOOD)), [(8, 8), (10, 13)])

    def test_every_breach_is_reported(self):
        for text, (name, content) in BREACHES.items():
            with self.subTest(text):
                found = self.breaches({"src/geometry/good.cpp": GOOD, name: content})
                self.assertEqual(len(found), 1, found)
                self.assertIn(text, found[0])
                self.assertTrue(found[0].startswith(name + ":"), found)


if __name__ == "__main__":
    unittest.main()
