# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets of one scene drawn in several ways: for each tile its label and options of `fovea draw`. A single tile has no
label."""

AT = ["--focus", "0.4,0.52", "--focus-radii", "0.1,0.7"]
DENSITY = ["--style", "pen_and_ink", "--effects", "density"]
LINE_EFFECTS = ("texture", "width", "opacity", "density", "overshoot")
COLOR_EFFECTS = ("desaturation", "fade", "blur")
STYLES = (
    "pen_and_ink",
    "pencil",
    "charcoal",
    "technical",
    "blueprint",
    "watercolor",
    "brush",
    "xray_focus",
    "engraving",
    "etching",
    "stipple",
    "ink_hatching",
    "comic",
)
WATERCOLOR = ["--style", "watercolor", *AT]


# The plan of the ground floor of the scene office, to scale.
PLAN = ("--section", "0,0,1.35,0,0,1", "--azimuth", "0", "--elevation", "90", "--scale", "100", "--style", "plan")


def _effects(scene):
    tiles = [(name, [*WATERCOLOR, "--effects", name]) for name in (*COLOR_EFFECTS, *LINE_EFFECTS)]
    return scene, [*tiles, ("all", WATERCOLOR)]


SHEETS = {  # name: (scene, tiles), after Cole 2009: figures 5.7, 5.8, 5.9, and the viewing conditions of section 5.3.3
    "demo": ("demo", [("", [])]),
    "styles": ("demo", [(name, ["--style", name, *AT]) for name in STYLES]),
    "elision": (
        "office",
        [
            ("without elision", [*DENSITY, "--no-elision"]),
            ("with elision", [*DENSITY, "--elision", "--focus", "0.35,0.5", "--focus-radii", "0,0.3"]),
        ],
    ),
    "density": (
        "office",
        [
            ("density on the left", [*DENSITY, "--focus", "0.2,0.5", "--focus-radii", "0.1,0.9"]),
            ("density on the right", [*DENSITY, "--focus", "0.8,0.5", "--focus-radii", "0.1,0.9"]),
        ],
    ),
    "effects-office": _effects("office"),
    "effects-demo": _effects("demo"),
    "conditions": (
        "office",
        [
            ("1 uniform", [*WATERCOLOR, "--uniform", "both"]),
            ("2 uniform color, no lines", [*WATERCOLOR, "--uniform", "both", "--without", "lines"]),
            ("3 uniform lines, no color", [*WATERCOLOR, "--uniform", "both", "--without", "colors"]),
            ("4 emphasis", WATERCOLOR),
            ("5 emphasis in color", [*WATERCOLOR, "--uniform", "lines"]),
            ("6 emphasis in lines", [*WATERCOLOR, "--uniform", "colors"]),
            ("7 emphasis in color, no lines", [*WATERCOLOR, "--without", "lines"]),
            ("8 emphasis in lines, no color", [*WATERCOLOR, "--without", "colors"]),
        ],
    ),
}
