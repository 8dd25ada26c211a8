"""The words of `fovea draw`: parsed once outside Blender, so that mistakes show at once, and again by draw.py inside."""

import argparse
import math
import re
from pathlib import Path

import scenes

from . import assignment

MODELS = (".obj",)
PICTURES = (".png", ".exr")
TILE = (480, 360)  # of a sheet


def parse(words):
    parser = _parser()
    options = parser.parse_args(words)
    try:
        _check(options)
    except ValueError as error:
        parser.error(str(error))
    return options


def default_output(spec, kind="fovea"):
    """Beside nothing of the user's: MODEL-fovea.png in the current folder."""
    stem = Path(spec).stem if is_file(spec) else spec.replace(":", "-")
    return Path(f"{stem}-{kind}.png").absolute()


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
    add("scene", nargs="?", help="MODEL.obj, SCENE.blend or a scene's NAME[:N]")
    add("-o", "--output", type=lambda text: Path(text).absolute(), help="OUT.png or OUT.exr")
    add("--size", type=frame_size, metavar="WxH", help="pixels; 1920x1080 for a model, 480x360 for a tile of a sheet")
    add("--lens", type=float, metavar="MM", help="focal length; 50 for a model")
    add("--margin", type=float, metavar="PERCENT", default=5.0, help="free on each side of a framed model")
    add("--azimuth", type=float, metavar="DEG", help="frame the model from so far left of its front (35)")
    add("--elevation", type=float, metavar="DEG", help="and from so far above it (25)")
    add("--backend", choices=("auto", "cpu", "gpu"))
    add("--visibility", choices=("auto", "exact", "atlas", "spine", "item-buffer"))
    add("--probes", choices=("1", "4", "9", "16"), help="looks into the depth buffer per sample (9)")
    add("--depth-scale", type=int, choices=(1, 2, 3), help="texels of the depth buffer per pixel (2)")
    add("--layers", type=int, choices=(1, 2, 3), help="lines to a texel of the item buffer (3)")
    add("--frames", type=_frames, metavar="A-B", help="an animation: OUT_0001.png ...")
    add("--style", metavar="NAME")
    add("--lines", type=lambda text: text.split(","), metavar="A,B", help="line definitions, or all: only these")
    add("--param", type=assignment.parse, action="append", default=[], metavar="DEFINITION.NAME=VALUE")
    add("--hidden", action="store_true", help="draw hidden lines, too: dashed, unless the style says how")
    add("--hidden-by", type=_surfaces, metavar="A-B", help="of hidden lines, those that A to B surfaces hide: 1, 2-3, 4-")
    add("--halo", type=_pixels, metavar="PX", help="gap where lines pass behind others, at a height of 1080 pixels")
    add("--overshoot", type=_pixels, metavar="PX", help="how far lines go on beyond their ends, alike")
    focus = parser.add_mutually_exclusive_group()
    where = "where to look: 0..1 from the left and the top, or in space, or an object's surface, by its name"
    focus.add_argument("--focus", type=_focus, metavar="U,V|X,Y,Z|OBJECT", help=where)
    focus.add_argument("--focus-painted", metavar="ATTRIBUTE", help="what is in focus is painted on the meshes")
    add("--focus-radii", type=_radii, metavar="NEAR,FAR", help="in focus up to, out of it from: heights, or units")
    add("--effects", type=lambda text: text.split(","), metavar="A,B", help="only these effects answer to focus")
    add("--uniform", choices=("lines", "colors", "both"), help="what is the same all over, wherever one looks")
    add("--without", choices=("lines", "colors"), help="what is not drawn")
    add("--elision", action=argparse.BooleanOptionalAction, help="thin lines that crowd each other")
    add("--sheet", action="store_true", help="a contact sheet: each definition of --lines in a tile by itself")
    add("--transparent", action="store_true", help="no paper")
    return parser


def _check(options):
    options.scene = options.scene or ("suzanne:3" if options.sheet else "demo")
    if is_file(options.scene):
        if not Path(options.scene).is_file():
            raise ValueError(f"there is no file {options.scene}")
    elif Path(options.scene).suffix:
        raise ValueError(f"{options.scene}: a scene is a {', '.join(MODELS)} or .blend file, or one of {scenes.names()}")
    else:
        scenes.parse(options.scene)
    options.output = options.output or default_output(options.scene, "sheet" if options.sheet else "fovea")
    if options.output.suffix not in PICTURES:
        raise ValueError(f"a picture is {' or '.join(PICTURES)}, not {options.output.name}")
    if options.sheet:
        _check_sheet(options)
    if not options.output.parent.is_dir():
        raise ValueError(f"there is no folder {options.output.parent}")
    if not 0 <= options.margin < 50:
        raise ValueError(f"a margin of {options.margin} percent leaves no picture")


def _check_sheet(options):
    options.lines = options.lines or ["all"]
    options.size = options.size or TILE
    if options.output.suffix != ".png":
        raise ValueError(f"a sheet is a .png, not {options.output.name}")
    others = ("frames", "style", "transparent", "hidden", "hidden_by", "halo", "overshoot", "focus", "focus_painted", "elision")
    for other in others:
        if getattr(options, other):
            raise ValueError(f"a sheet has no --{other.replace('_', '-')}")
    options.style = "plain"  # one pen for all lines


def frame_size(text):
    found = re.fullmatch(r"([1-9]\d*)x([1-9]\d*)", text)
    if not found:
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT")
    return int(found[1]), int(found[2])


def _surfaces(text):
    """(first, last): A, A-B or A-, whose last is None."""
    found = re.fullmatch(r"([1-9]\d*)(-(\d*))?", text)
    first, last = (int(found[1]), int(found[3] or 0) if found[2] else int(found[1])) if found else (1, -1)
    if last and last < first:
        raise argparse.ArgumentTypeError(f"'{text}' is not FIRST-LAST of the surfaces that hide a line")
    return first, last or None


def _numbers(text, counts, what):
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) not in counts or not all(math.isfinite(n) for n in numbers):
        raise argparse.ArgumentTypeError(f"'{text}' is not {what}")
    return numbers


def _focus(text):
    """Two or three numbers; what is no number is a name."""
    if re.search(r"[^\W\d]", re.sub(r"(?<=[\d.])[eE](?=[-+\d])", "", text)):
        return text
    return _numbers(text, (2, 3), "U,V in the image, X,Y,Z in space, or an object's name")


def _radii(text):
    near, far = _numbers(text, (2,), "NEAR,FAR")
    if not 0 <= near <= far:
        raise argparse.ArgumentTypeError(f"'{text}' is not NEAR,FAR, neither below 0 and FAR the larger")
    return near, far


def _pixels(text):
    """As a style takes it; its own limits are checked where the style is at hand."""
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of pixels") from None


def _frames(text):
    found = re.fullmatch(r"(\d+)(?:-(\d+))?", text)
    first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
    if last < first:
        raise argparse.ArgumentTypeError(f"'{text}' is not FIRST-LAST")
    return first, last
