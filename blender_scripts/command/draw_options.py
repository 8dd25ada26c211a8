"""The words of `fovea draw`: parsed once outside Blender, so that mistakes show at once, and again by draw.py inside."""

import argparse
import re
from pathlib import Path

import scenes

MODELS = (".obj",)
PICTURES = (".png", ".exr")


def parse(words):
    parser = _parser()
    options = parser.parse_args(words)
    try:
        _check(options)
    except ValueError as error:
        parser.error(str(error))
    return options


def default_output(spec):
    """Beside nothing of the user's: MODEL-fovea.png in the current folder."""
    stem = Path(spec).stem if is_file(spec) else spec.replace(":", "-")
    return Path(f"{stem}-fovea.png").absolute()


def is_file(spec):
    return Path(spec).suffix in (".blend", *MODELS)


def pictures(options):
    """The files that a run writes."""
    if not options.frames:
        return [options.output]
    first, last = options.frames
    return [options.output.with_stem(f"{options.output.stem}_{frame:04d}") for frame in range(first, last + 1)]


def _parser():
    parser = argparse.ArgumentParser("fovea draw")
    add = parser.add_argument
    add("scene", nargs="?", default="demo", help="MODEL.obj, SCENE.blend or a scene's NAME[:N]")
    add("-o", "--output", type=lambda text: Path(text).absolute(), help="OUT.png or OUT.exr")
    add("--size", type=_size, metavar="WxH", help="pixels; 1920x1080 for a model")
    add("--lens", type=float, metavar="MM", help="focal length; 50 for a model")
    add("--margin", type=float, metavar="PERCENT", default=5.0, help="free on each side of a framed model")
    add("--azimuth", type=float, metavar="DEG", help="frame the model from so far left of its front (35)")
    add("--elevation", type=float, metavar="DEG", help="and from so far above it (25)")
    add("--backend", choices=("auto", "cpu", "gpu"))
    add("--visibility", choices=("auto", "exact", "atlas"))
    add("--frames", type=_frames, metavar="A-B", help="an animation: OUT_0001.png ...")
    add("--style", metavar="NAME")
    add("--lines", type=lambda text: text.split(","), metavar="A,B", help="line definitions; only these are drawn")
    add("--transparent", action="store_true", help="no paper")
    return parser


def _check(options):
    if is_file(options.scene):
        if not Path(options.scene).is_file():
            raise ValueError(f"there is no file {options.scene}")
    elif Path(options.scene).suffix:
        raise ValueError(f"{options.scene}: a scene is a {', '.join(MODELS)} or .blend file, or one of {scenes.names()}")
    else:
        scenes.parse(options.scene)
    options.output = options.output or default_output(options.scene)
    if options.output.suffix not in PICTURES:
        raise ValueError(f"a picture is {' or '.join(PICTURES)}, not {options.output.name}")
    if not options.output.parent.is_dir():
        raise ValueError(f"there is no folder {options.output.parent}")
    if not 0 <= options.margin < 50:
        raise ValueError(f"a margin of {options.margin} percent leaves no picture")


def _size(text):
    found = re.fullmatch(r"([1-9]\d*)x([1-9]\d*)", text)
    if not found:
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT")
    return int(found[1]), int(found[2])


def _frames(text):
    found = re.fullmatch(r"(\d+)(?:-(\d+))?", text)
    first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
    if last < first:
        raise argparse.ArgumentTypeError(f"'{text}' is not FIRST-LAST")
    return first, last
