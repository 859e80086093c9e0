"""Pictures of the gallery as the program takes them."""

import os
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import dataclass

from pictures import FACES

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Failure(Exception):
    """What the user is told."""


@dataclass
class Shot:
    """A picture as taken."""
    name: str
    caption: str
    size: tuple
    command: str
    seconds: float


def path_for(folder, name):
    """As a word of a command typed in the project's folder."""
    path = os.path.join(os.path.abspath(folder), name)
    inside = os.path.relpath(path, ROOT)
    return path if inside.startswith("..") else inside


def words_for(picture, size, folder, options):
    words = ["pov/shading/%s.pov" % picture.scene, *picture.options]
    if picture.hall:
        words += ["--environment", ",".join(path_for(folder, "hall-%d.png" % i) for i in range(len(FACES)))]
    samples = options.samples or picture.samples
    return words + ["-W", str(size[0]), "-H", str(size[1]), "--ss", str(samples), "-o", path_for(folder, picture.name + ".png")]


def run(words, folder, partial):
    """Status and messages of a command. Ctrl-C ends it, too, and what it then leaves of its picture is removed from the folder."""
    with subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            messages = process.communicate()[1]
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.wait()
            if os.path.exists(os.path.join(folder, partial)):
                os.remove(os.path.join(folder, partial))
            raise
    return process.returncode, messages


def take(picture, folder, options):
    """Renders a picture into the folder. `options` are those of the gallery: program, size, samples. Raises Failure."""
    size = tuple(max(8, round(side * options.size)) for side in picture.size)
    words = words_for(picture, size, folder, options)
    begin = time.monotonic()
    try:
        status, messages = run([options.program, *words], folder, picture.name + ".partial.png")
    except OSError as error:
        raise Failure("%s: %s" % (options.program, error.strerror))
    seconds = time.monotonic() - begin
    command = shlex.join(["./raytrace", *words])
    if status != 0:
        raise Failure("%s\nended with status %d:\n%s" % (command, status, messages))
    sys.stderr.write(messages)
    return Shot(picture.name, picture.caption, size, command, seconds)
