# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of `fovea draw`: parsed outside Blender, to report errors at once, and again by draw.py inside
Blender."""

import argparse
import re
from pathlib import Path

import scenes

from . import model_files, output, quantities

PICTURES = (".png", ".exr")
VECTORS = (".svg", ".pdf", ".dxf")
LAYERS = (".ora",)
SHEETS = ("page", "pixels", "a0", "a1", "a2", "a3", "a4", "a5", "letter")
TITLES = ("title", "document", "number", "revision", "sheet", "date", "creator", "approver", "owner")
ENGINES = ("cycles", "eevee", "workbench")  # of Blender, over whose renders lines can be drawn
TILE = (480, 360)  # pixels of a tile of a sheet
# Defaults for the demo scene if neither style, lines nor focus is given: its door in focus.
DEMO = {"style": "watercolor", "focus": (0.474, 0.6), "focus_radii": (0.12, 0.75)}
LENSES = 1, 5000  # mm, Blender's limits


def parse(words):
    parser = _parser()
    options = parser.parse_args(words)
    try:
        _check(options)
    except ValueError as error:
        parser.error(str(error))
    return options


def default_output(spec, kind="fovea"):
    """MODEL-fovea.png (or another `kind`) in the current folder."""
    stem = Path(spec).stem if is_file(spec) else spec.replace(":", "-")
    return Path(f"{stem}-{kind}.png").absolute()


def is_file(spec):
    return model_files.is_blend(spec) or model_files.is_model(spec)


def pictures(options, camera=None):
    """Paths of the pictures that a run writes, one per frame. `camera`: what files have of one of --cameras."""
    return _numbered(_seen_from(options.output, camera), options.frames)


def kind(options, path):
    """The kind of file, as vectors.drawing names it, that is written at a path; None: Blender writes a picture."""
    return path.suffix[1:] if options.one_bit or path.suffix in VECTORS + LAYERS else None


def dumps(options, camera=None):
    """Paths of the dumps that a run writes, one per frame; [] without --dump."""
    return _numbered(_seen_from(options.dump, camera), options.frames) if options.dump else []


def _seen_from(path, camera):
    return path.with_stem(f"{path.stem}_{camera}") if camera else path


def _numbered(path, frames):
    """The frame's number stands for the last row of # in the name, with as many digits; else it follows the name."""
    if not frames:
        return [path]
    name = path.stem if "#" in path.stem else f"{path.stem}_####"
    before, row, after = re.fullmatch(r"(.*?)(#+)([^#]*)", name).groups()
    return [path.with_stem(f"{before}{frame:0{len(row)}d}{after}") for frame in range(frames[0], frames[1] + 1)]


def _parser():
    parser = argparse.ArgumentParser("fovea draw", usage=argparse.SUPPRESS)
    add = parser.add_argument
    add("scene", nargs="?", help="MODEL.obj (or .glb, .fbx, ...), SCENE.blend or a scene's NAME[:N]")
    add("-o", "--output", type=lambda text: Path(text).absolute(), help="OUT.png, .exr, .svg, .pdf, .dxf or .ora")
    add(
        "--size",
        type=quantities.frame_size,
        metavar="WxH",
        help="pixels; 1920x1080 for a model, 480x360 for a tile of a sheet",
    )
    add("--lens", type=quantities.within(*LENSES, "millimeters"), metavar="MM", help="focal length; 50 for a model")
    share = quantities.within(0, 100, "percent")
    add("--margin", type=share, metavar="PERCENT", default=5.0, help="free on each side of a framed model")
    add("--cameras", metavar="all|A,B", help="a picture from each camera, or from those named: OUT_A.png ...")
    degrees = quantities.within(-360, 360, "degrees")
    add("--azimuth", type=degrees, metavar="DEG", help="frame the model from so far left of its front (35)")
    add("--elevation", type=degrees, metavar="DEG", help="and from so far above it (25)")
    add("--backend", choices=("auto", "cpu", "gpu"))
    add("--visibility", choices=("auto", "exact", "atlas", "spine", "item-buffer"))
    add("--probes", choices=("1", "4", "9", "16"), help="looks into the depth buffer per sample (9)")
    add("--depth-scale", type=int, choices=(1, 2, 3), help="texels of the depth buffer per pixel (2)")
    add("--layers", type=int, choices=(1, 2, 3), help="lines to a texel of the item buffer (3)")
    add(
        "--frames",
        type=quantities.frames,
        metavar="A-B",
        help="an animation: OUT_0001.png ..., or what # are in OUT_####.png",
    )
    add("--style", metavar="NAME|FILE.json")
    add("--lines", type=lambda text: text.split(","), metavar="A,B", help="line definitions, or all: only these")
    add("--param", type=quantities.assignment, action="append", default=[], metavar="DEFINITION.NAME=VALUE")
    add("--hidden", action="store_true", help="draw hidden lines, too: dashed, unless the style says how")
    add(
        "--hidden-by",
        type=quantities.surfaces,
        metavar="A-B",
        help="of hidden lines, those that A to B surfaces hide: 1, 2-3, 4-",
    )
    pixels = quantities.finite("pixels")
    add("--halo", type=pixels, metavar="PX", help="gap where lines pass behind others, at a height of 1080 pixels")
    add("--overshoot", type=pixels, metavar="PX", help="how far lines go on beyond their ends, alike")
    plane = "cut open: what is on the +Z side of an object's XY plane is away, or of a point in the direction NX,NY,NZ"
    add("--section", type=quantities.section, metavar="OBJECT|X,Y,Z,NX,NY,NZ", help=plane)
    scale = quantities.within(1e-3, 1e6, "meters to a meter on paper")
    add(
        "--scale", type=scale, metavar="N", help="1:N, without perspective: the page is as high as that makes the frame"
    )
    focus = parser.add_mutually_exclusive_group()
    where = "where to look: 0..1 from the left and the top, or in space, or an object's surface, by its name"
    focus.add_argument("--focus", type=quantities.focus, metavar="U,V|X,Y,Z|OBJECT", help=where)
    focus.add_argument("--focus-painted", metavar="ATTRIBUTE", help="what is in focus is painted on the meshes")
    add(
        "--focus-radii",
        type=quantities.radii,
        metavar="NEAR,FAR",
        help="in focus up to, out of it from: heights, or units",
    )
    add("--effects", type=lambda text: text.split(","), metavar="A,B", help="only these effects answer to focus")
    add("--uniform", choices=("lines", "colors", "both"), help="what is the same all over, wherever one looks")
    add("--without", choices=("lines", "colors"), help="what is not drawn")
    add("--elision", action=argparse.BooleanOptionalAction, help="thin lines that crowd each other")
    add("--over", choices=ENGINES, help="draw lines over what this engine renders")
    add("--blend", choices=("over", "multiply"), help="how lines lie over it (over)")
    share = quantities.within(0, 1, "1")
    add("--opacity", type=share, metavar="0..1", help="of lines over it (1)")
    add("--samples", type=quantities.within(1, 100_000, "samples"), metavar="N", help="of that engine, to a pixel")
    add("--sheet", action="store_true", help="a contact sheet: each definition of --lines in a tile by itself")
    add("--transparent", action="store_true", help="no paper")
    _add_vectors(add)
    dump = "what the picture is drawn from, as arrays, for a bug report: OUT.npz"
    add("--dump", type=lambda text: Path(text).absolute(), metavar="OUT.npz", help=dump)
    return parser


OF_VECTORS = (
    *("paper", "paper_margin", "tolerance", "center_lines", "lines_alone", "color_areas", "plotter", "json"),
    *("title_block", "title_field"),
)


def _add_vectors(add):
    """Options of vectors, which other files refuse: None where they are not given."""
    add("--paper", type=str.lower, choices=SHEETS, help="the size of the page; page: as the style says")
    millimeters = quantities.within(0, 1000, "millimeters")
    add("--paper-margin", type=millimeters, metavar="MM", help="free around the picture on a sheet of paper (10)")
    deviation = quantities.within(0, 10, "millimeters")
    add("--tolerance", type=deviation, metavar="MM", help="how far curves may be off (0.02)")
    add("--center-lines", action="store_true", default=None, help="lines of one width where strokes change theirs")
    add("--lines-alone", action="store_true", default=None, help="neither paper nor colors")
    add("--color-areas", action="store_true", default=None, help="colors as filled areas, not as a picture")
    add("--title-block", action="store_true", default=None, help="a frame and a title block on a sheet of paper")
    field = "what the block says, else as the scene does; NAME: " + ", ".join(TITLES)
    add("--title-field", type=_title_field, action="append", metavar="NAME=TEXT", help=field)
    add("--plotter", action="store_true", default=None, help="lines of one width in an order of short ways")
    add("--one-bit", action="store_true", help="a PNG of black and white: lines by a threshold, tones as dots")
    number = quantities.within
    add("--dpi", type=number(50, 2400, "pixels per inch"), metavar="N", help="of the page, with --one-bit (600)")
    add("--screen", type=number(5, 200, "rows per inch"), metavar="N", help="rows of dots per inch (60)")
    add("--screen-angle", type=number(0, 90, "degrees"), metavar="DEG", help="of the rows of dots (45)")
    add("--json", action="store_true", default=None, help="print figures about the file")


def _title_field(text):
    name, equals, said = text.partition("=")
    if not equals or name not in TITLES:
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=TEXT; NAME can be: {', '.join(TITLES)}")
    return name, said


def vector_options(options):
    """The VectorOptions that are given, by their names."""
    given = {
        "sheet": options.paper,
        "margin": options.paper_margin,
        "to_scale": True if options.scale else None,
        "tolerance": options.tolerance,
        "widths": options.center_lines and "center",
        "ground": False if options.lines_alone else None,
        "colors": options.color_areas and "areas",
        "plotter": options.plotter,
        "title_block": True if options.title_block or options.title_field else None,
    }
    return {name: value for name, value in given.items() if value is not None}


def titles(options, sheet):
    """What a title block says, by the names of its fields; the others as in the scene. `sheet`: its number if several
    are drawn, as "2/3"; else empty."""
    return ({"sheet": sheet} if sheet else {}) | dict(options.title_field or ())


def screen_options(options):
    """The members of the Screen that are given, by their names."""
    given = {"dpi": options.dpi, "lines_per_inch": options.screen, "angle": options.screen_angle}
    return {name: value for name, value in given.items() if value is not None}


def _check_one_bit(options):
    if options.one_bit and (options.output.suffix != ".png" or options.sheet or options.size):
        raise ValueError("--one-bit is a .png, as large as the page: name such an output, without --sheet and --size")
    if not options.one_bit and (given := screen_options(options)):
        name = {"lines_per_inch": "screen", "angle": "screen-angle"}.get(first := next(iter(given)), first)
        raise ValueError(f"--{name} is for pictures in black and white: add --one-bit")


def _check_vectors(options):
    for name in OF_VECTORS:
        if getattr(options, name) is not None and options.output.suffix not in VECTORS:
            kinds = " or ".join(VECTORS)
            raise ValueError(f"--{name.replace('_', '-')} is for vectors: name an output that ends in {kinds}")
    if "title_block" in vector_options(options) and options.paper in (None, "page", "pixels"):
        raise ValueError("a title block lies on a sheet of paper: choose one, as --paper a4")


def _check(options):
    options.scene = options.scene or ("suzanne:3" if options.sheet else "demo")
    if is_file(options.scene):
        if not Path(options.scene).is_file():
            raise ValueError(f"there is no file {options.scene}")
    elif Path(options.scene).suffix:
        models = ", ".join(model_files.IMPORTERS)
        raise ValueError(f"{options.scene}: a scene is a {models} or .blend file, or one of {scenes.names()}")
    else:
        scenes.parse(options.scene)
    plain = not (options.style or options.lines or options.focus or options.focus_painted or options.sheet)
    if options.scene == "demo" and plain:
        vars(options).update(DEMO)
    options.output = options.output or default_output(options.scene, "sheet" if options.sheet else "fovea")
    if options.output.suffix not in PICTURES + VECTORS + LAYERS:
        kinds = f"a picture is {' or '.join(PICTURES)}, vectors are {' or '.join(VECTORS)}, layers are {LAYERS[0]}"
        raise ValueError(f"{kinds}, not {options.output.name}")
    _check_vectors(options)
    _check_one_bit(options)
    _check_over(options)
    if options.scale and options.paper == "pixels":
        raise ValueError("--scale is of paper, and --paper pixels has no size: leave out one of them")
    if options.sheet:
        _check_sheet(options)
    if options.cameras and (options.azimuth is not None or options.elevation is not None):
        raise ValueError("--cameras draws from cameras of the file: leave out --azimuth and --elevation")
    if not options.margin < 50:
        raise ValueError(f"a margin of {options.margin} percent leaves no picture")
    if options.dump and options.dump.suffix != ".npz":
        raise ValueError(f"a dump is a .npz, not {options.dump.name}")
    output.check(*pictures(options), *dumps(options))


def _check_over(options):
    for name in ("blend", "opacity", "samples"):
        if getattr(options, name) is not None and not options.over:
            raise ValueError(f"--{name} is for lines over renders: name the engine, as --over cycles")
    if options.over and (options.sheet or options.output.suffix in VECTORS):
        kinds = " or ".join(PICTURES)
        raise ValueError(f"--over draws a picture: leave out --sheet, and name an output that ends in {kinds}")


def _check_sheet(options):
    options.lines = options.lines or ["all"]
    options.size = options.size or TILE
    if options.output.suffix != ".png":
        raise ValueError(f"a sheet is a .png, not {options.output.name}")
    others = ("frames", "cameras", "style", "transparent", "hidden", "hidden_by", "halo", "overshoot", "dump")
    others += ("focus", "focus_painted", "elision", "section", "scale")
    for other in others:
        if getattr(options, other):
            raise ValueError(f"a sheet has no --{other.replace('_', '-')}")
    options.style = "plain"  # one pen for all lines
