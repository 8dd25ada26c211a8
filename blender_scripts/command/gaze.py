# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea gaze PICTURE.png|SCENE`: where the eye goes first in a picture, or in the drawing of a scene and whether that
is its focus; in Blender only for scenes."""

import argparse
import json
import tempfile
from pathlib import Path

from . import actions, draw_options, output

OTHERS = "frames", "cameras", "over", "sheet", "dump", "one_bit"  # words of `fovea draw` that make another picture


def gaze(target, words):
    options, of_draw = parse(words)
    if options.output:
        output.check(options.output)
    if options.of.lower().endswith(".png"):
        found = of_picture(target, options)
    else:
        found = of_scene(target, options, of_draw)
    print(json.dumps(found["told"]) if options.json else found["sentence"])
    if options.output and not options.json:
        print(options.output)
    return 0


def parse(words):
    """(options, words of `fovea draw`)."""
    parser = argparse.ArgumentParser("fovea gaze", usage=argparse.SUPPRESS)
    parser.add_argument("of", metavar="PICTURE.png|SCENE", help="a PNG file, or what `fovea draw` draws")
    parser.add_argument("--strengthen", action="store_true", help="with as much emphasis of a scene's focus as it "
                        "takes for the eye to go there")  # fmt: skip
    parser.add_argument("-o", "--output", type=lambda text: Path(text).absolute(), metavar="OUT.png", help="heat map")
    parser.add_argument("--json", action="store_true")
    options, rest = parser.parse_known_args(words)
    if options.output and options.output.suffix.lower() != ".png":
        parser.error(f"-o: a heat map is a .png, not {options.output.name}")
    if not options.of.lower().endswith(".png"):
        of_draw = [options.of, *rest, "-o", str(options.output or Path(tempfile.gettempdir(), "gaze.png"))]
        drawn = draw_options.parse(of_draw)
        for name in OTHERS:
            if getattr(drawn, name):
                parser.error(f"--{name.replace('_', '-')} is for fovea draw: the eye goes to one picture of the scene")
        return options, of_draw
    if rest or options.strengthen:
        parser.error(f"{' '.join(rest) or '--strengthen'}: a picture is taken as it is; name a scene to draw one")
    if not Path(options.of).is_file():
        parser.error(f"there is no file {options.of}")
    return options, []


def of_picture(target, options):
    """{"told": numbers, "sentence": words} of a PNG file."""
    looking, native = (actions.imported(target, name) for name in ("gaze", "native"))
    try:
        seen = looking.look(native.load().pixels_of_png(Path(options.of).read_bytes()))
    except ValueError as error:
        raise ValueError(f"{options.of}: {error}") from error
    if options.output:
        looking.write(seen, options.output)
    return {"told": looking.told(seen), "sentence": looking.sentence(seen)}


def of_scene(target, options, of_draw):
    """The same of a scene's drawing."""
    asked = {"heat": str(options.output or ""), "strengthen": options.strengthen, "draw": of_draw}
    return json.loads(actions.written_by(target, f"drawing {options.of}", "gaze.py", asked))
