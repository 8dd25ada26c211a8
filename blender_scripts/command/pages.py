"""The pictures of addon/docs: which model shows what, how it is seen, and what lies faintly beneath."""

from dataclasses import dataclass

LESSON = "lesson:"  # a model of scenes/lessons.py
SIZE = "640x480"
SHAPE = ("contour", "border")  # drawn faintly, so that one sees what lines lie on
MESH = ("contour", "crease")  # with crease.angle=0: every edge of the mesh


@dataclass(frozen=True)
class Picture:
    """One line definition, as `fovea draw` would draw it."""

    model: str  # a scene, a model of the shared folder (.obj), or a lesson
    camera: tuple  # words of `fovea draw`
    beneath: tuple = SHAPE  # line definitions
    beneath_params: tuple = ()  # words
    params: tuple = ()  # words


def _seen(azimuth, elevation, *more):
    return ("--azimuth", str(azimuth), "--elevation", str(elevation), *more)


def _params(*given):
    return tuple(word for param in given for word in ("--param", param))


MONKEY = "suzanne:4", _seen(25, 8)
BUNNY = "organic/stanford-bunny.obj", _seen(-55, 12)
SPOT = "organic/spot.obj", _seen(-135, 12)
VASE = LESSON + "vase", _seen(30, 18)
RELIEF = LESSON + "relief", _seen(0, 48)
DRAPERY = LESSON + "drapery", _seen(25, 12)
EVERY_EDGE = MESH, _params("crease.angle=0")

LINES = {  # definition: how it is shown
    "contour": Picture("suzanne:1", _seen(25, 8), *EVERY_EDGE),
    "silhouette": Picture("cad/crank-arm.obj", _seen(35, 25), ("contour", "crease")),
    "crease": Picture("cad/fandisk.obj", _seen(35, 25)),
    "border": Picture(LESSON + "cloth", _seen(30, 30), ("contour",)),
    "material_boundary": Picture(LESSON + "balls", _seen(20, 18)),
    "edge_mark": Picture(LESSON + "marked-vase", _seen(30, 18)),
    "smooth_contour": Picture(LESSON + "ring", _seen(20, 35), *EVERY_EDGE),
    "smooth_silhouette": Picture("suzanne:3", _seen(25, 8), ("smooth_contour",)),
    "suggestive_contour": Picture(*MONKEY),
    "suggestive_highlight": Picture(*MONKEY),
    "principal_highlight_ridge": Picture(*DRAPERY),
    "principal_highlight_valley": Picture(*DRAPERY),
    "ridge": Picture(*MONKEY),
    "valley": Picture(*MONKEY),
    "apparent_ridge": Picture(*MONKEY),
    "demarcating_curve": Picture(*MONKEY),
    "laplacian_line": Picture(*MONKEY),
    "parabolic": Picture(*VASE),
    "zero_mean_curvature": Picture(*VASE),
    "isophote": Picture(*MONKEY),
    "topographic": Picture(*SPOT),
    "intersection": Picture(LESSON + "crossings", _seen(5, 40)),
    "image_edge": Picture(*MONKEY),
    "abstracted_shading": Picture(*BUNNY),
}

GROUPS = {"lines": LINES}  # name: {picture: what it shows}; each a folder of addon/docs


def names():
    """GROUP/PICTURE of all."""
    return [f"{group}/{name}" for group, pictures in GROUPS.items() for name in pictures]
