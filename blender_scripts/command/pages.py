# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of addon/docs: for each, the model, the camera, and the lines drawn faintly below."""

from dataclasses import dataclass, field

from . import variants
from .target import PROJECT

DOCS = PROJECT / "addon" / "docs"
LESSON = "lesson:"  # a model of scenes/lessons.py
SIZE = "640x480"
SHAPE = ("contour", "border")  # drawn faintly to show the shape
MESH = ("contour", "crease")  # with crease.angle=0: every edge of the mesh


@dataclass(frozen=True)
class Picture:
    """A picture of one line definition."""

    model: str  # a scene, a model of the shared folder (.obj), or a lesson
    camera: tuple  # options of `fovea draw`
    beneath: tuple = SHAPE  # line definitions drawn faintly below
    beneath_params: tuple = ()  # options of `fovea draw` for these
    params: tuple = ()  # for its own lines
    learned: str = ""  # picture of LEARN from whose drawing the model is that its own lines need


def _seen(azimuth, elevation):
    return "--azimuth", str(azimuth), "--elevation", str(elevation)


def _params(*given):
    return tuple(word for param in given for word in ("--param", param))


MONKEY = "suzanne:4", _seen(25, 8)
BUNNY = "organic/stanford-bunny.obj", _seen(-55, 12)
SPOT = "organic/spot.obj", _seen(-135, 12)
VASE = LESSON + "vase", _seen(30, 18)
DRAPERY = LESSON + "drapery", _seen(25, 12)
CUT_PART = "cad/pump-cover.obj", (*_seen(25, 25), "--section", "0,0,0,0,-1,0")
EVERY_EDGE = MESH, _params("crease.angle=0")

_CHOSEN = {  # definition -> its picture; the others are drawn on the monkey
    "contour": Picture("suzanne:1", _seen(25, 8), *EVERY_EDGE),
    "silhouette": Picture("cad/crank-arm.obj", _seen(35, 25), ("contour", "crease")),
    "crease": Picture("cad/fandisk.obj", _seen(35, 25)),
    "border": Picture(LESSON + "cloth", _seen(30, 30), ("contour",)),
    "material_boundary": Picture(LESSON + "balls", _seen(20, 18)),
    "edge_mark": Picture(LESSON + "marked-vase", _seen(30, 18)),
    "smooth_contour": Picture(LESSON + "ring", _seen(20, 58), *EVERY_EDGE),
    "smooth_silhouette": Picture("suzanne:3", _seen(25, 8), ("smooth_contour",)),
    "principal_highlight_ridge": Picture(*DRAPERY),
    "principal_highlight_valley": Picture(*DRAPERY),
    "parabolic": Picture(*VASE),
    "zero_mean_curvature": Picture(*VASE),
    "isophote": Picture(LESSON + "pebble", _seen(30, 15)),
    "topographic": Picture(*SPOT),
    "intersection": Picture(LESSON + "crossings", _seen(5, 40)),
    "abstracted_shading": Picture(*BUNNY),
    "section_cut": Picture(*CUT_PART),
    "section_hatch": Picture(*CUT_PART, ("contour", "crease", "section_cut")),
    "cast_shadow": Picture(LESSON + "shadows", _seen(-40, 28), ("contour", "crease")),
    "hatching": Picture(
        LESSON + "shadows", _seen(-40, 28), ("contour", "crease"), params=_params("hatching.spacing=12")
    ),
    "learned_line": Picture("organic/cow.obj", _seen(-60, 12), learned="learned"),
}
# Every definition that has a page.
LINES = {
    page.stem: _CHOSEN.get(page.stem, Picture(*MONKEY))
    for page in sorted((DOCS / "lines").glob("*.md"))
    if page.stem != "README"
}


@dataclass(frozen=True)
class Stage:
    """A picture of a scene as a whole, or of the demo scene at one stage of the method."""

    words: tuple  # options of `fovea draw`
    settings: dict = field(default_factory=dict)  # {PART.NAME: value}; "pen", "hidden", "set": of all line sets


STAGE_SIZE = "560x315"
STAGE_VIEW = 0.53, 0.62, 1.8  # crop of the frame: center (u, v) from the left and the top, and magnification
_EDGES = "silhouette,contour,crease,border,material_boundary,edge_mark"
_LINES = ("--style", "plain", "--lines", f"{_EDGES},suggestive_contour,valley")
_PEN = {"pen.width": 3.0}
_DASHES = {"hidden.width": 2.0, "hidden.opacity": 0.5}
_SOLID = {"hidden.width": 3.0, "hidden.opacity": 1.0, "hidden.texture": "solid"}
_FOCUS = ("--style", "watercolor", "--focus", "0.5,0.55", "--focus-radii", "0.2,1.0")

WAY = {  # stage -> its picture, in the order of the pipeline
    "1_surfaces": Stage(
        ("--style", "plain", "--lines", "contour,border,crease", *_params("crease.angle=0")),
        {"pen.width": 1.4, "pen.opacity": 0.6, "color.shading": "SMOOTH"},
    ),
    "2_lines": Stage((*_LINES, "--hidden"), _PEN | _SOLID),
    "3_visible": Stage((*_LINES, "--hidden-by", "1"), _PEN | _DASHES),
    "4_elided": Stage((*_LINES, "--elision"), _PEN | {"pen.spacing": 18.0}),
    "5_strokes": Stage((*_FOCUS, "--without", "colors")),
    "6_picture": Stage(_FOCUS),
}

_WATERCOLOR = ("--style", "watercolor")
FOCUS = {  # focus model -> its picture
    "image": Stage((*_WATERCOLOR, "--focus", "0.1,0.7", "--focus-radii", "0.1,0.8")),
    "scene": Stage((*_WATERCOLOR, "--focus", "0,-2.3,1.2", "--focus-radii", "1,4")),
    "object": Stage((*_WATERCOLOR, "--focus", "Bicycle", "--focus-radii", "0.2,3")),
}
SITUATIONS_SIZE = "480x300"
_DARK = {"color.background": (0.012, 0.016, 0.035), "color.on_paper": False}
SITUATIONS = {  # scene of scenes/ -> its picture
    "foliage": Stage(("--style", "pen_and_ink")),
    "hair": Stage(("--style", "pencil")),
    "hull": Stage(("--style", "watercolor")),
    "scan": Stage(("--style", "pencil")),
    "parts": Stage(("--style", "technical")),
    "runner": Stage(("--style", "brush")),
    "office": Stage(("--style", "pen_and_ink")),
    "grove": Stage(("--style", "pen_and_ink")),
    "lettering": Stage(("--style", "plain")),
    "night": Stage(("--style", "watercolor"), _DARK),
}
OVER_SIZE = "560x315"
_RENDERED = ("--over", "cycles", "--samples", "32", "--style", "pen_and_ink", "--no-elision")
OVER = {  # how lines lie over a render of the demo scene -> its picture
    "cycles": Stage(_RENDERED, {"pen.width": 3.2}),
    "multiply": Stage(("--over", "workbench", "--style", "pencil", "--blend", "multiply"), {"pen.width": 5.0}),
}
SECTIONS_SIZE = "960x540"
SECTIONS = {  # picture -> its scene or model, and how that is drawn
    "plan": ("office", Stage(variants.PLAN)),
    "part": (CUT_PART[0], Stage((*CUT_PART[1], "--style", "plan"))),
}
_BRUSH = Stage(("--style", "brush", "--without", "colors"))
GREASE_PENCIL = {"film": _BRUSH, "baked": _BRUSH}  # strokes of one scene as Fovea draws them, and as they are baked
PENCIL_VIEW = 0.5, 0.45, 1.4  # as STAGE_VIEW
PAGE_SIZE, PAGE_PLACE = "560x315", (0.55, 0.47)  # of what is shown of a page, and its place from the lower left
VECTORS = {"one_bit": Stage(("--style", "watercolor", "--one-bit", "--dpi", "300"))}
_FIELDS = {
    "title": "Ground floor",
    "document": "Floor plan",
    "number": "A-101",
    "revision": "B",
    "sheet": "1/3",
    "date": "2026-05-31",
    "creator": "M. Weiß",
    "approver": "É. Dubois",
    "owner": "Atelier Süd",
}
TITLED_WIDTH = 900  # of a sheet, pixels
TITLED = {  # a sheet of paper with a title block -> its scene, and options of `fovea draw`
    "title_block": (
        "office",
        (
            *(*variants.PLAN, "--paper", "a4", "--paper-margin", "5"),
            *(word for name, text in _FIELDS.items() for word in ("--title-field", f"{name}={text}")),
        ),
    )
}
FRAME_SIZE, FRAMES = "180x200", (1, 5, 9, 13)
FARM = {"frames": Stage(("--style", "brush"))}
_LIGHT = {"pen.second_color": (0.5, 0.5, 0.5)}
STROKES_SIZE = "280x210"
STROKES_WORDS = (*MONKEY[1], "--style", "plain", "--lines", "smooth_contour,suggestive_contour,crease,border")
STROKES_PEN = {"pen.width": 26.0}
STROKES = {  # modifier along the stroke -> the pen of its picture, of a monkey
    "along": _LIGHT | {"pen.along_width.strength": 0.9, "pen.along_color.strength": 1.0},
    "nib": {"pen.nib_angle": 0.6, "pen.nib_width": 0.92},
    "distance": _LIGHT
    | {"pen.distance_near": 3.2, "pen.distance_far": 4.6}
    | {"pen.distance_width": 0.8, "pen.distance_color": 1.0},
    "noise": {"pen.noise_length": 16.0, "pen.noise_width": 0.75},
}
PAINTED_SIZE = "420x315"
_THIN = ("--style", "plain", "--lines", "smooth_contour,suggestive_contour,crease,border")
PAINTED = {  # what pens take from surfaces -> its scene or model, and how that is drawn
    "group": (
        MONKEY[0],
        Stage(
            (*MONKEY[1], *_THIN),
            {"pen.width": 24.0, "pen.paint_width": "VERTEX_GROUP", "pen.paint_width_name": "Paint"},
        ),
    ),
    "material": ("demo", Stage(("--style", "pen_and_ink", "--without", "colors"), {"pen.paint_color": "MATERIAL"})),
}
LIGHT_SIZE = "360x270"
SHADOWS = LESSON + "shadows", _seen(-40, 28)
_BY_LIGHT = (*SHADOWS[1], "--style", "plain", "--lines", "contour,smooth_contour,crease,border,cast_shadow")
LIGHT = {  # what light does -> a scene, and drawings of it, one over the other
    "weights": (
        SHADOWS[0],
        Stage(_BY_LIGHT, {"set.light": "LIT", "pen.width": 4.0}),
        Stage(_BY_LIGHT, {"set.light": "SHADED", "pen.width": 9.0}),
    ),
    "shadow": (SHADOWS[0], Stage(_BY_LIGHT[:-2], {"pen.width": 5.0, "color.shading": "SMOOTH", "color.shadow": 1.0})),
    "blacks": (SHADOWS[0], Stage((*SHADOWS[1], "--style", "comic", "--no-elision"), {"color.desaturation": 1.0})),
    "form": (
        MONKEY[0],
        Stage(
            (
                *(*MONKEY[1], "--style", "plain", "--lines", "contour,smooth_contour,hatching", "--no-elision"),
                *_params("hatching.spacing=13", "hatching.families=1", "hatching.light=0.9"),
                *_params("hatching.planes=3", "hatching.angle=0"),
            ),
            {"pen.width": 2.8},
        ),
    ),
}
TRANSFERS = {  # plot -> members of a style's Transfer
    "straight": {},
    "start_end": {"start": 0.25, "end": 0.75},
    "strength": {"start": 0.25, "end": 0.75, "strength": 0.5},
    "reversed": {"start": 0.75, "end": 0.25},
    "curve": {"curve": [[0, 0], [0.3, 0.75], [0.7, 0.85], [1, 1]]},
}
PLOT = 240  # pixels
ANIMATION_SIZE, ANIMATION_FRAMES = (320, 180), 16
ANIMATION = {  # scene with motion -> its lines in bench/coherence
    "turntable": "mesh",
    "dolly": "mesh",
    "zoom": "mesh",
    "walk": "view",
}
MARKS_FRAMES = {"walk": 16}  # frames over which marks of lines of the view are handed on
FOLLOWING_PEN = {"pen.width": 9.0, "pen.wobble": 14.0, "pen.wobble_length": 220.0}
FOLLOWING = {  # what changes between drawings of a monkey -> settings of each frame of its picture
    "boil": [{"animation.boil": 1.0, "animation.boil_hold": 1}] * 4,
    "written": [{"animation.written": share} for share in (0.25, 0.5, 0.75, 1.0)],
}
COMPARED_PEN = {"pen.width": 9.0}
COMPARED = {  # picture -> (scene with motion, its lines, settings of each row)
    "passing": (
        "passing",
        "contour,crease",
        [
            {"animation.visibility_frames": 0},
            *({"animation.visibility_frames": 2, "animation.vanish": how} for how in ("FADE", "RETRACT", "BREAK_UP")),
            {"animation.visibility_frames": 2, "animation.vanish": "BREAK_UP", "pen.texture": "charcoal"},
        ],
    ),
    "blurred": ("walk", "contour", [{}, {"animation.motion_blur": True, "animation.motion_samples": 16}]),
}
JPEG_QUALITY = 60  # of pictures that are part of the extension
STEPS = ("1_engine", "2_rendered", "3_style", "4_focus", "5_pull")  # pictures of first_drawing.md


@dataclass(frozen=True)
class Pair:
    """Two drawings of a model that are compared."""

    model: str
    camera: tuple
    drawn: tuple  # line definitions of each


COMPARE = {"overlay": Pair(*BUNNY, (("contour", "suggestive_contour"), ("contour", "apparent_ridge")))}

LEARN = {  # picture -> a drawing that is learned from, and another model that is drawn by that
    "learned": (
        Pair(*MONKEY, (("contour", "suggestive_contour", "ridge", "valley"),)),
        Pair("organic/cow.obj", _seen(-60, 12), (("learned_line",),)),
    )
}

GAZE_SIZE = "240x135"
GAZE = {  # heat map -> what of the office it is of
    name: Stage(
        ("--style", "brush", "--focus", "0.45,0.82", "--focus-radii", "0.03,0.8"), {"effects.emphasis": emphasis}
    )
    for name, emphasis in (("before", 1.0), ("strengthened", 2.74))
}

GAUGE_SIZE, GAUGES = "480x360", 40
GAUGE = {  # picture with true gauges -> its model, and how that is drawn
    name: (MONKEY[0], Stage((*MONKEY[1], "--style", "plain", "--lines", lines), {"pen.width": 4.0}))
    for name, lines in (("drawn", "contour,ridge,valley,suggestive_contour"),)
}

# Name -> {picture: its description}; each group is a folder of addon/docs.
GROUPS = {
    "lines": LINES, "sections": SECTIONS, "way": WAY, "focus": FOCUS, "strokes": STROKES, "painted": PAINTED,
    "light": LIGHT, "situations": SITUATIONS, "over": OVER, "transfers": TRANSFERS, "grease_pencil": GREASE_PENCIL,
    "animation": ANIMATION | FOLLOWING | COMPARED, "compare": COMPARE, "learn": LEARN,
    "gaze": GAZE, "gauge": GAUGE,
    "vectors": VECTORS | TITLED, "farm": FARM,
}  # fmt: skip


def names():
    """GROUP/PICTURE of all pictures."""
    return [f"{group}/{name}" for group, pictures in GROUPS.items() for name in pictures]


def file_of(name):
    """File of a GROUP/PICTURE, relative to addon/docs: PNG for gray pictures, JPEG for others."""
    return (
        f"{name}.png"
        if name.startswith(("animation/", "learn/", "light/", "lines/", "strokes/", "transfers/", "vectors/"))
        else f"{name}.jpg"
    )
