# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea figures [NAME...]`: draws the pictures of README and of its page of figures (single pictures with `fovea
draw`, variants as sheets), and those of addon/docs."""

import argparse
import tempfile
from pathlib import Path

import window

from . import actions, pages
from . import package as extension
from .target import PROJECT, SHARED
from .variants import PLAN, SHEETS

FOLDER = PROJECT / "blender_scripts" / "figures"
MODELS = SHARED / "models"
CRANK_ARM = MODELS / "cad" / "crank-arm.obj"
ORGANIC = {  # figure -> model, azimuth, elevation (degrees)
    "rocker-arm": ("rocker-arm", "65", "25"),
    "bunny": ("stanford-bunny", "105", "15"),
    "spot": ("spot", "120", "15"),
}
STYLES, THUMBNAILS = PROJECT / "addon" / "styles", "thumbnails"  # one picture per bundled style
SIZE = ["--size", "1280x720"]
STEPS, WINDOW = "first_drawing", (1280, 800)  # pictures of the steps of a page, and pixels of Blender's window in them
FIGURES = {  # name -> options of `fovea draw`
    f"lines-{name}": [
        MODELS / "organic" / f"{model}.obj", "--lines", "all", "--sheet", "--size", "480x360",
        "--azimuth", azimuth, "--elevation", elevation,
    ]
    for name, (model, azimuth, elevation) in ORGANIC.items()
} | {
    f"atlas-{probes}x{scale}": [
        "office", "--style", "plain", "--visibility", "atlas", "--probes", probes, "--depth-scale", scale,
        "--size", "640x360",
    ]
    for probes in ("1", "16") for scale in ("1", "3")
} | {
    "hidden-crank-arm": [CRANK_ARM, "--style", "technical", "--hidden"],
    "hidden-office": ["office", "--style", "technical", "--hidden-by", "1"],
    "halo-crank-arm": [CRANK_ARM, "--style", "plain", "--halo", "8"],
    "halo-office": ["office", "--style", "plain", "--halo", "5"],
    "overshoot-crank-arm": [CRANK_ARM, "--style", "pencil", "--overshoot", "20", "--size", "1200x675"],
    "overshoot-office": ["office", "--style", "plain", "--overshoot", "9"],
}  # fmt: skip


VECTORS = {"plan-office": ["office", *PLAN, "--tolerance", "0.05"]}  # name -> options of `fovea draw` for an SVG


def figures(target, words):
    parser = argparse.ArgumentParser("fovea figures")
    known = (*FIGURES, *VECTORS, *SHEETS, THUMBNAILS, *pages.GROUPS, STEPS)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(known))
    parser.add_argument("-o", "--output", type=Path, default=FOLDER, help="folder")
    options = parser.parse_args(words)
    unknown = sorted(set(options.names) - set(known) - set(pages.names()))
    if unknown:
        parser.error(f"there is no figure {', '.join(unknown)}; there are: {', '.join(known)}")
    options.output.mkdir(parents=True, exist_ok=True)
    for name in options.names or known:
        if name == THUMBNAILS:
            draw_thumbnails(target)
            continue
        if name == STEPS:
            draw_steps(target)
            continue
        if name.partition("/")[0] in pages.GROUPS:
            draw_pages(target, name)
            continue
        if name in SHEETS:
            draw_sheet(target, name, options.output.absolute() / f"{name}.jpg")
            continue
        picture = options.output.absolute() / f"{name}{'.svg' if name in VECTORS else '.png'}"
        words = VECTORS.get(name) or FIGURES[name]
        actions.draw(target, [*SIZE, *map(str, words), "-o", str(picture)])
    return 0


def draw_sheet(target, name, picture):
    extension.install(target)
    script = PROJECT / "blender_scripts" / "variants.py"
    actions.in_blender(target, f"drawing the sheet {name}", script, [name, str(picture)])


def draw_thumbnails(target):
    extension.install(target)
    script = PROJECT / "blender_scripts" / "thumbnails.py"
    actions.in_blender(target, "drawing the thumbnails", script, [str(STYLES)])


def draw_steps(target):
    """Draws the pictures of addon/docs/first_drawing.md; needs xvfb-run."""
    extension.install(target)
    output = pages.DOCS / STEPS
    output.mkdir(parents=True, exist_ok=True)
    script = PROJECT / "blender_scripts" / f"{STEPS}.py"
    with tempfile.TemporaryDirectory() as folder:
        how = {"size": WINDOW, "timeout": 300, "simulate": True}
        window.play(target.blender, target.environment(), script, "steps", Path(folder), (output,), **how)
    for name in pages.STEPS:
        print(output / f"{name}.jpg")


def draw_pages(target, name):
    """Draws a group of pages.py, or one GROUP/PICTURE."""
    extension.install(target)
    wanted = [picture for picture in pages.names() if picture == name or picture.startswith(f"{name}/")]
    (pages.DOCS / name.partition("/")[0]).mkdir(parents=True, exist_ok=True)
    script = PROJECT / "blender_scripts" / "pages.py"
    actions.in_blender(target, f"drawing the pictures {name}", script, [str(pages.DOCS), *wanted])
