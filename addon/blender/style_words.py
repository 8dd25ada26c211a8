# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels say about each number, choice and switch of a style: one line for each.

Keyed by the part of a style and its field: label, what it does to the picture, and options of the property, of which
`min` and `max` stand in for RANGES. A field without a line gets its own name as the label.
"""

from ..color import MOST_BANDS
from ..elision import MOST_FRAMES, MOST_WEIGHT
from ..style_values import MOST_LIGHT, RANGES

_HIGH = "in pixels of an image 1080 pixels high"
_PX = {"subtype": "PIXEL"}
_SHARE = {"subtype": "FACTOR", "min": 0.0, "max": 1.0}
_COLOR = {"subtype": "COLOR", "size": 3, "min": 0.0, "max": MOST_LIGHT, "soft_max": 1.0}
_ROOM = {"subtype": "FACTOR", "min": 0.0, "max": 0.99}
_WEIGHT = {"min": 0.0, "max": float(MOST_WEIGHT), "soft_max": 2.0}
_LENGTH = {"subtype": "DISTANCE", "soft_max": 1000.0}

SHADINGS = (
    ("PLAIN", "Paper", "No colors: the paper alone lies under the lines"),
    ("FLAT", "Flat", "Base colors of the materials"),
    ("SMOOTH", "Smooth", "Lit by the scene's lights, or by one at the camera"),
    ("TOON", "Toon", "Lit in bands"),
)
MODES = (
    ("EMPHASIZED", "Emphasized", "As focus says"),
    ("UNIFORM", "Uniform", "The same all over the image"),
    ("NONE", "None", "Not drawn"),
)
CAPS = (("ROUND", "Round", "Half a disc beyond each end"), ("BUTT", "Butt", "Cut off straight at each end"))
WIDTH_UNITS = (
    ("REFERENCE", "Reference Pixels", "Pixels of an image 1080 pixels high: alike at any resolution"),
    ("PIXELS", "Pixels", "Pixels of the image, however large it is"),
    ("MILLIMETRES", "Millimeters", "Millimeters on a page as high as the paper says"),
)
ANCHORS = (
    ("SCREEN", "Screen", "One repetition is always as long in the image, and slides along lines that grow"),
    ("PATH", "Path", "It stays where it is along lines, and divides as they grow: for grain, not for dashes"),
)
CHOICES = {
    "color.shading": SHADINGS,
    "effects.lines": MODES,
    "effects.colors": MODES,
    "pen.cap": CAPS,
    "pen.width_unit": WIDTH_UNITS,
    "pen.texture_anchor": ANCHORS,
}

WORDS = {
    "transfer.start": ("Start", "Value (focus: 0 in, 1 out of it) at which the effect begins", _SHARE),
    "transfer.end": ("End", "Value at which the effect is whole; less than the start turns it around", _SHARE),
    "transfer.strength": ("Strength", "How strong the effect is where it is whole; 0 switches it off", _SHARE),
    "pen.color": ("Color", "Color of the strokes", _COLOR),
    "pen.opacity": ("Opacity", "How much of what lies below the strokes cover", _SHARE),
    "pen.width": ("Width", f"Width of the strokes, by default {_HIGH}", {"soft_max": 20.0, "step": 10}),
    "pen.width_unit": ("Unit", "What the width of the strokes is measured in", {}),
    "pen.texture": ("Texture", "Ink of the strokes, repeated along them", {}),
    "pen.texture_anchor": ("Anchor", "What the texture is fixed to when strokes grow in the image", {}),
    "pen.length_scale": ("Stretch", "Stretches the texture along the strokes", {"soft_max": 10.0}),
    "pen.cap": ("Caps", "Shape of the ends of the strokes", {}),
    "pen.taper": ("Taper", f"Length of the thinning ends of the strokes, {_HIGH}", {**_PX, "soft_max": 200.0}),
    "pen.strength_width": ("Thin if Weak", "How far weak lines are thin instead of pale", _SHARE),
    "pen.wobble": ("Wobble", f"How far the strokes stray from their lines, {_HIGH}", {**_PX, "soft_max": 10.0}),
    "pen.wobble_length": (
        "Wavelength",
        f"Length of the waves in which strokes stray, {_HIGH}",
        {**_PX, "soft_max": 300.0},
    ),
    "pen.seed": ("Seed", "Another number is another hand", {"soft_max": 100.0, "precision": 0, "step": 100}),
    "pen.pressure": ("Pressure", "How much thinner strokes are at their ends than in the middle", _SHARE),
    "pen.spacing": (
        "Spacing",
        f"How near to each other lines may be where elision thins them, {_HIGH}",
        {**_PX, "soft_max": 60.0},
    ),
    "hidden.first": ("From", "Draw lines that at least so many surfaces hide", {}),
    "hidden.last": ("To", "Draw lines that at most so many surfaces hide; 0: any number", {}),
    "line_set.collection": ("Collection", "Only objects of this collection have the lines of this set; none: all", {}),
    "line_set.outside": ("Outside", "Only objects that are not in the collection have the lines of this set", {}),
    "line_set.object": (
        "Object",
        "Only this object, what it instances and what is instanced of it have the lines of this set; none: all",
        {},
    ),
    "line_set.other_objects": ("Other Objects", "Only other objects have the lines of this set", {}),
    "line_set.material": (
        "Material",
        "Only lines on faces of this material are of this set, those where another one meets it included; none: all",
        {},
    ),
    "line_set.other_materials": ("Other Materials", "Only lines on faces of other materials are of this set", {}),
    "line_set.corner_angle": ("Corner Angle", "Strokes end where a line turns by more than this", {"subtype": "ANGLE"}),
    "line_set.least_length": (
        "Min Length",
        f"Shorter lines that end without touching another are left out, {_HIGH}",
        {**_PX, "soft_max": 200.0},
    ),
    "line_set.overshoot": (
        "Overshoot",
        f"How far lines go on beyond their ends, but not behind what hides them, {_HIGH}",
        {**_PX, "soft_max": 60.0},
    ),
    "line_set.overshoot_away": (
        "Overshoot",
        f"How far lines out of focus go on beyond their ends, {_HIGH}",
        {**_PX, "soft_max": 60.0},
    ),
    "line_set.halo": (
        "Halo",
        f"Gap that is left in lines where they pass behind others, {_HIGH}",
        {**_PX, "soft_max": 30.0},
    ),
    "paper.color": ("Color", "Color of the paper", _COLOR),
    "paper.transparent": ("Transparent", "The picture has no paper, only what is drawn on it", {}),
    "paper.texture": ("Surface", "Height of the paper, which ink and color heed", {}),
    "paper.scale": ("Grain Size", "Size of the paper's grain", {"soft_max": 5.0}),
    "paper.tooth": ("Tooth", "How far ink stays off the valleys of the paper", _SHARE),
    "paper.granulation": ("Granulation", "How far color settles in the valleys of the paper", _SHARE),
    "paper.tint": ("Relief", "How far the paper's own relief shades the picture", _SHARE),
    "paper.height_mm": (
        "Page Height",
        "Height of the page, for pens measured in millimeters",
        {"subtype": "DISTANCE_CAMERA", "soft_max": 1000.0},
    ),
    "color.shading": ("Shading", "What colors lie under the lines", {}),
    "color.bands": ("Bands", "Number of tones of toon shading", {"min": 2, "max": MOST_BANDS}),
    "color.opacity": ("Opacity", "How much of the paper the colors cover", _SHARE),
    "color.desaturation": ("Desaturation", "How gray colors are everywhere", _SHARE),
    "elision.enabled": ("Elision", "Thin lines that go alongside each other nearer than their pens' spacing", {}),
    "elision.fade_from": ("Min Room", "Share of its room that a line must have to show at all", _ROOM),
    "elision.cut": ("Min Opacity", "Lines that are fainter are left out altogether", _ROOM),
    "elision.frames": (
        "Smooth Frames",
        "Renders smooth how lines come and go over so many frames before and after each, and take as many times as long",
        {"min": 0, "max": MOST_FRAMES},
    ),
    "elision.length": ("Length", "Of crowding lines, how far long ones stay before short ones", _WEIGHT),
    "elision.kind": ("Kind", "How far outlines stay before creases, and creases before smooth lines", _WEIGHT),
    "elision.strength": ("Strength", "Of crowding lines, how far strong ones stay before weak ones", _WEIGHT),
    "elision.depth": ("Depth", "Of crowding lines, how far near ones stay before far ones", _WEIGHT),
    "elision.object": ("Object", "Of crowding lines, how much the priority of their objects counts", _WEIGHT),
    "elision.painted": ("Painted", "Of crowding lines, how much counts what is painted on meshes", _WEIGHT),
    "elision.priority_attribute": (
        "Painted Priority",
        "Attribute of meshes: lines where it is white stay, half way where there is none",
        {},
    ),
    "elision.density_attribute": (
        "Painted Density",
        "Attribute of meshes: lines are four times as dense where it is white, a quarter as dense where it is black",
        {},
    ),
    "effects.lines": ("Lines", "Whether lines answer to focus", {}),
    "effects.colors": ("Colors", "Whether colors answer to focus", {}),
    "effects.uniform": ("Uniform Focus", "Focus everywhere, of what is uniform: 0 in focus, 1 out of it", _SHARE),
    "effects.blur_radius": ("Blur Radius", f"Radius of the full blur, {_HIGH}", {**_PX, "soft_max": 60.0}),
    "distance.near": ("Near", "Distance from the camera at which effects begin", _LENGTH),
    "distance.far": ("Far", "Distance from the camera at which effects are whole", _LENGTH),
}

EFFECTS = {  # transfer function: what it drives
    "color": "Line Color",
    "texture": "Line Texture",
    "width": "Line Width",
    "opacity": "Line Opacity",
    "density": "Line Density",
    "overshoot": "Overshoot",
    "desaturation": "Desaturation",
    "fade": "Fade to Paper",
    "blur": "Blur",
}
LINE_EFFECTS = ("color", "texture", "width", "opacity", "density", "overshoot")
COLOR_EFFECTS = ("desaturation", "fade", "blur")
DISTANCE_EFFECTS = ("width", "opacity", "density")


def of(part, field):
    """(label, description, options of a number's property) of a field."""
    label, told, options = WORDS.get(f"{part}.{field}", (field.replace("_", " ").title(), "", {}))
    low, high = RANGES.get(field.removesuffix("_away"), (None, None))
    limits = {} if low is None or "size" in options else {"min": float(low), "max": float(high)}
    return label, told, limits | options
