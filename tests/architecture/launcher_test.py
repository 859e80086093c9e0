#!/usr/bin/env python3
"""The launcher and the installer with stand-ins for cmake, dpkg-query, apt-get and id: who builds, who waits, who installs what."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

CMAKE = """#!/bin/sh
echo "cmake $*" >>"$LOG"
[ "$1" = --build ] || exit 0
[ -n "$BREAK" ] && exit 1
sleep 1
printf '#!/bin/sh\\nprintf "ran"; for word; do printf " [%%s]" "$word"; done; echo; exit 7\\n' >build/raytrace.new
chmod +x build/raytrace.new
mv build/raytrace.new build/raytrace
"""


class LauncherTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = pathlib.Path(folder.name) / "a place"
        self.project, self.tools, self.log = self.home / "the project", self.home / "tools", self.home / "log"
        (self.project / ".ci").mkdir(parents=True)
        self.tools.mkdir()
        self.log.write_text("")
        for name in ("raytrace", "packages", ".ci/install"):
            shutil.copy(ROOT / name, self.project / name)
        self.tool("cmake", CMAKE)
        self.tool("dpkg-query", "#!/bin/sh\nfor word; do case $word in -*) ;; \\$*) ;; *) echo \"installed $word\" ;; esac; done\n")
        self.environment = dict(os.environ, PATH=f"{self.tools}:/usr/bin:/bin", LOG=str(self.log))

    def tool(self, name, text):
        (self.tools / name).write_text(text)
        (self.tools / name).chmod(0o755)

    def run_it(self, *command, cwd="/", **options):
        return subprocess.run([str(c) for c in command], cwd=cwd, env=dict(self.environment, **options), capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)

    def test_builds_once_then_runs_at_once_from_anywhere(self):
        first = self.run_it(self.project / "raytrace", "scene one.pov", "-W", 3)
        self.assertEqual((first.stdout, first.returncode), ("ran [scene one.pov] [-W] [3]\n", 7))
        self.assertIn("building the program", first.stderr)
        self.assertIn("-DRAYTRACE_TESTS=OFF", self.log.read_text())
        link = self.home / "link"
        link.symlink_to(self.project / "raytrace")
        for command, cwd in (([self.project / "raytrace"], "/"), ([link], "/"), (["sh", "raytrace"], self.project), (["./raytrace"], self.project)):
            again = self.run_it(*command, "x", cwd=cwd)
            self.assertEqual((again.stdout, again.stderr, again.returncode), ("ran [x]\n", "", 7))
        self.assertEqual(self.log.read_text().count("--build"), 1)

    def test_first_starts_at_the_same_time_build_once(self):
        starts = [subprocess.Popen([self.project / "raytrace", str(i)], env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                  for i in range(4)]
        self.assertEqual([start.communicate()[0] for start in starts], [f"ran [{i}]\n" for i in range(4)])
        self.assertEqual(self.log.read_text().count("--build"), 1)

    def test_a_build_that_fails_says_so_and_the_next_start_tries_again(self):
        broken = self.run_it(self.project / "raytrace", BREAK="1")
        self.assertEqual((broken.stdout, broken.returncode), ("", 1))
        self.assertIn("could not be built", broken.stderr)
        self.assertEqual(self.run_it(self.project / "raytrace").returncode, 7)

    def missing(self, package):
        self.tool("dpkg-query", f"#!/bin/sh\nfor word; do case $word in -*|\\$*|{package}) ;; *) echo \"installed $word\" ;; esac; done\nexit 1\n")
        self.tool("apt-get", '#!/bin/sh\necho "apt-get $*" >>"$LOG"\n')

    def test_root_installs_what_is_missing_and_nothing_else(self):
        self.missing("libglm-dev")
        self.tool("id", "#!/bin/sh\necho 0\n")
        self.assertEqual(self.run_it(self.project / ".ci/install", "build").returncode, 0)
        calls = self.log.read_text().splitlines()
        self.assertEqual(len(calls), 2)
        self.assertTrue(calls[0].endswith(" update"))
        self.assertTrue(calls[1].endswith(" install -y --no-install-recommends libglm-dev"))

    def test_without_rights_the_exact_line_is_printed(self):
        self.missing("libglm-dev")
        self.tool("id", "#!/bin/sh\necho 1000\n")
        self.tool("sudo", "#!/bin/sh\nexit 1\n")
        done = self.run_it(self.project / "raytrace")
        self.assertEqual((done.stdout, done.returncode), ("", 1))
        self.assertIn("    apt-get update && apt-get install -y --no-install-recommends libglm-dev\n", done.stderr)
        self.assertEqual(self.log.read_text(), "")

    def test_sudo_without_a_password_is_used(self):
        self.missing("libglm-dev")
        self.tool("id", "#!/bin/sh\necho 1000\n")
        self.tool("sudo", '#!/bin/sh\n[ "$1" = -n ] || exit 1\nshift\nexec "$@"\n')
        self.assertEqual(self.run_it(self.project / ".ci/install", "build").returncode, 0)
        self.assertIn("install -y --no-install-recommends libglm-dev", self.log.read_text())

    def test_sections_name_different_packages(self):
        self.missing("povray")
        self.tool("id", "#!/bin/sh\necho 0\n")
        self.run_it(self.project / ".ci/install", "build")
        self.assertEqual(self.log.read_text(), "")
        self.run_it(self.project / ".ci/install", "build", "test")
        self.assertIn("install -y --no-install-recommends povray\n", self.log.read_text())


if __name__ == "__main__":
    unittest.main()
