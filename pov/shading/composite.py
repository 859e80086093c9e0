"""Some pictures of the gallery side by side in one file."""

import os
import subprocess
import tempfile
from dataclasses import replace

from pictures import find, hall
from taking import Failure, take

SIZE = (1200, 575)
PLACES = (  # picture, left upper corner, size
    ("demo-ct-both-shiny-gold", (0, 0), (358, 268)),
    ("gooch-drawing", (362, 0), (476, 268)),
    ("lamp-all", (842, 0), (358, 268)),
    ("metals-hall", (0, 272), (303, 303)),
    ("terms-ggx-conductor-cook-torrance", (307, 272), (481, 99)),
    ("terms-beckmann-conductor-ggx", (307, 374), (481, 99)),
    ("terms-blinn-schlick-cook-torrance", (307, 476), (481, 99)),
    ("demo-ct-lights-dull-gold", (792, 272), (408, 303)),
)


def scaled(pair, options):
    return tuple(round(x * options.size) for x in pair)


def joined(folder, options):
    """The command that joins the pictures of the folder on white."""
    words = ["convert", "-size", "%dx%d" % scaled(SIZE, options), "xc:white"]
    for name, corner, _ in PLACES:
        words += [os.path.join(folder, name + ".png"), "-geometry", "+%d+%d" % scaled(corner, options), "-composite"]
    return words + ["-strip", "-quality", "85", options.composite]


def composite(options):
    """Renders each picture in the size of its place and writes them to the file options.composite. Raises Failure."""
    with tempfile.TemporaryDirectory() as folder:
        for picture in hall().pictures:
            take(picture, folder, options)
        for name, _, size in PLACES:
            take(replace(find(name), size=size), folder, options)
        try:
            run = subprocess.run(joined(folder, options), capture_output=True, text=True)
        except OSError as error:
            raise Failure("convert (of ImageMagick): %s" % error.strerror)
        if run.returncode != 0:
            raise Failure("%s: %s" % (options.composite, run.stderr))
